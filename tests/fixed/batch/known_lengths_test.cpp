/// Tests batches whose length the compiler knows. g++ then warned of accesses beyond the spans, in
/// code for longer ones.
#include "fixed/batch/batch.hpp"
#include "fixed/batch/conversions.hpp"
#include "tests/fixed/batch/expected.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

using fixproof::q16_16;

template <class T, std::size_t size>
std::vector<T> converted(const std::vector<q16_16>& from) {
  std::vector<T> to(size);
  fixproof::batch::to_floats(from, to);
  return to;
}

template <class T, std::size_t size>
std::vector<q16_16> read(const std::vector<T>& from) {
  std::vector<q16_16> to(size);
  fixproof::batch::from_floats(from, to);
  return to;
}

template <std::size_t size>
std::vector<q16_16> computed(const std::vector<q16_16>& x) {
  std::vector<q16_16> to(size);
  fixproof::batch::divide(x, x, to);
  fixproof::batch::multiply(to, x, to);
  fixproof::batch::mul_add(to, x, x, to);
  fixproof::batch::sqrt(to, to);
  return to;
}

template <std::size_t size>
void check_length() {
  const std::vector<q16_16> x(size, q16_16(1.5));
  EXPECT_EQ((converted<double, size>(x)), std::vector<double>(size, 1.5));
  EXPECT_EQ((converted<float, size>(x)), std::vector<float>(size, 1.5F));
  EXPECT_EQ((read<double, size>(std::vector<double>(size, 1.5))), x);
  EXPECT_EQ((read<float, size>(std::vector<float>(size, 1.5F))), x);
  // 1.5 * 1.5 + 1.5 = 3.75, whose root is 1.936492 = 126910 ulps.
  EXPECT_EQ(computed<size>(x), std::vector<q16_16>(size, q16_16::from_raw(126910)));
}

TEST(KnownLengths, GiveNoWarning) {
  check_length<1>();
  check_length<3>();
  check_length<5>();
  check_length<9>();
  check_length<17>();
}

}  // namespace
}  // namespace batch_test
