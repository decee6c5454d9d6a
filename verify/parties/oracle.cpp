// The two oracles: one computes with integers of Boost.Multiprecision, one with built-in integers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/version.hpp>
#include <optional>
#include <span>

#include "oracle/exact.hpp"
#include "oracle/fast.hpp"
#include "oracle/fast_sine.hpp"
#include "verify/parties/formats.hpp"
#include "verify/parties/parties.hpp"

namespace fixproof::parties {

namespace {

using oracle::DivideRule;
using oracle::Rounding;
using oracle::Word;

Rounding multiply_rule(const cases::Variant& v) {
  switch (v.build.target) {
    case cases::Target::i386:
      return v.build.mul_round ? Rounding::half_up : Rounding::floor;
    case cases::Target::i8088:
      return v.build.mul_round ? Rounding::half_away : Rounding::truncate;
    case cases::Target::standard:
      break;
  }
  return Rounding::half_up;
}

DivideRule divide_rule(const cases::Variant& v) {
  if (v.build.target == cases::Target::i386) {
    return v.build.div_round ? DivideRule::i386_rounded : DivideRule::i386_unrounded;
  }
  return v.build.div_round ? DivideRule::i8088_rounded : DivideRule::i8088_unrounded;
}

oracle::TranslationRule translation(const cases::Variant& v) {
  if (cases::loses_carry(v)) return oracle::TranslationRule::fourth_in_parts;
  return v.build.chapter_52 ? oracle::TranslationRule::every : oracle::TranslationRule::fourth;
}

/// Calls `one_case(in, out)` for each case; it returns whether the case has a value.
template <class OneCase>
void each_case(const cases::Variant& v, const Cases& asked, OneCase one_case) {
  const std::size_t in = cases::words_in(v.operation);
  const std::size_t out = cases::words_out(v.operation);
  for (std::size_t i = 0; i < asked.endings.size(); ++i) {
    const bool valued = one_case(asked.in.subspan(i * in, in), asked.out.subspan(i * out, out));
    asked.endings[i] = valued ? Ending::value : Ending::divide_error;
  }
}

bool store(oracle::LongWord answer, std::span<std::uint32_t> out) {
  out[0] = static_cast<std::uint32_t>(answer);
  return true;
}

template <class Answer>
bool store(const std::optional<Answer>& answer, std::span<std::uint32_t> out) {
  out[0] = static_cast<std::uint32_t>(answer.value_or(0));
  return answer.has_value();
}

template <std::size_t n>
bool store(const std::array<Word, n>& answer, std::span<std::uint32_t> out) {
  std::copy(answer.begin(), answer.end(), out.begin());
  return true;
}

/// The sines in the formats of FIXED.ASM have oracles of their own.
bool is_sine_of_routine_format(const cases::Variant& v) {
  return (v.operation == cases::Operation::sin || v.operation == cases::Operation::cos) &&
         cases::has_routine_format(v);
}

class Oracle final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "oracle"; }
  [[nodiscard]] std::string identity() const override {
    return fmt::format("integers of Boost.Multiprecision {}.{}.{}", BOOST_VERSION / 100000,
                       BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100);
  }
  [[nodiscard]] bool answers(const cases::Variant& v) const override {
    if (!cases::has_routine_format(v)) return exists_in_format(v) && is_standard(v);
    return v.operation != cases::Operation::cossin || v.format == cases::q16_16;
  }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    if (!is_of_build(v) && !is_sine_of_routine_format(v)) return answer_exactly(v, asked);
    const auto format = v.format.as<oracle::Format>();
    const Rounding rounding = multiply_rule(v);
    each_case(v, asked, [&](std::span<const Word> in, std::span<Word> out) {
      switch (v.operation) {
        case cases::Operation::mul:
          return store(oracle::mul(in[0], in[1], rounding, format), out);
        case cases::Operation::div:
          return store(oracle::div(in[0], in[1], divide_rule(v), format), out);
        case cases::Operation::cossin: {
          const auto angle = static_cast<std::int16_t>(static_cast<std::uint16_t>(in[0]));
          const oracle::CosSin both = oracle::cos_sin(angle);
          return store(std::array{both.cos, both.sin}, out);
        }
        case cases::Operation::xformvec:
          return store(oracle::xform_vec(in.first<12>(), in.last<3>(), rounding, format), out);
        case cases::Operation::concat:
          return store(
              oracle::concat(in.first<12>(), in.last<12>(), rounding, translation(v), format), out);
        case cases::Operation::sin:
          return store(oracle::sin(in[0], format), out);
        case cases::Operation::cos:
          return store(oracle::cos(in[0], format), out);
        default:  // a conversion, which answers() refuses
          return false;
      }
    });
  }
};

class FastOracle final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "fast"; }
  [[nodiscard]] std::string identity() const override { return "built-in integers"; }
  [[nodiscard]] bool answers(const cases::Variant& v) const override {
    if (!cases::has_routine_format(v)) {
      return exists_in_format(v) && !v.from && v.format.word_bits <= 32 && is_standard(v);
    }
    return v.operation != cases::Operation::cossin;
  }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    if (!is_of_build(v) && !is_sine_of_routine_format(v)) return answer_fast(v, asked);
    // Each operation has its own loop, because the loop dominates the time of a sweep.
    const auto format = v.format.as<oracle::Format>();
    const Rounding rounding = multiply_rule(v);
    switch (v.operation) {
      case cases::Operation::mul:
        return each_case(v, asked, [&](auto in, auto out) {
          return store(oracle::fast::mul(in[0], in[1], rounding, format), out);
        });
      case cases::Operation::div:
        return each_case(v, asked, [&, rule = divide_rule(v)](auto in, auto out) {
          return store(oracle::fast::div(in[0], in[1], rule, format), out);
        });
      case cases::Operation::xformvec:
        return each_case(v, asked, [&](auto in, auto out) {
          return store(oracle::fast::xform_vec(in.template first<12>(), in.template last<3>(),
                                               rounding, format),
                       out);
        });
      case cases::Operation::concat:
        return each_case(v, asked, [&](auto in, auto out) {
          return store(oracle::fast::concat(in.template first<12>(), in.template last<12>(),
                                            rounding, translation(v), format),
                       out);
        });
      case cases::Operation::sin:
        return each_case(v, asked, [&](auto in, auto out) {
          return store(oracle::fast::sin(in[0], format.fraction_bits), out);
        });
      case cases::Operation::cos:
        return each_case(v, asked, [&](auto in, auto out) {
          return store(oracle::fast::cos(in[0], format.fraction_bits), out);
        });
      default:  // a conversion, which answers() refuses
        return;
    }
  }
};

}  // namespace

std::unique_ptr<Party> make_oracle() { return std::make_unique<Oracle>(); }
std::unique_ptr<Party> make_fast_oracle() { return std::make_unique<FastOracle>(); }

}  // namespace fixproof::parties
