/// Tests batches of every named format under every rounding rule and every rule for overflow and
/// division against exact integers: multiply, mul_add, divide and sqrt.
#include "tests/fixed/formats/batch_check.hpp"
#include "tests/fixed/formats/types.hpp"

namespace batch_formats {
namespace {

namespace batch = fixproof::batch;

/// Whether an operation of overflow rule O throws for a fault.
template <overflow O>
bool throws_by(Fault fault) {
  return fault != Fault::none && O == overflow::trap;
}

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
           return product(type, x * y + z * type.one());
         },
         [](const Spans& of, const auto& how) {
           return batch::mul_add(of.in<N>(0), of.in<N>(1), of.in<N>(2), of.out<N>(), how);
         },
         throws});
};

constexpr auto quotients = []<class N>() {
  const Type type = Type::of<N>();
  check({type,
         [=](const integer& x, const integer& y, const integer&) { return quotient(type, x, y); },
         [](const Spans& of, const auto& how) {
           return batch::divide(of.in<N>(0), of.in<N>(1), of.out<N>(), how);
         },
         [](Fault fault) {
           const bool has_faults = N::rules.fault != fixproof::divide_fault::none;
           return (fault == Fault::divide_error && has_faults) ||
                  throws_by<N::rules.quotient_range()>(fault);
         }});
};

constexpr auto roots = []<class N>() {
  const Type type = Type::of<N>();
  check(
      {type,
       [=](const integer& x, const integer&, const integer&) {
         if (x < 0) return Result{0, Fault::domain_error};
         // Roots saturate under policies that wrap.
         const bool traps = type.rules.range == overflow::trap;
         return narrowed(type, reference::root(x * type.one()),
                         traps ? overflow::trap : overflow::saturate);
       },
       [](const Spans& of, const auto& how) { return batch::sqrt(of.in<N>(0), of.out<N>(), how); },
       throws_by<N::rules.range>});
};

constexpr policy products_trap{.multiply = fixproof::rounding::half_even,
                               .divide = fixproof::rounding::half_even,
                               .products = overflow::trap};
constexpr policy saturate_or_fault{.range = overflow::saturate,
                                   .fault = fixproof::divide_fault::signed_quotient};

TEST(BatchesOfProducts, HalfUpWrap) { under<fixproof::policies::wrapping>(products); }
TEST(BatchesOfProducts, HalfEvenSaturate) { under<formats::even_saturate>(products); }
TEST(BatchesOfProducts, HalfAwayTrap) { under<formats::away_trap>(products); }
TEST(BatchesOfProducts, TruncateSaturate) { under<formats::truncate_saturate>(products); }
TEST(BatchesOfProducts, FloorWrapAndSumsTrap) { under<formats::mixed>(products); }
TEST(BatchesOfProducts, HalfEvenTrapAndSumsWrap) { under<products_trap>(products); }

TEST(BatchesOfQuotients, HalfUpWrap) { under<fixproof::policies::wrapping>(quotients); }
TEST(BatchesOfQuotients, HalfEvenSaturate) { under<formats::even_saturate>(quotients); }
TEST(BatchesOfQuotients, HalfAwayTrap) { under<formats::away_trap>(quotients); }
TEST(BatchesOfQuotients, TruncateSaturateAndSumsTrap) { under<formats::mixed>(quotients); }
TEST(BatchesOfQuotients, FloorWrap) { under<formats::floor_wrap>(quotients); }
TEST(BatchesOfQuotients, UnsignedFault) { under<fixproof::policies::i386_rounded>(quotients); }
TEST(BatchesOfQuotients, SignedFault) { under<saturate_or_fault>(quotients); }

using formats_of_one =
    std::tuple<fixproof::q8_0, fixproof::q4_4, fixproof::u4_4, fixproof::q12_4, fixproof::q4_12,
               fixproof::q2_14, fixproof::u8_8, fixproof::q32_0, fixproof::q24_8, fixproof::q8_24,
               fixproof::q2_30, fixproof::u16_16, fixproof::q48_16, fixproof::u32_32>;
TEST(BatchesOfQuotients, WholeDivisors) {
  under<fixproof::policies::i8088_rounded, formats_of_one>(quotients);
}

TEST(BatchesOfRoots, Wrap) { under<fixproof::policies::wrapping>(roots); }
TEST(BatchesOfRoots, Saturate) { under<formats::even_saturate>(roots); }
TEST(BatchesOfRoots, Trap) { under<formats::away_trap>(roots); }

}  // namespace
}  // namespace batch_formats
