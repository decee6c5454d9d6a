/// @file
/// The type in every format that fixed/formats.hpp names, as functions on words.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fixed/policy.hpp"
#include "verify/cases/format.hpp"

namespace fixproof::web {

/// The operations, in the order of `operation_names`.
enum class Operation : std::uint8_t { add, sub, mul, div, sqrt };
inline constexpr std::array<std::string_view, 5> operation_names{"add", "sub", "mul", "div",
                                                                 "sqrt"};
std::optional<Operation> operation_named(std::string_view name);

/// The rounding rules, with the type's default first.
inline constexpr std::array rules{rounding::half_up, rounding::half_away, rounding::half_even,
                                  rounding::floor,   rounding::ceiling,   rounding::truncate};
inline constexpr std::array<std::string_view, rules.size()> rule_names{
    "half up",      "half away from zero", "half to even",
    "down (floor)", "up (ceiling)",        "toward zero"};

/// What a format reads from a decimal text.
struct Reading {
  bool is_number = false;
  std::optional<std::uint64_t> word{};  ///< the nearest number; none if out of range
};

struct NumberFormat {
  using Answer = std::optional<std::uint64_t> (*)(Operation, std::uint64_t, std::uint64_t);

  cases::Format format{};
  Reading (*read)(std::string_view text) = nullptr;
  std::string (*write)(std::uint64_t word) = nullptr;
  /// One for each of `rules`. Results wrap; a zero divisor gives none.
  std::array<Answer, rules.size()> answer{};
  Answer saturated = nullptr;  ///< by the first rule, and saturating
};

/// Returns all formats, narrow words first.
std::span<const NumberFormat> formats();
/// Returns the format with a name, or null if formats() does not have it.
const NumberFormat* format_named(std::string_view name);
/// Returns the name of a format, such as `q16_16`.
std::string format_name(const cases::Format& format);

}  // namespace fixproof::web
