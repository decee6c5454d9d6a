/// Tests that batches touch no memory beside their spans: those begin or end at a page that cannot
/// be accessed.
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <limits>
#include <random>
#include <span>
#include <system_error>
#include <tuple>
#include <vector>

#include "fixed/batch/batch.hpp"
#include "fixed/batch/conversions.hpp"
#include "fixed/batch/functions.hpp"
#include "fixed/batch/radian.hpp"
#include "fixed/batch/vertices.hpp"
#include "fixed/presets.hpp"
#include "tests/fixed/batch/expected.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

using fixproof::q16_16;
using fixproof::q8_8;
using saturating = fixproof::q16_16_saturating;
using Options = fixproof::batch::options;
using fixproof::batch::path;

/// A page between two that cannot be accessed.
class Page {
 public:
  Page()
      : size_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
        all_(static_cast<std::byte*>(
            mmap(nullptr, 3 * size_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))) {
    if (all_ == MAP_FAILED || mprotect(all_ + size_, size_, PROT_READ | PROT_WRITE) != 0) {
      throw std::system_error(errno, std::generic_category(), "a page between two others");
    }
  }
  ~Page() { munmap(all_, 3 * size_); }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  /// `count` elements at the start or at the end.
  template <class Type>
  [[nodiscard]] std::span<Type> of(std::size_t count, bool at_end) const {
    const std::size_t bytes = count * sizeof(Type);
    EXPECT_LE(bytes, size_);
    std::byte* const first = all_ + size_ + (at_end ? size_ - bytes : 0);
    return {reinterpret_cast<Type*>(first), count};  // NOLINT(*-reinterpret-cast)
  }

 private:
  std::size_t size_;
  std::byte* all_;
};

struct Vertex {
  q16_16 x, y, z;
};
struct Point {
  q16_16 x, y;
};

/// Sets an element to a small number or, if `far`, to one that is a fault for most operations.
void set(double& out, int value, bool far) { out = far ? 1e300 * value : value / 64.0; }
void set(float& out, int value, bool far) {
  out = far ? std::numeric_limits<float>::infinity() : static_cast<float>(value) / 64;
}
template <fixproof::any_number Number>
void set(Number& out, int value, bool far) {
  out = far ? (value % 2 == 0 ? Number() : std::numeric_limits<Number>::lowest())
            : Number::from_raw(static_cast<typename Number::raw_type>(value));
}
void set(Vertex& out, int value, bool far) {
  set(out.x, value, far);
  set(out.y, 3 * value, far);
  set(out.z, 5 * value, far);
}

template <class Type>
struct Operand {
  Page page;

  /// Returns numbers that are the same for the same state of `random`. One in seven has a fault in
  /// most operations, if there are faults.
  std::span<Type> filled(std::size_t count, bool at_end, bool faults, std::mt19937& random) const {
    const std::span<Type> all = page.of<Type>(count, at_end);
    for (Type& x : all) {
      const int value = static_cast<int>(random() % 60000) - 30000;
      set(x, value, faults && value % 7 == 0);
    }
    return all;
  }
};

/// Runs a batch of `Out` from spans of `In` in such pages, with every length on every path, with
/// and without faults and marks. Its results are those of the portable path.
template <class Out, class... In, class Run>
void check(const Run& run) {
  const Page to;
  const Page marks;
  std::tuple<Operand<In>...> from;
  const auto results = [&](std::size_t n, path use, bool at_end, bool faults) {
    std::mt19937 random(static_cast<unsigned>(n));
    const std::span<Out> out = to.of<Out>(n, at_end);
    const std::span<bool> marked = marks.of<bool>(faults ? n : 0, at_end);
    // Braces, because they order the calls.
    const std::tuple<std::span<In>...> in = std::apply(
        [&](auto&... x) { return std::tuple{x.filled(n, at_end, faults, random)...}; }, from);
    std::apply([&](auto... x) { run(Options{.use = use, .marks = marked}, out, x...); }, in);
    const auto bytes = std::as_bytes(out);
    std::vector<std::byte> all(bytes.begin(), bytes.end());
    for (const bool mark : marked) all.push_back(static_cast<std::byte>(mark));
    return all;
  };
  for (const bool faults : {false, true}) {
    for (std::size_t n = 0; n <= 130; ++n) {
      const auto want = results(n, path::portable, false, faults);
      for (const path use : paths()) {
        ASSERT_EQ(results(n, use, false, faults), want) << n << ", path " << static_cast<int>(use);
        ASSERT_EQ(results(n, use, true, faults), want) << n << ", path " << static_cast<int>(use);
      }
    }
  }
}

TEST(PageEnds, OfProducts) {
  const auto multiply = [](const Options& how, auto out, auto a, auto b) {
    fixproof::batch::multiply(a, b, out, how);
  };
  check<q16_16, q16_16, q16_16>(multiply);
  check<saturating, saturating, saturating>(multiply);
  check<q8_8, q8_8, q8_8>(multiply);
  check<saturating, saturating, saturating, saturating>(
      [](const Options& how, auto out, auto a, auto b, auto c) {
        fixproof::batch::mul_add(a, b, c, out, how);
      });
  check<q16_16, q16_16, q16_16>([](const Options& how, auto out, auto a, auto b) {
    const q16_16 sum = fixproof::batch::dot(a, b, how.use);
    std::fill(out.begin(), out.end(), sum);
  });
}

TEST(PageEnds, OfQuotientsAndRoots) {
  const auto divide = [](const Options& how, auto out, auto n, auto d) {
    fixproof::batch::divide(n, d, out, how);
  };
  check<q16_16, q16_16, q16_16>(divide);
  check<saturating, saturating, saturating>(divide);
  check<q16_16, q16_16>(
      [](const Options& how, auto out, auto x) { fixproof::batch::sqrt(x, out, how); });
}

TEST(PageEnds, OfConversions) {
  const auto from = [](const Options& how, auto out, auto x) {
    fixproof::batch::from_floats(x, out, how);
  };
  check<q16_16, double>(from);
  check<q16_16, float>(from);
  check<q8_8, double>(from);
  check<fixproof::q16_16_i386_unrounded, double>(from);
  const auto to = [](const Options& how, auto out, auto x) {
    fixproof::batch::to_floats(x, out, how.use);
  };
  check<double, q16_16>(to);
  check<float, q16_16>(to);
  check<double, q8_8>(to);
}

TEST(PageEnds, OfFunctions) {
  check<q16_16, q16_16>(
      [](const Options& how, auto out, auto x) { fixproof::batch::exp(x, out, how.use); });
  check<q16_16, q16_16>(
      [](const Options& how, auto out, auto x) { fixproof::batch::log2(x, out, how.use); });
  check<q16_16, q16_16>(
      [](const Options& how, auto out, auto x) { fixproof::batch::sin(x, out, how.use); });
  // The second operand is written.
  check<q16_16, q16_16, q16_16>([](const Options& how, auto out, auto x, auto cosines) {
    fixproof::batch::sin_cos(x, out, cosines, how.use);
  });
}

// Where columns are written, the last operands are the other results.
TEST(PageEnds, OfVertices) {
  fixproof::detail::transform_rows<q16_16> rows{};
  for (auto& row : rows) row.fill(q16_16(0.25));
  check<Vertex, Vertex>([&](const Options& how, auto out, auto in) {
    fixproof::batch::transform(rows, in, out, how);
  });
  check<Vertex, Vertex>([&](const Options& how, auto out, auto in) {
    fixproof::batch::fused_transform(rows, in, out, how);
  });
  check<q16_16, q16_16, q16_16, q16_16, q16_16, q16_16>(
      [&](const Options& how, auto out, auto x, auto y, auto z, auto to_x, auto to_y) {
        fixproof::batch::transform(rows, x, y, z, to_x, to_y, out, how);
      });
  check<q16_16, q16_16, q16_16, q16_16, q16_16, q16_16>(
      [&](const Options& how, auto out, auto x, auto y, auto z, auto to_x, auto to_y) {
        fixproof::batch::fused_transform(rows, x, y, z, to_x, to_y, out, how);
      });
  check<Point, Vertex>([](const Options& how, auto out, auto in) {
    fixproof::batch::project(in, q16_16(160), out, how);
  });
  check<q16_16, q16_16, q16_16, q16_16, q16_16>(
      [](const Options& how, auto out, auto x, auto y, auto z, auto to_y) {
        fixproof::batch::project(x, y, z, q16_16(160), out, to_y, how);
      });
}

}  // namespace
}  // namespace batch_test
