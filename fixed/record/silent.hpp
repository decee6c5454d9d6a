/// @file
/// The interface of fixed/record/log.hpp when recording is off. Compilers leave no code of it.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace fixproof::record {

/// See fixed/record/options.hpp. The range is always empty.
struct full_range {
  bool is_of_frames = false;
  std::int64_t first = 0;
  std::int64_t last = -1;

  [[nodiscard]] static constexpr full_range from_text(std::string_view /*text*/) noexcept {
    return {};
  }
  [[nodiscard]] std::string to_text() const { return "nothing"; }
};

/// See fixed/record/options.hpp. It does not read the environment.
struct options {
  std::string_view program = "unnamed";
  full_range full{};

  [[nodiscard]] static constexpr full_range from_environment() noexcept { return {}; }
};

/// See fixed/record/log.hpp.
struct position {
  std::uint64_t records = 0;
  std::uint64_t hash = 0;
  friend bool operator==(const position&, const position&) = default;
};

/// See fixed/record/log.hpp. It opens no file.
class log {
 public:
  explicit constexpr log(const std::convertible_to<std::string> auto& /*path*/,
                         const options& /*how*/ = {}) noexcept {}
  ~log() {}  // NOLINT(*-equals-default): a log is no unused variable
  log(const log&) = delete;
  log(log&&) = delete;
  log& operator=(const log&) = delete;
  log& operator=(log&&) = delete;

  [[nodiscard]] static constexpr bool good() noexcept { return true; }
  [[nodiscard]] static constexpr const char* problem() noexcept { return ""; }
};

constexpr void frame(std::int64_t /*number*/) noexcept {}
constexpr void mark(std::string_view /*name*/) noexcept {}
constexpr void confirm(std::int64_t /*number*/) noexcept {}
constexpr void flush() noexcept {}
constexpr position where() noexcept { return {}; }

}  // namespace fixproof::record
