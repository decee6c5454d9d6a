#include "verify/proof/span_cases.hpp"

#include <algorithm>
#include <array>

#include "verify/cases/draw.hpp"

namespace fixproof::proof {

namespace {

namespace x86 = x86model;
using x86::Counting;
using x86::Loop;
using x86::LoopCall;
using x86::LoopForm;
using x86::Register;
using x86::Size;

constexpr std::size_t segment_bytes = 0x10000;
/// STOS writes here, beyond all named memory. The texture covers the whole segment.
constexpr std::uint32_t row_address = 0x2800;

using Segment = std::vector<std::uint8_t>;

/// The whole part of a stepped word: the pixel to draw or the coordinate of a texel.
std::uint8_t whole_part(std::uint32_t word) { return static_cast<std::uint8_t>(word >> 8U); }

/// Computes the expected memory after a span from the source's description of the loop.
class Drawing {
 public:
  Drawing(const LoopForm& form, const LoopCall& call, const Segment& data, Segment& extra,
          std::uint32_t ebx)
      : form_(form), call_(call), data_(data), extra_(extra), ebx_(ebx) {}

  /// @param screen data segment for the pixels and depths of a depth test
  void draw(Segment& screen) {
    for (std::uint32_t i = 0; i < call_.pixels; ++i) {
      const std::uint32_t value = call_.value + i * call_.step;
      if (form_.loop == Loop::depth_test) {
        test(screen, i, value);
        continue;
      }
      const std::size_t texel =
          std::size_t{256} * whole_part(call_.row + i * call_.row_step) + whole_part(value);
      extra_[call_.place + i] = form_.loop == Loop::texture
                                    ? data_[(texture + texel) % segment_bytes]
                                    : whole_part(value);
    }
  }

  /// Stores the exact depth of every seventh pixel in the buffer. Such a pixel must not be drawn.
  void prepare_ties(Segment& screen) {
    if (form_.loop != Loop::depth_test) return;
    std::uint32_t ebx = ebx_;
    for (std::uint32_t i = 0; i < call_.pixels; ++i) {
      ebx = shifted(call_.value + i * call_.step, ebx);
      if (i % 7 == 3) put_depth(screen, call_.place + i, ebx);
    }
  }

 private:
  static constexpr std::size_t texture = 0x100;
  static constexpr std::size_t pixels = 0x100;
  static constexpr std::size_t depths = 0x500;

  /// As printed, the depth's three lower bytes move above the former top byte of EBX.
  [[nodiscard]] std::uint32_t shifted(std::uint32_t depth, std::uint32_t ebx) const {
    return form_.as_printed ? depth << 8U | ebx >> 24U : depth >> 8U;
  }

  static void put_depth(Segment& screen, std::size_t index, std::uint32_t depth) {
    screen[depths + 2 * index] = static_cast<std::uint8_t>(depth);
    screen[depths + 2 * index + 1] = static_cast<std::uint8_t>(depth >> 8U);
  }

  void test(Segment& screen, std::uint32_t i, std::uint32_t depth) {
    ebx_ = shifted(depth, ebx_);
    const std::size_t index = call_.place + i;
    const std::size_t at = depths + 2 * index;
    const auto held = static_cast<std::int16_t>(screen[at] | screen[at + 1] << 8U);
    if (static_cast<std::int16_t>(ebx_) <= held) return;
    screen[pixels + index] = call_.colour;
    put_depth(screen, index, ebx_);
  }

  const LoopForm& form_;
  const LoopCall& call_;
  const Segment& data_;
  Segment& extra_;
  std::uint32_t ebx_;
};

/// Only the lower 16 bits change if the target steps words.
std::uint32_t stepped(const LoopForm& form, std::uint32_t value, std::uint32_t step,
                      std::uint32_t pixels) {
  const std::uint32_t sum = value + pixels * step;
  const bool by_words = form.loop == Loop::gouraud_byte || form.target == x86::Target::i8088;
  return by_words ? (value & 0xFFFF0000U) | (sum & 0xFFFFU) : sum;
}

bool registers_right(const LoopForm& form, const LoopCall& c, const x86::Registers<16>& left) {
  const auto is = [&](Register r, std::uint32_t wanted) {
    return left.read(r, Size::dword) == wanted;
  };
  const bool has_row = form.loop == Loop::texture;
  return is(Register::di, c.place + c.pixels) && is(Register::bp, c.step) &&
         is(Register::dx, stepped(form, c.value, c.step, c.pixels)) &&
         (!has_row || is(Register::si, stepped(form, c.row, c.row_step, c.pixels))) &&
         left.read(Register::sp, Size::word) == 0x60;
}

struct Trial {
  Segment noise = Segment(segment_bytes);
  Segment data, extra, data_wanted, extra_wanted;
  Segment stack = Segment(0x60);

  explicit Trial(std::uint64_t seed) {
    cases::Draw draw(seed, 0);
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(draw.bits());
  }

  bool passes(const LoopForm& form, std::span<const x86::Instruction> code, const LoopCall& call) {
    data = extra = noise;
    x86::LoopMachine m{.registers = {}, .memory = x86::ByteMemory(data, extra, stack)};
    std::uint32_t junk = 0x9E3779B9U * (call.pixels + 1);
    for (std::size_t r = 0; r < x86::register_count; ++r) {
      m.registers.write(static_cast<Register>(r), Size::dword, junk = junk * 0x85EBCA6BU + 1);
    }
    x86::enter_loop(form, m, call);
    extra_wanted = extra;
    Drawing drawing(form, call, data, extra_wanted, m.registers.read(Register::bx, Size::dword));
    drawing.prepare_ties(data);
    data_wanted = data;
    drawing.draw(data_wanted);
    constexpr std::uint64_t limit = 10'000;
    const auto ending = x86::run(
        code, m, [](std::size_t, const x86::LoopMachine&) {}, limit);
    return ending.outcome == x86::Outcome::returned && registers_right(form, call, m.registers) &&
           data == data_wanted && extra == extra_wanted;
  }
};

}  // namespace

std::vector<LoopCall> span_cases(const LoopForm& form, std::uint64_t seed) {
  std::vector<LoopCall> spans;
  const std::uint32_t turn = x86::pixels_per_iteration(form.loop);
  const std::uint32_t fewest = form.counting == Counting::unrolled ? 0 : turn;
  for (std::uint32_t pixels = fewest; pixels <= x86::loops::max_pixels; pixels += turn) {
    cases::Draw draw(seed, pixels + 1);
    const auto word = [&] { return static_cast<std::uint32_t>(draw.bits()); };
    // Mixes arbitrary steps with the small steps of real pictures.
    const auto step = [&] { return pixels % 3 == 0 ? word() : word() % 1024 - 512; };
    LoopCall call{.pixels = pixels,
                  .value = word(),
                  .step = step(),
                  .row = word(),
                  .row_step = step(),
                  .colour = static_cast<std::uint8_t>(word())};
    call.place = form.loop == Loop::depth_test ? word() % 64 : row_address + word() % 64;
    spans.push_back(call);
  }
  return spans;
}

std::optional<std::uint64_t> spans_to_kill(const LoopForm& form, const x86::Program& program,
                                           std::uint64_t seed) {
  const auto code = x86::code_of(form, program);
  const auto spans = span_cases(form, seed);
  Trial trial(seed);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (!trial.passes(form, code, spans[i])) return i + 1;
  }
  return std::nullopt;
}

}  // namespace fixproof::proof
