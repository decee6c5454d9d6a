#include "app/cli/trace_loop.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <iostream>

#include "app/cli/words.hpp"
#include "support/hex.hpp"
#include "support/usage_error.hpp"
#include "verify/machine_code/programs.hpp"
#include "verify/singlestep/shown.hpp"
#include "x86model/call_loop.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

namespace {

namespace x86 = x86model;

constexpr std::uint32_t traced_row = 0x2800;

/// Returns 64 KiB of zeros; for a texture loop, the texture fills the end.
std::vector<std::uint8_t> loop_memory(const x86::LoopForm& form) {
  std::vector<std::uint8_t> memory(0x10000);
  if (form.loop != x86::Loop::texture) return memory;
  const auto begin = static_cast<std::size_t>(x86::address_of(x86::Symbol::texture));
  for (std::size_t at = begin; at < memory.size(); ++at) {
    const std::size_t texel = at - begin;
    memory[at] = static_cast<std::uint8_t>(texel / 256 + texel);
  }
  return memory;
}

x86::LoopCall loop_call(const x86::LoopForm& form, const std::vector<std::string>& words) {
  const bool texture = form.loop == x86::Loop::texture;
  const std::size_t wanted = texture ? 5 : 3;
  if (words.size() != wanted) {
    throw support::UsageError(fmt::format(
        "{} takes {} words, not {}", machine_code::name_of_loop(form.loop), wanted, words.size()));
  }
  constexpr cases::Format whole{.word_bits = 32, .fraction_bits = 0};
  constexpr cases::Format q24_8{.word_bits = 32, .fraction_bits = 8};
  const auto read = [&words](std::size_t i, const cases::Format& format) {
    return static_cast<std::uint32_t>(word_of(words[i], format));
  };
  x86::LoopCall call{
      .pixels = read(0, whole), .value = read(1, q24_8), .step = read(2, q24_8), .colour = 0xFF};
  if (texture) {
    call.row = read(3, q24_8);
    call.row_step = read(4, q24_8);
  }
  if (form.loop != x86::Loop::depth_test) call.place = traced_row;
  const bool pairs = x86::pixels_per_iteration(form.loop) == 2;
  if (call.pixels < 1 || call.pixels > x86::loops::max_pixels || (pairs && call.pixels % 2 != 0)) {
    throw support::UsageError(fmt::format("{}: {} pixels; give {}",
                                          machine_code::name_of_loop(form.loop), call.pixels,
                                          pairs ? "an even number from 2 to 320" : "1 to 320"));
  }
  return call;
}

/// Formats the registers and memory bytes that differ, as in "  edi=00002801 [2800]=20".
std::string loop_changes(const x86::Registers<16>& before, const x86::Registers<16>& after,
                         std::vector<std::uint8_t>& seen, const std::vector<std::uint8_t>& memory,
                         x86::Size size) {
  std::string text;
  for (const x86::Register r : singlestep::shown_registers) {
    const std::uint32_t value = after.read(r, size);
    if (value == before.read(r, size)) continue;
    text += fmt::format(" {}=", x86::name_of(r, size));
    support::append_hex(text, value, size == x86::Size::word ? 4 : 8);
  }
  for (std::size_t at = 0; at < memory.size(); ++at) {
    if (memory[at] == seen[at]) continue;
    seen[at] = memory[at];
    text += fmt::format(" [{:04x}]={:02x}", at, memory[at]);
  }
  return text.empty() ? text : " " + text;
}

}  // namespace

void trace_loop(const x86::LoopForm& form, const std::vector<std::string>& words) {
  const x86::LoopCall call = loop_call(form, words);
  std::vector<std::uint8_t> memory = loop_memory(form);
  x86::LoopMachine machine{.registers = {}, .memory = x86::ByteMemory(memory, memory, memory)};
  const auto code = x86::code_of(form);
  x86::enter_loop(form, machine, call);
  const auto size = form.target == x86::Target::i386 ? x86::Size::dword : x86::Size::word;
  fmt::print(std::cout, "   #  {:<30} CF PF AF ZF SF OF  changes\n", x86::name_of(form.loop));
  auto before = machine.registers;
  auto seen = memory;
  const x86::Ending ending = x86::run(code, machine, [&](std::size_t at, const auto& after) {
    fmt::print(std::cout, "{:4}  {:<30}{}{}\n", at, x86::text_of(code[at]),
               singlestep::flag_columns(after.flags),
               loop_changes(before, after.registers, seen, memory, size));
    before = after.registers;
  });
  fmt::print(std::cout, "{} instructions, {} pixel{}\n", ending.steps, call.pixels,
             call.pixels == 1 ? "" : "s");
}

}  // namespace fixproof::cli
