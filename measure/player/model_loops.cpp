#include "measure/player/model_loops.hpp"

#include <array>
#include <stdexcept>

#include "x86model/call_loop.hpp"

namespace fixproof::player {

namespace {

namespace x86 = x86model;
using x86::Counting;
using x86::Loop;
using x86::Symbol;

constexpr std::uint32_t offset_of(Symbol symbol) {
  return static_cast<std::uint32_t>(x86::address_of(symbol));
}

/// Bytes for the stack of a call.
using Stack = std::array<std::uint8_t, 0x60>;

/// The row is the extra segment, and there is no data segment.
class RowMemory : public x86::ByteMemory {
 public:
  RowMemory(Stack& stack, std::span<std::uint8_t> row) : ByteMemory({}, row, stack) {}
};

/// The bitmap is the data segment, rotated so that it begins at Texture.
class TextureMemory : public RowMemory {
 public:
  TextureMemory(Stack& stack, std::span<std::uint8_t> row, std::span<const std::uint8_t> bitmap)
      : RowMemory(stack, row), bitmap_(bitmap) {}

  bool read_byte(std::uint32_t address, std::uint32_t& value) const {
    value = bitmap_[(address - offset_of(Symbol::texture)) % xsharp::bitmap_texels];
    return true;
  }

 private:
  std::span<const std::uint8_t> bitmap_;
};

/// The data segment has the row at Screen and its depths at ZBuff.
class DepthMemory : public x86::ByteMemory {
 public:
  DepthMemory(Stack& stack, std::span<std::uint8_t> row, std::span<std::int16_t> depths)
      : ByteMemory({}, {}, stack), row_(row), depths_(depths) {}

  bool read(std::uint32_t address, std::uint32_t& value) const {
    const std::size_t index = (address - offset_of(Symbol::z_buff)) / 2;
    if (index >= depths_.size()) return false;
    value = static_cast<std::uint16_t>(depths_[index]);
    return true;
  }
  bool write(std::uint32_t address, std::uint32_t value) {
    const std::size_t index = (address - offset_of(Symbol::z_buff)) / 2;
    if (index >= depths_.size()) return false;
    depths_[index] = static_cast<std::int16_t>(value);
    return true;
  }
  bool write_byte(std::uint32_t address, std::uint32_t value) {
    const std::size_t index = address - offset_of(Symbol::screen);
    if (index >= row_.size()) return false;
    row_[index] = static_cast<std::uint8_t>(value);
    return true;
  }

 private:
  std::span<std::uint8_t> row_;
  std::span<std::int16_t> depths_;
};

template <class Memory>
void run_loop(const x86::LoopForm& form, std::span<const x86::Instruction> code,
              const Memory& memory, const x86::LoopCall& call) {
  x86::Machine<16, Memory> m{.registers = {}, .memory = memory};
  x86::enter_loop(form, m, call);
  if (x86::run(code, m).outcome != x86::Outcome::returned) {
    throw std::logic_error("an inner loop has left its row");
  }
}

std::uint32_t pixels_of(std::span<const std::uint8_t> out) {
  if (out.size() > xsharp::longest_span) throw std::length_error("a row longer than any span");
  return static_cast<std::uint32_t>(out.size());
}

static_assert(xsharp::longest_span == x86::loops::max_pixels);

}  // namespace

ModelLoops::ModelLoops(Counting counting, x86::Target target)
    : bytes_({Loop::gouraud_byte, counting, target}),
      words_({Loop::gouraud_word, counting, target}),
      depth_({Loop::depth_test, counting == Counting::unrolled ? Counting::loop : counting,
              x86::Target::i386}),
      texture_({Loop::texture, Counting::unrolled, target}) {}

void ModelLoops::gouraud(std::span<std::uint8_t> out, std::uint16_t start,
                         std::uint16_t step) const {
  Stack stack{};
  const x86::LoopCall span{.pixels = pixels_of(out), .value = start, .step = step};
  for (const x86::LoopPart& part : x86::parts_of(words_.form, span)) {
    const Ready& ready = part.form.loop == Loop::gouraud_byte ? bytes_ : words_;
    run_loop(ready.form, ready.code, RowMemory(stack, out), part.call);
  }
}

void ModelLoops::gouraud_wide(std::span<std::uint8_t> out, std::uint32_t start,
                              std::uint32_t step) const {
  xsharp::PlainLoops().gouraud_wide(out, start, step);
}

void ModelLoops::depth(std::span<std::uint8_t> out, std::span<std::int16_t> buffer,
                       std::uint8_t pixel, std::uint32_t start, std::uint32_t step) const {
  // The listings' counting loops cannot run zero times.
  if (out.empty()) return;
  Stack stack{};
  run_loop(depth_.form, depth_.code, DepthMemory(stack, out, buffer),
           {.pixels = pixels_of(out), .value = start, .step = step, .colour = pixel});
}

void ModelLoops::texture(std::span<std::uint8_t> out, std::span<const std::uint8_t> bitmap,
                         std::uint32_t u, std::uint32_t du, std::uint32_t v,
                         std::uint32_t dv) const {
  if (bitmap.size() != xsharp::bitmap_texels) throw std::length_error("a bitmap is 256 by 256");
  Stack stack{};
  run_loop(texture_.form, texture_.code, TextureMemory(stack, out, bitmap),
           {.pixels = pixels_of(out), .value = u, .step = du, .row = v, .row_step = dv});
}

}  // namespace fixproof::player
