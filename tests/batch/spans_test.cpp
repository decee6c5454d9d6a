/// Tests every length to 130 at every kind of alignment, outputs that are inputs, and outputs that
/// overlap inputs.
#include "tests/batch/expected.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

constexpr std::size_t longest = 130;
constexpr std::size_t room = longest + 64;

template <class Number>
struct Operation {
  const char* name;
  std::function<Expected<Number>(Number, Number)> one;
  std::function<fixproof::batch::report(std::span<const Number>, std::span<const Number>,
                                        std::span<Number>, fixproof::batch::options)>
      many;
};

template <class N>
std::vector<Operation<N>> operations() {
  return {
      {"multiply", [](N a, N b) { return expected<N>([](auto x, auto y) { return x * y; }, a, b); },
       [](auto a, auto b, auto out, auto how) {
         return fixproof::batch::multiply(a, b, out, how);
       }},
      {"mul_add",
       [](N a, N b) {
         return expected<N>([](auto x, auto y) { return fixproof::mul_add(x, y, x); }, a, b);
       },
       [](auto a, auto b, auto out, auto how) {
         return fixproof::batch::mul_add(a, b, a, out, how);
       }},
      {"divide", [](N a, N b) { return expected_quotient(a, b); },
       [](auto a, auto b, auto out, auto how) { return fixproof::batch::divide(a, b, out, how); }},
      {"sqrt",
       [](N a, N) {
         auto root = expected<N>([](auto x) { return fixproof::sqrt(x); }, a);
         if (a.raw() < 0) root.fault = Fault::domain_error;
         return root;
       },
       [](auto a, auto, auto out, auto how) { return fixproof::batch::sqrt(a, out, how); }},
  };
}

/// Numbers that begin at a multiple of 64 bytes plus an offset.
template <class Number>
class Aligned {
 public:
  explicit Aligned(std::size_t offset) : first_(offset / sizeof(Number)) {}
  [[nodiscard]] std::span<Number> span(std::size_t n) { return std::span(all_).subspan(first_, n); }

 private:
  std::size_t first_;
  alignas(64) std::array<Number, room> all_{};
};

template <class Number>
class Spans : public testing::Test {};
using number_types = testing::Types<fixproof::q16_16, fixproof::q16_16_saturating,
                                    fixproof::q16_16_trapping, fixproof::q8_8_saturating>;
TYPED_TEST_SUITE(Spans, number_types);

template <class Number>
void check(const Operation<Number>& o, std::span<const Number> a, std::span<const Number> b,
           std::span<Number> out, const std::vector<Expected<Number>>& want,
           fixproof::batch::path path) {
  const std::size_t n = out.size();
  Marked marked(n);
  const auto report = o.many(a, b, out, marked.how(path));
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_EQ(out[i].raw(), want[i].value.raw())
        << o.name << ", path " << static_cast<int>(path) << ", " << i << " of " << n;
    faults.push_back(want[i].fault);
  }
  marked.check(report, faults);
}

/// The first and the last operands are often the ones that a path treats apart.
template <class Number>
struct Operands {
  std::vector<Number> a = operands<Number>(longest, 1);
  std::vector<Number> b = operands<Number>(longest, 2);
  std::vector<Expected<Number>> want;

  explicit Operands(const Operation<Number>& o) {
    for (std::size_t i = 0; i < longest; ++i) want.push_back(o.one(a[i], b[i]));
  }
};

TYPED_TEST(Spans, OfEveryLengthAndAlignment) {
  for (const auto& o : operations<TypeParam>()) {
    const Operands<TypeParam> x(o);
    for (const std::size_t at_a : {0U, 4U, 16U}) {
      for (const std::size_t at_b : {0U, 4U, 16U}) {
        for (const std::size_t at_out : {0U, 4U, 16U}) {
          Aligned<TypeParam> a(at_a);
          Aligned<TypeParam> b(at_b);
          std::copy(x.a.begin(), x.a.end(), a.span(longest).begin());
          std::copy(x.b.begin(), x.b.end(), b.span(longest).begin());
          for (std::size_t n = 0; n <= longest; ++n) {
            for (const auto path : paths()) {
              Aligned<TypeParam> out(at_out);
              check<TypeParam>(o, a.span(n), b.span(n), out.span(n), x.want, path);
              ASSERT_EQ(out.span(n + 1)[n], TypeParam()) << o.name << " writes after its end";
            }
          }
        }
      }
    }
  }
}

TYPED_TEST(Spans, MayBeOneSpan) {
  for (const auto& o : operations<TypeParam>()) {
    const Operands<TypeParam> x(o);
    for (std::size_t n = 0; n <= longest; ++n) {
      for (const auto path : paths()) {
        auto a = x.a;
        check<TypeParam>(o, std::span(a).first(n), std::span(x.b).first(n), std::span(a).first(n),
                         x.want, path);
        auto b = x.b;
        check<TypeParam>(o, std::span(x.a).first(n), std::span(b).first(n), std::span(b).first(n),
                         x.want, path);
      }
    }
  }
}

// One element with a fault among many without one. Blocks before it are stored before its own is
// tested, and the output is an input.
TYPED_TEST(Spans, MayBeOneSpanWithOneFault) {
  using N = TypeParam;
  using limits = std::numeric_limits<N>;
  for (const auto& o : operations<N>()) {
    for (std::size_t n = 1; n <= 70; ++n) {
      for (std::size_t at = 0; at < n; ++at) {
        for (const N second : {N(), limits::lowest()}) {
          std::vector<N> a(n, N(2));
          std::vector<N> b(n, N(1.5));
          a[at] = limits::lowest();
          b[at] = second;
          std::vector<Expected<N>> want;
          for (std::size_t i = 0; i < n; ++i) want.push_back(o.one(a[i], b[i]));
          for (const auto path : paths()) {
            auto x = a;
            check<N>(o, x, b, x, want, path);
            auto y = b;
            check<N>(o, a, y, y, want, path);
          }
        }
      }
    }
  }
}

// One product just beyond the range among many within it.
TYPED_TEST(Spans, WithOneOverflow) {
  using raw = typename TypeParam::raw_type;
  constexpr double highest = std::numeric_limits<raw>::max();
  constexpr double one = 1 << TypeParam::fraction_bits;
  const auto o = operations<TypeParam>()[0];
  // The smallest whose square is out of range, and its negative.
  const auto end = TypeParam::from_raw(static_cast<raw>(std::ceil(std::sqrt(highest * one))));
  for (std::size_t at = 0; at < longest; ++at) {
    for (const TypeParam factor : {end, TypeParam::from_raw(static_cast<raw>(-end.raw()))}) {
      Operands<TypeParam> x(o);
      std::fill(x.a.begin(), x.a.end(), TypeParam::from_raw(3));
      std::fill(x.b.begin(), x.b.end(), TypeParam::from_raw(-5));
      x.a[at] = end;
      x.b[at] = factor;
      for (std::size_t i = 0; i < longest; ++i) x.want[i] = o.one(x.a[i], x.b[i]);
      for (const auto path : paths()) {
        auto out = x.a;
        check<TypeParam>(o, x.a, x.b, out, x.want, path);
      }
    }
  }
}

// The results are unspecified, but nothing else is written.
TYPED_TEST(Spans, ThatOverlapDoNotWriteElsewhere) {
  for (const auto& o : operations<TypeParam>()) {
    for (std::size_t n = 1; n <= 70; ++n) {
      for (const std::size_t shift : {1U, 3U, 8U, 15U, 16U, 17U}) {
        for (const auto path : paths()) {
          const auto before = operands<TypeParam>(n + 2 * shift + 2, 5);
          for (const bool ahead : {false, true}) {
            auto all = before;
            const std::size_t from = ahead ? 1 : 1 + shift;
            const std::size_t to = ahead ? 1 + shift : 1;
            Marked marked(n);
            o.many(std::span(all).subspan(from, n), std::span(before).first(n),
                   std::span(all).subspan(to, n), marked.how(path));
            for (std::size_t i = 0; i < all.size(); ++i) {
              if (i >= to && i < to + n) continue;
              ASSERT_EQ(all[i], before[i]) << o.name << ", " << n << " shifted by " << shift;
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace batch_test
