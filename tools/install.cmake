# What users get: programs, the OpenImageIO module, manual pages, completions, docs, scenes; and the
# Debian package of it (cpack -G DEB in the build folder; tools/package.sh does all).
#   cmake --install build/release --prefix X
include(GNUInstallDirs)

set(LENTRAY_MODULES lib/lentray)  # a folder of the package's own: no multiarch
# Programs of the build tree find the module beside themselves, installed ones along this path.
# CMake pads a path of the build tree with colons, and an empty part of it is the current folder: a scene's.
set_target_properties(${LENTRAY_PROGRAMS} PROPERTIES INSTALL_RPATH "$ORIGIN/../${LENTRAY_MODULES}" BUILD_WITH_INSTALL_RPATH ON)
install(TARGETS ${LENTRAY_PROGRAMS} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS lentray_openimageio LIBRARY DESTINATION ${LENTRAY_MODULES})

# Manual pages and completions are made of what the programs' --help says.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(manual_tool ${CMAKE_SOURCE_DIR}/tools/manual.py)
set(manual_folder ${CMAKE_BINARY_DIR}/share)
file(MAKE_DIRECTORY ${manual_folder})
set(manual_files)
set(program_files)
foreach(program ${LENTRAY_PROGRAMS})
  list(APPEND program_files $<TARGET_FILE:${program}>)
  add_custom_command(OUTPUT ${manual_folder}/${program}.1.gz
    COMMAND Python3::Interpreter ${manual_tool} man $<TARGET_FILE:${program}> ${PROJECT_VERSION}
      ${manual_folder}/${program}.1.gz ${LENTRAY_PROGRAMS}
    DEPENDS ${program} ${manual_tool} VERBATIM)
  list(APPEND manual_files ${manual_folder}/${program}.1.gz)
endforeach()
foreach(shell bash zsh)
  add_custom_command(OUTPUT ${manual_folder}/completion.${shell}
    COMMAND Python3::Interpreter ${manual_tool} ${shell} ${manual_folder}/completion.${shell} ${program_files}
    DEPENDS ${LENTRAY_PROGRAMS} ${manual_tool} VERBATIM)
endforeach()
add_custom_target(manual ALL
  DEPENDS ${manual_files} ${manual_folder}/completion.bash ${manual_folder}/completion.zsh
    ${manual_folder}/changelog.gz)
install(FILES ${manual_files} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
# bash looks for a file of the program's name.
foreach(program ${LENTRAY_PROGRAMS})
  install(FILES ${manual_folder}/completion.bash RENAME ${program}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endforeach()
install(FILES ${manual_folder}/completion.zsh RENAME _lentray
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)

set(documents ${CMAKE_INSTALL_DATADIR}/doc/lentray)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${documents})
install(DIRECTORY docs/ DESTINATION ${documents}/docs)
install(DIRECTORY scenes/ DESTINATION ${documents}/examples)
install(DIRECTORY tools/service/ DESTINATION ${documents}/service)  # examples too: docs/service.md

# What Debian's policy asks of every package.
string(TIMESTAMP package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT ${manual_folder}/copyright CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: lentray

Files: *
Copyright: 2026 The Lentray project
License: Apache-2.0
 On Debian systems the text of this license is in /usr/share/common-licenses/Apache-2.0.
")
file(CONFIGURE OUTPUT ${manual_folder}/changelog CONTENT
"lentray (${PROJECT_VERSION}) unstable; urgency=medium

  * What is new: /usr/share/doc/lentray/CHANGELOG.md

 -- The Lentray project <lentray@localhost>  ${package_date}
")
find_program(GZIP gzip REQUIRED)
add_custom_command(OUTPUT ${manual_folder}/changelog.gz
  COMMAND ${GZIP} -9nkf ${manual_folder}/changelog DEPENDS ${manual_folder}/changelog VERBATIM)
install(FILES ${manual_folder}/copyright ${manual_folder}/changelog.gz DESTINATION ${documents})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lentray)
set(CPACK_PACKAGE_CONTACT "The Lentray project <lentray@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "renderer of POV-Ray scenes and of integral images for lens sheets")
set(CPACK_PACKAGE_DESCRIPTION "Lentray reads POV-Ray's scenes and takes its options, renders them faster,
and renders them as integral images for lenticular sheets too. lentray-diff
holds the pictures against those of POV-Ray.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS povray-includes)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "povray, gnuplot-nox | gnuplot, libjxl-devtools")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
