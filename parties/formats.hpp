/// @file
/// Answers in formats that no routine has: sums, differences, products and quotients rounded half
/// up and reduced modulo the word, square roots, round trips, and functions of
/// real numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "cases/variant.hpp"
#include "parties/party.hpp"

namespace fixproof::parties {

/// Tells whether the operation exists in the format.
constexpr bool exists_in_format(const cases::Variant& v) {
  using enum cases::Operation;
  const cases::Operation operation = v.operation;
  if (cases::is_function(operation)) return v.format.word_bits <= 32;
  return operation == mul || operation == div || operation == add || operation == sub ||
         operation == sqrt || operation == decimal || operation == binary64;
}

/// Tells whether the variant has the only rules that exist in every format.
constexpr bool is_standard(const cases::Variant& v) {
  return v.build.target == cases::Target::standard;
}

/// Calls `answer(operands)` for each case and stores its result. A case without one is a divide
/// error.
template <class OneAnswer>
void each_number(const cases::Variant& v, const Batch& batch, const OneAnswer& answer) {
  const std::size_t each = cases::words_per_number(v.format);
  const std::size_t in = cases::words_in(v);
  const auto number = [&](std::size_t at) {
    const std::uint64_t low = batch.in[at];
    return each == 1 ? low : low | std::uint64_t{batch.in[at + 1]} << 32U;
  };
  for (std::size_t i = 0; i < batch.endings.size(); ++i) {
    const std::size_t second = i * in + (in > each ? each : 0);
    const std::optional<std::uint64_t> result = answer(number(i * in), number(second));
    batch.endings[i] = result ? Ending::value : Ending::divide_error;
    batch.out[i * each] = static_cast<std::uint32_t>(result.value_or(0));
    if (each == 2) batch.out[i * 2 + 1] = static_cast<std::uint32_t>(result.value_or(0) >> 32U);
  }
}

/// The oracle with integers of any size.
void answer_exactly(const cases::Variant& v, const Batch& batch);
/// The oracle with built-in integers, for words of at most 32 bits.
void answer_fast(const cases::Variant& v, const Batch& batch);

/// The oracles of functions.
void answer_function_exactly(const cases::Variant& v, const Batch& batch);
void answer_function_fast(const cases::Variant& v, const Batch& batch);

/// Tells whether fixed/formats.hpp names the format.
bool is_named(const cases::Format& format);
/// The type in a named format.
void answer_by_type(const cases::Variant& v, const Batch& batch);
void answer_function_by_type(const cases::Variant& v, const Batch& batch);

}  // namespace fixproof::parties
