#include "judge/type/number_type.hpp"

#include <fmt/format.h>

#include <array>

namespace fixproof::judge {

namespace {

using oracle::Rounding;

/// As fixed/policy.hpp spells it.
std::string_view cpp_name(Rounding rounding) {
  switch (rounding) {
    case Rounding::half_up:
      return "half_up";
    case Rounding::half_away:
      return "half_away";
    case Rounding::half_even:
      return "half_even";
    case Rounding::floor:
      return "floor";
    case Rounding::ceiling:
      return "ceiling";
    default:
      return "truncate";
  }
}

}  // namespace

check::Rules NumberType::rules(cases::Operation operation) const {
  const bool divides = operation == cases::Operation::div;
  check::Rules rules{.variant = cases::variant_of(operation, format),
                     .rounding = divides ? quotients : products};
  rules.overflow = range == Range::saturate ? check::Overflow::saturate
                   : range == Range::trap || (divides && refuses_quotients) ? check::Overflow::error
                                                                            : check::Overflow::wrap;
  rules.no_result =
      range == Range::trap || refuses_zero ? check::NoResult::error : check::NoResult::saturate;
  return rules;
}

std::string_view name_of(Range range) {
  return range == Range::wrap ? "wrap" : range == Range::saturate ? "saturate" : "trap";
}

std::span<const cases::Format> proven_formats() {
  static const std::array<cases::Format, 6> formats{
      {{32, 16}, {16, 8}, {32, 30}, {32, 8}, {32, 16, false}, {64, 32}}};
  return formats;
}

std::span<const Rounding> type_roundings() {
  static constexpr std::array all{Rounding::half_up, Rounding::half_away, Rounding::half_even,
                                  Rounding::floor,   Rounding::truncate,  Rounding::ceiling};
  return all;
}

NumberType number_type(const cases::Format& format, Rounding rounding, Range range) {
  const std::string name = cases::name_of(format);
  return {.name = fmt::format("{}, {}, {}", name, check::name_of(rounding), name_of(range)),
          .cpp = fmt::format("with_policy<{0}, policy{{.multiply = rounding::{1}, .divide = "
                             "rounding::{1}, .range = overflow::{2}}}>",
                             name, cpp_name(rounding), name_of(range)),
          .format = format,
          .products = rounding,
          .quotients = rounding,
          .range = range};
}

std::vector<NumberType> build_types() {
  struct Row {
    const char* name;
    Rounding products;
    Rounding quotients;
  };
  std::vector<NumberType> all;
  const auto add = [&](const Row& row, const NumberType& rest) {
    NumberType type = rest;
    type.name = fmt::format("q16_16, {}", row.name);
    type.cpp = fmt::format("with_policy<q16_16, policies::{}>", row.name);
    type.products = row.products;
    type.quotients = row.quotients;
    type.refuses_zero = true;
    all.push_back(std::move(type));
  };
  // docs/semantics.md, "Multiply and divide". DIV of magnitudes faults beyond 32 bits, IDIV beyond
  // the range; the 8088 divides by the whole part of the divisor, and faults if that is zero.
  NumberType of_magnitudes;
  of_magnitudes.divide.faults_beyond_bits = true;
  NumberType of_signed;
  of_signed.refuses_quotients = true;
  NumberType of_i8088;
  of_i8088.divide.divides_by_whole_part = true;
  add({"i386_rounded", Rounding::half_up, Rounding::half_away}, of_magnitudes);
  add({"i386_div_rounded", Rounding::floor, Rounding::half_away}, of_magnitudes);
  add({"i386_mul_rounded", Rounding::half_up, Rounding::truncate}, of_signed);
  add({"i386_unrounded", Rounding::floor, Rounding::truncate}, of_signed);
  add({"i8088_rounded", Rounding::half_away, Rounding::half_away}, of_i8088);
  add({"i8088_mul_rounded", Rounding::half_away, Rounding::truncate}, of_i8088);
  add({"i8088_div_rounded", Rounding::truncate, Rounding::half_away}, of_i8088);
  add({"i8088_unrounded", Rounding::truncate, Rounding::truncate}, of_i8088);
  return all;
}

}  // namespace fixproof::judge
