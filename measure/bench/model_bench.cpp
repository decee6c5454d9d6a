// Times calls of the model's FixedMul and FixedDiv, compiled and interpreted, on one thread. Checks
// every product with the type. Needs no library:
//
//     g++ -std=c++20 -O3 -I. measure/bench/model_bench.cpp x86model/encoding.cpp -o model_bench
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <random>
#include <span>
#include <vector>

#include "fixed/fixed.hpp"
#include "measure/bench/least_time.hpp"
#include "x86model/call.hpp"

namespace {

using x86model::Outcome;
using x86model::Routine;
using x86model::Target;
using Words = std::vector<std::uint32_t>;

constexpr std::size_t count = 4096;
constexpr x86model::Build rounded{.mul_rounding = true, .div_rounding = true};

template <Routine routine, Target target>
void compiled(const Words& in, Words& out) {
  static std::vector<Outcome> outcomes(count);
  x86model::call_compiled<routine, target, rounded, 16>(in, out, outcomes);
  bench::keep(out);
}

template <Routine routine, Target target>
void interpreted(const Words& in, Words& out) {
  constexpr const x86model::Program& program = x86model::program<routine, target, rounded>;
  const std::span<const x86model::Instruction> code(program.code.data(), program.size);
  for (std::size_t i = 0; i < count; ++i) {
    x86model::call<routine, 16>(code, std::span(in).subspan(2 * i, 2),
                                std::span(out).subspan(i, 1));
  }
  bench::keep(out);
}

template <class Number>
bool are_products(const Words& in, const Words& out) {
  const auto number = [](std::uint32_t word) {
    return Number::from_raw(static_cast<std::int32_t>(word));
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (number(in[2 * i]) * number(in[2 * i + 1]) != number(out[i])) return false;
  }
  return true;
}

template <Routine routine, Target target, class Number>
bool time_routine(const char* name, const Words& in) {
  Words fast(count);
  Words slow(count);
  const auto [of_compiled, of_interpreted] = bench::least_times<100>(
      count, [&] { compiled<routine, target>(in, fast); },
      [&] { interpreted<routine, target>(in, slow); });
  std::printf("%-15s %6.1f million per second compiled, %5.1f interpreted\n", name,
              1000 / of_compiled, 1000 / of_interpreted);
  if (fast == slow && (routine != Routine::mul || are_products<Number>(in, fast))) return true;
  std::printf("wrong result\n");
  return false;
}

}  // namespace

int main() {
  std::mt19937 random(54);
  Words in(2 * count);
  for (std::uint32_t& word : in) word = static_cast<std::uint32_t>(random());
  using fixproof::q16_16_i386;
  using fixproof::q16_16_i8088;
  bool right = time_routine<Routine::mul, Target::i8088, q16_16_i8088>("FixedMul, 8088", in);
  right = time_routine<Routine::mul, Target::i386, q16_16_i386>("FixedMul, 386", in) && right;
  // No quotient faults: every dividend is below 2^24, and no divisor is.
  for (std::size_t i = 0; i < count; ++i) {
    in[2 * i] >>= 8;
    in[2 * i + 1] = (in[2 * i + 1] >> 1) | 0x01000000;
  }
  right = time_routine<Routine::div, Target::i8088, q16_16_i8088>("FixedDiv, 8088", in) && right;
  right = time_routine<Routine::div, Target::i386, q16_16_i386>("FixedDiv, 386", in) && right;
  return right ? 0 : 1;
}
