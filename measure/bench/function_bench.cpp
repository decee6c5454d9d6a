// Times functions of 16.16: the type, libfixmath, FreeType, and double with lrint. First
// checks every result: the type must be exact, the others within the errors stated here. The
// counter `off` is the largest error in ulp.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "fixed/fixed.hpp"
#include "oracle/fast.hpp"
#include "oracle/function.hpp"
#if defined(FIXPROOF_LIBFIXMATH)
#include <libfixmath/fix16.h>
#endif
#if defined(FIXPROOF_FREETYPE)
#include <freetype/freetype.h>
#endif

namespace {

using fixproof::q16_16;
using oracle::Function;
using Words = std::vector<std::int32_t>;

/// The operands that a function is given.
enum class Operands { exponents, positive, unit, angles, any, powers, quotients };

/// More elements than libfixmath's result cache holds.
constexpr std::size_t count = 16384;

struct Triples {
  Words x = Words(count);
  Words y = Words(count);
  Words z = Words(count);
};

/// The nearest word to the function of x, of x and y, or of all three.
using Exact = std::function<std::int64_t(std::int32_t x, std::int32_t y, std::int32_t z)>;
using Run = std::function<void(const Triples& in, Words& out)>;

struct Contender {
  std::string name;
  Exact exact;
  Operands operands;
  Run run;
  std::int64_t error;  ///< the largest, in ulps
};

template <class OfWord>
Run each(OfWord of_word) {
  return [of_word](const Triples& in, Words& out) {
    for (std::size_t i = 0; i < count; ++i) {
      if constexpr (std::is_invocable_v<OfWord, std::int32_t>) {
        out[i] = of_word(in.x[i]);
      } else if constexpr (std::is_invocable_v<OfWord, std::int32_t, std::int32_t>) {
        out[i] = of_word(in.x[i], in.y[i]);
      } else {
        out[i] = of_word(in.x[i], in.y[i], in.z[i]);
      }
    }
  };
}

/// The nearest word to a result out of range.
std::int64_t limited(std::int64_t ulps) {
  return std::clamp<std::int64_t>(ulps, std::numeric_limits<std::int32_t>::min(),
                                  std::numeric_limits<std::int32_t>::max());
}

Exact exact(Function function) {
  return [function](std::int32_t x, std::int32_t y, std::int32_t /*z*/) {
    return limited(
        oracle::fast::nearest(function, x, y, 16, oracle::Rounding::half_up).value_or(0));
  };
}

constexpr oracle::Format format = 16;

std::uint32_t bits(std::int32_t word) { return static_cast<std::uint32_t>(word); }

std::int64_t word_of(std::optional<oracle::LongWord> result) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(result.value_or(0)));
}

template <class OfNumber>
auto by_type(OfNumber of_number) {
  return each([of_number](std::int32_t word) { return of_number(q16_16::from_raw(word)).raw(); });
}

template <class OfDouble>
auto by_double(OfDouble of_double) {
  return each([of_double](std::int32_t word) {
    return static_cast<std::int32_t>(std::lrint(of_double(word / 65536.0) * 65536));
  });
}

template <class OfNumbers>
auto by_type_of_two(OfNumbers of_numbers) {
  return each([of_numbers](std::int32_t x, std::int32_t y) {
    return of_numbers(q16_16::from_raw(x), q16_16::from_raw(y)).raw();
  });
}

template <class OfNumbers>
auto by_type_of_three(OfNumbers of_numbers) {
  return each([of_numbers](std::int32_t x, std::int32_t y, std::int32_t z) {
    return of_numbers(q16_16::from_raw(x), q16_16::from_raw(y), q16_16::from_raw(z)).raw();
  });
}

template <class OfDoubles>
auto by_double_of_three(OfDoubles of_doubles) {
  return each([of_doubles](std::int32_t x, std::int32_t y, std::int32_t z) {
    const double units = of_doubles(x / 65536.0, y / 65536.0, z / 65536.0) * 65536;
    return static_cast<std::int32_t>(std::lrint(std::clamp(units, -2147483648.0, 2147483647.0)));
  });
}

template <class OfDoubles>
auto by_double_of_two(OfDoubles of_doubles) {
  return each([of_doubles](std::int32_t x, std::int32_t y) {
    const double units = of_doubles(x / 65536.0, y / 65536.0) * 65536;
    return static_cast<std::int32_t>(std::lrint(std::clamp(units, -2147483648.0, 2147483647.0)));
  });
}

std::vector<Contender> contenders() {
  std::vector<Contender> all;
  const auto add = [&all](Function function, Operands operands, const std::string& name,
                          const auto& of_number, const auto& of_double) {
    all.push_back({name + "/q16_16", exact(function), operands, by_type(of_number), 0});
    all.push_back({name + "/double", exact(function), operands, by_double(of_double), 1});
  };
  constexpr double two_pi = 2 * std::numbers::pi;
  add(
      Function::exp, Operands::exponents, "exp", [](q16_16 x) { return exp(x); },
      [](double x) { return std::exp(x); });
  add(
      Function::exp2, Operands::exponents, "exp2", [](q16_16 x) { return exp2(x); },
      [](double x) { return std::exp2(x); });
  add(
      Function::expm1, Operands::exponents, "expm1", [](q16_16 x) { return expm1(x); },
      [](double x) { return std::expm1(x); });
  add(
      Function::sinh, Operands::exponents, "sinh", [](q16_16 x) { return sinh(x); },
      [](double x) { return std::sinh(x); });
  add(
      Function::cosh, Operands::exponents, "cosh", [](q16_16 x) { return cosh(x); },
      [](double x) { return std::cosh(x); });
  add(
      Function::tanh, Operands::exponents, "tanh", [](q16_16 x) { return tanh(x); },
      [](double x) { return std::tanh(x); });
  add(
      Function::log, Operands::positive, "log", [](q16_16 x) { return log(x); },
      [](double x) { return std::log(x); });
  add(
      Function::log2, Operands::positive, "log2", [](q16_16 x) { return log2(x); },
      [](double x) { return std::log2(x); });
  add(
      Function::log10, Operands::positive, "log10", [](q16_16 x) { return log10(x); },
      [](double x) { return std::log10(x); });
  add(
      Function::rsqrt, Operands::positive, "rsqrt", [](q16_16 x) { return rsqrt(x); },
      [](double x) { return 1 / std::sqrt(x); });
  add(
      Function::cbrt, Operands::any, "cbrt", [](q16_16 x) { return cbrt(x); },
      [](double x) { return std::cbrt(x); });
  add(
      Function::reciprocal, Operands::positive, "reciprocal",
      [](q16_16 x) { return reciprocal(x); }, [](double x) { return 1 / x; });
  add(
      Function::sin_of_turns, Operands::angles, "sin_of_turns",
      [](q16_16 x) { return sin_of_turns(x); }, [](double x) { return std::sin(x * two_pi); });
  add(
      Function::sin_of_degrees, Operands::angles, "sin_of_degrees",
      [](q16_16 x) { return sin_of_degrees(x); },
      [](double x) { return std::sin(x * (two_pi / 360)); });
  add(
      Function::tan, Operands::angles, "tan", [](q16_16 x) { return tan(x); },
      [](double x) { return std::tan(x); });
  add(
      Function::asin, Operands::unit, "asin", [](q16_16 x) { return asin(x); },
      [](double x) { return std::asin(x); });
  add(
      Function::acos, Operands::unit, "acos", [](q16_16 x) { return acos(x); },
      [](double x) { return std::acos(x); });
  add(
      Function::atan, Operands::any, "atan", [](q16_16 x) { return atan(x); },
      [](double x) { return std::atan(x); });
  const auto add_of_two = [&all](const Exact& exact_word, Operands operands,
                                 const std::string& name, const auto& of_numbers,
                                 const auto& of_doubles) {
    all.push_back({name + "/q16_16", exact_word, operands, by_type_of_two(of_numbers), 0});
    all.push_back({name + "/double", exact_word, operands, by_double_of_two(of_doubles), 1});
  };
  add_of_two(
      exact(Function::atan2), Operands::any, "atan2",
      [](q16_16 y, q16_16 x) { return atan2(y, x); },
      [](double y, double x) { return std::atan2(y, x); });
  add_of_two(
      exact(Function::hypot), Operands::any, "hypot",
      [](q16_16 x, q16_16 y) { return hypot(x, y); },
      [](double x, double y) { return std::hypot(x, y); });
  add_of_two(
      exact(Function::pow), Operands::powers, "pow", [](q16_16 x, q16_16 y) { return pow(x, y); },
      [](double x, double y) { return std::pow(x, y); });
  const Exact exact_fmod = [](std::int32_t x, std::int32_t y, std::int32_t /*z*/) {
    return word_of(oracle::fast::truncated_remainder(bits(x), bits(y), format));
  };
  add_of_two(
      exact_fmod, Operands::quotients, "fmod", [](q16_16 x, q16_16 y) { return fmod(x, y); },
      [](double x, double y) { return std::fmod(x, y); });
  add_of_two(
      [](std::int32_t x, std::int32_t y, std::int32_t /*z*/) {
        return word_of(oracle::fast::nearest_remainder(bits(x), bits(y), format));
      },
      Operands::quotients, "remainder", [](q16_16 x, q16_16 y) { return remainder(x, y); },
      [](double x, double y) { return std::remainder(x, y); });
  const auto add_of_three = [&all](const Exact& exact_word, Operands operands,
                                   const std::string& name, const auto& of_numbers,
                                   const auto& of_doubles) {
    all.push_back({name + "/q16_16", exact_word, operands, by_type_of_three(of_numbers), 0});
    all.push_back({name + "/double", exact_word, operands, by_double_of_three(of_doubles), 1});
  };
  const Exact exact_mul_div = [](std::int32_t x, std::int32_t y, std::int32_t z) {
    return word_of(oracle::fast::product_quotient(bits(x), bits(y), bits(z),
                                                  oracle::Rounding::half_up, format));
  };
  add_of_three(
      exact_mul_div, Operands::quotients, "mul_div",
      [](q16_16 x, q16_16 y, q16_16 z) { return mul_div(x, y, z); },
      [](double x, double y, double z) { return x * y / z; });
  add_of_three(
      [](std::int32_t x, std::int32_t y, std::int32_t z) {
        return limited(static_cast<std::int64_t>(
            oracle::fast::nearest_length(bits(x), bits(y), bits(z), format)));
      },
      Operands::any, "hypot3", [](q16_16 x, q16_16 y, q16_16 z) { return hypot(x, y, z); },
      [](double x, double y, double z) { return std::hypot(x, y, z); });
#if defined(FIXPROOF_LIBFIXMATH)
  all.push_back({"atan2/libfixmath", exact(Function::atan2), Operands::any, each(fix16_atan2),
                 std::int64_t{1} << 33});
  all.push_back({"fmod/libfixmath", exact_fmod, Operands::quotients, each(fix16_mod), 0});
  const auto add_libfixmath = [&all](Function function, Operands operands, const std::string& name,
                                     fix16_t (*of_word)(fix16_t)) {
    all.push_back(
        {name + "/libfixmath", exact(function), operands, each(of_word), std::int64_t{1} << 33});
  };
  add_libfixmath(Function::exp, Operands::exponents, "exp", fix16_exp);
  add_libfixmath(Function::log, Operands::positive, "log", fix16_log);
  add_libfixmath(Function::log2, Operands::positive, "log2", fix16_log2);
  add_libfixmath(Function::tan, Operands::angles, "tan", fix16_tan);
  add_libfixmath(Function::asin, Operands::unit, "asin", fix16_asin);
  add_libfixmath(Function::acos, Operands::unit, "acos", fix16_acos);
  add_libfixmath(Function::atan, Operands::any, "atan", fix16_atan);
#endif
#if defined(FIXPROOF_FREETYPE)
  // It rounds negative ties down.
  all.push_back({"mul_div/FreeType", exact_mul_div, Operands::quotients,
                 each([](std::int32_t x, std::int32_t y, std::int32_t z) {
                   return static_cast<std::int32_t>(FT_MulDiv(x, y, z));
                 }),
                 1});
#endif
  return all;
}

/// Operands of all lengths within what makes sense for the function.
std::int32_t operand_from(std::mt19937& random, Operands operands, std::size_t i) {
  const auto word = static_cast<std::int32_t>(random());
  switch (operands) {
    case Operands::exponents:
      return word >> 12;  // within +-8
    case Operands::positive:
      return static_cast<std::int32_t>((random() | 0x80000000U) >> (1 + i % 29));
    case Operands::unit:
      return word >> 15;  // within +-1
    case Operands::angles:
      return word >> 8;  // within +-128
    case Operands::powers:
      return (word & 0x3ffff) + 16384;  // from 1/4 to 4 1/4
    case Operands::quotients:
    case Operands::any:
      break;
  }
  return word >> i % 31;
}

Triples triples_of(Operands operands) {
  Triples in;
  std::mt19937 random(54);
  std::mt19937 third(55);
  for (std::size_t i = 0; i < count; ++i) {
    in.x[i] = operand_from(random, operands, i);
    // Exponents within +-2, or numbers of other lengths than x.
    in.y[i] = operands == Operands::powers ? static_cast<std::int32_t>(random()) >> 14
                                           : operand_from(random, operands, 7 * i);
    in.z[i] = operand_from(third, operands, 11 * i);
    if (operands == Operands::quotients) {
      // No divisor is 0, and x * y / z is at most x.
      in.y[i] |= 1;
      in.z[i] |= 1;
      if (std::abs(std::int64_t{in.z[i]}) < std::abs(std::int64_t{in.y[i]})) {
        std::swap(in.y[i], in.z[i]);
      }
    }
  }
  return in;
}

void time_contender(benchmark::State& state, const Contender& contender) {
  const Triples in = triples_of(contender.operands);
  Words out(count);
  contender.run(in, out);
  std::int64_t off = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t expected = contender.exact(in.x[i], in.y[i], in.z[i]);
    off = std::max<std::int64_t>(off, std::abs(out[i] - expected));
  }
  if (off > contender.error) {
    state.SkipWithError("wrong result");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    contender.run(in, out);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
  state.counters["off"] = static_cast<double>(off);
}

}  // namespace

int main(int argc, char** argv) {
  for (const Contender& contender : contenders()) {
    benchmark::RegisterBenchmark(contender.name.c_str(), [contender](benchmark::State& state) {
      time_contender(state, contender);
    });
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
