#include "tests/fixed/formats/reference.hpp"

#include <algorithm>
#include <ostream>
#include <random>
#include <sstream>

namespace reference {

using fixproof::overflow;

integer root(const integer& n) {
  const integer r = floor_root(n);
  return n - r * r > r ? r + 1 : r;
}

Word Type::word(std::uint64_t value) const {
  const int unused = 64 - bits();
  const Word high = value << unused;
  return is_signed ? static_cast<Word>(static_cast<std::int64_t>(high) >> unused) : high >> unused;
}

Word Type::stored(const integer& x) const {
  return x < 0 ? 0 - static_cast<Word>(-x) : static_cast<Word>(x);
}

integer Type::value(Word stored) const {
  return is_signed ? integer(static_cast<std::int64_t>(stored)) : integer(stored);
}

std::ostream& operator<<(std::ostream& out, const Type& type) {
  return out << (type.is_signed ? "signed " : "unsigned ") << type.bits() << " bits, "
             << type.fraction_bits << " after the point";
}

Result product(const Type& type, const integer& sum) {
  return narrowed(type, round(sum, type.one, type.rules.multiply), type.rules.product_range());
}

Result quotient(const Type& type, const integer& n, const integer& d) {
  return policy_quotient<integer>(type, n, d);
}

Returned in_range(const Type& type, const integer& value, overflow rule) {
  return returned(type, narrowed(type, value, rule), rule);
}

Returned returned_product(const Type& type, const integer& sum) {
  return returned(type, product(type, sum), type.rules.product_range());
}

Returned returned_quotient(const Type& type, const integer& n, const integer& d) {
  return returned(type, quotient(type, n, d), type.rules.quotient_range());
}

std::string difference(const Type& type, const std::optional<Word>& got, const Returned& expected) {
  const Returned value = got ? Returned(type.value(*got)) : std::nullopt;
  if (value == expected) return {};
  const auto text = [](const Returned& x) { return x ? x->str() : "an error"; };
  return text(value) + ", expected " + text(expected);
}

std::string with_point(std::string digits, int places) {
  if (places == 0) return digits;
  const auto count = static_cast<std::size_t>(places);
  if (digits.size() <= count) digits.insert(0, count + 1 - digits.size(), '0');
  return digits.insert(digits.size() - count, ".");
}

std::string listed(const Type& type, const std::vector<Word>& words) {
  std::ostringstream text;
  text << "stored integers";
  for (const Word word : words) text << ' ' << type.value(word);
  text << " (" << type << ")";
  return text.str();
}

std::vector<Word> operands(const Type& type, int random_count) {
  std::vector<Word> values;
  const auto add = [&](std::uint64_t value) { values.push_back(type.word(value)); };
  for (int bit = 0; bit < type.bits(); bit += bit % 8 == 7 || bit % 8 == 6 ? 1 : 3) {
    const std::uint64_t power = std::uint64_t{1} << bit;
    for (const std::uint64_t value : {power - 1, power, power + 1}) {
      add(value);
      add(0 - value);
    }
  }
  std::mt19937_64 random(19);
  for (int i = 0; i < random_count; ++i) {
    const std::uint64_t value = random() >> (random() % 64);
    add(random() % 2 == 0 ? value : 0 - value);
  }
  return values;
}

std::vector<Word> distinct_operands(const Type& type, int random_count) {
  std::vector<Word> values = operands(type, random_count);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace reference
