#include "check/idioms.hpp"

#include <cmath>

namespace fixproof::check {

namespace {

using cases::Operation;
using Ulps = std::optional<std::int64_t>;

constexpr float scale = 65536;

/// Conversion to int truncates. The result is at most 2^48, so it fits.
Ulps cut(float value) { return static_cast<std::int64_t>(value); }

/// Cuts n / d + 1/2 toward zero.
Ulps half_and_cut(std::int64_t n, std::int64_t d) { return (2 * n + d) / (2 * d); }

/// Rounds up to nearest by adding a half, but drops the carry from the fraction.
Ulps without_carry(std::int64_t product) {
  const std::int64_t floor = product >> 16;
  const std::int64_t half = product >> 15 & 1;
  return (floor & ~std::int64_t{0xffff}) | ((floor + half) & 0xffff);
}

/// Adds fractions and integer parts apart.
Ulps sum_of_halves(std::int64_t a, std::int64_t b) {
  return (a & ~std::int64_t{0xffff}) + (b & ~std::int64_t{0xffff}) + ((a + b) & 0xffff);
}

std::int64_t low_word(std::int64_t value) { return static_cast<std::int32_t>(value); }

constexpr std::array<Idiom, idiom_count> all_idioms{{
    {Operation::mul, "(int64_t)a * b >> 16", [](auto a, auto b) { return Ulps(a * b >> 16); }},
    {Operation::mul, "(int64_t)a * b / 65536", [](auto a, auto b) { return Ulps(a * b / 65536); }},
    {Operation::mul, "((int64_t)a * b + 0x8000) >> 16",
     [](auto a, auto b) { return Ulps((a * b + 0x8000) >> 16); }},
    {Operation::mul, "(int)(x * 65536 + 0.5), which cuts negative results toward zero",
     [](auto a, auto b) { return half_and_cut(a * b, 65536); }},
    {Operation::mul, "((((int64_t)a * b + 0x80) >> 8) + 0x80) >> 8, which rounds twice",
     [](auto a, auto b) { return Ulps((((a * b + 0x80) >> 8) + 0x80) >> 8); }},
    {Operation::mul, "((((int64_t)a * b + 0x4000) >> 15) + 1) >> 1, which rounds twice",
     [](auto a, auto b) { return Ulps((((a * b + 0x4000) >> 15) + 1) >> 1); }},
    {Operation::mul, "half-up without the carry from the fraction to the integer part",
     [](auto a, auto b) { return without_carry(a * b); }},
    {Operation::mul, "(a >> 8) * (b >> 8), which drops the low bytes",
     [](auto a, auto b) { return Ulps((a >> 8) * (b >> 8)); }},
    {Operation::mul, "a * b >> 16 in 32 bits, which drops the high half of the product",
     [](auto a, auto b) { return Ulps(low_word(a * b) >> 16); }},
    {Operation::mul, "(int)((float)a * b / 65536), which has 24 bits",
     [](auto a, auto b) { return cut(static_cast<float>(a) * static_cast<float>(b) / scale); }},
    {Operation::div, "(int64_t)a * 65536 / b", [](auto a, auto b) { return Ulps(a * 65536 / b); }},
    {Operation::div, "((int64_t)a * 65536 + b / 2) / b, which is off for operands of unlike signs",
     [](auto a, auto b) { return Ulps((a * 65536 + b / 2) / b); }},
    {Operation::div, "(int)(x * 65536 + 0.5), which cuts negative results toward zero",
     [](auto a, auto b) { return half_and_cut(a * 65536, b); }},
    {Operation::div, "(int64_t)a * 256 / (b >> 8), which drops the low byte of b",
     [](auto a, auto b) { return b >> 8 == 0 ? Ulps() : Ulps(a * 256 / (b >> 8)); }},
    {Operation::div, "(int64_t)a * ((1LL << 32) / b) >> 16, which cuts the reciprocal",
     [](auto a, auto b) { return Ulps(a * ((std::int64_t{1} << 32) / b) >> 16); }},
    {Operation::div, "(int)((float)a / b * 65536), which has 24 bits",
     [](auto a, auto b) { return cut(static_cast<float>(a) / static_cast<float>(b) * scale); }},
    {Operation::add, "sums of fractions and integer parts, without the carry between them",
     sum_of_halves},
    {Operation::sqrt, "(int)(sqrtf(a / 65536.0f) * 65536), which has 24 bits",
     [](auto a, auto /*b*/) { return cut(std::sqrt(static_cast<float>(a) / scale) * scale); }},
}};

}  // namespace

const std::array<Idiom, idiom_count>& idioms() { return all_idioms; }

void IdiomTrial::add(const JudgedCase& one, bool right) {
  ++cases_;
  if (!right) ++wrong_;
  const std::int64_t a = static_cast<std::int32_t>(one.words[0]);
  const std::int64_t b = static_cast<std::int32_t>(one.words[1]);
  for (std::size_t i = 0; i < all_idioms.size(); ++i) {
    if (all_idioms.at(i).operation != operation_) continue;
    const Ulps result = all_idioms.at(i).result(a, b);
    const Said said = result ? Said(static_cast<std::uint32_t>(*result)) : Said();
    if (one.said != said) ++exceptions_.at(i);
  }
}

std::optional<Likeness> IdiomTrial::likeness() const {
  if (wrong_ == 0) return std::nullopt;
  Likeness best{.idioms = {}, .exceptions = cases_, .cases = cases_};
  for (std::size_t i = 0; i < all_idioms.size(); ++i) {
    if (all_idioms.at(i).operation != operation_ || exceptions_.at(i) > best.exceptions) continue;
    if (exceptions_.at(i) < best.exceptions) best.idioms.clear();
    best.exceptions = exceptions_.at(i);
    best.idioms.push_back(&all_idioms.at(i));
  }
  // An idiom must explain most of the defect, not only resemble sound arithmetic.
  if (100 * best.exceptions > cases_ || 10 * best.exceptions > wrong_) return std::nullopt;
  return best;
}

}  // namespace fixproof::check
