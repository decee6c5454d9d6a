# How CMake builds for Linux on AArch64, with Debian's compiler and the libraries that app/packages/sysroot unpacks:
#
#     cmake --toolchain app/packages/aarch64.cmake -S . -B FOLDER
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
cmake_path(SET sysroot NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../build/sysroot)
set(CMAKE_FIND_ROOT_PATH ${sysroot})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# With its full path, by which tests/tools/sbom finds its package.
find_program(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++ REQUIRED)
# Debian keeps the headers that differ from processor to processor in a folder of their own.
include_directories(SYSTEM ${sysroot}/usr/include/aarch64-linux-gnu)
# Debian's Zydis names Zycore without its folder. An option, because CMake drops a folder that it has seen the compiler
# link with, as when it tries this toolchain.
add_link_options(-L${sysroot}/usr/lib/aarch64-linux-gnu)
# The folder of the clone must not be in the program, whose bytes are the same wherever it is built.
add_compile_options(-ffile-prefix-map=${sysroot}=)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64 -L ${sysroot})
