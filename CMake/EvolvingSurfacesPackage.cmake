# What find_package(EvolvingSurfaces) reads, in the build tree and in an installed one, and what an
# installation says when it is done.

include(CMakePackageConfigHelpers)
set(evolvingsurfaces_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/EvolvingSurfaces")
# Both trees have the same folders, so one file serves both.
configure_package_config_file(
  "${CMAKE_SOURCE_DIR}/CMake/EvolvingSurfacesConfig.cmake.in"
  "${CMAKE_BINARY_DIR}/${evolvingsurfaces_cmake_dir}/EvolvingSurfacesConfig.cmake"
  INSTALL_DESTINATION "${evolvingsurfaces_cmake_dir}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${evolvingsurfaces_cmake_dir}/EvolvingSurfacesConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${evolvingsurfaces_cmake_dir}/EvolvingSurfacesConfig.cmake"
    "${CMAKE_BINARY_DIR}/${evolvingsurfaces_cmake_dir}/EvolvingSurfacesConfigVersion.cmake"
  DESTINATION "${evolvingsurfaces_cmake_dir}"
  COMPONENT development)
install(FILES "${CMAKE_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/evolvingsurfaces")

set(evolvingsurfaces_plugin_line)
if (EVOLVINGSURFACES_USE_PARAVIEW)
  set(evolvingsurfaces_plugin_line
    "\n  PV_PLUGIN_PATH=\${prefix}/${CMAKE_INSTALL_LIBDIR}    (for Filters > Evolving Surfaces in ParaView)")
endif ()
# The prefix is known when it is installed.
configure_file(
  "${CMAKE_SOURCE_DIR}/CMake/InstalledTree.cmake.in"
  "${CMAKE_BINARY_DIR}/CMakeFiles/InstalledTree.cmake" @ONLY)
install(SCRIPT "${CMAKE_BINARY_DIR}/CMakeFiles/InstalledTree.cmake")
