// The MOO format, version 1: nested chunks, each with a tag of four characters and a length. All
// numbers are little-endian. The format is documented at https://github.com/dbalsom/moo.
#include <fmt/format.h>

#include <array>
#include <span>

#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "verify/singlestep/formats.hpp"

namespace fixproof::singlestep {

namespace {

using x86model::Cpu;

/// The registers of REGS and RG32 in the order of their mask bits.
constexpr std::array registers_16{Place::ax, Place::bx, Place::cx, Place::dx,   Place::cs,
                                  Place::ss, Place::ds, Place::es, Place::sp,   Place::bp,
                                  Place::si, Place::di, Place::ip, Place::flags};
constexpr std::array registers_32{Place::cr0, Place::cr3, Place::ax,    Place::bx,  Place::cx,
                                  Place::dx,  Place::si,  Place::di,    Place::bp,  Place::sp,
                                  Place::cs,  Place::ds,  Place::es,    Place::fs,  Place::gs,
                                  Place::ss,  Place::ip,  Place::flags, Place::dr6, Place::dr7};

struct Chunk;

/// A part of the file, read from front to back.
class Bytes {
 public:
  Bytes(std::string_view rest, std::size_t at) : rest_(rest), at_(at) {}

  [[nodiscard]] bool empty() const { return rest_.empty(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }

  [[noreturn]] void fail(std::string_view message) const {
    throw support::UsageError(fmt::format("byte {}: {}", at_, message));
  }

  Bytes take(std::size_t count, std::string_view what) {
    if (count > rest_.size()) {
      fail(fmt::format("cut short: {} has {} bytes, {} are left", what, count, rest_.size()));
    }
    const Bytes taken(rest_.substr(0, count), at_);
    rest_.remove_prefix(count);
    at_ += count;
    return taken;
  }
  std::uint32_t number(std::size_t bytes, std::string_view what) {
    const Bytes taken = take(bytes, what);
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      value |= std::uint32_t{static_cast<std::uint8_t>(taken.rest_[i])} << (8 * i);
    }
    return value;
  }
  Chunk chunk();

 private:
  std::string_view rest_;
  std::size_t at_;
};

struct Chunk {
  std::string_view tag;
  Bytes body;
};

Chunk Bytes::chunk() {
  const std::string_view tag = take(4, "a chunk's tag").rest();
  const std::size_t length = number(4, "a chunk's length");
  return {tag, take(length, fmt::format("chunk {}", support::quoted(tag)))};
}

void read_registers(Bytes body, std::span<const Place> order, std::size_t width, Cpu cpu,
                    State& state) {
  const std::uint32_t mask = body.number(width, "the mask of registers");
  if ((mask & ~largest(static_cast<int>(order.size()))) != 0) body.fail("no such register");
  for (std::size_t i = 0; i < order.size(); ++i) {
    if ((mask >> i & 1U) == 0) continue;
    const std::string_view name = name_of(order[i], cpu);
    const std::uint32_t value = body.number(width, name);
    // RG32 has 32 bits for each register.
    if (value > largest(bits_of(order[i], cpu))) {
      body.fail(fmt::format("{:x} is too large for {}", value, name));
    }
    state.registers[static_cast<std::size_t>(order[i])] = value;
  }
}

void read_ram(Bytes body, Cpu cpu, State& state) {
  const std::uint32_t count = body.number(4, "the number of bytes in memory");
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t address = body.number(4, "an address");
    if (address > largest(address_bits(cpu))) {
      body.fail(fmt::format("address {:x} is too large for the {}", address, name_of(cpu)));
    }
    state.ram[address] = static_cast<std::uint8_t>(body.number(1, "a byte in memory"));
  }
}

void read_state(Bytes body, Cpu cpu, State& state) {
  const bool wide = cpu >= Cpu::i386;
  while (!body.empty()) {
    const Chunk chunk = body.chunk();
    if (chunk.tag == "RAM ") read_ram(chunk.body, cpu, state);
    if (chunk.tag != "REGS" && chunk.tag != "RG32") continue;
    if ((chunk.tag == "RG32") != wide) {
      chunk.body.fail(fmt::format("registers {} are not those of the {}", chunk.tag, name_of(cpu)));
    }
    wide ? read_registers(chunk.body, registers_32, 4, cpu, state)
         : read_registers(chunk.body, registers_16, 2, cpu, state);
  }
}

Case case_in(Bytes body, Cpu cpu, std::size_t index) {
  // The longest published case, a repeated string instruction, has less than 1 MiB.
  constexpr std::size_t max_size = std::size_t{4} << 20U;
  if (body.rest().size() > max_size) body.fail(fmt::format("case {} is too long", index));
  const Bytes whole = body;
  Case c;
  c.index = index;
  std::array<bool, 3> found{};
  body.number(4, "the case's number");
  while (!body.empty()) {
    Chunk chunk = body.chunk();
    if (chunk.tag == "NAME" || chunk.tag == "BYTS") {
      const std::uint32_t length = chunk.body.number(4, "a length");
      const std::string_view text = chunk.body.take(length, chunk.tag).rest();
      if (chunk.tag == "NAME") {
        c.name = text;
      } else {
        c.bytes.assign(text.begin(), text.end());
        found[0] = true;
      }
    } else if (chunk.tag == "INIT") {
      read_state(chunk.body, cpu, c.initial);
      found[1] = true;
    } else if (chunk.tag == "FINA") {
      read_state(chunk.body, cpu, c.final);
      found[2] = true;
    }
  }
  static constexpr std::array<std::string_view, 3> required{"BYTS", "INIT", "FINA"};
  for (std::size_t i = 0; i < required.size(); ++i) {
    if (!found.at(i)) whole.fail(fmt::format("{}: no {}", label_of(c), required.at(i)));
  }
  return c;
}

/// Returns whether a processor named in a file's header executes as `cpu` does.
bool is_captured_on(std::string_view id, Cpu cpu) {
  if (cpu == Cpu::i8088) return id == "8088" || id == "8086";
  return id == (cpu == Cpu::i286 ? "C286" : "386E");
}

}  // namespace

void read_moo(std::string_view bytes, Cpu cpu, const UseCase& use) {
  Bytes file(bytes, 0);
  Bytes header = file.chunk().body;
  const std::uint32_t version = header.number(1, "the version");
  if (version != 1) header.fail(fmt::format("MOO version {}; this reads version 1", version));
  header.take(1, "the minor version");
  header.take(2, "what is reserved");
  const std::uint32_t count = header.number(4, "the number of cases");
  const std::string_view id = header.take(4, "the processor").rest();
  if (!is_captured_on(id, cpu)) {
    header.fail(
        fmt::format("captured on {}, not on a {}; see --cpu", support::quoted(id), name_of(cpu)));
  }
  std::size_t index = 0;
  while (!file.empty()) {
    const Chunk chunk = file.chunk();
    if (chunk.tag != "TEST") continue;
    Case c = case_in(chunk.body, cpu, index++);
    finish(c, cpu, use);
  }
  if (index != count) file.fail(fmt::format("{} cases, but the header says {}", index, count));
  if (index == 0) throw support::UsageError("the file has no cases");
}

}  // namespace fixproof::singlestep
