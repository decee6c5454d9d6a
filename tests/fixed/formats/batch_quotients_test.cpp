/// Tests batches of quotients in every named format under every rounding rule and every rule for
/// overflow and division against exact integers.
#include "tests/fixed/formats/batch_check.hpp"
#include "tests/fixed/formats/types.hpp"

namespace batch_formats {
namespace {

namespace batch = fixproof::batch;

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

TEST(BatchesOfQuotients, HalfUpWrap) { under<fixproof::policies::wrapping, Turn<0, 7>>(quotients); }
TEST(BatchesOfQuotients, HalfEvenSaturate) { under<formats::even_saturate, Turn<1, 7>>(quotients); }
TEST(BatchesOfQuotients, CeilingSaturate) {
  under<formats::ceiling_saturate, Turn<1, 7>>(quotients);
}
TEST(BatchesOfQuotients, HalfAwayTrap) { under<formats::away_trap, Turn<2, 7>>(quotients); }
TEST(BatchesOfQuotients, TruncateSaturateAndSumsTrap) {
  under<formats::mixed, Turn<3, 7>>(quotients);
}
TEST(BatchesOfQuotients, FloorWrap) { under<formats::floor_wrap, Turn<4, 7>>(quotients); }
TEST(BatchesOfQuotients, UnsignedFault) {
  under<fixproof::policies::i386_rounded, Turn<5, 7>>(quotients);
}
TEST(BatchesOfQuotients, SignedFault) { under<saturate_or_fault, Turn<6, 7>>(quotients); }

using formats_of_one =
    std::tuple<fixproof::q8_0, fixproof::q4_4, fixproof::u4_4, fixproof::q12_4, fixproof::q4_12,
               fixproof::q2_14, fixproof::u8_8, fixproof::q32_0, fixproof::q24_8, fixproof::q8_24,
               fixproof::q2_30, fixproof::u16_16, fixproof::q48_16, fixproof::u32_32>;
TEST(BatchesOfQuotients, WholeDivisors) {
  under<fixproof::policies::i8088_rounded, Turn<0, 2>, formats_of_one>(quotients);
}

}  // namespace
}  // namespace batch_formats
