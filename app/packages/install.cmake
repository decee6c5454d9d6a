# What `cmake --install` copies where the command is built: the command, its manual pages and its completions.
# fixed/install.cmake copies the headers.
include(GNUInstallDirs)
install(TARGETS fixproof)

# The command writes its own texts when it is installed. A processor of another kind has an emulator.
set(texts ${CMAKE_CURRENT_BINARY_DIR}/texts)
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" -D \"RUN=${CMAKE_CROSSCOMPILING_EMULATOR};$<TARGET_FILE:fixproof>\"
  -D \"FOLDER=${texts}\" -P \"${CMAKE_CURRENT_LIST_DIR}/write_texts.cmake\" COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY ${texts}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
foreach(place bash-completion/completions zsh/site-functions fish/vendor_completions.d)
  install(DIRECTORY ${texts}/${place}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/${place})
endforeach()

option(FIXPROOF_PORTABLE "Copy shared libraries that few systems have beside the installed command" OFF)
if(FIXPROOF_PORTABLE)
  foreach(library IN ITEMS fmt::fmt tinyobjloader::tinyobjloader_double Zycore::Zycore Zydis::Zydis)
    install(FILES $<TARGET_FILE:${library}> DESTINATION lib/fixproof RENAME $<TARGET_SONAME_FILE_NAME:${library}>)
  endforeach()
  if(FIXPROOF_UNICORN)
    file(REAL_PATH ${FIXPROOF_UNICORN_LIBRARY} unicorn)
    install(FILES ${unicorn} DESTINATION lib/fixproof)
  endif()
endif()
