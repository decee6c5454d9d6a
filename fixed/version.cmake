# Sets fixed_version to what version.hpp says.
file(READ ${CMAKE_CURRENT_LIST_DIR}/version.hpp fixed_version)
if(NOT fixed_version MATCHES "MAJOR ([0-9]+)[^\n]*\n[^\n]*MINOR ([0-9]+)[^\n]*\n[^\n]*PATCH ([0-9]+)")
  message(FATAL_ERROR "fixed/version.hpp: no version found")
endif()
set(fixed_version ${CMAKE_MATCH_1}.${CMAKE_MATCH_2}.${CMAKE_MATCH_3})
