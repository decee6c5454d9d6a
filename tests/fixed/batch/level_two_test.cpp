/// Compares results, marks and reports for the 1.4 * 10^8 cases of `fixproof verify --level 2`, on
/// every path and under policies that no party of `verify` has. The run takes minutes;
/// FIXPROOF_STREAMS=1/20 selects the first of twenty parts.
#include <atomic>
#include <iostream>
#include <thread>

#include "app/cli/selection.hpp"
#include "tests/fixed/batch/check.hpp"
#include "tests/fixed/batch/expected.hpp"
#include "tests/fixed/batch/expected_vertex.hpp"
#include "tests/support/test.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"
#include "verify/parties/with_number.hpp"
#include "verify/report.hpp"

namespace batch_test {
namespace {

using fixproof::cases::Operation;

/// The default seed of a level.
constexpr std::uint64_t seed = 1994;

fixproof::cases::Shard part() {
  const char* const asked = std::getenv("FIXPROOF_STREAMS");
  return fixproof::cases::parse_shard(asked != nullptr ? asked : "1/1");
}

/// The operand words of a block of cases.
class Cases {
 public:
  Cases(const fixproof::cases::Plan& plan, const fixproof::cases::Chunk& chunk)
      : arity_(fixproof::cases::words_in(plan.rows()[0].variant.operation)),
        words_(chunk.cases * arity_) {
    fixproof::cases::make_cases(chunk.job->stream, plan.rows()[0].variant, plan.seed(), chunk.first,
                                words_);
  }

  [[nodiscard]] std::size_t count() const { return words_.size() / arity_; }

  template <class Number>
  [[nodiscard]] Number operand(std::size_t one, std::size_t which) const {
    return fixproof::parties::number_of<Number>(words_[one * arity_ + which]);
  }

  /// Operand `which` of each case, or of the case `after` places later.
  template <class Number>
  [[nodiscard]] std::vector<Number> column(std::size_t which, std::size_t after = 0) const {
    std::vector<Number> all;
    for (std::size_t i = 0; i < count(); ++i) {
      all.push_back(operand<Number>((i + after) % count(), which));
    }
    return all;
  }

 private:
  std::size_t arity_;
  std::vector<std::uint32_t> words_;
};

/// Calls compare(cases) for each block of the part on all processors, stops at the first failure
/// and prints progress.
template <class Compare>
void each_block(Operation operation, const Compare& compare) {
  const fixproof::cases::Plan plan(2, seed, {{{.operation = operation}, {"type", "batch"}}});
  const fixproof::cases::Shard shard = part();
  std::vector<std::uint64_t> blocks;
  for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk) {
    if (shard.has(chunk)) blocks.push_back(chunk);
  }
  ASSERT_FALSE(blocks.empty());
  std::atomic<std::size_t> next = 0;
  std::atomic<std::uint64_t> cases = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < blocks.size(); i = next++) {
      if (testing::Test::HasFailure()) return;
      const Cases block(plan, plan.chunk(blocks[i]));
      compare(block);
      cases += block.count();
      if ((i + 1) * 10 / blocks.size() != i * 10 / blocks.size()) {
        std::cout << "block " + std::to_string(i + 1) + " of " + std::to_string(blocks.size()) +
                         '\n'
                  << std::flush;
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
    threads.emplace_back(work);
  }
  for (std::thread& thread : threads) thread.join();
  std::cout << fixproof::cases::name_of(operation) << ": " << cases << " of " << plan.cases()
            << " cases\n";
}

template <class Number>
class LevelTwo : public testing::Test {};
using policies = testing::Types<fixproof::q16_16_saturating, fixproof::q16_16_trapping,
                                fixproof::q16_16_i386, fixproof::q16_16_i8088>;
TYPED_TEST_SUITE(LevelTwo, policies, );

TYPED_TEST(LevelTwo, Multiply) {
  each_block(Operation::mul, [](const Cases& cases) {
    const auto a = cases.column<TypeParam>(0);
    const auto b = cases.column<TypeParam>(1);
    std::vector<Expected<TypeParam>> want;
    for (std::size_t i = 0; i < a.size(); ++i) {
      want.push_back(expected<TypeParam>([](auto x, auto y) { return x * y; }, a[i], b[i]));
    }
    check<TypeParam>(want,
                     [&](auto out, auto how) { return fixproof::batch::multiply(a, b, out, how); });
  });
}

// The addend is the second operand of a later case, so that the lattice varies it independently.
TYPED_TEST(LevelTwo, MulAdd) {
  each_block(Operation::mul, [](const Cases& cases) {
    const auto a = cases.column<TypeParam>(0);
    const auto b = cases.column<TypeParam>(1);
    const auto c = cases.column<TypeParam>(1, 7919);
    std::vector<Expected<TypeParam>> want;
    for (std::size_t i = 0; i < a.size(); ++i) {
      want.push_back(expected<TypeParam>(
          [](auto x, auto y, auto z) { return fixproof::mul_add(x, y, z); }, a[i], b[i], c[i]));
    }
    check<TypeParam>(
        want, [&](auto out, auto how) { return fixproof::batch::mul_add(a, b, c, out, how); });
  });
}

TYPED_TEST(LevelTwo, Divide) {
  each_block(Operation::div, [](const Cases& cases) {
    const auto n = cases.column<TypeParam>(0);
    const auto d = cases.column<TypeParam>(1);
    std::vector<Expected<TypeParam>> want;
    for (std::size_t i = 0; i < n.size(); ++i) want.push_back(expected_quotient(n[i], d[i]));
    check<TypeParam>(want,
                     [&](auto out, auto how) { return fixproof::batch::divide(n, d, out, how); });
  });
}

/// Each case has its own transform. Its vertex takes each place of the widest register in turn. The
/// other vertices are zero, so only the translation remains of them.
template <class Number>
void check_transform(const Rows<Number>& rows, const Vertex<Number>& vertex, std::size_t place) {
  constexpr std::size_t block = 16;
  const auto own = expected_vertex(rows, vertex);
  std::vector<Coordinates<Number, 3>> want(block, {{rows[0][3], rows[1][3], rows[2][3]}});
  want[place % block] = own;
  check<Number, 3>(want, [&](auto how) {
    std::vector<Vertex<Number>> all(block);
    all[place % block] = vertex;
    if (place / block % 2 == 0)
      return std::pair(fixproof::batch::transform(rows, all, all, how), all);
    std::array<std::array<Number, block>, 3> columns{};
    auto& [x, y, z] = columns;
    for (std::size_t c = 0; c < 3; ++c) columns[c][place % block] = vertex[c];
    const auto report = fixproof::batch::transform(rows, x, y, z, x, y, z, how);
    for (std::size_t i = 0; i < block; ++i) all[i] = {x[i], y[i], z[i]};
    return std::pair(report, all);
  });
}

template <class Number>
Vertex<Number> vertex_of(const Cases& cases, std::size_t i) {
  return {cases.operand<Number>(i, 12), cases.operand<Number>(i, 13), cases.operand<Number>(i, 14)};
}

// The party `batch` of `verify` covers the wrapping policies.
TYPED_TEST(LevelTwo, Transform) {
  if (TypeParam::rules.range == fixproof::overflow::wrap) GTEST_SKIP() << "fixproof verify does it";
  each_block(Operation::xformvec, [](const Cases& cases) {
    for (std::size_t i = 0; i < cases.count(); ++i) {
      Rows<TypeParam> rows;
      for (std::size_t k = 0; k < 12; ++k) rows[k / 4][k % 4] = cases.operand<TypeParam>(i, k);
      check_transform(rows, vertex_of<TypeParam>(cases, i), i);
    }
  });
}

// The vertices form batches. The projection constant of a batch is the first coefficient of its
// first case.
TYPED_TEST(LevelTwo, Project) {
  constexpr std::size_t batch = 256;
  each_block(Operation::xformvec, [](const Cases& cases) {
    for (std::size_t first = 0; first < cases.count(); first += batch) {
      const auto constant = cases.operand<TypeParam>(first, 0);
      std::vector<Vertex<TypeParam>> vertices;
      std::vector<Coordinates<TypeParam, 2>> want;
      for (std::size_t i = first; i < std::min(first + batch, cases.count()); ++i) {
        vertices.push_back(vertex_of<TypeParam>(cases, i));
        want.push_back(expected_point(vertices.back(), constant));
      }
      check<TypeParam, 2>(want, [&](auto how) {
        std::vector<Point<TypeParam>> out(vertices.size());
        return std::pair(fixproof::batch::project(vertices, constant, out, how), out);
      });
    }
  });
}

}  // namespace
}  // namespace batch_test
