/// Tests batches of products and square roots in every named format under every rounding rule and
/// every rule for overflow against exact integers: multiply, mul_add and sqrt.
#include "tests/fixed/formats/batch_check.hpp"
#include "tests/fixed/formats/types.hpp"

namespace batch_formats {
namespace {

namespace batch = fixproof::batch;

constexpr auto products = []<class N>() {
  const Type type = Type::of<N>();
  const auto throws = throws_by<N::rules.product_range()>;
  check({type,
         [=](const integer& x, const integer& y, const integer&) { return product(type, x * y); },
         [](const Spans& of, const auto& how) {
           return batch::multiply(of.in<N>(0), of.in<N>(1), of.out<N>(), how);
         },
         throws});
  check({type,
         [=](const integer& x, const integer& y, const integer& z) {
           return product(type, x * y + z * type.one);
         },
         [](const Spans& of, const auto& how) {
           return batch::mul_add(of.in<N>(0), of.in<N>(1), of.in<N>(2), of.out<N>(), how);
         },
         throws});
};

constexpr auto roots = []<class N>() {
  const Type type = Type::of<N>();
  check(
      {type,
       [=](const integer& x, const integer&, const integer&) {
         if (x < 0) return Result{0, Fault::domain_error};
         // Roots saturate under policies that wrap.
         const bool traps = type.rules.range == overflow::trap;
         return narrowed(type, reference::root(x * type.one),
                         traps ? overflow::trap : overflow::saturate);
       },
       [](const Spans& of, const auto& how) { return batch::sqrt(of.in<N>(0), of.out<N>(), how); },
       throws_by<N::rules.range>});
};

constexpr policy products_trap{.multiply = fixproof::rounding::half_even,
                               .divide = fixproof::rounding::half_even,
                               .products = overflow::trap};

TEST(BatchesOfProducts, HalfUpWrap) { under<fixproof::policies::wrapping, Turn<0, 6>>(products); }
TEST(BatchesOfProducts, HalfEvenSaturate) { under<formats::even_saturate, Turn<1, 6>>(products); }
TEST(BatchesOfProducts, CeilingSaturate) { under<formats::ceiling_saturate, Turn<1, 6>>(products); }
TEST(BatchesOfProducts, HalfAwayTrap) { under<formats::away_trap, Turn<2, 6>>(products); }
TEST(BatchesOfProducts, TruncateSaturate) {
  under<formats::truncate_saturate, Turn<3, 6>>(products);
}
TEST(BatchesOfProducts, FloorWrapAndSumsTrap) { under<formats::mixed, Turn<4, 6>>(products); }
TEST(BatchesOfProducts, HalfEvenTrapAndSumsWrap) { under<products_trap, Turn<5, 6>>(products); }

TEST(BatchesOfRoots, Wrap) { under<fixproof::policies::wrapping, Turn<0, 3>>(roots); }
TEST(BatchesOfRoots, Saturate) { under<formats::even_saturate, Turn<1, 3>>(roots); }
TEST(BatchesOfRoots, Trap) { under<formats::away_trap, Turn<2, 3>>(roots); }

}  // namespace
}  // namespace batch_formats
