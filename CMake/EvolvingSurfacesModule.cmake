# The VTK module with its Python package, and the ParaView plugin where ParaView's SDK is found.
#
# One shared module serves the plugin, Python imports and the C++ tests: two copies of a class in
# one process would not recognise each other's objects.

option(EVOLVINGSURFACES_WHEEL
  "Lay the installation out as a Python wheel beside VTK's own; pyproject.toml sets it." OFF)
set(evolvingsurfaces_library_version
  VERSION "${PROJECT_VERSION}" SOVERSION "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
if (EVOLVINGSURFACES_WHEEL)
  include(WheelLayout)
endif ()
include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(BUILD_SHARED_LIBS ON)

option(EVOLVINGSURFACES_USE_PARAVIEW
  "Build against ParaView's SDK, with the plugin; otherwise against plain VTK." ON)

# VTK 9.3 hands on keywords without a value, of which CMake from 3.31 on warns.
set(CMAKE_POLICY_DEFAULT_CMP0174 OLD)

if (EVOLVINGSURFACES_USE_PARAVIEW)
  include(MendedParaView)
  evolvingsurfaces_mend_paraview()
  find_package(ParaView REQUIRED)
else ()
  find_package(VTK 9.1 REQUIRED COMPONENTS
    CommonCore CommonDataModel CommonExecutionModel FiltersCore FiltersGeneral ParallelCore
    WrappingPythonCore Python
    OPTIONAL_COMPONENTS
    FiltersGeometry FiltersSources IOGeometry IOImage IOLegacy IOPLY IOXML InteractionStyle
    RenderingOpenGL2 TestingRendering)
endif ()
find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)

vtk_module_scan(
  MODULE_FILES "${CMAKE_SOURCE_DIR}/Filters/vtk.module"
  PROVIDES_MODULES evolvingsurfaces_modules
  REQUEST_MODULES EvolvingSurfaces::Filters
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${evolvingsurfaces_modules}
  PACKAGE EvolvingSurfaces
  INSTALL_EXPORT EvolvingSurfaces
  ${evolvingsurfaces_library_version}
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/EvolvingSurfaces"
  TEST_DIRECTORY_NAME NONE)

# Debian's python3 reads dist-packages, every other one site-packages.
if (EXISTS "/etc/debian_version")
  set(evolvingsurfaces_python_default "lib/python3/dist-packages")
else ()
  set(evolvingsurfaces_python_default
    "${CMAKE_INSTALL_LIBDIR}/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/site-packages")
endif ()
set(EVOLVINGSURFACES_PYTHON_DIR "${evolvingsurfaces_python_default}" CACHE STRING
  "Where the Python package is, relative to the build tree and to the prefix.")

vtk_module_wrap_python(
  MODULES ${evolvingsurfaces_modules}
  TARGET EvolvingSurfaces::FiltersPython
  PYTHON_PACKAGE "evolvingsurfaces"
  MODULE_DESTINATION "${EVOLVINGSURFACES_PYTHON_DIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INSTALL_HEADERS OFF
  BUILD_STATIC OFF)

# VTK writes no __init__.py; ours re-exports the classes, so that one import serves all.
set(EVOLVINGSURFACES_PYTHON_EXTENSION vtkEvolvingSurfacesFilters)
set(evolvingsurfaces_package "${CMAKE_BINARY_DIR}/${EVOLVINGSURFACES_PYTHON_DIR}/evolvingsurfaces")
configure_file(
  "${CMAKE_SOURCE_DIR}/Filters/Python/__init__.py.in" "${evolvingsurfaces_package}/__init__.py" @ONLY)
install(FILES "${evolvingsurfaces_package}/__init__.py"
  DESTINATION "${EVOLVINGSURFACES_PYTHON_DIR}/evolvingsurfaces" COMPONENT python)
# By which Python's tools know name and version; what builds a wheel writes its own.
if (NOT EVOLVINGSURFACES_WHEEL)
  configure_file(
    "${CMAKE_SOURCE_DIR}/Filters/Python/METADATA.in"
    "${evolvingsurfaces_package}-${PROJECT_VERSION}.dist-info/METADATA" @ONLY)
  install(FILES "${evolvingsurfaces_package}-${PROJECT_VERSION}.dist-info/METADATA"
    DESTINATION "${EVOLVINGSURFACES_PYTHON_DIR}/evolvingsurfaces-${PROJECT_VERSION}.dist-info"
    COMPONENT python)
endif ()

if (EVOLVINGSURFACES_USE_PARAVIEW)
  paraview_plugin_scan(
    PLUGIN_FILES "${CMAKE_SOURCE_DIR}/Plugin/paraview.plugin"
    PROVIDES_PLUGINS evolvingsurfaces_plugins
    ENABLE_BY_DEFAULT ON
    HIDE_PLUGINS_FROM_CACHE ON)
  find_program(EVOLVINGSURFACES_XMLPATTERNS NAMES xmlpatterns HINTS /usr/lib/qt5/bin)
  if (NOT EVOLVINGSURFACES_XMLPATTERNS)
    message(STATUS "xmlpatterns was not found: the plugin is built without its help pages.")
    set(evolvingsurfaces_no_help DISABLE_XML_DOCUMENTATION ON)
  endif ()
  paraview_plugin_build(
    PLUGINS ${evolvingsurfaces_plugins}
    PLUGINS_COMPONENT plugin
    PLUGINS_FILE_NAME "evolvingsurfaces.plugins.xml"
    ${evolvingsurfaces_no_help})
endif ()

# What is installed, without the tests: two fifths of all there is to compile.
add_custom_target(product)
add_dependencies(product vtkEvolvingSurfacesFiltersPython)
if (TARGET EvolvingSurfaces)
  add_dependencies(product EvolvingSurfaces)
endif ()

if (NOT EVOLVINGSURFACES_WHEEL)
  include(EvolvingSurfacesPackage)
  include(EvolvingSurfacesDebian)
endif ()
