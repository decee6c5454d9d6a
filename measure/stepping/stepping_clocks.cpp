#include "measure/stepping/stepping_clocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <stdexcept>

#include "measure/clocks/call_clocks.hpp"
#include "measure/clocks/claim_clocks.hpp"
#include "verify/cases/draw.hpp"
#include "x86model/clocks.hpp"
#include "x86model/notation.hpp"

namespace fixproof::measure {

namespace {

namespace x86 = x86model;
using x86::Cpu;
using x86::Loop;

x86::Target target_of(Cpu cpu) { return cpu < Cpu::i386 ? x86::Target::i8088 : x86::Target::i386; }

/// The clocks of a loop counted by DEC and JNZ.
/// @throws std::bad_optional_access if the processor has no such loop
Bounds clocks_by_count(Loop loop, Cpu cpu, Pixels pixels = Pixels::drawn) {
  const x86::LoopForm form{loop, x86::Counting::dec_jnz, target_of(cpu)};
  return pixel_clocks(form, pixels, cpu).value().at_least();
}

Bounds clocks_alone(Cpu cpu, std::initializer_list<x86::Instruction> instructions) {
  x86::Range sum;
  for (const x86::Instruction& instruction : instructions) {
    sum += x86::clocks(cpu, {.instruction = instruction}).value();
  }
  return {static_cast<double>(sum.min), static_cast<double>(sum.max)};
}

Bounds clocks_of_depth_write(Cpu cpu) {
  using namespace x86::notation;
  using x86::notation::operator+;  // operators of fixproof, which is nearer, would hide it
  return clocks_alone(cpu,
                      {mov(byte[Screen + edi], al), mov(word[ZBuff + twice(edi)], bx), inc(edi)});
}

Bounds clocks_of_gouraud_write(Cpu cpu) {
  using namespace x86::notation;
  using x86::notation::operator+;  // operators of fixproof, which is nearer, would hide it
  return clocks_alone(cpu, {stosb()});
}

/// Compares minimum with minimum and maximum with maximum, because both have the same ranges.
Bounds paired_ratio(const Bounds& a, const Bounds& b) {
  const double least = a.min / b.min;
  const double most = a.max / b.max;
  return {std::min(least, most), std::max(least, most)};
}

struct CostedLoop {
  const char* name;
  Loop loop;
  Pixels pixels;
  int values;
};
constexpr std::array costed_loops{
    CostedLoop{"GouraudBytes", Loop::gouraud_byte, Pixels::drawn, 1},
    CostedLoop{"GouraudWords", Loop::gouraud_word, Pixels::drawn, 1},
    CostedLoop{"DepthTest drawn", Loop::depth_test, Pixels::drawn, 1},
    CostedLoop{"DepthTest hidden", Loop::depth_test, Pixels::hidden, 1},
    CostedLoop{"TextureSpan", Loop::texture, Pixels::drawn, 2},
};

}  // namespace

std::vector<SetupClocks> measure_setup_clocks(std::uint64_t seed) {
  constexpr std::uint64_t spans = 500;
  std::vector<std::uint32_t> divides;
  std::vector<std::uint32_t> multiplies;
  for (std::uint64_t i = 0; i < spans; ++i) {
    cases::Draw draw(cases::mix(seed), i);
    const auto units = static_cast<std::int64_t>(65536 + draw.below(319 * 65536 + 1));
    const std::int64_t way =
        draw.either_sign(static_cast<std::int64_t>(draw.below(std::uint64_t{253} * 65536)));
    divides.push_back(static_cast<std::uint32_t>(way));
    divides.push_back(static_cast<std::uint32_t>(units));
    multiplies.push_back(static_cast<std::uint32_t>(way * 65536 / units));
    multiplies.push_back(static_cast<std::uint32_t>(draw.below(65536)));
  }
  std::vector<SetupClocks> all;
  for (const cases::Target target : {cases::Target::i8088, cases::Target::i386}) {
    CallClocks divide = no_calls({.operation = cases::Operation::div, .build = {.target = target}});
    CallClocks multiply =
        no_calls({.operation = cases::Operation::mul, .build = {.target = target}});
    add_calls(divide, divides, true);
    add_calls(multiply, multiplies, true);
    for (std::size_t i = 0; i < divide.processors.size(); ++i) {
      const Cpu cpu = divide.processors[i].cpu;
      if ((target == cases::Target::i8088) != (cpu < Cpu::i386)) continue;
      all.push_back(
          {cpu, divide.processors[i].mean().at_least(), multiply.processors[i].mean().at_least()});
    }
  }
  return all;
}

std::vector<PixelCost> measure_pixel_costs(const std::vector<SetupClocks>& setups) {
  std::vector<PixelCost> costs;
  for (const CostedLoop& loop : costed_loops) {
    for (const SetupClocks& setup : setups) {
      if (loop.loop == Loop::depth_test && setup.cpu < Cpu::i386) continue;
      const Bounds pixel = clocks_by_count(loop.loop, setup.cpu, loop.pixels);
      PixelCost cost{loop.name, setup.cpu, loop.values, pixel, {}};
      for (std::size_t i = 0; i < costed_lengths.size(); ++i) {
        const double share = static_cast<double>(loop.values) / costed_lengths.at(i);
        cost.of_span.at(i) = {pixel.min + share * (setup.divide.min + setup.multiply.min),
                              pixel.max + share * (setup.divide.max + setup.multiply.max)};
      }
      costs.push_back(std::move(cost));
    }
  }
  return costs;
}

std::vector<Claim> judge_stepping_claims(const std::vector<SetupClocks>& setups) {
  Claim depth{"Under a depth buffer the writing operation is two times slower than Gouraud's.",
              "interpolation text, Z-buffer",
              "clocks of the two MOVs and INC over those of STOSB; and clocks of a whole drawn "
              "pixel with its\n"
              "test over those of Gouraud's bytes; 1.6 to 2.5",
              "times",
              {1.6, 2.5},
              {}};
  Claim order{
      "From front to back, with a bit of luck, hidden pixels are not written, which saves time.",
      "interpolation text, tips, Z-buffer optimizations",
      "clocks of a drawn pixel over those of a hidden one, which is still tested; more than 1",
      "times",
      {1.0001, unlimited},
      {}};
  Claim linear{
      "The linear method is fast beside true texture mapping.",
      "interpolation text, texture mapping",
      "the texture loop and two FixedDivs a pixel, as an exact place has here, over the loop "
      "alone;\ntwice at least",
      "times",
      {2, unlimited},
      {}};
  for (const SetupClocks& setup : setups) {
    const std::string on{x86::name_of(setup.cpu)};
    const Bounds loop = clocks_by_count(Loop::texture, setup.cpu);
    add_figure(
        linear, on,
        paired_ratio({loop.min + 2 * setup.divide.min, loop.max + 2 * setup.divide.max}, loop));
    if (setup.cpu < Cpu::i386) continue;
    const Bounds drawn = clocks_by_count(Loop::depth_test, setup.cpu);
    add_figure(depth, on + ", the writing operation",
               paired_ratio(clocks_of_depth_write(setup.cpu), clocks_of_gouraud_write(setup.cpu)));
    add_figure(depth, on + ", the whole pixel",
               paired_ratio(drawn, clocks_by_count(Loop::gouraud_byte, setup.cpu)));
    add_figure(order, on,
               paired_ratio(drawn, clocks_by_count(Loop::depth_test, setup.cpu, Pixels::hidden)));
  }
  return {depth, order, linear};
}

}  // namespace fixproof::measure
