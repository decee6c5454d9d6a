/// @file
/// What the emulators of all processors share: Unicorn's engine, its hooks and its memory.
#pragma once

#include <fmt/format.h>
#include <unicorn/unicorn.h>

#include <algorithm>
#include <boost/noncopyable.hpp>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

#include "judge/code/image.hpp"
#include "verify/machine_code/emulator.hpp"

namespace fixproof::judge {

inline constexpr std::size_t page_bytes = 0x1000;

/// @throws machine_code::EmulatorError
inline void check(uc_err error, const char* what) {
  if (error == UC_ERR_OK) return;
  throw machine_code::EmulatorError(fmt::format("Unicorn: {}: {}", what, uc_strerror(error)));
}

/// A copy of an image's memory in whole pages.
class MappedMemory {
 public:
  explicit MappedMemory(const Image& image)
      : size_((image.memory.size() + page_bytes - 1) / page_bytes * page_bytes),
        bytes_(static_cast<std::uint8_t*>(std::aligned_alloc(page_bytes, size_))) {
    if (!bytes_) throw std::bad_alloc();
    std::fill_n(bytes_.get(), size_, std::uint8_t{0});
    std::copy(image.memory.begin(), image.memory.end(), bytes_.get());
  }
  [[nodiscard]] std::uint8_t* bytes() const { return bytes_.get(); }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  struct Free {
    // NOLINTNEXTLINE(*-no-malloc,*-owning-memory): the memory is std::aligned_alloc()'s
    void operator()(std::uint8_t* memory) const { std::free(memory); }
  };
  std::size_t size_;
  std::unique_ptr<std::uint8_t, Free> bytes_;
};

class Engine : private boost::noncopyable {
 public:
  Engine(uc_arch processor, uc_mode mode) { check(uc_open(processor, mode, &engine_), "open"); }
  ~Engine() {
    if (fresh_ != nullptr) uc_context_free(fresh_);
    if (engine_ != nullptr) uc_close(engine_);
  }

  [[nodiscard]] uc_engine* get() const { return engine_; }

  /// Keeps the state of all registers for restore_state().
  void keep_state() {
    check(uc_context_alloc(engine_, &fresh_), "context");
    check(uc_context_save(engine_, fresh_), "context");
  }
  void restore_state() { check(uc_context_restore(engine_, fresh_), "context"); }

  /// @param first, last the addresses that the hook is for; 1 and 0 for all
  template <class Function, class... More>
  void hook(int kind, Function* function, void* data, std::uint64_t first, std::uint64_t last,
            More... more) {
    uc_hook hook = 0;
    // Unicorn takes hooks as void*, and only a reinterpret_cast converts a function to one.
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): see above
    auto* const address = reinterpret_cast<void*>(function);
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the only function there is
    check(uc_hook_add(engine_, &hook, kind, address, data, first, last, more...), "hook");
  }

 private:
  uc_engine* engine_ = nullptr;
  uc_context* fresh_ = nullptr;
};

}  // namespace fixproof::judge
