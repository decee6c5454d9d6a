# Sets fixproof_hardening and fixproof_hardening_link: options that make memory errors hard to exploit, as far as the
# compiler and the linker support them. For optimised builds of the command only: _FORTIFY_SOURCE needs optimisation and
# hides errors from the sanitizers.
include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)
include(CheckLinkerFlag)

set(fixproof_hardening)
foreach(flag -fPIE -fstack-protector-strong -fstack-clash-protection -fcf-protection=full -mbranch-protection=standard)
  string(MAKE_C_IDENTIFIER "FIXPROOF_HAS${flag}" has)
  check_cxx_compiler_flag(${flag} ${has})
  if(${has})
    list(APPEND fixproof_hardening ${flag})
  endif()
endforeach()

# Level 3 also checks sizes that are known only at run time. Both need glibc; elsewhere the macro does nothing.
set(CMAKE_REQUIRED_FLAGS "-O2 -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3")
check_cxx_source_compiles("#include <cstdio>
  #if __USE_FORTIFY_LEVEL != 3
  #error level 2 is the highest
  #endif
  int main() {}" FIXPROOF_HAS_FORTIFY_3)
unset(CMAKE_REQUIRED_FLAGS)
if(FIXPROOF_HAS_FORTIFY_3)
  list(APPEND fixproof_hardening -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3)
else()
  list(APPEND fixproof_hardening -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
endif()

set(fixproof_hardening_link)
foreach(flag -pie -Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)
  string(MAKE_C_IDENTIFIER "FIXPROOF_HAS${flag}" has)
  check_linker_flag(CXX ${flag} ${has})
  if(${has})
    list(APPEND fixproof_hardening_link ${flag})
  endif()
endforeach()
