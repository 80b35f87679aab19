# Debian 13's paraview-dev 5.13 names Python modules vtkmodules/NAME.so that its packages install as
# vtkmodules/NAME.cpython-313-x86_64-linux-gnu.so, so find_package(ParaView) ends with an error.
#
# evolvingsurfaces_mend_paraview() changes nothing in the system: where a package has this fault, it
# writes a copy of the package's CMake files into the build tree, with the names that are there, and
# sets ParaView_DIR to it. The copies find headers and libraries from where the originals are.

# The first file that the package names and that is not there, in `result`; empty where all are.
function (_evolvingsurfaces_missing_python_module targets_file prefix result)
  set(${result} "" PARENT_SCOPE)
  file(STRINGS "${targets_file}" lines REGEX "IMPORTED_LOCATION_")
  foreach (line IN LISTS lines)
    if (line MATCHES "\"\\\${_IMPORT_PREFIX}(/[^\"]*)\\.so\"" AND
        NOT EXISTS "${prefix}${CMAKE_MATCH_1}.so")
      set(${result} "${prefix}${CMAKE_MATCH_1}.so" PARENT_SCOPE)
      return ()
    endif ()
  endforeach ()
endfunction ()

# Copies one CMake file. What it derives from its place is derived from the original's, and what
# has no such file beside it gets the suffix.
function (_evolvingsurfaces_copy_mended original copy suffix)
  get_filename_component(folder "${original}" DIRECTORY)
  file(READ "${original}" text)
  set(derives "(get_filename_component\\([A-Za-z_]+|set\\([A-Za-z_]+prefix)")
  string(REGEX REPLACE
    "${derives} \"\\\${CMAKE_CURRENT_LIST_FILE}" "\\1 \"${original}" text "${text}")
  string(REGEX REPLACE
    "${derives} \"\\\${CMAKE_CURRENT_LIST_DIR}" "\\1 \"${folder}" text "${text}")
  if (original MATCHES "Python[A-Za-z]*-targets-[a-z]+\\.cmake$")
    string(REGEX REPLACE "(/dist-packages/[^\"]*)\\.so\"" "\\1${suffix}\"" text "${text}")
  endif ()
  file(WRITE "${copy}" "${text}")
endfunction ()

macro (evolvingsurfaces_mend_paraview)
  if (NOT ParaView_DIR)
    _evolvingsurfaces_mended_paraview(_evolvingsurfaces_paraview_dir)
    if (_evolvingsurfaces_paraview_dir)
      set(ParaView_DIR "${_evolvingsurfaces_paraview_dir}" CACHE PATH "ParaView's CMake files.")
    endif ()
  endif ()
endmacro ()

function (_evolvingsurfaces_mended_paraview result)
  set(${result} "" PARENT_SCOPE)
  file(GLOB configurations "/usr/lib/*/cmake/paraview-*/paraview-config.cmake")
  list(LENGTH configurations count)
  if (NOT count EQUAL 1)
    return ()
  endif ()
  get_filename_component(folder "${configurations}" DIRECTORY)
  file(GLOB targets_file "${folder}/vtk/VTKPython-targets-*.cmake")
  if (NOT targets_file)
    return ()
  endif ()
  _evolvingsurfaces_missing_python_module("${targets_file}" "/usr" missing)
  string(REGEX REPLACE "\\.so$" ".*.so" pattern "${missing}")
  file(GLOB present "${pattern}")
  if (NOT missing OR NOT present)
    return ()
  endif ()

  string(REGEX REPLACE "^.*/[^/.]*(\\..*)$" "\\1" suffix "${present}")
  set(mended "${CMAKE_BINARY_DIR}/CMakeFiles/MendedParaView")
  message(WARNING "ParaView's package names ${missing}, which is ${present}: using a copy of its "
    "CMake files with the right names, in ${mended}. Nothing in the system is changed.")
  file(GLOB_RECURSE files RELATIVE "${folder}" "${folder}/*")
  foreach (file IN LISTS files)
    if (file MATCHES "\\.cmake$")
      _evolvingsurfaces_copy_mended("${folder}/${file}" "${mended}/${file}" "${suffix}")
    else ()
      configure_file("${folder}/${file}" "${mended}/${file}" COPYONLY)
    endif ()
  endforeach ()
  set(${result} "${mended}" PARENT_SCOPE)
endfunction ()
