# The number type in one file:
#
#     cmake -D OUT=fixed.hpp -P cmake/single_header.cmake
#
# writes fixed/fixed.hpp with every header of this library in the place where it is included first.
# fixed/batch.hpp, which compiles one source again for each instruction set, is not part of it.
# fixed/format.hpp comes last and outside the include guard: including the file again after fmt gives
# fmt's formatter, as including that header again does.
cmake_minimum_required(VERSION 3.22)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
include(${root}/fixed/version.cmake)
if(NOT OUT)
  message(FATAL_ERROR "usage: cmake -D OUT=FILE -P cmake/single_header.cmake")
endif()

# read_header(HEADER RESULT): its text, without what only a file of its own needs.
function(read_header header result)
  file(READ ${root}/${header} text)
  string(REPLACE "\n#pragma once\n" "\n" text "${text}")
  set(${result} "\n// ${header}\n${text}" PARENT_SCOPE)
endfunction()

read_header(fixed/fixed.hpp text)
set(done fixed/fixed.hpp)
while(text MATCHES "\n#include \"(fixed/[a-z_/]+[.]hpp)\"")
  set(header ${CMAKE_MATCH_1})
  string(FIND "${text}" "${CMAKE_MATCH_0}" at)
  string(LENGTH "${CMAKE_MATCH_0}" length)
  math(EXPR after "${at} + ${length}")
  string(SUBSTRING "${text}" 0 ${at} before)
  string(SUBSTRING "${text}" ${after} -1 text)
  set(included "")
  if(NOT header IN_LIST done AND NOT header STREQUAL fixed/format.hpp)
    list(APPEND done ${header})
    read_header(${header} included)
  endif()
  set(text "${before}${included}${text}")
endwhile()

read_header(fixed/format.hpp format)
string(REGEX REPLACE "\n#include \"fixed/[^\n]*" "" format "${format}")
file(READ ${root}/LICENSE license)
string(STRIP "${license}" license)
string(REPLACE "\n" "\n// " license "// ${license}")
string(REPLACE "// \n" "//\n" license "${license}")
file(WRITE ${OUT} "\
// Fixproof ${fixed_version}: 16.16 and 8.8 fixed-point numbers, header-only C++20.
// Made of fixed/fixed.hpp and what it includes; change those, not this file.
//
${license}
#ifndef FIXED_SINGLE_HEADER
#define FIXED_SINGLE_HEADER
${text}
#endif  // FIXED_SINGLE_HEADER

#if __STDC_HOSTED__
${format}
#endif
")
message(STATUS "${OUT}: the number type ${fixed_version} in one file")
