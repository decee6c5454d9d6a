/// @file
/// Answers in formats that no routine has: sums, differences, products and quotients rounded half
/// up and reduced modulo the word, square roots, round trips, remainders, and functions of real
/// numbers; in one format, or with results in a format of their own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "oracle/integer.hpp"
#include "oracle/rule.hpp"
#include "verify/cases/variant.hpp"
#include "verify/parties/party.hpp"

namespace fixproof::parties {

/// Tells whether the operation exists in the format, or in both formats.
constexpr bool exists_in_format(const cases::Variant& v) {
  using enum cases::Operation;
  const cases::Operation operation = v.operation;
  if (v.from && (operation == decimal || operation == binary64)) return false;
  if (cases::is_function(operation) || cases::is_quotient_function(operation)) {
    return cases::is_in_format(operation, v.format);
  }
  return operation == mul || operation == div || operation == add || operation == sub ||
         operation == sqrt || operation == decimal || operation == binary64;
}

/// Tells whether the variant is a routine of FIXED.ASM, whose answer depends on its build.
constexpr bool is_of_build(const cases::Variant& v) {
  const bool is_number =
      v.operation == cases::Operation::mul || v.operation == cases::Operation::div;
  return cases::is_routine(v.operation) && cases::has_routine_format(v) &&
         !(is_number && v.build.target == cases::Target::standard);
}

/// Tells whether the variant has the only rules that exist in every format.
constexpr bool is_standard(const cases::Variant& v) {
  return v.build.target == cases::Target::standard;
}

/// Calls `answer` with the array of the operands of each case, at most three, and stores its
/// result. A case without one is a divide error.
template <class OneAnswer>
void each_case_in(const cases::Variant& v, const Cases& asked, const OneAnswer& answer) {
  const std::size_t each = cases::words_per_number(cases::operand_format(v));
  const std::size_t each_out = cases::words_per_number(v.format);
  const std::size_t in = cases::words_in(v);
  const std::size_t operands = cases::words_in(v.operation);
  const auto number = [&](std::size_t at) {
    const std::uint64_t low = asked.in[at];
    return each == 1 ? low : low | std::uint64_t{asked.in[at + 1]} << 32U;
  };
  for (std::size_t i = 0; i < asked.endings.size(); ++i) {
    std::array<std::uint64_t, 3> one{};
    for (std::size_t k = 0; k < operands; ++k) one[k] = number(i * in + k * each);
    const std::optional<std::uint64_t> result = answer(one);
    asked.endings[i] = result ? Ending::value : Ending::divide_error;
    std::uint32_t* out = asked.out.data() + i * each_out;
    out[0] = static_cast<std::uint32_t>(result.value_or(0));
    if (each_out == 2) out[1] = static_cast<std::uint32_t>(result.value_or(0) >> 32U);
  }
}

/// The same, with the first two operands as arguments.
template <class OneAnswer>
void each_number(const cases::Variant& v, const Cases& asked, const OneAnswer& answer) {
  each_case_in(v, asked,
               [&](const std::array<std::uint64_t, 3>& in) { return answer(in[0], in[1]); });
}

/// The oracle with integers of any size.
void answer_exactly(const cases::Variant& v, const Cases& asked);
/// The oracle with built-in integers, for words of at most 32 bits.
void answer_fast(const cases::Variant& v, const Cases& asked);

/// The oracle of an operation whose results have a format of their own.
void answer_mixed_exactly(const cases::Variant& v, const Cases& asked);

/// What a function returns outside its domain: the end of the results' range nearest to a pole, or
/// 0.
oracle::Integer outside_domain(cases::Operation operation, bool is_zero,
                               const oracle::Format& results);

/// The oracles of functions.
void answer_function_exactly(const cases::Variant& v, const Cases& asked);
void answer_function_fast(const cases::Variant& v, const Cases& asked);

/// The oracles of remainders and of the quotient of a product.
void answer_quotient_exactly(const cases::Variant& v, const Cases& asked);
void answer_quotient_fast(const cases::Variant& v, const Cases& asked);

/// Tells whether the type answers: in the formats that fixed/formats.hpp names, and with results in
/// another format for a choice of five.
bool is_of_type(const cases::Variant& v);
/// The type in a named format.
void answer_by_type(const cases::Variant& v, const Cases& asked);
void answer_function_by_type(const cases::Variant& v, const Cases& asked);
void answer_quotient_by_type(const cases::Variant& v, const Cases& asked);
void answer_mixed_by_type(const cases::Variant& v, const Cases& asked);
bool is_of_type_mixed(const cases::Variant& v);

}  // namespace fixproof::parties
