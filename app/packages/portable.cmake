# How the command is linked for packages, so that one program runs on many systems:
#
#     cmake -C app/packages/portable.cmake -S . -B FOLDER
#
# Libraries of which Debian has an archive are linked in. Those of which it has none lie in lib/fixproof beside the
# command; app/packages/install.cmake copies them.
set(CMAKE_BUILD_TYPE Release CACHE STRING "")
set(CMAKE_UNITY_BUILD ON CACHE BOOL "")
set(CMAKE_UNITY_BUILD_BATCH_SIZE 24 CACHE STRING "")
set(BUILD_TESTING OFF CACHE BOOL "")
set(FIXPROOF_PORTABLE ON CACHE BOOL "Copy shared libraries that few systems have beside the installed command")
set(CMAKE_INSTALL_RPATH "\$ORIGIN/../lib/fixproof" CACHE STRING "")
# The program of the build is the one that is installed, byte for byte: the bill of materials has its digest.
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON CACHE BOOL "")
# The C++ library is that of the system, too: who has a C library as new as Debian 12 has the C++ library of g++ 12 or later.
# The older of the two kinds of paths is also followed from one library beside the command to another.
set(CMAKE_EXE_LINKER_FLAGS "-s -Wl,--disable-new-dtags" CACHE STRING "")

set(Boost_USE_STATIC_LIBS ON CACHE BOOL "")
set(OPENSSL_USE_STATIC_LIBS ON CACHE BOOL "")
set(ZLIB_USE_STATIC_LIBS ON CACHE BOOL "")
set(PNG_NAMES libpng.a CACHE STRING "")

# SDL needs the libraries of a desktop. simavr has version 3 of the GPL and Unicorn version 2, so one program that is
# passed on cannot have both. FreeType and libfixmath are only contenders of `measure host`.
set(CMAKE_DISABLE_FIND_PACKAGE_SDL2 ON CACHE BOOL "")
set(FIXPROOF_LIBRARIES OFF CACHE BOOL "")
set(FIXPROOF_SIMAVR_LIBRARY OFF CACHE STRING "")
