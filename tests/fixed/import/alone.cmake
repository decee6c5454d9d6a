# A toolchain file under which only the number type can be found: whoever asks for another package fails.
include_guard(GLOBAL)
macro(find_package name)
  if(NOT ${name} MATCHES "^(fixproof|Git)$")  # Git: what FetchContent clones with
    message(FATAL_ERROR "find_package(${name}): the number type needs a compiler and nothing else")
  endif()
  _find_package(${ARGV})
endmacro()
