# The library in one file, without comments:
#
#     cmake -D OUT=fixed.hpp -P fixed/single_header.cmake
#
# The file has three parts:
#   1. fixed/fixed.hpp with every header of this library in the place where it is included first, but those of functions
#      of real numbers, which would make the file half as large again: with `-D FUNCTIONS=ON` it has them;
#   2. fixed/std_format.hpp, outside the include guard: including the file again after fmt adds fmt's
#      formatter, as including that header again does;
#   3. fixed/batch/batch.hpp, fixed/batch/radian.hpp and fixed/batch/conversions.hpp, if FIXED_BATCH is defined. Their
#      vector code is compiled once for each instruction set, so it comes first and the file
#      includes itself.
cmake_minimum_required(VERSION 3.22)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)
include(${root}/fixed/version.cmake)
if(NOT OUT)
  message(FATAL_ERROR "usage: cmake -D OUT=FILE [-D FUNCTIONS=ON] -P fixed/single_header.cmake")
endif()
get_filename_component(own_name ${OUT} NAME)

# The standard headers of a program without a run-time library. The file includes them once, first.
set(standard_headers array bit cfloat compare concepts cstddef cstdint limits numbers optional
    type_traits utility)
list(TRANSFORM standard_headers REPLACE ".+" "#include <\\0>\n" OUTPUT_VARIABLE standard_includes)
list(JOIN standard_includes "" standard_includes)
list(JOIN standard_headers "|" standard_header)

# read_header(HEADER RESULT): its text. It drops comments, `#pragma once`, the includes of standard_headers, and spaces
# that only indent or align. Before the first string of a line, it drops the space after a comma or semicolon, and those
# around an operator, and around a = or == that follows a name, ) or ]; after > they stay, because >= is another token. It
# drops the space before {, before a return or a } on the same line, and after if, for and while. To a line that ends with
# (, a comma, an operator or template <...>, it appends the next line. It appends a line that begins with : or ? to the
# line before. It puts a block of one statement on one line. It moves any other indented closing brace to the end of the
# line before.
function(read_header header result)
  file(READ ${root}/${header} text)
  string(REGEX REPLACE "}  // namespace (fixproof|fixproof::detail|fixproof::detail::FIXED_LANES)\n" "}@\\1@\n" text
         "${text}")
  string(REGEX REPLACE " *//[^\n]*| */[*][^*\n]*[*]/" "" text "\n${text}")
  string(REGEX REPLACE "\n\n+" "\n" text "${text}")
  string(REGEX REPLACE "([^ \n])  +" "\\1 " text "${text}")
  string(REGEX REPLACE "([(])\n +" "\\1" text "${text}")
  string(REGEX REPLACE "(,|&&| [=+|&?:</-])\n +" "\\1 " text "${text}")
  string(REGEX REPLACE "\n +([:?] )" " \\1" text "${text}")
  string(REGEX REPLACE "{\n +([^\n#{}]+;)\n *}" "{ \\1 }" text "${text}")
  while(text MATCHES "[;}]\n +}\n")
    string(REGEX REPLACE "([;}])\n +}\n" "\\1 }\n" text "${text}")
  endwhile()
  string(REGEX REPLACE "(\n +template <[^\n]+>)\n +" "\\1 " text "${text}")
  string(REGEX REPLACE "\n +" "\n" text "${text}")
  while(text MATCHES "\n[^#\"\n][^\"\n]*[,;] ")
    string(REGEX REPLACE "(\n[^#\"\n][^\"\n]*[,;]) " "\\1" text "${text}")
  endwhile()
  while(text MATCHES "\n[^#\"\n][^\"\n]*[]A-Za-z0-9_)] ==? ")
    string(REGEX REPLACE "(\n[^#\"\n][^\"\n]*[]A-Za-z0-9_)]) (==?) " "\\1\\2" text "${text}")
  endwhile()
  while(text MATCHES "\n[^#\"\n][^\"\n]* (!=|&&|[|][|]|<<|[-+*?:|&]) ")
    string(REGEX REPLACE "(\n[^#\"\n][^\"\n]*) (!=|&&|[|][|]|<<|[-+*?:|&]) " "\\1\\2" text "${text}")
  endwhile()
  string(REPLACE "template <" "template<" text "${text}")
  string(REPLACE " {" "{" text "${text}")
  string(REPLACE "{ return " "{return " text "${text}")
  string(REPLACE "; }" ";}" text "${text}")
  foreach(keyword "if constexpr" if for while)
    string(REPLACE "${keyword} (" "${keyword}(" text "${text}")
  endforeach()
  string(REPLACE "\n#pragma once\n" "\n" text "${text}")
  string(REGEX REPLACE "\n#include <(${standard_header})>" "" text "${text}")
  string(REGEX REPLACE "\n$" "" text "${text}")
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# expand(TEXT RESULT): the text with the headers that it includes and `done` does not have.
set(done fixed/std_format.hpp)
if(NOT FUNCTIONS)
  list(APPEND done fixed/angle.hpp fixed/exponential.hpp fixed/power.hpp fixed/results.hpp fixed/trigonometry.hpp)
endif()
# A function, because a macro would evaluate the backslashes of the text again.
function(expand start result)
  set(text "${start}")
  while(text MATCHES "\n#include \"(fixed/[a-z_/]+[.]hpp)\"")
    set(header ${CMAKE_MATCH_1})
    string(FIND "${text}" "${CMAKE_MATCH_0}" at)
    string(LENGTH "${CMAKE_MATCH_0}" length)
    math(EXPR after "${at} + ${length}")
    string(SUBSTRING "${text}" 0 ${at} before)
    string(SUBSTRING "${text}" ${after} -1 text)
    set(included "")
    if(NOT header IN_LIST done)
      list(APPEND done ${header})
      read_header(${header} included)
    endif()
    set(text "${before}${included}${text}")
  endwhile()
  set(done "${done}" PARENT_SCOPE)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

set(parts fixed/batch/detail/parts.hpp)
set(start "\n#include \"fixed/fixed.hpp\"")
if(FUNCTIONS)
  # First, because FIXED_SMALL chooses among the headers that include these, and every choice needs them.
  foreach(header arcsine arctangent exponential hyperbolic phase power)
    string(PREPEND start "\n#include \"fixed/detail/${header}.hpp\"")
  endforeach()
endif()
expand("${start}" number)
read_header(fixed/std_format.hpp format)
string(REGEX REPLACE "\n#include \"fixed/[^\n]*" "" format "${format}")
read_header(${parts} lanes)
expand("${lanes}" lanes)
read_header(fixed/batch/detail/targets.hpp targets)
string(REPLACE "#include \"${parts}\"" "#include \"${own_name}\"" targets "${targets}")
list(APPEND done fixed/batch/detail/targets.hpp)
expand("${targets}" targets)
expand("\n#include \"fixed/batch/batch.hpp\"\n#include \"fixed/batch/radian.hpp\"\n#include \"fixed/batch/conversions.hpp\"" batch)

file(READ ${root}/LICENSE license)
string(STRIP "${license}" license)
string(REPLACE "\n" "\n// " license "// ${license}")
string(REPLACE "// \n" "//\n" license "${license}")
set(text "\
// Fixproof ${fixed_version}: fixed-point numbers, header-only C++20.
// Made of the headers in fixed/ and fixed/batch/, whose comments document everything; change those, not this file.
// #define FIXED_BATCH before including this file to have the operations over spans, too. They need
// the file under its own name, ${own_name}.
//
${license}
#if defined(FIXED_LANES)
${lanes}
#else

#ifndef FIXED_SINGLE_HEADER
#define FIXED_SINGLE_HEADER
${standard_includes}${number}
#endif  // FIXED_SINGLE_HEADER

#if __STDC_HOSTED__
${format}
#endif

#if defined(FIXED_BATCH) && !defined(FIXED_SINGLE_HEADER_BATCH)
#define FIXED_SINGLE_HEADER_BATCH
${targets}${batch}
#endif  // FIXED_BATCH

#endif  // FIXED_LANES
")
# Shorter names for macros: tests/fixed/import/single_header limits the size.
foreach(pair "LANE_FUNCTION FN" "LANE_BYTES BYTES" "ALWAYS_INLINE HOT" "INLINE_UNOPTIMISED HOT0" "REFUSED_OPERATOR NO_OP"
    "REFUSED NO" "LITERAL LIT" "INSTEAD USE" "SURE_OF_AVX512 SURE")
  string(REPLACE " " ";FIXED_" pair "FIXED_${pair}")
  list(GET pair 0 long)
  list(GET pair 1 short)
  string(REPLACE ${long} ${short} text "${text}")
endforeach()
# Joins namespaces that one header closes and the next opens again. A name between @ marks where a header closes one.
# Headers of vector code are each a namespace in an #if.
set(open_lanes "#if defined(FIXED_LANES)\nnamespace fixproof::detail::FIXED_LANES{\n")
string(REPLACE "}@fixproof::detail::FIXED_LANES@\n#endif\n${open_lanes}" "" text "${text}")
foreach(name fixproof fixproof::detail fixproof::detail::FIXED_LANES)
  string(REGEX REPLACE "}@${name}@\n+namespace ${name}{\n" "" text "${text}")
  string(REPLACE "}@${name}@" "}" text "${text}")
endforeach()
file(WRITE ${OUT} "${text}")
message(STATUS "${OUT}: the library ${fixed_version} in one file")
