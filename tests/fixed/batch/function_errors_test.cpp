/// Checks that the functions of fixed/batch/functions.hpp throw what those of one number throw, on
/// every path.
#include <string>

#include "fixed/formats.hpp"
#include "tests/fixed/batch/functions.hpp"
#include "tests/support/thrown.hpp"

namespace batch_test {
namespace {

/// The operands of a function, by what it does with them.
template <class N>
struct Sorted {
  Numbers<N> x, y, results;  ///< operands with a result
  struct Fault {
    N x, y;
    Thrown thrown;
  };
  std::vector<Fault> faults;
};

template <class N>
Sorted<N> sorted(const BatchFunction<N>& f) {
  const Numbers<N> x = operands<N>(1000, 22);
  const Numbers<N> y = operands<N>(1000, 23);
  Sorted<N> all;
  for (std::size_t i = 0; i < x.size(); ++i) {
    N result;
    const Thrown thrown = thrown_by([&] { result = f.one(x[i], y[i]); });
    if (thrown == Thrown::nothing) {
      all.x.push_back(x[i]);
      all.y.push_back(y[i]);
      all.results.push_back(result);
    } else if (all.faults.size() < 100) {
      all.faults.push_back({x[i], y[i], thrown});
    }
  }
  return all;
}

/// Puts one fault, at another place each time, into a span whose other elements have results.
template <class N>
void expect_faults_alone(const BatchFunction<N>& f, const Sorted<N>& all, batch::path path) {
  constexpr std::size_t count = 40;  // whole registers, and a rest
  const bool has_results = all.results.size() >= count;
  for (std::size_t i = 0; i < all.faults.size(); ++i) {
    const auto& fault = all.faults[i];
    const std::size_t place = has_results ? i % count : 0;
    Numbers<N> x(count, fault.x);
    Numbers<N> y(count, fault.y);
    for (std::size_t k = 0; k < count && has_results; ++k) {
      if (k == place) continue;
      x[k] = all.x[k];
      y[k] = all.y[k];
    }
    Numbers<N> out(count);
    ASSERT_EQ(thrown_by([&] { f.many(x, y, out, path); }), fault.thrown)
        << f.name << " of raw " << fault.x.raw() << ' ' << fault.y.raw() << ", element " << place;
    for (std::size_t k = 0; k < place; ++k) {
      ASSERT_EQ(out[k], all.results[k]) << f.name << ", element " << k << " before " << place;
    }
  }
}

template <class Raw, int F>
void expect_same_endings() {
  using N = number<Raw, F, policies::trapping>;
  for (const BatchFunction<N>& f : all_functions<N>) {
    const Sorted<N> all = sorted(f);
    for (const batch::path path : every_path) {
      SCOPED_TRACE("path " + std::to_string(static_cast<int>(path)));
      Numbers<N> results(all.x.size());
      ASSERT_EQ(thrown_by([&] { f.many(all.x, all.y, results, path); }), Thrown::nothing) << f.name;
      ASSERT_EQ(results, all.results) << f.name;
      expect_faults_alone(f, all, path);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(BatchFunctionErrors, AreThoseOfOneNumber) {
  expect_same_endings<std::int32_t, 16>();
  expect_same_endings<std::int32_t, 30>();
  expect_same_endings<std::int16_t, 15>();
  expect_same_endings<std::int32_t, 32>();
}

}  // namespace
}  // namespace batch_test
