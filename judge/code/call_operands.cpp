#include "judge/code/call_operands.hpp"

#include <algorithm>

#include "judge/code/bytes.hpp"

namespace fixproof::judge {

std::vector<Parameter> parameters_of(const cases::Variant& v) {
  using cases::Operation;
  const int bits = v.format.word_bits;
  if (v.operation == Operation::cossin) {
    const Parameter result{.bits = bits, .is_pointer = true, .is_result = true};
    return {{.bits = cases::operand_bits(v)}, result, result};
  }
  if (v.operation == Operation::xformvec) {
    const auto array = [bits](std::size_t numbers, bool is_result) {
      return Parameter{
          .bits = bits, .numbers = numbers, .is_pointer = true, .is_result = is_result};
    };
    return {array(12, false), array(3, false), array(3, true)};
  }
  return std::vector<Parameter>(cases::words_in(v.operation),
                                {.bits = bits, .is_signed = v.format.is_signed});
}

int bits_of_returned(const cases::Variant& v) {
  return std::ranges::any_of(parameters_of(v), &Parameter::is_result) ? 0 : v.format.word_bits;
}

CallOperands::CallOperands(const Image& image, const cases::Variant& variant)
    : image_(image), parameters_(parameters_of(variant)) {
  std::size_t word = 0;
  std::uint32_t place = image.data;
  for (const Parameter& p : parameters_) {
    first_words_.push_back(word);
    places_.push_back(place);
    if (!p.is_result) word += p.numbers * static_cast<std::size_t>((p.bits + 31) / 32);
    place += static_cast<std::uint32_t>(p.numbers) * static_cast<std::uint32_t>(p.bits) / 8;
  }
}

std::uint64_t CallOperands::value(std::size_t parameter,
                                  std::span<const std::uint32_t> words) const {
  const Parameter& p = parameters_[parameter];
  const std::size_t index = first_words_[parameter];
  if (p.bits > 32) return words[index] | std::uint64_t{words[index + 1]} << 32U;
  std::uint64_t value = words[index];
  const std::uint64_t sign = std::uint64_t{1} << (p.bits - 1);
  if (p.is_signed && (value & sign) != 0) value |= ~std::uint64_t{0} << p.bits;
  return value;
}

bool CallOperands::has_results_behind_pointers() const {
  return std::ranges::any_of(parameters_, &Parameter::is_result);
}

std::size_t CallOperands::index_of(std::size_t parameter, std::size_t number) const {
  const std::uint32_t offset = places_[parameter] + static_cast<std::uint32_t>(number) * 4;
  return image_.index_of(image_.data_at(offset));
}

void CallOperands::put(std::uint8_t* memory, std::span<const std::uint32_t> words,
                       cases::Draw& draw) const {
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Parameter& p = parameters_[i];
    if (!p.is_pointer) continue;
    for (std::size_t n = 0; n < p.numbers; ++n) {
      const std::uint32_t value =
          p.is_result ? static_cast<std::uint32_t>(draw.bits()) : words[first_words_[i] + n];
      store(memory + index_of(i, n), value, 4, image_.is_big_endian());
    }
  }
}

void CallOperands::take(const std::uint8_t* memory, std::span<std::uint32_t> words) const {
  std::size_t word = 0;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    if (!parameters_[i].is_result) continue;
    for (std::size_t n = 0; n < parameters_[i].numbers; ++n) {
      words[word++] = fetch(memory + index_of(i, n), 4, image_.is_big_endian());
    }
  }
}

}  // namespace fixproof::judge
