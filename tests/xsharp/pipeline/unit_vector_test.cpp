/// Tests unit vectors by the exact length against the formula in double.
#include "xsharp/unit_vector.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/types.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using pipeline::number;
using pipeline::product_error;
using pipeline::triple;
using pipeline::ulp;

/// The bound of a component's error. A divide is within half an ulp or within one. The 8088's
/// whole-part divide makes components too large by up to 2^-12, which a Newton step reduces to
/// 3/2 * 2^-24; the step's products round.
template <class N>
double component_error() {
  if constexpr (std::same_as<N, double>) {
    return 1e-12;
  } else {
    const double quotient = N::rules.divide == fixproof::rounding::half_up ||
                                    N::rules.divide == fixproof::rounding::half_away
                                ? 0.501 * ulp
                                : 1.001 * ulp;
    if (!Arithmetic<N>::divides_by_whole_part()) return quotient;
    // The square's three products and the factor's one reach a component; so does its own. Each
    // component's quotient also reaches the square, twice times the component, at most sqrt(3).
    return quotient + std::sqrt(3.0) * quotient + 3.5 * product_error<N>() + ulp / 8;
  }
}

template <class N>
struct UnitVector : testing::Test {};
TYPED_TEST_SUITE(UnitVector, pipeline::all_types, );

TYPED_TEST(UnitVector, OfAnyLengthIsTheQuotientsByTheLength) {
  using N = TypeParam;
  EXPECT_TRUE(draws::hold_for_raws(3, [](const Integers& raws) {
    const auto part = [](std::int64_t raw) {
      return Arithmetic<N>::from_raw(static_cast<std::int32_t>(raw));
    };
    const Vec3<N> v{part(raws[0]), part(raws[1]), part(raws[2])};
    const Triple exact = triple(v);
    const double size = length(exact);
    if (size == 0 || size >= 32767) return true;
    const Triple is = triple(unit_vector(v));
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::fabs(is[i] - exact[i] / size) > component_error<N>()) return false;
    }
    return true;
  }));
}

TYPED_TEST(UnitVector, OfTheShortestAndTheLongest) {
  using N = TypeParam;
  const auto of = [](std::int32_t x, std::int32_t y, std::int32_t z) {
    return triple(unit_vector(Vec3<N>{Arithmetic<N>::from_raw(x), Arithmetic<N>::from_raw(y),
                                      Arithmetic<N>::from_raw(z)}));
  };
  EXPECT_EQ(of(0, 0, 0), (Triple{0, 0, 0}));
  EXPECT_NEAR(of(1, 0, 0)[0], 1, component_error<N>());
  EXPECT_NEAR(of(0, -1, 0)[1], -1, component_error<N>());
  EXPECT_NEAR(of(-2, 1, 2)[1], 1 / 3.0, component_error<N>());
  EXPECT_NEAR(of(0, 0, INT32_MIN + 1)[2], -1, component_error<N>());
  EXPECT_NEAR(of(0x48000000, 0x48000000, 0x48000000)[2], std::sqrt(1 / 3.0), component_error<N>());
}

// By hand: (2, 3, 6) has length 7, and so 2/7, 3/7 and 6/7: 18724.57, 28086.86 and 56173.71 units.
TEST(UnitVectorByHand, IsRoundedAsTheDivideRounds) {
  using Rounded = fixproof::q16_16_i386;
  using Cut = fixproof::q16_16_i386_unrounded;
  const auto rounded = unit_vector(Vec3<Rounded>{Rounded(2), Rounded(-3), Rounded(6)});
  EXPECT_EQ(rounded.x.raw(), 18725);
  EXPECT_EQ(rounded.y.raw(), -28087);
  EXPECT_EQ(rounded.z.raw(), 56174);
  const auto cut = unit_vector(Vec3<Cut>{Cut(2), Cut(-3), Cut(6)});
  EXPECT_EQ(cut.x.raw(), 18724);
  EXPECT_EQ(cut.y.raw(), -28086);
  EXPECT_EQ(cut.z.raw(), 56173);
}

// By hand: the 8088 divides by 8191, the whole part of the length 8191.9, so the quotient is
// 1.00011, seven units of 2^-16 too long. The Newton step leaves half a unit and its own roundings.
TEST(UnitVectorByHand, AWholePartDivideLeavesNoErrorOfLength) {
  using N = fixproof::q16_16_i8088;
  EXPECT_NEAR(static_cast<double>(unit_vector(Vec3<N>{number<N>(8191.9), N(0), N(0)}).x), 1,
              1.5 * ulp);
  EXPECT_NEAR(static_cast<double>(unit_vector(Vec3<N>{N(0), number<N>(-8191.9), N(0)}).y), -1,
              1.5 * ulp);
}

TEST(UnitVectorByHand, InFloat) {
  const Vec3<float> v = unit_vector(Vec3<float>{2e-30F, -3e-30F, 6e-30F});
  EXPECT_NEAR(static_cast<double>(v.x), 2 / 7.0, 2e-7);
  EXPECT_NEAR(static_cast<double>(v.y), -3 / 7.0, 2e-7);
  EXPECT_NEAR(static_cast<double>(v.z), 6 / 7.0, 2e-7);
  EXPECT_EQ(unit_vector(Vec3<float>{}), Vec3<float>{});
}

}  // namespace
}  // namespace xsharp
