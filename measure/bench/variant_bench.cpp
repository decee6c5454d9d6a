// Times forms of conversions from double and of quotients, to see what each promise of ours costs,
// and what a branch on the divisor's sign costs: in loops over arrays, in chains, and over so many
// random signs that no processor learns them. Prints how many results of each form are not the
// exact ones. Needs no library:
//
//     g++ -std=c++20 -O3 -march=native -fno-math-errno -I. measure/bench/variant_bench.cpp -o
//     variant_bench && ./variant_bench
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "fixed/batch/vectorizable.hpp"
#include "fixed/fixed.hpp"
#include "measure/bench/least_time.hpp"

namespace {

using fixproof::q16_16;
using Word = std::int32_t;
using Wide = std::int64_t;

// Its sum with an integer has that integer in its low bits; the mode rounds what is no integer.
constexpr double place = 0x1.8p52;
Word placed(double x) { return static_cast<Word>(std::bit_cast<std::uint64_t>(x + place)); }

struct ExactFrom {
  static Word of(double x) {
    return static_cast<Word>(std::floor(static_cast<long double>(x) * 65536 + 0.5L));
  }
};
struct From {
  static constexpr const char* name = "ours";
  static Word of(double x) { return fixproof::vectorizable_from<q16_16>(x).raw(); }
};
struct FromToEven {
  static constexpr const char* name = "halves to even, in the nearest mode alone";
  static Word of(double x) { return placed(x * 65536); }
};
struct FromByRint {
  static constexpr const char* name = "peer: rint";
  static Word of(double x) { return static_cast<Word>(std::rint(x * 65536)); }
};

struct ExactQuotient {
  static Word of(Word n, Word d) {
    using limits = std::numeric_limits<Word>;
    if (d == 0) return n == 0 ? 0 : n < 0 ? limits::min() : limits::max();
    const Wide top = d < 0 ? -Wide{n} : Wide{n};
    const Wide below = d < 0 ? -Wide{d} : Wide{d};
    const Wide twice = top * 131072 + below;
    const Wide quotient = twice / (2 * below);
    return static_cast<Word>(quotient - Wide{twice % (2 * below) < 0});
  }
};
struct Quotient {
  static constexpr const char* name = "ours";
  static Word of(Word n, Word d) {
    return fixproof::vectorizable_divide(q16_16::from_raw(n), q16_16::from_raw(d)).raw();
  }
};
struct QuotientInTheMode {
  static constexpr const char* name = "rounds in the current mode";
  static Word of(Word n, Word d) {
    const Word by_zero = -Word{d == 0};
    const auto divisor = static_cast<double>(d);
    const double quotient = n / (divisor + (divisor == 0 ? 1.0 : 0.0)) * 65536;
    return (placed(quotient) & ~by_zero) | (fixproof::detail::vectorizable_limit(n) & by_zero);
  }
};
struct QuotientOfNoZero {
  static constexpr const char* name = "no zero divisors";
  static Word of(Word n, Word d) {
    const double sum = static_cast<double>(n) / d * 65536 + 0.5;
    return static_cast<Word>(fixproof::detail::placed_floor<0>(sum));
  }
};
struct QuotientByRint {
  static constexpr const char* name = "peer: neither";
  static Word of(Word n, Word d) {
    return static_cast<Word>(std::rint(static_cast<double>(n) * 65536 / d));
  }
};

struct Operator {
  static constexpr const char* name = "ours";
  static Word of(Word n, Word d) { return (q16_16::from_raw(n) / q16_16::from_raw(d)).raw(); }
};
struct SignedShift {
  static constexpr const char* name = "a signed division and a shift";
  static Word of(Word n, Word d) { return static_cast<Word>((Wide{n} * 131072 / d) >> 1); }
};
struct UnsignedShift {
  static constexpr const char* name = "an unsigned division and a shift";
  static Word of(Word n, Word d) {
    const std::uint64_t twice = std::uint64_t{static_cast<std::uint32_t>(n)} << 17;
    return static_cast<Word>(twice / static_cast<std::uint32_t>(d) >> 1);
  }
};

/// The bits of the operator, with a branch that suits positive divisors: they need fewer steps
/// before and after the division.
struct DivisorBranch {
  static constexpr const char* name = "a branch on the divisor's sign";
  static Word of(Word n, Word d) {
    if (d > 0) [[likely]] {
      const Wide below{n < 0};
      return static_cast<Word>(((Wide{n} * 131072 + below) / d + (1 - below)) >> 1);
    }
    return Operator::of(n, d);
  }
};

// `few` elements stay in the first cache, wherever they lie. `many` are more than a branch
// predictor learns.
constexpr std::size_t few = 1024;
constexpr std::size_t many = 1 << 20;
using Words = std::array<Word, many>;
struct Operands {
  alignas(64) std::array<double, many> x;
  alignas(64) Words n;
  alignas(64) Words d;
  alignas(64) Words out;
};

// The caller has the length, so that no loop has one that the compiler knows.
template <class Form>
struct Loop {
  [[gnu::noinline]] static void run(Operands& all, std::size_t length) {
    Word* __restrict const out = all.out.data();
    for (std::size_t i = 0; i < length; ++i) {
      if constexpr (std::is_invocable_v<decltype(Form::of), double>) {
        out[i] = Form::of(all.x[i]);
      } else {
        out[i] = Form::of(all.n[i], all.d[i]);
      }
    }
    bench::keep(all);
  }
};

template <class Form>
struct Chain {
  [[gnu::noinline]] static void run(Operands& all, std::size_t length) {
    Word last = 0x18000;
    for (std::size_t i = 0; i < length; ++i) all.out[i] = last = Form::of(all.d[i], last);
    bench::keep(all);
  }
};

template <class Run>
std::vector<Word> results_of(Operands& all, std::size_t count) {
  Run::run(all, count);
  return {all.out.begin(), all.out.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// @return whether the first form, ours, has the exact results
template <template <class> class Shape, class Exact, class... Forms>
bool time_forms(const char* what, Operands& all, std::size_t count = few) {
  const std::vector<Word> exact = results_of<Shape<Exact>>(all, count);
  const auto wrong = [&](const std::vector<Word>& results) {
    std::size_t differ = 0;
    for (std::size_t i = 0; i < count; ++i) differ += std::size_t{results[i] != exact[i]};
    return differ;
  };
  const std::array differ{wrong(results_of<Shape<Forms>>(all, count))...};
  // The clock has steps of some nanoseconds.
  const std::size_t calls = std::max<std::size_t>(1, 64 * few / count);
  const auto times = bench::least_times<400>(count * calls, [&] {
    for (std::size_t i = 0; i < calls; ++i) Shape<Forms>::run(all, count);
  }...);
  const std::array names{Forms::name...};
  std::printf("%s\n", what);
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::printf("  %-45s %7.3f  %zu differ\n", names[i], times[i], differ[i]);
  }
  return differ[0] == 0;
}

void fill(Operands& all) {
  std::mt19937 random(58);
  for (std::size_t i = 0; i < many; ++i) {
    const auto word = static_cast<Word>(random());
    all.x[i] = word / 65536.0 / static_cast<double>(1 + random() % 4);
    all.n[i] = word >> (random() % 20);
    const Word d = static_cast<Word>(random() >> (random() % 12)) | 1;  // not zero
    all.d[i] = random() % 2 == 0 ? d : -d;
  }
}

}  // namespace

int main() {
  std::printf("nanoseconds for an element\n");
  static Operands all;
  fill(all);
  bool right =
      time_forms<Loop, ExactFrom, From, FromToEven, FromByRint>("from double, in loops", all);
  right = time_forms<Loop, ExactQuotient, Quotient, QuotientInTheMode, QuotientOfNoZero,
                     QuotientByRint>("divide, in loops", all) &&
          right;
  right = time_forms<Loop, ExactQuotient, Operator, DivisorBranch>(
              "divide, one by one, random signs", all, many) &&
          right;
  // Positive, for forms that know no other operands. The results are 2.5 / 1.5 and 1.5 in turn.
  all.d.fill(0x28000);
  right = time_forms<Chain, ExactQuotient, Operator, DivisorBranch, SignedShift, UnsignedShift>(
              "divide, in chains", all) &&
          right;
  if (!right) std::printf("WRONG: ours has results that are not exact\n");
  return right ? 0 : 1;
}
