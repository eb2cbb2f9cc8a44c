# What man and the shells know of the programs: manual pages and completion scripts, which the
# program itself writes.
set(manuals "${PROJECT_BINARY_DIR}/man/man1")
set(completions "${PROJECT_BINARY_DIR}/completions")
set(checkdesign_page "${PROJECT_SOURCE_DIR}/apps/checkdesign/checkdesign.1")
add_custom_command(OUTPUT "${PROJECT_BINARY_DIR}/man/made"
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${manuals}" "${completions}"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${manuals}" "${completions}"
  COMMAND changeover manual --into "${manuals}"
  COMMAND "${CMAKE_COMMAND}" -E copy "${checkdesign_page}" "${manuals}"
  COMMAND changeover completion bash --output "${completions}/changeover"
  COMMAND changeover completion zsh --output "${completions}/_changeover"
  COMMAND changeover completion fish --output "${completions}/changeover.fish"
  COMMAND "${CMAKE_COMMAND}" -E touch "${PROJECT_BINARY_DIR}/man/made"
  DEPENDS changeover "${checkdesign_page}"
  COMMENT "Writing manual pages and completions" VERBATIM)
add_custom_target(changeover_manuals ALL DEPENDS "${PROJECT_BINARY_DIR}/man/made")

if(NOT CHANGEOVER_INSTALL)
  return()
endif()
install(DIRECTORY "${manuals}" DESTINATION "${CMAKE_INSTALL_MANDIR}")
install(FILES "${completions}/changeover" DESTINATION
  "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
install(FILES "${completions}/changeover.fish"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
# Below usr Debian's zsh looks into a separate folder; elsewhere all look into the other one. The
# prefix is known when it is installed: packages are made of a build for another.
set(zsh_script "${completions}/_changeover")
set(zsh_folder "\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/zsh")
install(CODE "
  set(zsh_folder \"${zsh_folder}/site-functions\")
  if(CMAKE_INSTALL_PREFIX MATCHES \"/usr$\" AND EXISTS \"/etc/debian_version\")
    set(zsh_folder \"${zsh_folder}/vendor-completions\")
  endif()
  file(INSTALL DESTINATION \"\${zsh_folder}\" TYPE FILE FILES \"${zsh_script}\")")
