#include "judge/code/call_operands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "judge/code/bytes.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

std::uint64_t extended(std::uint64_t value, int bits, bool is_signed) {
  if (bits >= 64) return value;
  const std::uint64_t above = ~std::uint64_t{0} << bits;
  const bool is_negative = is_signed && (value >> (bits - 1) & 1U) != 0;
  return is_negative ? value | above : value & ~above;
}

/// Returns how many bytes behind a pointer belong to a parameter. Compilers expect a number at a
/// multiple of its width, and none is wider than 8 bytes.
std::uint32_t bytes_of(const Parameter& p) {
  constexpr std::uint32_t widest = 8;
  if (!p.is_pointer) return 0;
  const auto bytes = static_cast<std::uint32_t>(p.numbers) * static_cast<std::uint32_t>(p.bits) / 8;
  return (bytes + widest - 1) / widest * widest;
}

}  // namespace

Signature signature_of(const cases::Variant& v) {
  using cases::Operation;
  const int bits = cases::storage_bits(v.format);
  if (v.operation == Operation::cossin) {
    const Parameter result{.bits = bits, .is_pointer = true, .is_result = true};
    return {{{.bits = cases::operand_bits(v)}, result, result}};
  }
  if (v.operation == Operation::xformvec) {
    const auto array = [bits](std::size_t numbers, bool is_result) {
      return Parameter{
          .bits = bits, .numbers = numbers, .is_pointer = true, .is_result = is_result};
    };
    return {{array(12, false), array(3, false), array(3, true)}};
  }
  const cases::Format operand = cases::operand_format(v);
  return {.operands = std::vector<Parameter>(
              cases::operands_of(v),
              {.bits = cases::storage_bits(operand), .is_signed = operand.is_signed}),
          .result_bits = bits};
}

void expect_room(const Signature& signature) {
  std::uint32_t bytes = 0;
  for (const Parameter& p : signature.operands) bytes += bytes_of(p);
  if (bytes <= data_bytes) return;
  throw support::UsageError(fmt::format(
      "--frame: what the pointers point to takes {} bytes, and there are {}; take fewer terms",
      bytes, data_bytes));
}

CallOperands::CallOperands(const Image& image, const Signature& signature,
                           const cases::Variant& variant)
    : image_(image), parameters_(signature.operands), variant_(variant) {
  std::size_t operand = 0;
  std::uint32_t place = image.data;
  for (const Parameter& p : parameters_) {
    first_operands_.push_back(operand);
    places_.push_back(place);
    if (!p.is_result && !p.constant) operand += p.numbers;
    place += bytes_of(p);
  }
}

std::uint64_t CallOperands::operand(std::size_t number,
                                    std::span<const std::uint32_t> words) const {
  const int bits = cases::operand_bits(variant_);
  const bool is_signed = cases::operand_format(variant_).is_signed;
  if (bits <= 32) return extended(words[number], bits, is_signed);
  return extended(words[2 * number] | std::uint64_t{words[2 * number + 1]} << 32U, bits, is_signed);
}

std::uint64_t CallOperands::value(std::size_t parameter,
                                  std::span<const std::uint32_t> words) const {
  const Parameter& p = parameters_[parameter];
  const std::uint64_t value = p.constant ? static_cast<std::uint64_t>(*p.constant)
                                         : operand(first_operands_[parameter], words);
  return extended(value, p.bits, p.is_signed);
}

bool CallOperands::has_results_behind_pointers() const {
  return std::ranges::any_of(parameters_, &Parameter::is_result);
}

std::size_t CallOperands::index_of(std::size_t parameter, std::size_t number) const {
  const auto bytes = static_cast<std::uint32_t>(parameters_[parameter].bits) / 8;
  const std::uint32_t offset = places_[parameter] + static_cast<std::uint32_t>(number) * bytes;
  return image_.index_of(image_.data_at(offset));
}

void CallOperands::put(std::uint8_t* memory, std::span<const std::uint32_t> words,
                       cases::Draw& draw) const {
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Parameter& p = parameters_[i];
    if (!p.is_pointer) continue;
    for (std::size_t n = 0; n < p.numbers; ++n) {
      const std::uint64_t value =
          p.is_result ? draw.bits() : operand(first_operands_[i] + n, words);
      store(memory + index_of(i, n), value, p.bits / 8, image_.is_big_endian());
    }
  }
}

void CallOperands::take(const std::uint8_t* memory, std::span<std::uint32_t> words) const {
  const std::size_t each = cases::words_per_number(variant_.format);
  std::size_t word = 0;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Parameter& p = parameters_[i];
    if (!p.is_result) continue;
    for (std::size_t n = 0; n < p.numbers; ++n) {
      give(fetch(memory + index_of(i, n), p.bits / 8, image_.is_big_endian()),
           words.subspan(word, each));
      word += each;
    }
  }
}

void CallOperands::give(std::uint64_t result, std::span<std::uint32_t> words) const {
  const std::uint64_t stored = extended(result, cases::storage_bits(variant_.format), false);
  const std::uint64_t word = cases::word_in(stored, variant_.format);
  words[0] = static_cast<std::uint32_t>(word);
  if (words.size() > 1) words[1] = static_cast<std::uint32_t>(word >> 32U);
}

}  // namespace fixproof::judge
