// A library that stands before Unicorn (LD_PRELOAD) and makes a function of it fail.
// FAIL=FUNCTION makes every call of that function fail for lack of memory, FAIL=FUNCTION:N all but
// the first N calls.
#include <dlfcn.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

constexpr int no_memory = 1;  // UC_ERR_NOMEM

bool fails(std::string_view function) {
  static std::atomic<unsigned long> calls = 0;
  const char* const wanted = std::getenv("FAIL");
  if (wanted == nullptr) return false;
  const std::string_view text = wanted;
  const std::size_t colon = text.find(':');
  if (text.substr(0, colon) != function) return false;
  const unsigned long before =
      colon == std::string_view::npos ? 0 : std::stoul(std::string(text.substr(colon + 1)));
  return calls++ >= before;
}

/// The function of the same name in the library behind this one.
template <class Function>
Function* behind(const char* name) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): what dlsym() is for
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int uc_open(int architecture, int mode, void** engine) {
  return fails("uc_open") ? no_memory
                          : behind<int(int, int, void**)>("uc_open")(architecture, mode, engine);
}

int uc_mem_map_ptr(void* engine, std::uint64_t address, std::size_t size, std::uint32_t rights,
                   void* memory) {
  if (fails("uc_mem_map_ptr")) return no_memory;
  return behind<int(void*, std::uint64_t, std::size_t, std::uint32_t, void*)>("uc_mem_map_ptr")(
      engine, address, size, rights, memory);
}

int uc_emu_start(void* engine, std::uint64_t begin, std::uint64_t until, std::uint64_t timeout,
                 std::size_t count) {
  if (fails("uc_emu_start")) return no_memory;
  return behind<int(void*, std::uint64_t, std::uint64_t, std::uint64_t, std::size_t)>(
      "uc_emu_start")(engine, begin, until, timeout, count);
}

}  // extern "C"
