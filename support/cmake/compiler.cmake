# What every target of this tree is compiled with. Users of fixed/ get none of it.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

option(FIXPROOF_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)

add_library(fixproof_compile_options INTERFACE)
target_compile_options(fixproof_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast
  -Wcast-align -Wcast-qual -Wformat=2 -Wnon-virtual-dtor -Woverloaded-virtual
  -Wnull-dereference -Wdouble-promotion -Wimplicit-fallthrough -Wundef
  # A later compiler's warnings are no business of a project that Fixproof is a part of.
  $<$<BOOL:${PROJECT_IS_TOP_LEVEL}>:-Werror>
  $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond -Wduplicated-branches -Wlogical-op -Wuseless-cast>)
if(FIXPROOF_SANITIZE)
  # -O1: instrumented code that is optimised further takes many times longer to compile than to run.
  add_compile_options(-O1 -gline-tables-only -fsanitize=address,undefined -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  # The bounds that make a conversion exact (fixed/detail/assert.hpp).
  add_compile_definitions(FIXED_ASSERTIONS)
  add_link_options(-fsanitize=address,undefined)
elseif(FIXPROOF_TOOLS)
  include(${CMAKE_CURRENT_LIST_DIR}/hardening.cmake)
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # In kB. g++ collects garbage less often, and takes 6 % less time or better.
  add_compile_options(--param=ggc-min-heapsize=524288)
endif()

# For tests and for code that reads options and prints: half of the time to compile at -O3.
set(quick $<$<CONFIG:Release>:-Og>)

# fixproof_target(NAME): the strict warnings, the hardening, and includes written from the repository root.
function(fixproof_target name)
  target_link_libraries(${name} PRIVATE fixproof_compile_options)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  set(optimised "$<CONFIG:Release,RelWithDebInfo,MinSizeRel>")
  target_compile_options(${name} PRIVATE "$<${optimised}:${fixproof_hardening}>")
  get_target_property(type ${name} TYPE)
  if(type STREQUAL "EXECUTABLE")
    target_link_options(${name} PRIVATE "$<${optimised}:${fixproof_hardening_link}>")
  endif()
endfunction()
