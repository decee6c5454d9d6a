/// @file
/// The expected result of the inner loops, in plain integers, and a memory to run them in.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "x86model/call_loop.hpp"
#include "x86model/text.hpp"

namespace loops_test {

namespace x86 = x86model;

// The layout of the one segment that these tests use for data, extra data and stack. The addresses
// are written out here so that they do not depend on the model.
inline constexpr std::uint32_t bytes = 0x10000;
inline constexpr std::uint32_t row_at = 0x2800;  ///< where STOS writes the pixels
inline constexpr std::uint32_t texture_at = 0x100;
inline constexpr std::uint32_t screen_at = 0x100;
inline constexpr std::uint32_t z_buff_at = 0x500;
inline constexpr std::uint32_t inc_j_at = 0x70;
inline constexpr std::uint32_t most = 320;

using Memory = std::vector<std::uint8_t>;
using Random = std::mt19937;

inline Memory noise(Random& random) {
  Memory memory(bytes);
  std::uint64_t word = random();
  for (auto& byte : memory) {
    word = word * 6364136223846793005U + 1442695040888963407U;
    byte = static_cast<std::uint8_t>(word >> 56U);
  }
  return memory;
}

/// A call of `pixels` pixels with random words; about half of the steps are small, as in pictures.
inline x86::LoopCall draw_call(x86::Loop loop, std::uint32_t pixels, Random& random) {
  const auto word = [&] {
    const auto bits = static_cast<std::uint32_t>(random());
    return random() % 2 == 0 ? bits
                             : static_cast<std::uint32_t>(static_cast<int>(bits % 1024) - 512);
  };
  x86::LoopCall call{.pixels = pixels,
                     .value = static_cast<std::uint32_t>(random()),
                     .step = word(),
                     .row = static_cast<std::uint32_t>(random()),
                     .row_step = word(),
                     .colour = static_cast<std::uint8_t>(random())};
  call.place = loop == x86::Loop::depth_test ? random() % 64 : row_at + random() % 64;
  return call;
}

inline std::uint32_t byte_of(std::uint32_t word, int place) {
  return word >> (8 * place) % 32 & 255;
}

inline int depth_at(const Memory& m, std::uint32_t at) {
  const int word = m[at] + 256 * m[at + 1];
  return word < 32768 ? word : word - 65536;
}

/// The memory after a span, according to the source.
/// @param as_printed compares and stores the depth as SHRD computes it; `bx` is EBX before the loop
inline Memory drawn(x86::Loop loop, const x86::LoopCall& c, Memory m, bool as_printed = false,
                    std::uint32_t bx = 0) {
  for (std::uint32_t i = 0; i < c.pixels; ++i) {
    const std::uint32_t value = c.value + i * c.step;
    const std::uint32_t row = c.row + i * c.row_step;
    switch (loop) {
      case x86::Loop::gouraud_byte:
      case x86::Loop::gouraud_word:
        m[c.place + i] = static_cast<std::uint8_t>(value % 65536 / 256);
        break;
      case x86::Loop::texture: {
        const std::uint32_t texel = row % 65536 / 256 * 256 + value % 65536 / 256;
        m[c.place + i] = m[(texture_at + texel) % 65536];
        break;
      }
      case x86::Loop::depth_test: {
        // As printed: the top byte of EBX, below the three lower bytes of the depth.
        bx = as_printed ? bx / 16777216 + value % 16777216 * 256 : value / 256;
        const int depth = static_cast<int>(bx % 65536 ^ 32768) - 32768;
        const std::uint32_t index = c.place + i;
        if (depth <= depth_at(m, z_buff_at + 2 * index)) break;
        m[screen_at + index] = c.colour;
        m[z_buff_at + 2 * index] = static_cast<std::uint8_t>(bx % 256);
        m[z_buff_at + 2 * index + 1] = static_cast<std::uint8_t>(bx / 256 % 256);
        break;
      }
    }
  }
  return m;
}

inline x86::LoopMachine machine(Memory& memory, Random& random) {
  x86::LoopMachine m{.registers = {}, .memory = x86::ByteMemory(memory, memory, memory)};
  for (std::size_t r = 0; r < x86::register_count; ++r) {
    m.registers.write(static_cast<x86::Register>(r), x86::Size::dword,
                      static_cast<std::uint32_t>(random()));
  }
  return m;
}

inline std::string text(const x86::LoopForm& form) {
  return std::string(name_of(form.loop)) + ' ' + std::string(name_of(form.counting)) +
         (form.target == x86::Target::i386 ? " 386" : " 8088") +
         (form.as_printed ? " as printed" : "");
}

/// Copies the words that the call itself writes: IncJ, and the return address on the stack.
inline void take_frame(const Memory& from, Memory& to) {
  for (std::uint32_t at = inc_j_at; at < inc_j_at + 4; ++at) to[at] = from[at];
  for (std::uint32_t at = 0x5E; at < 0x60; ++at) to[at] = from[at];
}

}  // namespace loops_test
