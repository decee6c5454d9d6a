#include "verify/cases/conversion_makers.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "verify/cases/format_makers.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::cases {

namespace {

void store_long(std::span<std::uint32_t> words, std::uint64_t value) {
  words[0] = static_cast<std::uint32_t>(value);
  if (words.size() > 1) words[1] = static_cast<std::uint32_t>(value >> 32U);
}

/// The fraction bits that a change of format drops.
int dropped_bits(const Variant& v) {
  return operand_format(v).fraction_bits - v.format.fraction_bits;
}

/// About how many bits a fraction has: a digit is worth 3.3 bits.
int width_of_fraction(const Format& format) {
  return format.is_decimal ? format.fraction_bits * 10 / 3 : format.fraction_bits;
}

/// Returns half a unit of the results in units of the operands, if that is whole and they have
/// ties; otherwise 0.
std::uint64_t half_dropped(const Variant& v) {
  const Format from = operand_format(v);
  const int dropped = dropped_bits(v);
  if (from.is_decimal != v.format.is_decimal || dropped < 1) return 0;
  if (!from.is_decimal) return dropped > from.word_bits ? 0 : std::uint64_t{1} << (dropped - 1);
  std::uint64_t half = 5;
  for (int i = 1; i < dropped; ++i) {
    if (half > highest(from) / 10) return 0;
    half *= 10;
  }
  return half <= highest(from) ? half : 0;
}

// Doubles.

constexpr int mantissa_bits = 52;
constexpr std::uint64_t exponents = 2048;
/// The mantissas of boundary doubles.
constexpr std::array<std::uint64_t, 6> mantissas{0,
                                                 1,
                                                 2,
                                                 std::uint64_t{1} << (mantissa_bits - 1),
                                                 (std::uint64_t{1} << mantissa_bits) - 2,
                                                 (std::uint64_t{1} << mantissa_bits) - 1};

/// Returns the bits of magnitude * 2^exponent, for a magnitude of 1 ... 2^53 - 1 whose exponent is
/// in the normal range.
std::uint64_t double_bits(std::uint64_t magnitude, int exponent) {
  const int top = static_cast<int>(std::bit_width(magnitude)) - 1;
  const std::uint64_t mantissa =
      (magnitude << (mantissa_bits - top)) & ((std::uint64_t{1} << mantissa_bits) - 1);
  return static_cast<std::uint64_t>(exponent + top + 1023) << mantissa_bits | mantissa;
}

std::uint64_t any_double_near(Draw& draw, const Format& format) {
  // From a sixteenth of an ulp to four times the largest word.
  const int fraction = width_of_fraction(format);
  const int exponent = draw.between(-fraction - 4, magnitude_bits(format) - fraction + 1);
  const std::uint64_t mantissa = draw.bits() >> (64 - mantissa_bits);
  return static_cast<std::uint64_t>(exponent + 1023) << mantissa_bits | mantissa;
}

/// A double halfway between two words. It has at most 52 bits, so the next double lies nearer to it
/// than a word does.
std::uint64_t double_tie(Draw& draw, const Format& format) {
  const int widest = std::min(magnitude_bits(format), mantissa_bits - 1);
  std::uint64_t ulps = static_cast<std::uint64_t>(draw.magnitude(widest));
  // In one of eight cases next to the end of the range.
  if (draw.below(8) == 0 && magnitude_bits(format) == widest) {
    ulps = (std::uint64_t{1} << widest) - 1 - draw.below(2);
  }
  return double_bits(2 * ulps + 1, -format.fraction_bits - 1);
}

std::uint64_t double_in(Stream stream, Draw& draw, const Format& format) {
  if (stream == Stream::uniform) return draw.bits();
  const std::uint64_t sign = draw.coin() ? std::uint64_t{1} << 63U : 0;
  if (stream == Stream::scaled) return sign | any_double_near(draw, format);
  const std::uint64_t tie = double_tie(draw, format);
  if (stream == Stream::value_ties) return sign | tie;
  return sign | (draw.coin() ? tie + 1 : tie - 1);
}

// Words of another format.

/// A word of `from` halfway between two of the results' words.
std::uint64_t word_tie(Draw& draw, const Variant& v) {
  const Format from = operand_format(v);
  const std::uint64_t half = half_dropped(v);
  if (from.is_decimal) {
    // An odd multiple of half a unit of the results.
    const std::uint64_t units = draw.bits() % (highest(from) / half + 1);
    return either_sign(draw, half * (units % 2 == 0 && units != 0 ? units - 1 : units | 1), from);
  }
  std::uint64_t word = any_width(draw, from);
  // In one of eight cases next to the end of the results' range, if `from` reaches it.
  const int end = magnitude_bits(v.format) + dropped_bits(v);
  if (draw.below(8) == 0 && end < from.word_bits) {
    word = std::uint64_t{1} << end;
    if (draw.coin()) word -= half;
    if (draw.coin()) word = 0 - word;
  }
  return (word & ~(2 * half - 1)) | half;
}

std::uint64_t word_in(Stream stream, Draw& draw, const Variant& v) {
  const Format from = operand_format(v);
  if (stream == Stream::uniform) return any_word(draw, from);
  if (stream == Stream::scaled) return any_width(draw, from);
  std::uint64_t word = word_tie(draw, v);
  if (stream == Stream::near_value_ties) word += draw.coin() ? 1 : ~std::uint64_t{};
  return word & all_ones(from);
}

// Decimal texts. The first two words are a magnitude, the third says how to write it.

constexpr std::uint32_t minus_sign = 1;
/// Above the magnitude in ulps, as a multiple of `form_position`.
constexpr std::uint32_t form_position = 2;
constexpr std::uint32_t halfway = 1;
constexpr std::uint32_t above_half = 2;
constexpr std::uint32_t below_half = 3;
/// The magnitude is a number of units of 10^-places; otherwise of ulps.
constexpr std::uint32_t counts_places = 8;
/// Zeros that change nothing stand before and after the digits.
constexpr std::uint32_t padded = 16;
/// A multiple of this: the places, or the distance of the last digit from a tie.
constexpr std::uint32_t form_number = 256;

constexpr std::uint64_t decimal_forms = 8;  ///< four positions, with and without padding

void decimal_case(Stream stream, Draw& draw, const Format& format, std::span<std::uint32_t> words) {
  const int bits = magnitude_bits(format);
  std::uint32_t form = draw.below(format.is_signed ? 2 : 8) == 0 ? minus_sign : 0;
  std::uint64_t magnitude = 0;
  if (stream == Stream::uniform) {
    // As people write them: few digits, some after the point.
    const int places = draw.between(0, 6);
    const int whole_bits = std::max(0, bits - width_of_fraction(format));
    magnitude =
        static_cast<std::uint64_t>(draw.magnitude(std::min(62, whole_bits + 1 + places * 10 / 3)));
    form |= counts_places | static_cast<std::uint32_t>(places) * form_number;
  } else {
    const int width = draw.between(0, bits);
    magnitude = width == 0 ? 0 : draw.bits() >> (64 - width);
    if (stream == Stream::value_ties) form |= halfway * form_position;
    if (stream == Stream::near_value_ties) {
      form |= (draw.coin() ? above_half : below_half) * form_position;
    }
  }
  if (draw.below(8) == 0) form |= padded;
  if ((form & counts_places) == 0) form |= static_cast<std::uint32_t>(draw.below(24)) * form_number;
  store_long(words.first(2), magnitude);
  words[2] = form;
}

/// Appends digits that leave the halfway point after the text's last digit, which is 5.
void leave_halfway(std::string& digits, std::uint32_t where, std::uint32_t distance) {
  if (where == below_half) {
    digits.back() = '4';
    digits.append(distance + 1, '9');
  } else if (where == above_half) {
    digits.append(distance, '0');
    digits += '1';
  }
}

}  // namespace

bool has_ties_of_words(Operation operation) {
  return operation == Operation::convert || operation == Operation::add ||
         operation == Operation::sub;
}

WordPair sum_tie(Stream stream, Draw& draw, const Variant& v) {
  const Format from = operand_format(v);
  // Both operands are on the side of the tie, so neither leaves the range.
  const std::uint64_t tie = word_in(stream, draw, v);
  const bool below_0 = from.is_signed && tie >> (from.word_bits - 1) != 0;
  const std::uint64_t size = below_0 ? (0 - tie) & all_ones(from) : tie;
  const std::uint64_t part = size == 0 ? 0 : draw.bits() % size;
  const std::uint64_t first = below_0 ? 0 - part : part;
  const std::uint64_t rest = tie - first;
  const std::uint64_t second = v.operation == Operation::sub ? 0 - rest : rest;
  return {first & all_ones(from), second & all_ones(from)};
}

bool has_conversion_stream(Stream stream, const Variant& v) {
  switch (stream) {
    case Stream::lattice:
    case Stream::uniform:
    case Stream::scaled:
      return true;
    case Stream::every:
      return v.operation == Operation::convert || v.operation == Operation::to_decimal;
    case Stream::value_ties:
      return (v.operation == Operation::from_binary64 && !v.format.is_decimal) ||
             v.operation == Operation::from_decimal ||
             (has_ties_of_words(v.operation) && half_dropped(v) != 0);
    case Stream::near_value_ties:
      // A word next to a tie is not a tie itself if two bits are dropped.
      return has_conversion_stream(Stream::value_ties, v) &&
             (!has_ties_of_words(v.operation) || half_dropped(v) > 1) &&
             // A tie of units above 1 has no digit after the point to change.
             (v.operation != Operation::from_decimal || v.format.fraction_bits >= 0);
    default:
      return false;
  }
}

std::uint64_t conversion_lattice_size(const Variant& v) {
  if (v.operation == Operation::from_binary64) return 2 * exponents * mantissas.size();
  const std::uint64_t values = boundary_lattice(operand_format(v).word_bits).size();
  return v.operation == Operation::from_decimal ? decimal_forms * values : values;
}

void conversion_lattice_case(const Variant& v, std::uint64_t number,
                             std::span<std::uint32_t> words) {
  if (v.operation == Operation::from_binary64) {
    const std::uint64_t sign = number % 2;
    const std::uint64_t mantissa = mantissas.at(number / 2 % mantissas.size());
    store_long(words, sign << 63U | number / 2 / mantissas.size() << mantissa_bits | mantissa);
    return;
  }
  const Format format = operand_format(v);
  const auto values = boundary_lattice(format.word_bits);
  if (v.operation != Operation::from_decimal) return store_long(words, values[number]);
  const std::uint64_t word = values[number / decimal_forms];
  const bool below_0 = format.is_signed && word >> (format.word_bits - 1) != 0;
  store_long(words.first(2), below_0 ? (0 - word) & all_ones(format) : word);
  const auto form = static_cast<std::uint32_t>(number % decimal_forms);
  words[2] = (below_0 ? minus_sign : 0) | form % 4 * form_position | (form < 4 ? 0 : padded) |
             3 * form_number;
}

void conversion_case(Stream stream, Draw& draw, const Variant& v, std::span<std::uint32_t> words) {
  switch (v.operation) {
    case Operation::from_binary64:
      return store_long(words, double_in(stream, draw, v.format));
    case Operation::from_decimal:
      return decimal_case(stream, draw, v.format, words);
    default:
      return store_long(words, word_in(stream, draw, v));
  }
}

void append_decimal_operand(std::string& to, std::span<const std::uint32_t> words,
                            const Format& format) {
  const std::uint64_t magnitude = std::uint64_t{words[1]} << 32U | words[0];
  const std::uint32_t form = words[2];
  const std::uint32_t where = form / form_position % 4;
  const std::uint32_t number = form / form_number;
  std::string digits;
  if ((form & counts_places) != 0) {
    digits = decimal_of(magnitude, {.fraction_bits = static_cast<int>(number), .is_decimal = true});
  } else {
    digits = decimal_of(magnitude, format, where != 0);
    leave_halfway(digits, where, number);
  }
  if ((form & minus_sign) != 0) to += '-';
  const bool pad = (form & padded) != 0;
  if (pad) to += "00";
  to += digits;
  if (pad) to += digits.find('.') == std::string::npos ? ".00" : "00";
}

}  // namespace fixproof::cases
