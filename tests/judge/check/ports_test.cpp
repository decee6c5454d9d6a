// Tests the rules of programs against other ways to compute them: the program's own floating point,
// or fractions that are rounded by the definition.
#include "judge/check/ports.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "judge/check/cases.hpp"
#include "tests/judge/check/port_cases.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof::check;
using fixproof::rounding;
using fixproof::cases::Format;
using fixproof::cases::Operation;
using fixproof::cases::variant_of;
using port_cases::Pair;
using port_cases::Pairs;

constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
constexpr int cases = 10'000'000;

const PortRule& rule_of(std::string_view name, Operation operation) {
  const auto rules = port_rules();
  const auto found = std::ranges::find_if(rules, [&](const PortRule& rule) {
    return rule.name == name && rule.operation == operation;
  });
  if (found == rules.end()) throw std::invalid_argument("no rule " + std::string(name));
  return *found;
}

Said word(std::int64_t value) { return static_cast<std::uint32_t>(value); }

/// Compares a rule with a function of its operands.
template <class Expected>
void expect_same(std::string_view name, Operation operation, int count, int shift,
                 const Expected& expected) {
  const PortRule& rule = rule_of(name, operation);
  Pairs pairs;
  int wrong = 0;
  for (int i = 0; i < count && wrong < 3; ++i) {
    const Pair pair = pairs.next();
    const std::array<std::int64_t, 3> x{pair.a, pair.b, pairs.next().b};
    const Said said = rule.result(x, shift);
    const Said right = expected(x);
    if (said == right) continue;
    ++wrong;
    ADD_FAILURE() << name << ' ' << rule.routine << " of " << x[0] << ' ' << x[1] << ' ' << x[2]
                  << ": " << said.value_or(0xDE) << ", not " << right.value_or(0xDE);
  }
}

Said of_double(double value) { return word(static_cast<std::int64_t>(value)); }

/// FixedDiv in C, with abs() of a machine that wraps and the double of FixedDiv2.
Said doom_in_double(std::int32_t a, std::int32_t b) {
  const auto size = [](std::int32_t x) { return x == least ? least : std::abs(x); };
  if (size(a) >> 14 >= size(b)) return word((a ^ b) < 0 ? least : most);
  if (b == 0) return std::nullopt;
  const double quotient = static_cast<double>(a) / static_cast<double>(b) * 65536.0;
  if (quotient >= 2147483648.0 || quotient < -2147483648.0) return std::nullopt;
  return of_double(quotient);
}

/// ftofix() of Allegro.
Said allegro_in_double(double x) {
  if (x > 32767.0) return word(most);
  if (x < -32767.0) return word(-most);
  return of_double(x * 65536.0 + (x < 0 ? -0.5 : 0.5));
}
double as_double(std::int64_t x) { return static_cast<double>(x) / 65536.0; }

/// An exact fraction by a rounding and the word that a result out of range becomes.
template <class Beyond>
Said by_definition(exact::integer n, exact::integer d, rounding rule, const Beyond& beyond) {
  const exact::integer x = exact::round(exact::ratio(n, d), rule);
  return x < least || x > most ? beyond(x) : word(static_cast<std::int64_t>(x));
}

Said faults(exact::integer) { return std::nullopt; }
Said wraps(exact::integer x) { return word(static_cast<std::int64_t>(exact::wrapped(x, 32))); }

TEST(Ports, DoomDividesDoublesAsItDividesIntegers) {
  expect_same("doom", Operation::div, cases, 16, [](const auto& x) {
    return doom_in_double(static_cast<std::int32_t>(x[0]), static_cast<std::int32_t>(x[1]));
  });
}

// A double quotient could only be wrong just below a whole number of ulps. The nearest are 1 / b
// below, for a * 65536 one less than a multiple of b.
TEST(Ports, DoomDividesDoublesAsIntegersAtTheHardestQuotients) {
  const PortRule& rule = rule_of("doom", Operation::div);
  std::mt19937 random(1994);
  int compared = 0;
  for (int i = 0; i < cases; ++i) {
    const auto b = static_cast<std::int64_t>((random() >> 1U >> random() % 8) | 1U);
    // b is odd. Sixteen halvings modulo b find the inverse of 2^16.
    std::int64_t inverse = 1;
    for (int bit = 0; bit < 16; ++bit) inverse = inverse % 2 == 0 ? inverse / 2 : (inverse + b) / 2;
    const std::int64_t first = (b - inverse) % b;
    const std::int64_t steps = (most - first) / b;
    const std::int64_t a =
        first + b * (steps == 0 ? 0 : static_cast<std::int64_t>(random()) % (steps + 1));
    if (a > most || a >> 14 >= b) continue;
    ASSERT_EQ(a % b * 65536 % b, b == 1 ? 0 : b - 1) << a << ' ' << b;
    ++compared;
    const double quotient = static_cast<double>(a) / static_cast<double>(b) * 65536.0;
    ASSERT_EQ(rule.result(std::array{a, b}, 16), of_double(quotient)) << a << ' ' << b;
    ASSERT_EQ(rule.result(std::array{a, -b}, 16), of_double(-quotient)) << a << ' ' << b;
  }
  EXPECT_GT(compared, cases / 2);
}

TEST(Ports, DoomGuardsBeforeItDivides) {
  const auto doom = [](std::int32_t a, std::int32_t b) {
    return rule_of("doom", Operation::div).result(std::array<std::int64_t, 2>{a, b}, 16);
  };
  EXPECT_EQ(doom(16384 * 65536, 65536), word(most));
  EXPECT_EQ(doom(16384 * 65536 - 1, 65536), word(16384 * 65536 - 1));
  EXPECT_EQ(doom(-16384 * 65536, 65536), word(least));
  EXPECT_EQ(doom(0, 0), word(most));
  EXPECT_EQ(doom(-1, 0), word(least));
  EXPECT_EQ(doom(1, least), word(least)) << "the size of the lowest divisor is below 0";
  EXPECT_EQ(doom(least, least), word(most));
  EXPECT_EQ(doom(least, 65536), word(least)) << "the lowest dividend passes the guard";
  EXPECT_EQ(doom(least, 65535), Said());
  EXPECT_EQ(doom(least, 0), Said());
}

TEST(Ports, ChocolateDoomDiffersWhereDoomFaults) {
  const PortRule& doom = rule_of("doom", Operation::div);
  int faulted = 0;
  expect_same("chocolate-doom", Operation::div, cases, 16, [&](const auto& x) {
    const Said said = doom.result(x, 16);
    if (said || x[1] == 0) return said;
    ++faulted;
    EXPECT_EQ(x[0], least);
    return by_definition(x[0] * exact::integer{65536}, x[1], rounding::truncate, wraps);
  });
  EXPECT_GT(faulted, 1000);
}

TEST(Ports, ProductsThatAreShiftedAreFloored) {
  for (const char* name : {"doom", "chocolate-doom", "descent"}) {
    expect_same(name, Operation::mul, cases / 10, 16, [](const auto& x) {
      return by_definition(exact::integer{x[0]} * x[1], 65536, rounding::floor, wraps);
    });
  }
  for (int shift = 1; shift <= 32; ++shift) {
    expect_same("build", Operation::mul, cases / 32, shift, [shift](const auto& x) {
      return by_definition(exact::integer{x[0]} * x[1], exact::integer{1} << shift, rounding::floor,
                           wraps);
    });
  }
}

TEST(Ports, RiseOfTheTriadRoundsProductsHalfUp) {
  expect_same("rott", Operation::mul, cases, 16, [](const auto& x) {
    return by_definition(exact::integer{x[0]} * x[1], 65536, rounding::half_up, wraps);
  });
}

TEST(Ports, QuotientsByIdivFaultOutOfRange) {
  for (const char* name : {"rott", "descent"}) {
    expect_same(name, Operation::div, cases / 10, 16, [](const auto& x) {
      if (x[1] == 0) return Said();
      return by_definition(x[0] * exact::integer{65536}, x[1], rounding::truncate, faults);
    });
  }
  for (int shift = 1; shift <= 32; ++shift) {
    expect_same("build", Operation::div, cases / 32, shift, [shift](const auto& x) {
      if (x[1] == 0) return Said();
      return by_definition(x[0] * (exact::integer{1} << shift), x[1], rounding::truncate, faults);
    });
  }
}

TEST(Ports, ProductsOverADivisorFaultOutOfRange) {
  for (const char* name : {"build", "rott", "descent"}) {
    expect_same(name, Operation::mul_div, cases / 3, 16, [](const auto& x) {
      if (x[2] == 0) return Said();
      return by_definition(exact::integer{x[0]} * x[1], x[2], rounding::truncate, faults);
    });
  }
}

// The lowest number is -32768, but Allegro's range ends at -32767.99998.
TEST(Ports, AllegroOnThe386CutsAndSaturates) {
  const auto ends = [](exact::integer x) { return word(x < 0 ? -most : most); };
  expect_same("allegro-i386", Operation::mul, cases, 16, [&](const auto& x) {
    return by_definition(exact::integer{x[0]} * x[1], 65536, rounding::floor, ends);
  });
  expect_same("allegro-i386", Operation::div, cases, 16, [&](const auto& x) {
    if (x[1] == 0) return word(x[0] < 0 ? -most : most);
    const Said said = by_definition(x[0] * exact::integer{65536}, x[1], rounding::truncate, ends);
    return said == word(least) ? word(-most) : said;
  });
}

TEST(Ports, AllegroInCRoundsQuotientsInDouble) {
  expect_same("allegro-c", Operation::div, cases, 16, [](const auto& x) {
    if (x[1] == 0) return word(x[0] < 0 ? -most : most);
    return allegro_in_double(as_double(x[0]) / as_double(x[1]));
  });
  expect_same("allegro-c", Operation::mul, cases, 16, [](const auto& x) {
    return by_definition(exact::integer{x[0]} * x[1], 65536, rounding::floor,
                         [](exact::integer y) { return word(y < 0 ? least : most); });
  });
  expect_same("allegro-double", Operation::mul, cases, 16,
              [](const auto& x) { return allegro_in_double(as_double(x[0]) * as_double(x[1])); });
}

/// FixedByFrac as its 16-bit code has it: digits of the magnitude, then two's complement.
Said by_digits(std::uint32_t a, std::uint32_t b) {
  const bool negative = ((a ^ b) >> 31U) != 0;
  const std::uint32_t size = a >> 31U != 0 ? ~a + 1 : a;
  const std::uint32_t fraction = b & 0xffff;
  const std::uint32_t low = (size & 0xffff) * fraction >> 16U;
  const std::uint32_t sum = (size >> 16U) * fraction + low;
  return negative ? ~sum + 1 : sum;
}

TEST(Ports, WolfensteinMultipliesMagnitudesByDigits) {
  expect_same("wolf3d", Operation::mul, cases, 16, [](const auto& x) {
    return by_digits(static_cast<std::uint32_t>(x[0]), static_cast<std::uint32_t>(x[1]));
  });
  const PortRule& rule = rule_of("wolf3d", Operation::mul);
  // -0.5 is 80008000h there, and the whole bits do not count.
  using Words = std::array<std::uint64_t, 2>;
  EXPECT_EQ(read_words(rule, {7, 0x80008000}), (Words{7, 0xffff8000}));
  EXPECT_EQ(read_words(rule, {7, 0x7fff8000}), (Words{7, 0x8000}));
  EXPECT_EQ(read_words(rule, {7, 0x80000000}), (Words{7, 0}));
}

// What proofs claim of a rule are its general rules.
TEST(Ports, GeneralRulesAreTheRule) {
  for (const PortRule& rule : port_rules()) {
    const Format& format = fixproof::cases::q16_16;
    Rules general = rules_of(rule, format);
    general.port = nullptr;
    Pairs pairs;
    int other = 0;
    for (int i = 0; i < 50'000; ++i) {
      const Pair pair = pairs.next();
      const std::array words{static_cast<std::uint32_t>(pair.a),
                             static_cast<std::uint32_t>(pair.b)};
      const std::array<std::uint64_t, 2> two{words[0], words[1]};
      const ValuedCase three =
          parse_valued(fmt::format("{:08x} {:08x} {:08x}", words[0], words[1],
                                   static_cast<std::uint32_t>(pairs.next().b)),
                       fixproof::cases::variant_of(Operation::mul_div, fixproof::cases::q16_16));
      const Operands operands = rule.operation == Operation::mul_div ? Operands(three) : two;
      if (!keeps(general, operands, result_of(rule, format, operands))) ++other;
    }
    EXPECT_EQ(other == 0, rule.is_general) << rule.name << ' ' << rule.routine << ": " << other;
  }
}

TEST(Ports, NamesAreOfOneRoutineEach) {
  std::set<std::pair<std::string_view, Operation>> names;
  for (const PortRule& rule : port_rules()) {
    EXPECT_TRUE(names.emplace(rule.name, rule.operation).second) << rule.name;
    EXPECT_TRUE(rule.is_for(variant_of(rule.operation, fixproof::cases::q16_16)));
    EXPECT_FALSE(rule.is_for(variant_of(rule.operation, fixproof::cases::q8_8)));
    EXPECT_EQ(rule.is_for(variant_of(rule.operation, fixproof::cases::format_named("q0_32"))),
              rule.has_shift);
    EXPECT_FALSE(rule.is_for(variant_of(rule.operation, fixproof::cases::format_named("q32_0"))));
    EXPECT_FALSE(rule.is_for(variant_of(rule.operation, fixproof::cases::format_named("u16_16"))));
  }
}

}  // namespace
