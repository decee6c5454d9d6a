# cmake -D program=PROGRAM -D prefix=PREFIX -D without=PATTERNS -D listing=FILE -P suites.cmake
# Writes CTest's list of the suites of a GoogleTest program, but for the tests that match PATTERNS (GoogleTest's, joined by
# colons). Types and parameters of a suite stay together. A case writes its results beside FILE, for count-tests.
execute_process(COMMAND ${program} --gtest_list_tests "--gtest_filter=*-${without}"
  OUTPUT_VARIABLE said RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${program} does not list its tests (${status}):\n${said}")
endif()
string(REGEX MATCHALL "(^|\n)[^ \n][^ \n]*\\." suites "${said}")
if(NOT suites)
  message(FATAL_ERROR "${program} lists no tests")
endif()

set(names "")
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  # `Suite/0.` and `Suite/1.` are of two types.
  string(REGEX REPLACE "(/[0-9]+)?\\.$" "" name "${suite}")
  list(APPEND names ${name})
  list(APPEND filter_of_${name} ${suite}*)
endforeach()
list(REMOVE_DUPLICATES names)

get_filename_component(results ${listing} DIRECTORY)
set(lines "")
foreach(name IN LISTS names)
  string(REPLACE "/" "-" file "${prefix}${name}")
  list(JOIN filter_of_${name} ":" filter)
  string(APPEND lines "add_test([==[${prefix}${name}]==] [==[${program}]==] [==[--gtest_filter=${filter}-${without}]==]"
    " [==[--gtest_output=xml:${results}/${file}.xml]==])\n"
    "set_tests_properties([==[${prefix}${name}]==] PROPERTIES TIMEOUT 3600)\n")
endforeach()
file(WRITE ${listing} "${lines}")
