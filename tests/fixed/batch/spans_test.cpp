/// Tests every length to 130 at every kind of alignment, outputs that are inputs, and outputs that
/// overlap inputs.
#include "tests/fixed/batch/elements.hpp"
#include "tests/fixed/batch/expected.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

constexpr std::size_t longest = 130;

/// The operations of one type.
struct OfType {
  Type type;
  std::array<Operation, 4> operations;

  friend std::ostream& operator<<(std::ostream& out, const OfType& all) { return out << all.type; }
};
constexpr auto operations_of = []<class N>(std::type_identity<N> number) -> OfType {
  return {Type::of<N>(), {multiply(number), mul_add(number), divide(number), square_root(number)}};
};

using number_types = testing::Types<fixproof::q16_16, fixproof::q16_16_saturating,
                                    fixproof::q16_16_trapping, fixproof::q8_8_saturating>;

class Spans : public testing::TestWithParam<OfType> {
 protected:
  [[nodiscard]] static const Type& type() { return GetParam().type; }
  [[nodiscard]] static const std::array<Operation, 4>& operations() {
    return GetParam().operations;
  }
};
INSTANTIATE_TEST_SUITE_P(OfEachType, Spans,
                         testing::ValuesIn(of_each(number_types(), operations_of)));

/// Zeros that begin at a multiple of 64 bytes plus an offset.
class Aligned {
 public:
  explicit Aligned(std::size_t offset) : first_(offset) {}
  /// Those of the column.
  Aligned(std::size_t offset, const Column& numbers) : Aligned(offset) {
    std::copy(numbers.at(0), numbers.at(numbers.size()), begin());
  }
  [[nodiscard]] std::byte* begin() { return &all_[first_]; }

 private:
  std::size_t first_;
  alignas(64) std::array<std::byte, 1024> all_{};
};

/// Operands of an operation, and its results. The third operand is the first one.
struct Operands {
  Column a;
  Column b;
  Column want;
  std::vector<Fault> faults;

  Operands(const Operation& o, const Words& in_a, const Words& in_b)
      : a(o.type, in_a), b(o.type, in_b), want(o.type, in_a.size()) {
    Wanted results;
    for (std::size_t i = 0; i < in_a.size(); ++i) {
      results.push_back(o.one(in_a[i], in_b[i], in_a[i]));
    }
    want = Column(o.type, results.raw);
    faults = results.faults;
  }
  /// The first and the last operands are often the ones that a path treats apart.
  explicit Operands(const Operation& o)
      : Operands(o, operands(o.type, longest, 1), operands(o.type, longest, 2)) {}
};

/// Checks the first `n` results.
void check(const Operation& o, const void* a, const void* b, std::byte* out, std::size_t n,
           const Operands& x, fixproof::batch::path path) {
  Marked marked(n);
  const auto report = o.many(a, b, a, out, n, marked.how(path));
  Column got(o.type, n);
  std::copy(out, out + n * o.type.size, got.at(0));
  SCOPED_TRACE(testing::Message() << o.name << ", path " << static_cast<int>(path));
  ASSERT_TRUE(same(got, x.want, n));
  marked.check(report, {x.faults.begin(), x.faults.begin() + static_cast<std::ptrdiff_t>(n)});
}

TEST_P(Spans, OfEveryLengthAndAlignment) {
  for (const Operation& o : operations()) {
    const Operands x(o);
    for (const std::size_t at_a : {0U, 4U, 16U}) {
      for (const std::size_t at_b : {0U, 4U, 16U}) {
        for (const std::size_t at_out : {0U, 4U, 16U}) {
          Aligned a(at_a, x.a);
          Aligned b(at_b, x.b);
          for (std::size_t n = 0; n <= longest; ++n) {
            for (const auto path : paths()) {
              Aligned out(at_out);
              check(o, a.begin(), b.begin(), out.begin(), n, x, path);
              const std::byte* const end = out.begin() + n * type().size;
              ASSERT_TRUE(std::all_of(end, end + type().size,
                                      [](std::byte after) { return after == std::byte{}; }))
                  << o.name << " writes after its end";
            }
          }
        }
      }
    }
  }
}

TEST_P(Spans, MayBeOneSpan) {
  for (const Operation& o : operations()) {
    const Operands x(o);
    for (std::size_t n = 0; n <= longest; ++n) {
      for (const auto path : paths()) {
        Column a = x.a;
        check(o, a.at(0), x.b.at(0), a.at(0), n, x, path);
        Column b = x.b;
        check(o, x.a.at(0), b.at(0), b.at(0), n, x, path);
      }
    }
  }
}

// One element with a fault among many without one. Blocks before it are stored before its own is
// tested, and the output is an input.
TEST_P(Spans, MayBeOneSpanWithOneFault) {
  const Word one = Word{1} << type().fraction_bits;
  const auto check_fault_at = [&](const Operation& o, std::size_t n, std::size_t at) {
    for (const Word second : {Word{0}, type().lowest()}) {
      Words in_a(n, 2 * one);
      Words in_b(n, 3 * one / 2);
      in_a[at] = type().lowest();
      in_b[at] = second;
      const Operands x(o, in_a, in_b);
      for (const auto path : paths()) {
        Column a = x.a;
        check(o, a.at(0), x.b.at(0), a.at(0), n, x, path);
        Column b = x.b;
        check(o, x.a.at(0), b.at(0), b.at(0), n, x, path);
      }
    }
  };
  for (const Operation& o : operations()) {
    for (std::size_t n = 1; n <= 70; ++n) {
      for (std::size_t at = 0; at < n; ++at) check_fault_at(o, n, at);
    }
    // Whole groups of blocks, without and with a rest.
    for (const std::size_t n : {std::size_t{128}, longest}) {
      for (const std::size_t at : {std::size_t{0}, std::size_t{63}, std::size_t{64}, n - 1}) {
        check_fault_at(o, n, at);
      }
    }
  }
}

// One product just beyond the range among many within it.
TEST_P(Spans, WithOneOverflow) {
  const Operation& products = operations()[0];
  // The smallest whose square is out of range, and its negative.
  const auto highest = static_cast<double>(type().highest());
  const auto end =
      static_cast<Word>(std::ceil(std::sqrt(std::ldexp(highest, type().fraction_bits))));
  for (std::size_t at = 0; at < longest; ++at) {
    for (const Word factor : {end, -end}) {
      Words a(longest, 3);
      Words b(longest, -5);
      a[at] = end;
      b[at] = factor;
      const Operands x(products, a, b);
      for (const auto path : paths()) {
        Column out = x.a;
        check(products, x.a.at(0), x.b.at(0), out.at(0), longest, x, path);
      }
    }
  }
}

/// Checks an output that begins `shift` numbers after the first operand, or before it.
void check_overlap(const Operation& o, std::size_t n, std::size_t shift, fixproof::batch::path path,
                   bool ahead) {
  const Column before(o.type, operands(o.type, n + 2 * shift + 2, 5));
  Column all = before;
  const std::size_t from = ahead ? 1 : 1 + shift;
  const std::size_t to = ahead ? 1 + shift : 1;
  Marked marked(n);
  o.many(all.at(from), before.at(0), all.at(from), all.at(to), n, marked.how(path));
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i >= to && i < to + n) continue;
    ASSERT_EQ(all[i], before[i]) << o.name << ", " << n << " shifted by " << shift;
  }
}

// The results are unspecified, but nothing else is written.
TEST_P(Spans, ThatOverlapDoNotWriteElsewhere) {
  for (const Operation& o : operations()) {
    for (std::size_t n = 1; n <= 70; ++n) {
      for (const std::size_t shift : {1U, 3U, 8U, 15U, 16U, 17U}) {
        for (const auto path : paths()) {
          check_overlap(o, n, shift, path, false);
          check_overlap(o, n, shift, path, true);
        }
      }
    }
  }
}

}  // namespace
}  // namespace batch_test
