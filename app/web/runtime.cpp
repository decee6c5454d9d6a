// Functions that Debian's libraries for WebAssembly need and do not have.
#include <cstddef>
#include <cstdint>

// NOLINTBEGIN(bugprone-reserved-identifier): the names are the compiler's
extern "C" {

// Debian compiles the compiler's runtime library with stack protectors.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
std::uintptr_t __stack_chk_guard = 0x2F8A61C3;
[[noreturn]] void __stack_chk_fail() { __builtin_trap(); }

// The C++ library has no exceptions, and no request of the page should lead to one. A throw ends
// the module, and the page says so.
void* __cxa_allocate_exception(std::size_t /*size*/) { __builtin_trap(); }
[[noreturn]] void __cxa_throw(void* /*thrown*/, void* /*type*/, void (* /*destroy*/)(void*)) {
  __builtin_trap();
}
}
// NOLINTEND(bugprone-reserved-identifier)
