#include "tests/fixed/formats/reference.hpp"

#include <random>

namespace reference {

using fixproof::divide_fault;
using fixproof::overflow;

std::ostream& operator<<(std::ostream& out, const Type& type) {
  return out << (type.is_signed ? "signed " : "unsigned ") << type.bits() << " bits, "
             << type.fraction_bits << " after the point";
}

result in_range(const Type& type, const integer& value, overflow rule) {
  if (type.fits(value)) return value;
  if (rule == overflow::trap) return std::nullopt;
  if (rule == overflow::saturate) return value < 0 ? type.lowest() : type.highest();
  return type.wrapped(value);
}

result quotient(const Type& type, const integer& n, const integer& whole_divisor) {
  const overflow rule = type.rules.quotient_range();
  const divide_fault fault = type.rules.fault;
  const integer one = type.one();
  integer d = whole_divisor;
  if (type.rules.divisor == fixproof::divisor_width::whole_part) d = d / one * one;
  if (d == 0) {
    if (fault != divide_fault::none || rule == overflow::trap) return std::nullopt;
    if (n == 0) return n;
    return in_range(type, n < 0 ? -power(2, 100) : power(2, 100), overflow::saturate);
  }
  const integer scaled = n * one;
  if (fault == divide_fault::unsigned_quotient && abs(scaled / d) >= type.count()) {
    return std::nullopt;
  }
  const integer rounded =
      d < 0 ? round(-scaled, -d, type.rules.divide) : round(scaled, d, type.rules.divide);
  return in_range(type, rounded, fault == divide_fault::signed_quotient ? overflow::trap : rule);
}

std::vector<std::uint64_t> words(int bits, int random_count) {
  std::vector<std::uint64_t> values;
  for (int bit = 0; bit < bits; bit += bit % 8 == 7 || bit % 8 == 6 ? 1 : 3) {
    const std::uint64_t power = std::uint64_t{1} << bit;
    for (const std::uint64_t value : {power - 1, power, power + 1}) {
      values.push_back(value);
      values.push_back(0 - value);
    }
  }
  std::mt19937_64 random(19);
  for (int i = 0; i < random_count; ++i) {
    const std::uint64_t value = random() >> (random() % 64);
    values.push_back(random() % 2 == 0 ? value : 0 - value);
  }
  return values;
}

}  // namespace reference
