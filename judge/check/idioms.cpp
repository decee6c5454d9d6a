#include "judge/check/idioms.hpp"

#include <fmt/format.h>

#include <cmath>

#include "oracle/format.hpp"

namespace fixproof::check {

namespace {

using cases::Format;
using cases::Operation;
using oracle::Integer;

/// Conversion to int truncates. The result is at most 2^48, so it fits.
std::int64_t cut(float value) { return static_cast<std::int64_t>(value); }

/// Cuts n / d + 1/2 toward zero.
template <class Number>
Number half_and_cut(const Number& n, const Number& d) {
  return (2 * n + d) / (2 * d);
}

/// Rounds up to nearest by adding a half, but drops the carry from the fraction.
std::int64_t without_carry(std::int64_t product) {
  const std::int64_t floor = product >> 16;
  const std::int64_t half = product >> 15 & 1;
  return (floor & ~std::int64_t{0xffff}) | ((floor + half) & 0xffff);
}

/// Adds fractions and integer parts apart.
std::int64_t sum_of_halves(std::int64_t a, std::int64_t b) {
  return (a & ~std::int64_t{0xffff}) + (b & ~std::int64_t{0xffff}) + ((a + b) & 0xffff);
}

/// Reduces a value to a word.
std::int64_t low_word(std::int64_t value, const Format& /*format*/) {
  return static_cast<std::int32_t>(value);
}
Integer low_word(const Integer& value, const Format& format) {
  const auto wide = format.as<oracle::Format>();
  return oracle::ulps(oracle::wrap(value, wide), wide);
}

/// 1.0 in ulps; a template because 2^64 fits only an Integer.
template <class Number>
Number one(const Format& format) {
  return Number(1) << format.fraction_bits;
}

/// The result of an idiom for any format, as its two functions.
template <class Arithmetic>
constexpr Idiom any_format(Operation operation, std::string_view text, Arithmetic arithmetic) {
  return {operation, text, arithmetic, arithmetic};
}

constexpr float units_per_one = 65536;

constexpr auto shift = [](const auto& a, const auto& b, const Format& f) {
  return std::optional((a * b) >> f.fraction_bits);
};
constexpr auto divide_product = []<class Number>(const Number& a, const Number& b,
                                                 const Format& f) {
  return std::optional<Number>(a * b / one<Number>(f));
};
constexpr auto half_added = []<class Number>(const Number& a, const Number& b, const Format& f) {
  return std::optional<Number>((a * b + one<Number>(f) / 2) >> f.fraction_bits);
};
constexpr auto product_and_half = []<class Number>(const Number& a, const Number& b,
                                                   const Format& f) {
  return std::optional<Number>(half_and_cut<Number>(a * b, one<Number>(f)));
};
constexpr auto low_bits_dropped = []<class Number>(const Number& a, const Number& b,
                                                   const Format& f) {
  const int low = f.fraction_bits / 2;
  return std::optional<Number>((a >> low) * (b >> (f.fraction_bits - low)));
};
constexpr auto high_half_dropped = []<class Number>(const Number& a, const Number& b,
                                                    const Format& f) {
  return std::optional<Number>(low_word(a * b, f) >> f.fraction_bits);
};
constexpr auto quotient = []<class Number>(const Number& a, const Number& b, const Format& f) {
  return std::optional<Number>(a * one<Number>(f) / b);
};
constexpr auto half_divisor_added = []<class Number>(const Number& a, const Number& b,
                                                     const Format& f) {
  return std::optional<Number>((a * one<Number>(f) + b / 2) / b);
};
constexpr auto quotient_and_half = []<class Number>(const Number& a, const Number& b,
                                                    const Format& f) {
  return std::optional<Number>(half_and_cut<Number>(a * one<Number>(f), b));
};

constexpr auto truncated_rest = []<class Number>(const Number& a, const Number& b, const Format&) {
  return std::optional<Number>(a % b);
};
constexpr auto floored_rest = []<class Number>(const Number& a, const Number& b, const Format&) {
  const Number rest = a % b;
  const bool is_other_side = rest != 0 && (rest < 0) != (b < 0);
  return std::optional<Number>(is_other_side ? rest + b : rest);
};
constexpr auto rest_of_ties_away = []<class Number>(const Number& a, const Number& b,
                                                    const Format&) {
  const Number rest = a % b;
  const Number size = rest < 0 ? -rest : rest;
  const Number divisor = b < 0 ? -b : b;
  const Number other = rest < 0 ? rest + divisor : rest - divisor;
  return std::optional<Number>(2 * size < divisor ? rest : other);
};

constexpr auto value_and_half = [](const Integer& a, const Integer& b, const Format&) {
  return std::optional(half_and_cut<Integer>(a, b));
};
constexpr auto cut_single = [](const Integer& a, const Integer& b, const Format&) {
  const int dropped = a == 0 ? 0 : static_cast<int>(msb(abs(a))) - 23;
  if (dropped <= 0) return std::optional<Integer>(a / b);
  const Integer kept = oracle::rounded(a, Integer(1) << dropped, oracle::Rounding::half_even);
  return std::optional<Integer>((kept << dropped) / b);
};

// Arithmetic on a product and a divisor.

/// Returns k if the divisor is 2^k - 1, for which people shift.
std::optional<int> near_power_of_two(const Integer& divisor) {
  if (divisor <= 1 || ((divisor + 1) & divisor) != 0) return std::nullopt;
  return static_cast<int>(msb(divisor)) + 1;
}
using WideUlps = std::optional<Integer>;
constexpr auto shifted_instead = [](const Integer& product, const Integer& divisor, const Format&) {
  const auto k = near_power_of_two(divisor);
  return k ? WideUlps(product >> *k) : WideUlps();
};
constexpr auto half_and_shifted_instead = [](const Integer& product, const Integer& divisor,
                                             const Format&) {
  const auto k = near_power_of_two(divisor);
  return k ? WideUlps((product + (Integer(1) << (*k - 1))) >> *k) : WideUlps();
};
constexpr auto shifted_after_one = [](const Integer& product, const Integer& divisor,
                                      const Format&) {
  const auto k = near_power_of_two(divisor);
  return k ? WideUlps((product + (product >> *k) + 1) >> *k) : WideUlps();
};
constexpr auto shifted_twice = [](const Integer& product, const Integer& divisor, const Format&) {
  const auto k = near_power_of_two(divisor);
  if (!k) return WideUlps();
  const Integer sum = product + (Integer(1) << (*k - 1));
  return WideUlps((sum + (sum >> *k)) >> *k);
};
constexpr auto half_of_divisor_added = [](const Integer& product, const Integer& divisor,
                                          const Format&) {
  return divisor == 0 ? WideUlps() : WideUlps((product + divisor / 2) / divisor);
};
constexpr auto low_product_divided = [](const Integer& product, const Integer& divisor,
                                        const Format& f) {
  return divisor == 0 ? WideUlps() : WideUlps(low_word(product, f) / divisor);
};

using Ulps = std::optional<std::int64_t>;

constexpr std::array<Idiom, idiom_count> all_idioms{{
    any_format(Operation::mul, "({wide})a * b >> {F}", shift),
    any_format(Operation::mul, "({wide})a * b / {one}", divide_product),
    any_format(Operation::mul, "(({wide})a * b + {half}) >> {F}", half_added),
    any_format(Operation::mul, "(int)(x * {one} + 0.5), which cuts negative results toward zero",
               product_and_half),
    {Operation::mul, "((((int64_t)a * b + 0x80) >> 8) + 0x80) >> 8, which rounds twice",
     [](auto& a, auto& b, auto&) { return Ulps((((a * b + 0x80) >> 8) + 0x80) >> 8); }, nullptr},
    {Operation::mul, "((((int64_t)a * b + 0x4000) >> 15) + 1) >> 1, which rounds twice",
     [](auto& a, auto& b, auto&) { return Ulps((((a * b + 0x4000) >> 15) + 1) >> 1); }, nullptr},
    {Operation::mul, "half-up without the carry from the fraction to the integer part",
     [](auto& a, auto& b, auto&) { return Ulps(without_carry(a * b)); }, nullptr},
    any_format(Operation::mul, "(a >> {low}) * (b >> {high}), which drops the low {lost}",
               low_bits_dropped),
    any_format(Operation::mul,
               "a * b >> {F} in {bits} bits, which drops the high half of the product",
               high_half_dropped),
    {Operation::mul, "(int)((float)a * b / 65536), which has 24 bits",
     [](auto& a, auto& b, auto&) {
       return Ulps(cut(static_cast<float>(a) * static_cast<float>(b) / units_per_one));
     },
     nullptr},
    any_format(Operation::div, "({wide})a * {one} / b", quotient),
    any_format(Operation::div,
               "(({wide})a * {one} + b / 2) / b, which is off for operands of unlike signs",
               half_divisor_added),
    any_format(Operation::div, "(int)(x * {one} + 0.5), which cuts negative results toward zero",
               quotient_and_half),
    {Operation::div, "(int64_t)a * 256 / (b >> 8), which drops the low byte of b",
     [](auto& a, auto& b, auto&) { return b >> 8 == 0 ? Ulps() : Ulps(a * 256 / (b >> 8)); },
     nullptr},
    {Operation::div, "(int64_t)a * ((1LL << 32) / b) >> 16, which cuts the reciprocal",
     [](auto& a, auto& b, auto&) { return Ulps(a * ((std::int64_t{1} << 32) / b) >> 16); },
     nullptr},
    {Operation::div, "(int)((float)a / b * 65536), which has 24 bits",
     [](auto& a, auto& b, auto&) {
       return Ulps(cut(static_cast<float>(a) / static_cast<float>(b) * units_per_one));
     },
     nullptr},
    any_format(Operation::fmod, "a - b * floor(a / b), which has the sign of b", floored_rest),
    any_format(Operation::remainder, "a % b, the remainder of the truncated quotient",
               truncated_rest),
    any_format(Operation::remainder, "a - b * round(a / b), whose ties go away from zero",
               rest_of_ties_away),
    {Operation::add, "sums of fractions and integer parts, without the carry between them",
     [](auto& a, auto& b, auto&) { return Ulps(sum_of_halves(a, b)); }, nullptr},
    {Operation::sqrt, "(int)(sqrtf(a / 65536.0f) * 65536), which has 24 bits",
     [](auto& a, auto&, auto&) {
       return Ulps(cut(std::sqrt(static_cast<float>(a) / units_per_one) * units_per_one));
     },
     nullptr},
    {Operation::from_binary64, "(int)(x * {one} + 0.5), which cuts negative results toward zero",
     nullptr, value_and_half},
    {Operation::from_decimal, "(int)(x * {one} + 0.5), which cuts negative results toward zero",
     nullptr, value_and_half},
    {Operation::from_binary64, "(int)((float)x * {one}), which has 24 bits", nullptr, cut_single},
    {Operation::mul_div, "a * b >> k, which divides by 2^k where c is 2^k - 1", nullptr,
     shifted_instead},
    {Operation::mul_div, "(a * b + 2^(k-1)) >> k, which divides by 2^k where c is 2^k - 1", nullptr,
     half_and_shifted_instead},
    {Operation::mul_div, "(p + (p >> k) + 1) >> k for p = a * b and c = 2^k - 1", nullptr,
     shifted_after_one},
    {Operation::mul_div, "(t + (t >> k)) >> k for t = a * b + 2^(k-1) and c = 2^k - 1", nullptr,
     shifted_twice},
    {Operation::mul_div, "(a * b + c / 2) / c, which is off where the quotient is negative",
     nullptr, half_of_divisor_added},
    {Operation::mul_div, "a * b / c in {bits} bits, which drops the high half of the product",
     nullptr, low_product_divided},
}};

}  // namespace

bool Idiom::is_for(const cases::Variant& of) const {
  if (operation != of.operation || of.format.is_decimal) return false;
  if (operation == Operation::mul_div) return !of.from && of.format.fraction_bits >= 0;
  if (of.from && !cases::is_conversion(operation)) return false;
  // Without two fraction bits the idioms agree with each other or shift by a negative number.
  const int fraction_bits = of.format.fraction_bits;
  return of.format == cases::q16_16 ||
         (wide != nullptr && fraction_bits >= 2 && fraction_bits <= of.format.word_bits);
}

std::string Idiom::text_in(const Format& format) const {
  const int wide_bits = 2 * cases::storage_bits(format);
  const std::string sign = format.is_signed ? "" : "u";
  const Integer ulps = one<Integer>(format);
  const int low = format.fraction_bits / 2;
  const int high = format.fraction_bits - low;
  return fmt::format(
      fmt::runtime(text),
      fmt::arg("wide", wide_bits == 128 ? fmt::format("{}__int128", sign.empty() ? "" : "unsigned ")
                                        : fmt::format("{}int{}_t", sign, wide_bits)),
      fmt::arg("F", format.fraction_bits), fmt::arg("one", ulps.str()),
      fmt::arg("half", "0x" + (ulps / 2).str(0, std::ios_base::hex)), fmt::arg("low", low),
      fmt::arg("high", high), fmt::arg("lost", low == 8 && high == 8 ? "bytes" : "bits"),
      fmt::arg("bits", format.word_bits));
}

const std::array<Idiom, idiom_count>& idioms() { return all_idioms; }

void IdiomTrial::add(const JudgedCase& one, bool right) {
  ++cases_;
  if (!right) ++wrong_;
  const Format& format = variant_.format;
  const auto compare = [&](std::size_t i, const auto& result, const auto& word) {
    if (one.said != (result ? Said(word(*result)) : Said())) ++exceptions_.at(i);
  };
  const auto wide = format.as<oracle::Format>();
  const auto compare_wide = [&](const Integer& a, const Integer& b) {
    const auto word = [&wide](const Integer& ulps) { return oracle::wrap(ulps, wide); };
    for (std::size_t i = 0; i < all_idioms.size(); ++i) {
      if (!all_idioms.at(i).is_for(variant_)) continue;
      const auto result = all_idioms.at(i).wide(a, b, format);
      // Single precision rounds to the end of the range what lies before it.
      if (!result || oracle::fits(*result, wide)) compare(i, result, word);
    }
  };
  if (variant_.operation == Operation::mul_div) {
    const auto ulps = [&](std::size_t i) { return oracle::ulps(one.valued->words.at(i), wide); };
    return compare_wide(ulps(0) * ulps(1), ulps(2));
  }
  if (one.valued) {
    const auto& [numerator, denominator] = *one.valued->value;
    const oracle::Ratio unit = unit_of(format);
    return compare_wide(numerator * unit.denominator, denominator * unit.numerator);
  }
  const auto words = one.values().words();
  if (format == cases::q16_16) {
    const std::int64_t a = static_cast<std::int32_t>(words[0]);
    const std::int64_t b = static_cast<std::int32_t>(words[1]);
    const auto word = [](std::int64_t ulps) { return static_cast<std::uint32_t>(ulps); };
    for (std::size_t i = 0; i < all_idioms.size(); ++i) {
      if (all_idioms.at(i).operation != variant_.operation) continue;
      compare(i, all_idioms.at(i).narrow(a, b, format), word);
    }
    return;
  }
  compare_wide(oracle::ulps(words[0], wide), oracle::ulps(words[1], wide));
}

std::optional<Likeness> IdiomTrial::likeness() const {
  if (wrong_ == 0) return std::nullopt;
  Likeness best{.idioms = {}, .exceptions = cases_, .cases = cases_};
  for (std::size_t i = 0; i < all_idioms.size(); ++i) {
    if (!all_idioms.at(i).is_for(variant_) || exceptions_.at(i) > best.exceptions) continue;
    if (exceptions_.at(i) < best.exceptions) best.idioms.clear();
    best.exceptions = exceptions_.at(i);
    best.idioms.push_back(&all_idioms.at(i));
  }
  // An idiom must explain most of the defect, not only resemble sound arithmetic.
  if (100 * best.exceptions > cases_ || 10 * best.exceptions > wrong_) return std::nullopt;
  return best;
}

}  // namespace fixproof::check
