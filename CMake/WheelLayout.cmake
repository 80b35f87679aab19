# The folders of a wheel: the library inside the package, the package beside VTK's (vtkmodules), where
# the libraries of VTK's own wheel are. pyproject.toml asks for it by EVOLVINGSURFACES_WHEEL.

set(CMAKE_INSTALL_LIBDIR "evolvingsurfaces")
set(EVOLVINGSURFACES_PYTHON_DIR ".")
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/../vtkmodules")
# A wheel has no links, which a library with a version is found by.
set(evolvingsurfaces_library_version)
