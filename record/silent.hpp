/// \file
/// The interface of record/log.hpp when recording is off. Compilers leave no code of it.
#pragma once

#include <cstdint>
#include <string_view>

namespace fixproof::record {

/// See record/log.hpp.
struct full_range {};

/// See record/log.hpp.
struct options {
  std::string_view program;
  full_range full{};
};

/// See record/log.hpp.
struct position {
  std::uint64_t records = 0;
  std::uint64_t hash = 0;
  friend bool operator==(const position&, const position&) = default;
};

/// See record/log.hpp. It opens no file.
class log {
 public:
  explicit constexpr log(std::string_view /*path*/, const options& /*how*/ = {}) noexcept {}
  ~log() {}  // NOLINT(*-equals-default): a log is no unused variable
  log(const log&) = delete;
  log(log&&) = delete;
  log& operator=(const log&) = delete;
  log& operator=(log&&) = delete;

  [[nodiscard]] static constexpr bool good() noexcept { return true; }
  static constexpr void frame(std::int64_t /*number*/) noexcept {}
  static constexpr void mark(std::string_view /*name*/) noexcept {}
  static constexpr void confirm(std::int64_t /*number*/) noexcept {}
  static constexpr void flush() noexcept {}
  [[nodiscard]] static constexpr position where() noexcept { return {}; }
};

constexpr void frame(std::int64_t /*number*/) noexcept {}
constexpr void mark(std::string_view /*name*/) noexcept {}
constexpr void confirm(std::int64_t /*number*/) noexcept {}
constexpr void flush() noexcept {}
constexpr position where() noexcept { return {}; }

}  // namespace fixproof::record
