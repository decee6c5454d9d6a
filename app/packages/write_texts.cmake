# Writes the manual pages and the completions of the command RUN (an emulator may come before it) into FOLDER. Nothing of
# an earlier run stays there.
file(REMOVE_RECURSE ${FOLDER})

# write(FILE ARGUMENT...): what the command prints. Sets `said`.
macro(write file)
  execute_process(COMMAND ${RUN} ${ARGN} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${FOLDER}/${file} "${said}")
endmacro()

write(bash-completion/completions/fixproof completion bash)
write(zsh/site-functions/_fixproof completion zsh)
write(fish/vendor_completions.d/fixproof.fish completion fish)
# The last heading of the first page names the page of each command.
write(man1/fixproof.1 manual)
string(REGEX MATCHALL "fixproof\\\\-[a-z]+ \\(1\\)" pages "${said}")
if(NOT pages)
  message(FATAL_ERROR "fixproof manual names no page of a command")
endif()
foreach(page IN LISTS pages)
  string(REGEX REPLACE ".*-([a-z]+) .*" "\\1" command ${page})
  write(man1/fixproof-${command}.1 manual ${command})
endforeach()
