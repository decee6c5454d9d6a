#include "measure/clocks/span_clocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "verify/machine_code/programs.hpp"
#include "x86model/call_loop.hpp"
#include "x86model/count_clocks.hpp"
#include "x86model/text.hpp"

namespace fixproof::measure {

namespace {

namespace x86 = x86model;
using x86::Counting;
using x86::Cpu;
using x86::Loop;
using x86::LoopForm;
using x86::Target;

bool can_run(const LoopForm& form, Cpu cpu) {
  return form.target == Target::i8088 || cpu >= Cpu::i386;
}

/// Counts a call from its first instruction to RET. The depth buffer lets all pixels through, or
/// none.
x86::ClockCounter count_call(std::span<const x86::Instruction> code, const LoopForm& form,
                             Pixels pixels, Cpu cpu, std::uint32_t count) {
  std::vector<std::uint8_t> memory(0x10000);
  constexpr std::size_t depths = 0x500;
  for (std::size_t i = 0; i < count; ++i) {
    const bool drawn = pixels == Pixels::drawn;
    memory.at(depths + 2 * i) = drawn ? 0x00 : 0xFF;
    memory.at(depths + 2 * i + 1) = drawn ? 0x80 : 0x7F;
  }
  x86::LoopMachine m{.registers = {}, .memory = x86::ByteMemory(memory, memory, memory)};
  x86::ClockCounter counter(code, cpu);
  constexpr std::uint32_t row = 0x2800;
  x86::LoopCall call{.pixels = count};
  // A row begins at an even address.
  if (form.loop != Loop::depth_test) call.place = row;
  x86::call_loop(form, code, m, call, counter);
  return counter;
}

std::string form_name(const LoopForm& form) {
  return fmt::format("{}{}", machine_code::name_of_loop(form.loop),
                     form.as_printed ? " as printed" : "");
}

/// Visits every form; the depth test twice, with drawn and with hidden pixels.
template <class Visit>
void each_row(Visit visit) {
  for (const LoopForm& form : x86::all_loop_forms()) {
    visit(form, Pixels::drawn);
    if (form.loop == Loop::depth_test) visit(form, Pixels::hidden);
  }
}

/// Adds the ratio of `slow` to `fast` on every processor that runs both.
void compare(LoopClaim& claim, const LoopForm& slow, const LoopForm& fast, Pixels pixels) {
  for (const Cpu cpu : loop_processors) {
    const auto a = pixel_clocks(slow, pixels, cpu);
    const auto b = pixel_clocks(fast, pixels, cpu);
    if (!a || !b) continue;
    // A 386 can run the 8088 listings too, but the claim is about its own.
    if (slow.target == Target::i8088 && cpu >= Cpu::i386) continue;
    // The same loop has the same ranges in the same instructions, so minimum is compared with
    // minimum and maximum with maximum. Of different loops only the bounds are known.
    const bool same = slow.loop == fast.loop;
    const double least = a->table.min / (same ? b->table.min : b->table.max);
    const double most = a->table.max / (same ? b->table.max : b->table.min);
    const std::string where = fmt::format(
        "{}, {} to {}, on {} {}", name_of(slow, pixels), x86::name_of(slow.counting),
        slow.loop == fast.loop ? std::string(x86::name_of(fast.counting)) : form_name(fast),
        cpu == Cpu::i8088 ? "an" : "a", x86::name_of(cpu));
    claim.gains.push_back({where, std::min(least, most), std::max(least, most)});
    if (cpu != Cpu::i8088) continue;
    // The table has no ranges for an 8088 here.
    const double with_bus = a->at_least().min / b->at_least().min;
    claim.gains.push_back({where + " with its bus", with_bus, with_bus});
  }
}

/// Compares the forms with `counting` of the loops from `first` to `last` with those that differ
/// only in `change`, where they exist.
template <class Change>
void compare_all(LoopClaim& claim, Loop first, Loop last, Counting counting, Change change) {
  each_row([&](const LoopForm& form, Pixels pixels) {
    if (form.counting != counting || form.as_printed) return;
    if (form.loop < first || form.loop > last) return;
    LoopForm fast = form;
    change(fast);
    if (exists(fast)) compare(claim, form, fast, pixels);
  });
}

}  // namespace

std::optional<Clocks> pixel_clocks(const LoopForm& form, Pixels pixels, Cpu cpu) {
  if (!can_run(form, cpu)) return std::nullopt;
  constexpr std::uint32_t most = x86::loops::max_pixels;
  constexpr std::uint32_t more = most - most / 2;
  const auto code = x86::code_of(form);
  const x86::ClockCounter whole = count_call(code, form, pixels, cpu, most);
  const x86::ClockCounter half = count_call(code, form, pixels, cpu, most / 2);
  const auto per_pixel = [](std::uint64_t of_whole, std::uint64_t of_half) {
    return static_cast<double>(of_whole - of_half) / more;
  };
  return Clocks{{per_pixel(whole.total().min, half.total().min),
                 per_pixel(whole.total().max, half.total().max)},
                per_pixel(whole.bus().clocks(), half.bus().clocks())};
}

std::string name_of(const LoopForm& form, Pixels pixels) {
  if (form.loop != Loop::depth_test) return form_name(form);
  return form_name(form) + (pixels == Pixels::drawn ? " drawn" : " hidden");
}

std::string_view target_name(const LoopForm& form) {
  return form.target == Target::i386 ? "i386" : "i8088";
}

std::vector<LoopClocks> loop_clocks() {
  std::vector<LoopClocks> all;
  each_row([&all](const LoopForm& form, Pixels pixels) {
    all.push_back({form, pixels, {}});
    for (std::size_t i = 0; i < loop_processors.size(); ++i) {
      all.back().on.at(i) = pixel_clocks(form, pixels, loop_processors.at(i));
    }
  });
  return all;
}

std::vector<LoopClaim> loop_claims() {
  using enum Counting;
  LoopClaim words{
      "Two pixels a store are faster than one.", "interpolation text, tips, single bytes", {}};
  for (const Counting counting : {loop, dec_jnz, unrolled}) {
    compare_all(words, Loop::gouraud_byte, Loop::gouraud_byte, counting,
                [](LoopForm& form) { form.loop = Loop::gouraud_word; });
  }
  LoopClaim jumps{
      "DEC and JNZ are faster than LOOP.", "interpolation text, tips, the loop instruction", {}};
  compare_all(jumps, Loop::gouraud_byte, Loop::texture, loop,
              [](LoopForm& form) { form.counting = dec_jnz; });
  LoopClaim straight{
      "Not to loop at all is the fastest.", "interpolation text, tips, unrolled loops", {}};
  compare_all(straight, Loop::gouraud_byte, Loop::texture, dec_jnz,
              [](LoopForm& form) { form.counting = unrolled; });
  return {words, jumps, straight};
}

}  // namespace fixproof::measure
