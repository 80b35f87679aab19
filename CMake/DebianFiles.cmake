# What the Debian packages have beside the files of an installed tree.

# _evolvingsurfaces_install_debian(DESTINATION FILE...): into the package, not with `cmake --install`.
function (_evolvingsurfaces_install_debian destination)
  install(FILES ${ARGN} DESTINATION "${destination}" COMPONENT debian EXCLUDE_FROM_ALL)
endfunction ()

# _evolvingsurfaces_link(RESULT NAME TO): a symbolic link that can be installed.
function (_evolvingsurfaces_link result name to)
  file(MAKE_DIRECTORY "${evolvingsurfaces_debian_dir}/links")
  set(link "${evolvingsurfaces_debian_dir}/links/${name}")
  file(CREATE_LINK "${to}" "${link}" SYMBOLIC)
  set(${result} "${link}" PARENT_SCOPE)
endfunction ()

# Whether ParaView lists plugins that are in /usr/share/paraview/plugins: as Debian's paraview.conf
# says, from 5.13 on.
function (_evolvingsurfaces_paraview_lists_plugins result)
  set(listed)
  file(GLOB configuration
    "/usr/lib/*/paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/paraview.conf")
  if (configuration)
    file(STRINGS "${configuration}" listed REGEX "^/usr/share/paraview/plugins/?$")
  endif ()
  set(${result} "${listed}" PARENT_SCOPE)
endfunction ()

# Links by which ParaView comes upon the plugin. Debian's earlier ones know no folder but `plugins`
# beside the executable, and load what is there when they start; that is made a link to the later
# ones' folder. Sets `result` to a sentence for users.
function (evolvingsurfaces_link_plugin result)
  _evolvingsurfaces_link(link EvolvingSurfaces "../../../${CMAKE_INSTALL_LIBDIR}/EvolvingSurfaces")
  _evolvingsurfaces_install_debian("share/paraview/plugins" "${link}")
  _evolvingsurfaces_paraview_lists_plugins(listed)
  if (listed)
    set(${result} "ParaView lists it in
Tools > Manage Plugins, to be loaded there, or whenever ParaView starts." PARENT_SCOPE)
  else ()
    _evolvingsurfaces_link(link plugins "../share/paraview/plugins")
    _evolvingsurfaces_install_debian("bin" "${link}")
    set(${result} "ParaView loads it when it starts,
by the link /usr/bin/plugins, as this ParaView looks nowhere else." PARENT_SCOPE)
  endif ()
endfunction ()

# _evolvingsurfaces_install_compressed(FILE RESULT): without the time, by which packages would differ.
function (_evolvingsurfaces_install_compressed file name)
  execute_process(COMMAND gzip -9 --no-name --stdout "${file}"
    OUTPUT_FILE "${evolvingsurfaces_debian_dir}/${name}")
  _evolvingsurfaces_install_debian("share/doc/evolvingsurfaces"
    "${evolvingsurfaces_debian_dir}/${name}")
endfunction ()

# _evolvingsurfaces_fill_in(NAME...): the files of CMake/Debian with values for their variables.
function (_evolvingsurfaces_fill_in)
  # The day of the release, so that the same source makes the same package.
  file(STRINGS "${CMAKE_SOURCE_DIR}/CITATION.cff" day REGEX "^date-released:")
  string(REGEX REPLACE "^date-released: *" "" day "${day}")
  execute_process(COMMAND date --utc --rfc-email "--date=${day}"
    OUTPUT_VARIABLE day OUTPUT_STRIP_TRAILING_WHITESPACE)
  # All but the title and the copyright, as Debian writes paragraphs.
  file(READ "${CMAKE_SOURCE_DIR}/LICENSE" license)
  string(REGEX REPLACE "^.*All rights reserved\\.\n\n" "" license "${license}")
  string(REPLACE "\n\n" "\n.\n" license "${license}")
  string(REGEX REPLACE "\n([^\n])" "\n \\1" license "${license}")
  foreach (name IN LISTS ARGN)
    configure_file("${CMAKE_SOURCE_DIR}/CMake/Debian/${name}.in"
      "${evolvingsurfaces_debian_dir}/${name}" @ONLY NO_SOURCE_PERMISSIONS)
  endforeach ()
endfunction ()

# What Debian asks of every package. Sets `result` to what goes beside the package's control file:
# scripts that compile the Python package and clean up after it, and what a library needs.
function (evolvingsurfaces_write_debian_files result)
  set(control postinst prerm shlibs triggers)
  _evolvingsurfaces_fill_in(changelog copyright lintian-overrides ${control})
  list(TRANSFORM control PREPEND "${evolvingsurfaces_debian_dir}/")
  set(${result} "${control}" PARENT_SCOPE)

  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/CHANGELOG.md")
  _evolvingsurfaces_install_compressed("${CMAKE_SOURCE_DIR}/CHANGELOG.md" changelog.gz)
  _evolvingsurfaces_install_compressed("${evolvingsurfaces_debian_dir}/changelog" changelog.Debian.gz)
  _evolvingsurfaces_install_debian("share/doc/evolvingsurfaces"
    "${evolvingsurfaces_debian_dir}/copyright")
  install(FILES "${evolvingsurfaces_debian_dir}/lintian-overrides"
    DESTINATION "share/lintian/overrides" RENAME evolvingsurfaces
    COMPONENT debian EXCLUDE_FROM_ALL)
  # The second package's folder of documents is that of the first, which it depends on.
  _evolvingsurfaces_link(link evolvingsurfaces-dev evolvingsurfaces)
  install(FILES "${link}" DESTINATION "share/doc" COMPONENT debian-development EXCLUDE_FROM_ALL)
endfunction ()
