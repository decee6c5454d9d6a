#include "verify/cases/streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "verify/cases/conversion_makers.hpp"
#include "verify/cases/draw.hpp"
#include "verify/cases/edges.hpp"
#include "verify/cases/format_makers.hpp"
#include "verify/cases/function_makers.hpp"
#include "verify/cases/stream_makers.hpp"

namespace fixproof::cases {

namespace {

constexpr std::array<std::string_view, 29> stream_names{"uniform",
                                                        "scaled",
                                                        "lattice",
                                                        "every",
                                                        "product_ties",
                                                        "near_product_ties",
                                                        "quotient_ties",
                                                        "near_quotient_ties",
                                                        "whole_divisor_ties",
                                                        "large_quotients",
                                                        "small_divisors",
                                                        "fault_edge",
                                                        "rotations",
                                                        "axes",
                                                        "lattice_words",
                                                        "transform_ties",
                                                        "root_ties",
                                                        "quarter_turns",
                                                        "hard_angles",
                                                        "value_ties",
                                                        "near_value_ties",
                                                        "half_multiples",
                                                        "ratio_ties",
                                                        "near_ratio_ties",
                                                        "large_ratios",
                                                        "whole_lengths",
                                                        "near_length_ties",
                                                        "edges",
                                                        "extremes"};

[[noreturn]] void refuse(Stream stream, const Variant& variant) {
  throw std::invalid_argument(
      fmt::format("stream {} has no cases of {}", name_of(stream), name_of(variant.operation)));
}

template <class Make>
void each_case(std::size_t arity, std::uint64_t key, std::uint64_t first,
               std::span<std::uint32_t> words, Make make) {
  for (std::size_t i = 0; i * arity < words.size(); ++i) {
    Draw draw(key, first + i);
    make(draw, words.subspan(i * arity, arity));
  }
}

template <class Make>
void each_pair(std::uint64_t key, std::uint64_t first, std::span<std::uint32_t> words,
               const Format& format, Make make) {
  each_case(2, key, first, words, [&](Draw& draw, std::span<std::uint32_t> one_case) {
    const Pair pair = make(draw, format);
    one_case[0] = format.word(pair.first);
    one_case[1] = format.word(pair.second);
  });
}

/// Stores a number of the format.
void store(std::span<std::uint32_t> words, std::size_t number, std::uint64_t value,
           const Format& format) {
  const std::size_t each = words_per_number(format);
  words[number * each] = static_cast<std::uint32_t>(value);
  if (each == 2) words[2 * number + 1] = static_cast<std::uint32_t>(value >> 32U);
}

void count_lattice(std::size_t arity, const Format& format, std::uint64_t first,
                   std::span<std::uint32_t> words) {
  const auto values = boundary_lattice(format.word_bits);
  const std::size_t cases = words.size() / (arity * words_per_number(format));
  for (std::size_t i = 0; i < cases; ++i) {
    std::uint64_t left = first + i;
    for (std::size_t operand = arity; operand-- > 0; left /= values.size()) {
      store(words, i * arity + operand, values[left % values.size()], format);
    }
  }
}

void count_every(std::size_t arity, const Format& format, std::uint64_t first,
                 std::span<std::uint32_t> words) {
  for (std::size_t i = 0; i * arity < words.size(); ++i) {
    std::uint64_t left = first + i;
    for (std::size_t operand = arity; operand-- > 0; left >>= format.word_bits) {
      words[i * arity + operand] = format.word(static_cast<std::int64_t>(left));
    }
  }
}

/// Writes the cases next to edges, again and again.
void count_edges(const Variant& v, std::uint64_t first, std::span<std::uint32_t> words) {
  const auto edges = edge_words(v.operation, operand_format(v));
  const std::size_t start = first * words_in(v.operation);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = edges[(start + i) % edges.size()];
}

/// Writes each hard angle, then its negative.
void count_hard_angles(const Format& format, std::uint64_t first, std::span<std::uint32_t> words) {
  const auto angles = hard_angles();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::uint64_t number = first + i;
    const std::int64_t angle = angles[number / 2 % angles.size()];
    words[i] = format.word(number % 2 == 0 ? angle : -angle);
  }
}

bool is_stream_of(Stream stream, const Variant& variant) {
  const Operation operation = variant.operation;
  if (is_conversion(operation)) return has_conversion_stream(stream, variant);
  const std::size_t arity = words_in(operation);
  switch (stream) {
    case Stream::uniform:
    case Stream::scaled:
      return true;
    case Stream::lattice:
      return arity <= 2;
    case Stream::every:
      return arity <= 3 && !is_sum(operation);
    case Stream::product_ties:
    case Stream::near_product_ties:
      return operation == Operation::mul || is_sum(operation);
    case Stream::extremes:
      return is_sum(operation);
    case Stream::quotient_ties:
    case Stream::near_quotient_ties:
    case Stream::large_quotients:
    case Stream::small_divisors:
    case Stream::whole_divisor_ties:
    case Stream::fault_edge:
      return operation == Operation::div;
    case Stream::rotations:
    case Stream::axes:
    case Stream::transform_ties:
      return arity > 3 && !is_sum(operation);
    case Stream::lattice_words:
      return arity > 2;
    case Stream::half_multiples:
      return operation == Operation::fmod || operation == Operation::remainder;
    case Stream::ratio_ties:
    case Stream::near_ratio_ties:
    case Stream::large_ratios:
      return operation == Operation::mul_div;
    case Stream::whole_lengths:
    case Stream::near_length_ties:
      return operation == Operation::hypot3 && operand_format(variant).word_bits <= 32;
    case Stream::root_ties:
      return operation == Operation::sqrt;
    case Stream::edges:
      return has_edges_in(operation, operand_format(variant));
    case Stream::value_ties:
    case Stream::near_value_ties:
      return has_ties_of_words(operation) && has_conversion_stream(stream, variant);
    case Stream::quarter_turns:
    case Stream::hard_angles:
      break;
  }
  return operation == Operation::sin || operation == Operation::cos;
}

}  // namespace

std::string_view name_of(Stream stream) {
  return stream_names.at(static_cast<std::size_t>(stream));
}

std::vector<std::uint64_t> boundary_lattice(int word_bits) {
  const std::uint64_t all_ones = ~std::uint64_t{0} >> (64 - word_bits);
  std::set<std::uint64_t> values;
  const auto add = [&](std::uint64_t value) {
    values.insert(value & all_ones);
    values.insert((0 - value) & all_ones);
  };
  for (const std::uint64_t small : {0U, 1U, 2U, 3U}) add(small);
  for (int bit = 0; bit < word_bits; ++bit) {
    const std::uint64_t power = std::uint64_t{1} << bit;
    add(power - 1);
    add(power);
    add(power + 1);
  }
  for (const std::uint64_t pattern :
       {0x5555555555555555U, 0x3333333333333333U, 0x0f0f0f0f0f0f0f0fU, 0x00ff00ff00ff00ffU}) {
    add(pattern);
    add(~pattern);
  }
  return {values.begin(), values.end()};
}

std::optional<std::uint64_t> size_of(Stream stream, const Variant& variant) {
  if (stream == Stream::hard_angles) return 2 * hard_angles().size();
  if (stream == Stream::edges) {
    if (!is_stream_of(stream, variant)) refuse(stream, variant);
    return edge_words(variant.operation, operand_format(variant)).size() /
           words_in(variant.operation);
  }
  if (stream != Stream::lattice && stream != Stream::every) return std::nullopt;
  const std::size_t arity = words_in(variant.operation);
  const int bits = operand_bits(variant);
  if (stream == Stream::lattice && is_conversion(variant.operation)) {
    return conversion_lattice_size(variant);
  }
  if (stream == Stream::lattice) {
    if (arity > 2) refuse(stream, variant);
    const std::uint64_t values = boundary_lattice(bits).size();
    return arity == 1 ? values : values * values;
  }
  if (arity * static_cast<std::size_t>(bits) > 32) refuse(stream, variant);
  return std::uint64_t{1} << (arity * static_cast<std::size_t>(bits));
}

namespace {

/// Returns the bits of an operand that are whole units of the results, in binary scales.
std::uint64_t whole_bits(const Variant& v) {
  const int dropped = operand_format(v).fraction_bits - v.format.fraction_bits;
  if (v.format.is_decimal || dropped <= 0) return ~std::uint64_t{0};
  return dropped > 63 ? 0 : ~std::uint64_t{0} << dropped;
}

/// Makes a product like those of a stream, and what is added to it: whole units of the results.
template <class Make>
void make_sum(const Variant& variant, Draw& draw, const Format& format,
              std::span<std::uint64_t> operands, Make make) {
  const WordPair pair = make(draw, format);
  switch (variant.operation) {
    case Operation::mul_add:
      operands[0] = pair.first;
      operands[1] = pair.second;
      operands[2] = any_width(draw, format) & whole_bits(variant);
      return;
    case Operation::lerp: {
      // The difference b - a is the first factor. If that takes b out of the range, a is 0.
      const std::uint64_t from = draw.coin() ? any_width(draw, format) & whole_bits(variant) : 0;
      const std::uint64_t end = (from + pair.first) & all_ones(format);
      const bool is_same_side = ((end ^ from) >> (format.word_bits - 1) & 1U) == 0;
      operands[0] = is_same_side ? from : 0;
      operands[1] = is_same_side ? end : pair.first;
      operands[2] = pair.second;
      return;
    }
    default:
      break;
  }
  const std::size_t terms = variant.terms;
  std::ranges::fill(operands, 0);
  const std::size_t at = draw.below(terms);
  operands[at] = pair.first;
  operands[terms + at] = pair.second;
}

/// Makes the cases of a format that no routine has.
void make_cases_in(Stream stream, const Variant& variant, std::uint64_t key, std::uint64_t first,
                   std::span<std::uint32_t> words) {
  const auto made_for = maker_format(stream, variant);
  if (!made_for) refuse(stream, variant);
  const Format& format = *made_for;
  const std::size_t arity = operands_of(variant);
  const auto numbers = [&](auto make) {
    each_case(words_in(variant), key, first, words, [&](Draw& draw, auto one_case) {
      for (std::size_t i = 0; i < arity; ++i) store(one_case, i, make(draw, format), format);
    });
  };
  const auto sums = [&](auto make) {
    std::vector<std::uint64_t> operands(arity);
    each_case(words_in(variant), key, first, words, [&](Draw& draw, auto one_case) {
      make(draw, std::span(operands));
      for (std::size_t i = 0; i < arity; ++i) store(one_case, i, operands[i], format);
    });
  };
  const auto pairs = [&](auto make) {
    if (is_sum(variant.operation)) {
      return sums([&](Draw& draw, std::span<std::uint64_t> operands) {
        make_sum(variant, draw, format, operands, make);
      });
    }
    each_case(words_in(variant), key, first, words, [&](Draw& draw, auto one_case) {
      const WordPair pair = make(draw, format);
      store(one_case, 0, pair.first, format);
      store(one_case, 1, pair.second, format);
    });
  };
  const auto triples = [&](auto make) {
    each_case(words_in(variant), key, first, words, [&](Draw& draw, auto one_case) {
      const WordTriple triple = make(draw, format);
      for (std::size_t i = 0; i < triple.size(); ++i) store(one_case, i, triple.at(i), format);
    });
  };
  switch (stream) {
    case Stream::uniform:
      return numbers(any_word);
    case Stream::scaled:
      return numbers(any_width);
    case Stream::lattice:
      return count_lattice(arity, format, first, words);
    case Stream::every:
      return count_every(arity, format, first, words);
    case Stream::product_ties:
      return pairs(product_tie_in);
    case Stream::near_product_ties:
      return pairs(near_product_tie_in);
    case Stream::quotient_ties:
      return pairs(quotient_tie_in);
    case Stream::near_quotient_ties:
      return pairs(near_quotient_tie_in);
    case Stream::large_quotients:
      return pairs(large_quotient_in);
    case Stream::small_divisors:
      return pairs(small_divisor_in);
    case Stream::root_ties:
      return numbers(root_tie_in);
    case Stream::lattice_words:
      return numbers([values = boundary_lattice(format.word_bits)](Draw& draw, const Format&) {
        return values[draw.below(values.size())];
      });
    case Stream::half_multiples:
      return pairs(half_multiple);
    case Stream::ratio_ties:
      return triples(ratio_tie);
    case Stream::near_ratio_ties:
      return triples(near_ratio_tie);
    case Stream::large_ratios:
      return triples(large_ratio);
    case Stream::whole_lengths:
      return triples(whole_length);
    case Stream::near_length_ties:
      return triples(near_length_tie);
    case Stream::value_ties:
    case Stream::near_value_ties:
      return pairs([&](Draw& draw, const Format&) { return sum_tie(stream, draw, variant); });
    case Stream::extremes:
      return sums([&](Draw& draw, std::span<std::uint64_t> operands) {
        const bool same = draw.coin();
        for (std::size_t i = 0; i < arity; ++i) {
          const bool begins = i == 0 || 2 * i == arity;
          operands[i] = same && !begins ? operands[i - 1] : extreme_word(draw, format);
        }
      });
    default:
      refuse(stream, variant);
  }
}

void make_conversion_cases(Stream stream, const Variant& variant, std::uint64_t key,
                           std::uint64_t first, std::span<std::uint32_t> words) {
  const std::size_t each = words_in(variant);
  if (stream == Stream::every) return count_every(1, operand_format(variant), first, words);
  if (stream == Stream::lattice) {
    for (std::size_t i = 0; i * each < words.size(); ++i) {
      conversion_lattice_case(variant, first + i, words.subspan(i * each, each));
    }
    return;
  }
  each_case(each, key, first, words, [&](Draw& draw, std::span<std::uint32_t> one_case) {
    conversion_case(stream, draw, variant, one_case);
  });
}

}  // namespace

void make_cases(Stream stream, const Variant& variant, std::uint64_t seed, std::uint64_t first,
                std::span<std::uint32_t> words) {
  const Operation operation = variant.operation;
  if (!is_stream_of(stream, variant)) refuse(stream, variant);
  if (stream == Stream::edges) return count_edges(variant, first, words);
  // The key leaves out the variant's rules, so all variants of an operation get the same cases.
  const std::uint64_t key =
      mix(seed) + 0x100U * row_of(operation).seed + static_cast<std::uint64_t>(stream);
  if (is_conversion(operation)) {
    return make_conversion_cases(stream, variant, key, first, words);
  }
  if (!has_routine_format(variant)) return make_cases_in(stream, variant, key, first, words);
  const Format format{.word_bits = operand_bits(variant),
                      .fraction_bits = variant.format.fraction_bits};
  const std::size_t arity = words_in(operation);
  const auto pairs = [&](auto make) { each_pair(key, first, words, format, make); };
  const auto cases = [&](auto make) { each_case(arity, key, first, words, make); };
  switch (stream) {
    case Stream::uniform:
      return cases([&](Draw& draw, auto one_case) {
        for (auto& word : one_case)
          word = format.word(static_cast<std::int64_t>(draw.bits() >> 1U));
      });
    case Stream::scaled:
      return cases([&](Draw& draw, auto one_case) {
        for (auto& word : one_case) word = scaled_word(draw, format);
      });
    case Stream::lattice:
      return count_lattice(arity, format, first, words);
    case Stream::every:
      return count_every(arity, format, first, words);
    case Stream::product_ties:
      return pairs(product_tie);
    case Stream::near_product_ties:
      return pairs(near_product_tie);
    case Stream::quotient_ties:
      return pairs(quotient_tie);
    case Stream::near_quotient_ties:
      return pairs(near_quotient_tie);
    case Stream::whole_divisor_ties:
      return pairs(whole_divisor_tie);
    case Stream::large_quotients:
      return pairs(large_quotient);
    case Stream::small_divisors:
      return pairs(small_divisor);
    case Stream::fault_edge:
      return pairs(fault_edge);
    case Stream::rotations:
      return cases([&](Draw& draw, auto one_case) { rotation(draw, format, one_case); });
    case Stream::axes:
      return cases([&](Draw& draw, auto one_case) { axes(draw, format, one_case); });
    case Stream::lattice_words:
      return cases([&, values = boundary_lattice(format.word_bits)](Draw& draw, auto one_case) {
        for (auto& word : one_case)
          word = static_cast<std::uint32_t>(values[draw.below(values.size())]);
      });
    case Stream::transform_ties:
      return cases([&](Draw& draw, auto one_case) { transform_tie(draw, format, one_case); });
    case Stream::root_ties:
      return cases([&](Draw& draw, auto one_case) { one_case[0] = root_tie(draw, format); });
    case Stream::quarter_turns:
      return cases([&](Draw& draw, auto one_case) { one_case[0] = quarter_turn(draw, format); });
    case Stream::hard_angles:
      return count_hard_angles(format, first, words);
    default:
      refuse(stream, variant);
  }
}

}  // namespace fixproof::cases
