# cmake -D program=PROGRAM -D prefix=PREFIX -D without=PATTERNS -D listing=FILE -P suites.cmake
# Writes CTest's list of the suites of a GoogleTest program, but for the tests that match PATTERNS (GoogleTest's, joined by
# colons). Types and parameters of a suite stay together. A case writes its results beside FILE, for count-tests.
execute_process(COMMAND ${program} --gtest_list_tests "--gtest_filter=*-${without}"
  OUTPUT_VARIABLE said RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${program} does not list its tests (${status}):\n${said}")
endif()
string(REGEX MATCHALL "(^|\n)[^ \n][^ \n]*\\." suites "${said}")
list(TRANSFORM suites STRIP)
# `Suite/0.` and `Suite/1.` are of two types.
list(TRANSFORM suites REPLACE "(/[0-9]+)?\\.$" "")
list(REMOVE_DUPLICATES suites)

get_filename_component(results ${listing} DIRECTORY)
set(lines "")
foreach(suite IN LISTS suites)
  string(REPLACE "/" "-" file "${prefix}${suite}")
  string(APPEND lines "add_test([==[${prefix}${suite}]==] [==[${program}]==] [==[--gtest_filter=${suite}.*:${suite}/*-${without}]==]"
    " [==[--gtest_output=xml:${results}/${file}.xml]==])\n")
endforeach()
file(WRITE ${listing} "${lines}")
