#include "tests/fixed/property.hpp"

#include <rapidcheck.h>

#include <stdexcept>

#include "judge/property/generator.hpp"

namespace property {

namespace {

using Wide = fixproof::q16_16;
using Narrow = fixproof::q8_8;

template <class Number>
Raws raws_of(const std::vector<Number>& numbers) {
  Raws raws;
  for (const Number x : numbers) raws.push_back(x.raw());
  return raws;
}

template <class Number>
bool holds_for(int operands, const std::function<bool(const Raws&)>& check) {
  switch (operands) {
    case 1:
      return rc::check([&](Number a) { RC_ASSERT(check({a.raw()})); });
    case 2:
      return rc::check([&](Number a, Number b) { RC_ASSERT(check({a.raw(), b.raw()})); });
    case 3:
      return rc::check([&](Number a, Number b, Number c) {
        RC_ASSERT(check({a.raw(), b.raw(), c.raw()}));
      });
    default:
      throw std::invalid_argument("1 to 3 operands");
  }
}

template <class Number>
bool lists_hold(const std::function<bool(const Raws&, const Raws&)>& check) {
  return rc::check([&](const std::vector<Number>& a, const std::vector<Number>& b) {
    RC_ASSERT(check(raws_of(a), raws_of(b)));
  });
}

}  // namespace

bool holds(int fraction_bits, int operands, const std::function<bool(const Raws&)>& check) {
  return fraction_bits == Wide::fraction_bits ? holds_for<Wide>(operands, check)
                                              : holds_for<Narrow>(operands, check);
}

bool holds_for_lists(int fraction_bits,
                     const std::function<bool(const Raws&, const Raws&)>& check) {
  return fraction_bits == Wide::fraction_bits ? lists_hold<Wide>(check) : lists_hold<Narrow>(check);
}

bool holds_for_parts(const std::function<bool(bool, std::uint16_t, std::uint64_t)>& check) {
  return rc::check([&](bool negative, std::uint16_t whole, std::uint64_t fraction) {
    RC_ASSERT(check(negative, whole, fraction));
  });
}

}  // namespace property
