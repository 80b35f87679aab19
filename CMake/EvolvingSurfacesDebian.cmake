# What cpack makes on Debian and systems like it: the package evolvingsurfaces, which Python and ParaView
# find without being told, and evolvingsurfaces-dev, with which others build. Both have the files of an
# installed tree, below /usr, and what is Debian's own (DebianFiles.cmake).

find_program(EVOLVINGSURFACES_DPKG_SHLIBDEPS NAMES dpkg-shlibdeps)
find_program(EVOLVINGSURFACES_FILE NAMES file)
mark_as_advanced(EVOLVINGSURFACES_DPKG_SHLIBDEPS EVOLVINGSURFACES_FILE)
if (NOT EVOLVINGSURFACES_DPKG_SHLIBDEPS OR NOT EVOLVINGSURFACES_FILE)
  message(STATUS "dpkg-shlibdeps or file was not found: cpack makes no Debian packages.")
  return ()
endif ()

set(EVOLVINGSURFACES_PACKAGE_CONTACT
  "The EvolvingSurfaces authors <evolvingsurfaces@users.noreply.invalid>" CACHE STRING
  "Who is named as the maintainer of the Debian packages: a name and an address.")
set(EVOLVINGSURFACES_PACKAGE_REVISION "" CACHE STRING
  "The revision of the Debian packages; where empty, 1~deb12 or the like.")
set(evolvingsurfaces_debian_revision "${EVOLVINGSURFACES_PACKAGE_REVISION}")
if (NOT evolvingsurfaces_debian_revision)
  # The package of a later release of Debian replaces that of an earlier one.
  cmake_host_system_information(RESULT evolvingsurfaces_release QUERY DISTRIB_INFO)
  string(REPLACE "debian" "deb" evolvingsurfaces_debian_revision
    "1~${evolvingsurfaces_release_ID}${evolvingsurfaces_release_VERSION_ID}")
endif ()
set(evolvingsurfaces_debian_version "${PROJECT_VERSION}-${evolvingsurfaces_debian_revision}")
set(evolvingsurfaces_debian_dir "${CMAKE_BINARY_DIR}/CMakeFiles/Debian")
include(DebianFiles)
evolvingsurfaces_write_debian_files(evolvingsurfaces_debian_control)

# _evolvingsurfaces_of_minor(RESULT PACKAGE MAJOR MINOR): a dependency on this minor version of a
# package, as what was compiled for it runs with no other.
function (_evolvingsurfaces_of_minor result package major minor)
  math(EXPR next "${minor} + 1")
  set(${result} "${package} (>= ${major}.${minor}), ${package} (<< ${major}.${next}~)" PARENT_SCOPE)
endfunction ()

_evolvingsurfaces_of_minor(evolvingsurfaces_python
  python3 "${Python3_VERSION_MAJOR}" "${Python3_VERSION_MINOR}")
if (EVOLVINGSURFACES_USE_PARAVIEW)
  evolvingsurfaces_link_plugin(evolvingsurfaces_plugin_use)
  set(EVOLVINGSURFACES_DEBIAN_PYTHON_VTK python3-paraview)
  set(evolvingsurfaces_vtk_dev paraview-dev)
  set(evolvingsurfaces_vtk_version "${ParaView_VERSION_MAJOR}" "${ParaView_VERSION_MINOR}")
  set(evolvingsurfaces_parts "the VTK module, the Python package evolvingsurfaces and
the plugin for ParaView. ${evolvingsurfaces_plugin_use}")
else ()
  set(EVOLVINGSURFACES_DEBIAN_PYTHON_VTK "python3-vtk${VTK_MAJOR_VERSION}")
  set(evolvingsurfaces_vtk_dev "libvtk${VTK_MAJOR_VERSION}-dev")
  set(evolvingsurfaces_vtk_version "${VTK_MAJOR_VERSION}" "${VTK_MINOR_VERSION}")
  set(evolvingsurfaces_parts "the VTK module and the Python package
evolvingsurfaces.")
endif ()
_evolvingsurfaces_of_minor(evolvingsurfaces_python_vtk
  "${EVOLVINGSURFACES_DEBIAN_PYTHON_VTK}" ${evolvingsurfaces_vtk_version})
_evolvingsurfaces_of_minor(evolvingsurfaces_vtk_dev
  "${evolvingsurfaces_vtk_dev}" ${evolvingsurfaces_vtk_version})

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME evolvingsurfaces)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "${EVOLVINGSURFACES_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/package")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "${evolvingsurfaces_debian_revision}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_USE_PACKAGE_NAME evolvingsurfaces)
set(CPACK_DEBIAN_USE_PACKAGE_SECTION science)
# Finds the packages of the libraries: of ParaView, the version that its package says is compatible.
set(CPACK_DEBIAN_USE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_USE_PACKAGE_DEPENDS "${evolvingsurfaces_python_vtk}, ${evolvingsurfaces_python}")
set(CPACK_DEBIAN_USE_PACKAGE_CONTROL_EXTRA ${evolvingsurfaces_debian_control})
set(CPACK_DEBIAN_USE_DESCRIPTION "clean surface meshes by evolving surfaces
Turns any surface mesh into a clean one by evolving a surface onto it:
signed distance fields, mean curvature flow, tangential redistribution,
shrink-wrapping, smooth surfaces of the labels of an image.
.
This package has ${evolvingsurfaces_parts}")

set(CPACK_DEBIAN_BUILD_PACKAGE_NAME evolvingsurfaces-dev)
set(CPACK_DEBIAN_BUILD_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_BUILD_PACKAGE_DEPENDS
  "evolvingsurfaces (= ${evolvingsurfaces_debian_version}), ${evolvingsurfaces_vtk_dev}")
set(CPACK_DEBIAN_BUILD_DESCRIPTION "clean surface meshes by evolving surfaces, development files
The headers of the VTK module EvolvingSurfaces::Filters, and what CMake's
find_package(EvolvingSurfaces) reads.")

set(EVOLVINGSURFACES_DEBIAN_PACKAGES evolvingsurfaces)
set(CPACK_COMPONENTS_ALL runtime python plugin debian)
# Where ParaView's CMake files had to be mended, the copy is in the build tree: no package can name it.
cmake_path(IS_PREFIX CMAKE_BINARY_DIR "${VTK_DIR}" evolvingsurfaces_vtk_is_mended)
if (evolvingsurfaces_vtk_is_mended)
  message(STATUS "cpack makes no evolvingsurfaces-dev: ParaView's own CMake files cannot be used.")
else ()
  list(APPEND EVOLVINGSURFACES_DEBIAN_PACKAGES evolvingsurfaces-dev)
  list(APPEND CPACK_COMPONENTS_ALL development debian-development)
endif ()
if (NOT EVOLVINGSURFACES_USE_PARAVIEW)
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL plugin)
endif ()

include(CPack)
foreach (component IN ITEMS runtime python plugin debian)
  cpack_add_component(${component} GROUP use)
endforeach ()
foreach (component IN ITEMS development debian-development)
  cpack_add_component(${component} GROUP build)
endforeach ()
