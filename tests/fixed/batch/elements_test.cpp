/// Tests multiply, multiply-add and square root on every path against the operators of the number
/// type, with every length and alignment.
#include "tests/fixed/batch/elements.hpp"

#include "tests/fixed/types.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

/// The operations of one type.
struct OfType {
  Operation products;
  Operation sums;
  Operation roots;

  friend std::ostream& operator<<(std::ostream& out, const OfType& all) {
    return out << all.products.type;
  }
};
constexpr auto operations_of = [](auto number) -> OfType {
  return {multiply(number), mul_add(number), square_root(number)};
};

class Elements : public testing::TestWithParam<OfType> {};
INSTANTIATE_TEST_SUITE_P(OfEachType, Elements,
                         testing::ValuesIn(of_each(fixproof::some_types(), operations_of)));

TEST_P(Elements, Multiply) { check_every_length(GetParam().products); }

TEST_P(Elements, MulAdd) { check_every_length(GetParam().sums); }

TEST_P(Elements, SquareRoot) { check_every_length(GetParam().roots); }

void check_pairs(const Operation& o, const Column& a, const Column& b) {
  Words want;
  for (std::size_t i = 0; i < a.size(); ++i) want.push_back(o.one(a[i], b[i], 0).raw);
  for (const auto path : paths()) {
    Column out(o.type, a.size());
    o.many(a.at(0), b.at(0), nullptr, out.at(0), a.size(), {path, {}});
    ASSERT_TRUE(same(out, Column(o.type, want))) << o.name << ", path " << static_cast<int>(path);
  }
}

// Covers every 8.8 pair in which one operand is near a value where the behaviour changes.
TEST(AllOf88, MultiplyAndDivide) {
  const std::type_identity<fixproof::q8_8> number;
  const Operation products = multiply(number);
  const Operation quotients = divide(number);
  Words words;
  for (Word raw = -32768; raw <= 32767; raw += 1) words.push_back(raw);
  const Column all(products.type, words);
  for (const int raw : {-32768, -32767, -257, -256, -255, -129, -128, -3,  -2,  -1,   0,    1,
                        2,      3,      127,  128,  129,  181,  255,  256, 257, 1000, 32767}) {
    const Column other(products.type, Words(words.size(), raw));
    SCOPED_TRACE(testing::Message() << "all and raw " << raw);
    check_pairs(products, all, other);
    check_pairs(quotients, all, other);
    check_pairs(quotients, other, all);
  }
}

}  // namespace
}  // namespace batch_test
