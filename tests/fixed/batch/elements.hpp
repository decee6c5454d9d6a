/// @file
/// The operations that work element by element, for types known at run time, and their checks.
#pragma once

#include "tests/fixed/batch/columns.hpp"
#include "tests/fixed/batch/expected.hpp"
#include "tests/support/test.hpp"

namespace batch_test {

/// The stored integer of an expected element, and its fault.
struct Result {
  Word raw;
  Fault fault;
};

/// An operation on numbers of one type. Those of fewer than three operands ignore the others.
struct Operation {
  Type type;
  const char* name;
  Result (*one)(Word a, Word b, Word c);
  Report (*many)(const void* a, const void* b, const void* c, void* out, std::size_t count,
                 const Options& how);

  friend std::ostream& operator<<(std::ostream& out, const Operation& o) {
    return out << o.name << ", " << o.type;
  }
};

template <class N>
Result result_of(const Expected<N>& x) {
  return {x.value.raw(), x.fault};
}

/// @name The operations of a type
/// \{

inline constexpr auto multiply = []<class N>(std::type_identity<N> /*number*/) -> Operation {
  return {
      Type::of<N>(), "multiply",
      [](Word a, Word b, Word) {
        return result_of(
            expected<N>([](auto x, auto y) { return x * y; }, number_of<N>(a), number_of<N>(b)));
      },
      [](const void* a, const void* b, const void*, void* out, std::size_t n, const Options& how) {
        return fixproof::batch::multiply(numbers<N>(a, n), numbers<N>(b, n), numbers<N>(out, n),
                                         how);
      }};
};

inline constexpr auto mul_add = []<class N>(std::type_identity<N> /*number*/) -> Operation {
  return {Type::of<N>(), "mul_add",
          [](Word a, Word b, Word c) {
            return result_of(
                expected<N>([](auto x, auto y, auto z) { return fixproof::mul_add(x, y, z); },
                            number_of<N>(a), number_of<N>(b), number_of<N>(c)));
          },
          [](const void* a, const void* b, const void* c, void* out, std::size_t n,
             const Options& how) {
            return fixproof::batch::mul_add(numbers<N>(a, n), numbers<N>(b, n), numbers<N>(c, n),
                                            numbers<N>(out, n), how);
          }};
};

inline constexpr auto divide = []<class N>(std::type_identity<N> /*number*/) -> Operation {
  return {
      Type::of<N>(), "divide",
      [](Word a, Word b, Word) {
        return result_of(expected_quotient(number_of<N>(a), number_of<N>(b)));
      },
      [](const void* a, const void* b, const void*, void* out, std::size_t n, const Options& how) {
        return fixproof::batch::divide(numbers<N>(a, n), numbers<N>(b, n), numbers<N>(out, n), how);
      }};
};

inline constexpr auto square_root = []<class N>(std::type_identity<N> /*number*/) -> Operation {
  return {
      Type::of<N>(), "sqrt",
      [](Word a, Word, Word) {
        auto root = expected<N>([](auto x) { return fixproof::sqrt(x); }, number_of<N>(a));
        if (a < 0) root.fault = Fault::domain_error;
        return result_of(root);
      },
      [](const void* a, const void*, const void*, void* out, std::size_t n, const Options& how) {
        return fixproof::batch::sqrt(numbers<N>(a, n), numbers<N>(out, n), how);
      }};
};

/// \}

/// The expected results of a batch, and their faults.
struct Wanted {
  Words raw;
  std::vector<Fault> faults;

  void push_back(const Result& one) {
    raw.push_back(one.raw);
    faults.push_back(one.fault);
  }
};

/// Checks an operation at every length. The operands have different alignments.
inline void check_every_length(const Operation& o) {
  const Words words = operands(o.type, 3300, 8);
  const Column all(o.type, words);
  for (const std::size_t n : lengths()) {
    const std::size_t a = n % 5;
    const std::size_t b = 1100 + n % 6;
    const std::size_t c = 2200 + n % 7;
    Wanted want;
    for (std::size_t i = 0; i < n; ++i) {
      want.push_back(o.one(words[a + i], words[b + i], words[c + i]));
    }
    for (const auto path : paths()) {
      Column out(o.type, n);
      Marked marked(n);
      const auto report = o.many(all.at(a), all.at(b), all.at(c), out.at(0), n, marked.how(path));
      SCOPED_TRACE(testing::Message() << o.name << ", path " << static_cast<int>(path));
      ASSERT_TRUE(same(out, Column(o.type, want.raw)));
      marked.check(report, want.faults);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

}  // namespace batch_test
