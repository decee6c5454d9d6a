# Writes OUTPUT, the source with the commit of FOLDER. GIT is the program git, or empty.
set(commit unknown)
if(GIT)
  execute_process(COMMAND ${GIT} rev-parse --show-toplevel HEAD WORKING_DIRECTORY ${FOLDER}
    OUTPUT_VARIABLE said RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  # A copy of the tree inside the repository of another project has no commit.
  if(status EQUAL 0 AND said MATCHES "^(.*)\n([0-9a-f]+)$")
    set(hash ${CMAKE_MATCH_2})
    get_filename_component(top "${CMAKE_MATCH_1}" REALPATH)
    get_filename_component(folder ${FOLDER} REALPATH)
    if(top STREQUAL folder)
      # Files that git does not track cannot be part of the build unless a file that it tracks changes too.
      execute_process(COMMAND ${GIT} --no-optional-locks status --porcelain --untracked-files=no
        WORKING_DIRECTORY ${FOLDER} OUTPUT_VARIABLE changes RESULT_VARIABLE status ERROR_QUIET)
      set(commit ${hash})
      if(changes OR NOT status EQUAL 0)
        string(APPEND commit " with changes")
      endif()
    endif()
  endif()
endif()

set(text "#include \"support/build_info/build_info.hpp\"

namespace fixproof::support {

std::string_view source_commit() { return \"${commit}\"; }

}  // namespace fixproof::support
")
set(before "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT before STREQUAL text)
  file(WRITE ${OUTPUT} "${text}")
endif()
