/// Tests quotients on every path against the operator of the number type, with every length and
/// alignment, and quotients and roots around the points where their rounding changes, against exact
/// integers in every rounding mode of the processor. One file, so that each divide is compiled
/// once.
#include "fixed/batch/vectorizable.hpp"
#include "tests/fixed/batch/elements.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/rounding_mode.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

/// Stored integers of operands.
struct Pair {
  Word n, d;
};

/// Operands whose quotients are nearly ties or integers. They depend on the format alone.
template <class Raw, int fraction_bits>
std::vector<Pair> near_misses() {
  std::vector<Pair> pairs;
  for (const auto& [n, d] : exact::near_misses<fixproof::number<Raw, fraction_bits>>()) {
    pairs.push_back({n.raw(), d.raw()});
  }
  return pairs;
}

/// Divides of one type.
struct Division {
  Operation divide;
  std::vector<Pair> (*pairs)();
  /// Nothing if it throws.
  std::optional<Word> (*exact)(Word n, Word d);
  /// The same by vectorizable_divide().
  std::optional<Word> (*in_loop)(Word n, Word d);

  friend std::ostream& operator<<(std::ostream& out, const Division& x) {
    return out << x.divide.type;
  }
};
constexpr auto division_of = []<class N>(std::type_identity<N> number) -> Division {
  return {divide(number), near_misses<typename N::raw_type, N::fraction_bits>,
          [](Word n, Word d) {
            const auto want = exact::quotient(number_of<N>(n), number_of<N>(d));
            return want.throws ? std::nullopt : std::optional<Word>(want.raw);
          },
          [](Word n, Word d) -> std::optional<Word> {
            try {
              return fixproof::vectorizable_divide(number_of<N>(n), number_of<N>(d)).raw();
            } catch (const std::exception&) {
              return std::nullopt;
            }
          }};
};

class Quotients : public testing::TestWithParam<Division> {};
INSTANTIATE_TEST_SUITE_P(OfEachType, Quotients,
                         testing::ValuesIn(of_each(fixproof::dividing_types(), division_of)));

TEST_P(Quotients, EveryLength) { check_every_length(GetParam().divide); }

TEST_P(Quotients, OneZeroIsFoundAtEveryPlace) {
  const Operation& divide = GetParam().divide;
  constexpr std::size_t count = 70;
  const Words n(count, 1);
  // Above 0 in every format, and so is its whole part where a policy divides by that.
  const Word usual = Word{1} << (divide.type.bits() - 2);
  for (std::size_t at = 0; at < count; ++at) {
    Words d(count, usual);
    d[at] = 0;
    Wanted want;
    for (std::size_t i = 0; i < count; ++i) want.push_back(divide.one(n[i], d[i], 0));
    ASSERT_EQ(want.faults[at], Fault::divide_error);
    const Column ns(divide.type, n);
    const Column ds(divide.type, d);
    for (const auto path : paths()) {
      Column out(divide.type, count);
      Marked marked(count);
      const auto report =
          divide.many(ns.at(0), ds.at(0), nullptr, out.at(0), count, marked.how(path));
      SCOPED_TRACE(testing::Message() << "zero at " << at << ", path " << static_cast<int>(path));
      ASSERT_TRUE(same(out, Column(divide.type, want.raw)));
      marked.check(report, want.faults);
      if (HasFatalFailure()) return;
    }
  }
}

TEST_P(Quotients, AreExactInEveryRoundingMode) {
  const Operation& divide = GetParam().divide;
  Words n;
  Words d;
  std::vector<std::optional<Word>> want;
  for (const Pair& pair : GetParam().pairs()) {
    n.push_back(pair.n);
    d.push_back(pair.d);
    want.push_back(GetParam().exact(pair.n, pair.d));
  }
  const std::size_t count = n.size();
  ASSERT_GT(count, 17'000U);
  const Column ns(divide.type, n);
  const Column ds(divide.type, d);
  for (const auto path : paths()) {
    for (const int mode : RoundingMode::all) {
      Column out(divide.type, count);
      Marked marked(count);
      const auto how = marked.how(path);
      {
        const RoundingMode set(mode);
        divide.many(ns.at(0), ds.at(0), nullptr, out.at(0), count, how);
      }
      for (std::size_t i = 0; i < count; ++i) {
        if (want[i] ? out[i] == *want[i] : how.marks[i]) continue;
        FAIL() << "raw " << n[i] << " / raw " << d[i] << " is raw " << out[i]
               << (how.marks[i] ? ", marked," : "") << " instead of "
               << (want[i] ? "raw " + std::to_string(*want[i]) : "an error") << ", path "
               << static_cast<int>(path) << ", mode " << mode;
      }
    }
  }
}

// A constant expression divides integers in place of doubles.
constexpr fixproof::q16_16 zero(0);
constexpr fixproof::q16_16 one(1);
static_assert(fixproof::vectorizable_divide(-one, zero) ==
              std::numeric_limits<fixproof::q16_16>::lowest());
static_assert(fixproof::vectorizable_divide(one, zero) ==
              std::numeric_limits<fixproof::q16_16>::max());
static_assert(fixproof::vectorizable_divide(zero, zero) == zero);
static_assert(fixproof::vectorizable_divide(-one, fixproof::q16_16(3)).raw() == -21845);
static_assert(fixproof::vectorizable_divide(fixproof::q8_8(-1), fixproof::q8_8(0)) ==
              std::numeric_limits<fixproof::q8_8>::lowest());

// Both forms of n / 0 agree. Each compiler has one of the vectorizable forms.
template <class Raw>
constexpr bool limits_agree() {
  using limits = std::numeric_limits<Raw>;
  for (const Raw n : {limits::min(), Raw{-1}, Raw{0}, Raw{1}, limits::max()}) {
    const Raw limit = fixproof::detail::limit_toward_zero(n);
    if (fixproof::detail::vectorizable_limit(n) != limit) return false;
  }
  return true;
}
static_assert(limits_agree<std::int8_t>() && limits_agree<std::int16_t>() &&
              limits_agree<std::int32_t>());

TEST_P(Quotients, AreExactInLoops) {
  std::vector<Pair> pairs = GetParam().pairs();
  const Type& type = GetParam().divide.type;
  for (const Word n : {type.lowest(), Word{-3}, Word{0}, Word{3}, type.highest()}) {
    pairs.push_back({n, 0});
  }
  for (const auto& [n, d] : pairs) {
    const std::optional<Word> want = GetParam().exact(n, d);
    for (const int mode : RoundingMode::all) {
      std::optional<Word> quotient;
      {
        const RoundingMode set(mode);
        quotient = GetParam().in_loop(n, d);
      }
      ASSERT_EQ(quotient, want) << "raw " << n << " / raw " << d << ", mode " << mode;
    }
  }
}

template <int plus, int shift, bool rounds>
void check_floor(double x) {
  const std::uint64_t bits = fixproof::detail::placed_floor<plus, shift, rounds>(x);
  const std::uint64_t place = fixproof::detail::place_of_floors<shift, rounds>;
  const auto word = static_cast<std::int64_t>(bits - place);
  const double shifted = std::ldexp(x, shift);
  if (std::abs(shifted) < 0x1p50) {
    EXPECT_EQ(word, static_cast<std::int64_t>(std::floor(shifted)) + plus) << x;
  } else {
    EXPECT_GE(std::abs(word), (std::int64_t{1} << 50) - 1) << x;
  }
}

/// By an instruction, and without.
template <int plus, int shift>
void check_every_floor(double x) {
  check_floor<plus, shift, false>(x);
  check_floor<plus, shift, true>(x);
}

TEST(Floors, OfEveryKindOfDoubleInEveryRoundingMode) {
  using limits = std::numeric_limits<double>;
  for (const double x :
       {0.0, limits::denorm_min(), 0.25, 0.5, 0x1.fffffffffffffp-1, 1.0, 0x1.0000000000001p0, 1.5,
        0x1.fffffffffffffp0, 0x1.fffffffffffffp49, 0x1p50, 0x1p51, 0x1.8p52, 0x1p53, 1e308,
        limits::infinity(), limits::quiet_NaN()}) {
    for (const int mode : RoundingMode::all) {
      const RoundingMode set(mode);
      for (const double either : {x, -x}) {
        check_every_floor<0, 0>(either);
        check_every_floor<1, 0>(either);
        check_every_floor<1, 1>(either);
        check_every_floor<1, 17>(either);
        check_every_floor<1, 17>(std::ldexp(either, -17));
        check_every_floor<1, 33>(std::ldexp(either, -33));
      }
    }
  }
}

/// Divides 1 and 0 by 0.
template <class N>
void check_zero_divisor() {
  const volatile typename N::raw_type none = 0;
  const auto d = N::from_raw(none);
  std::feclearexcept(FE_ALL_EXCEPT);
  const N of_one = fixproof::vectorizable_divide(N(1), d);
  const N of_zero = fixproof::vectorizable_divide(N(0), d);
  EXPECT_EQ(std::fetestexcept(FE_DIVBYZERO | FE_INVALID), 0);
  EXPECT_EQ(of_one, std::numeric_limits<N>::max());
  EXPECT_EQ(of_zero, N(0));
}

TEST(Quotients, DivideNoDoubleByZero) {
  check_zero_divisor<fixproof::q16_16>();
  check_zero_divisor<fixproof::q16_16_saturating>();
  constexpr fixproof::policy truncating{.divide = fixproof::rounding::truncate};
  check_zero_divisor<fixproof::number<std::int32_t, 16, truncating>>();
}

/// Checks every path in every rounding mode of the processor.
void check_roots(const Operation& root, const Words& x, const Words& want) {
  const Column from(root.type, x);
  for (const auto path : paths()) {
    for (const int mode : RoundingMode::all) {
      // Up to eight are half a block of AVX-512.
      for (const std::size_t piece : {x.size(), std::size_t{8}}) {
        Column out(root.type, x.size());
        {
          const RoundingMode set(mode);
          for (std::size_t i = 0; i < x.size(); i += piece) {
            const std::size_t count = std::min(piece, x.size() - i);
            root.many(from.at(i), nullptr, nullptr, out.at(i), count, {path, {}});
          }
        }
        ASSERT_TRUE(same(out, Column(root.type, want)))
            << "path " << static_cast<int>(path) << ", mode " << mode << ", " << piece
            << " at a time";
      }
    }
  }
}

// The root of r (r + 1) lies nearest to r + 1/2, and the root of a square is exact.
TEST(Roots, AreNearestInEveryRoundingMode) {
  Words x;
  Words want;
  std::mt19937_64 random(22);
  while (x.size() < 3000) {
    const auto r = static_cast<std::int64_t>(random() % 11863283);
    // Chooses raw so that raw * 2^16 is near r^2 or r (r + 1).
    for (const std::int64_t target : {r * r, r * (r + 1)}) {
      for (const int step : {0, 1}) {
        const std::int64_t raw = target / 65536 + step;
        if (raw > std::numeric_limits<std::int32_t>::max()) continue;
        x.push_back(raw);
        auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(raw) * 65536)) - 2;
        while ((2 * root + 1) * (2 * root + 1) < 4 * raw * 65536) ++root;
        want.push_back(std::max<std::int64_t>(root, 0));
      }
    }
  }
  check_roots(square_root(std::type_identity<fixproof::q16_16>()), x, want);
}

TEST(Roots, OfEvery88WordInEveryRoundingMode) {
  Words x;
  Words want;
  int root = 0;
  for (int raw = -32768; raw <= 32767; ++raw) {
    x.push_back(raw);
    // Finds the nearest root: the first one whose upper half-way point, squared, exceeds the
    // operand.
    while (raw > 0 && (2 * root + 1) * (2 * root + 1) < 4 * 256 * raw) ++root;
    want.push_back(root);
  }
  check_roots(square_root(std::type_identity<fixproof::q8_8>()), x, want);
}

}  // namespace
}  // namespace batch_test
