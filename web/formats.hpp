/// @file
/// The type in every format that fixed/formats.hpp names, as functions of words.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cases/format.hpp"
#include "fixed/policy.hpp"

namespace fixproof::web {

/// Operations in the order of their numbers in requests.
enum class Operation : std::uint8_t { add, sub, mul, div, sqrt };
inline constexpr std::array<std::string_view, 5> operation_names{"add", "sub", "mul", "div",
                                                                 "sqrt"};
std::optional<Operation> operation_named(std::string_view name);

/// Rules of rounding, the type's own first.
inline constexpr std::array rules{rounding::half_up, rounding::half_away, rounding::half_even,
                                  rounding::floor, rounding::truncate};
inline constexpr std::array<std::string_view, 5> rule_names{
    "half up", "half away from zero", "half to even", "down (floor)", "toward zero"};

/// The number nearest to a decimal text.
struct Reading {
  bool is_number = false;
  std::optional<std::uint64_t> word{};  ///< empty if out of range
};

struct NumberFormat {
  using Answer = std::optional<std::uint64_t> (*)(Operation, std::uint64_t, std::uint64_t);

  cases::Format format{};
  Reading (*read)(std::string_view text) = nullptr;
  std::string (*write)(std::uint64_t word) = nullptr;
  /// By each of `rules`, wrapped; empty for a zero divisor.
  std::array<Answer, rules.size()> answer{};
  Answer saturated = nullptr;  ///< by the first rule
};

/// All formats, narrow words first.
std::span<const NumberFormat> formats();
/// Null for any name that is not one of formats().
const NumberFormat* format_named(std::string_view name);
/// `q16_16`.
std::string format_name(const cases::Format& format);

}  // namespace fixproof::web
