/// @file
/// Checks a batch against the expected elements on every path of this processor. The calls are
/// std::function, so that the checks are compiled once for each type of number.
#pragma once

#include "tests/fixed/batch/expected.hpp"
#include "tests/fixed/batch/expected_vertex.hpp"
#include "tests/support/test.hpp"

namespace batch_test {

/// Checks `call(out, options)`, which computes the results of `want`, on every path.
template <class Number>
void check(const std::vector<Expected<Number>>& want,
           const std::function<fixproof::batch::report(std::span<Number>,
                                                       fixproof::batch::options)>& call) {
  std::vector<Fault> faults;
  for (const auto& one : want) faults.push_back(one.fault);
  for (const auto on : paths()) {
    Guarded<Number> out(want.size());
    Marked marked(want.size());
    const auto report = call(out.inside(), marked.how(on));
    for (std::size_t i = 0; i < want.size(); ++i) {
      ASSERT_EQ(out.inside()[i].raw(), want[i].value.raw())
          << "path " << static_cast<int>(on) << ", element " << i << " of " << want.size();
    }
    marked.check(report, faults);
    ASSERT_TRUE(out.intact());
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// Checks `call(options)`, which returns the report of a batch and its results, on every path.
template <class Number, std::size_t size>
void check(
    const std::vector<Coordinates<Number, size>>& want,
    const std::function<std::pair<fixproof::batch::report, std::vector<std::array<Number, size>>>(
        fixproof::batch::options)>& call) {
  std::vector<Fault> faults;
  for (const auto& one : want) faults.push_back(one.fault);
  for (const auto path : paths()) {
    Marked marked(want.size());
    const auto [report, got] = call(marked.how(path));
    for (std::size_t i = 0; i < want.size(); ++i) {
      for (std::size_t c = 0; c < size; ++c) {
        ASSERT_EQ(got[i][c].raw(), want[i].values[c].raw())
            << "path " << static_cast<int>(path) << ", element " << i << " of " << want.size()
            << ", coordinate " << c;
      }
    }
    marked.check(report, faults);
    if (testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace batch_test
