/// Tests batches of dot in every named format against exact integers.
#include "tests/fixed/formats/batch_check.hpp"
#include "tests/fixed/formats/types.hpp"

namespace batch_formats {
namespace {

namespace batch = fixproof::batch;

constexpr auto dots = []<class N>() {
  const Type type = Type::of<N>();
  SCOPED_TRACE(testing::Message() << type);
  constexpr std::size_t size = 400;
  const auto a = operands(type, size, 4);
  const auto b = operands(type, size, 5);
  Column x(type, a);
  Column y(type, b);
  for (std::size_t count = 0; count <= 41; ++count) {
    const std::size_t at = 7 * count % (size - 41);
    const std::size_t terms = count <= 40 ? count : size - at;
    integer sum = 0;
    for (std::size_t i = at; i < at + terms; ++i) sum += a[i] * b[i];
    const Result want = product(type, sum);
    const bool throws =
        want.fault == Fault::overflow && type.rules.product_range() == overflow::trap;
    for (const path use : paths()) {
      const auto got = reference::outcome([&] {
        return integer(
            batch::dot(x.numbers<N>().subspan(at, terms), y.numbers<N>().subspan(at, terms), use)
                .raw());
      });
      ASSERT_EQ(got, throws ? std::nullopt : std::optional(want.raw)) << terms << " terms";
    }
  }
};

TEST(BatchesOfDots, HalfUpWrap) { under<fixproof::policies::wrapping, Turn<0, 4>>(dots); }
TEST(BatchesOfDots, HalfEvenSaturate) { under<formats::even_saturate, Turn<1, 4>>(dots); }
TEST(BatchesOfDots, CeilingSaturate) { under<formats::ceiling_saturate, Turn<1, 4>>(dots); }
TEST(BatchesOfDots, HalfAwayTrap) { under<formats::away_trap, Turn<2, 4>>(dots); }
TEST(BatchesOfDots, FloorWrapAndSumsTrap) { under<formats::mixed, Turn<3, 4>>(dots); }

}  // namespace
}  // namespace batch_formats
