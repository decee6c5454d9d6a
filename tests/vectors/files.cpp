#include "tests/vectors/files.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <fstream>
#include <stdexcept>
#include <string_view>

#include "tests/vectors/writer.hpp"

namespace vectors {

namespace {

void append(Bytes& bytes, std::uint32_t value, int bits) {
  for (int i = 0; i < bits; i += 8) bytes.push_back(static_cast<std::uint8_t>(value >> i));
}

std::uint8_t modrm(unsigned reg, unsigned rm) {
  return static_cast<std::uint8_t>(0xC0U | reg << 3U | rm);
}

struct Operation {
  std::string_view name;
  unsigned number;
};
constexpr Operation add{"add", 0};
constexpr Operation adc{"adc", 2};
constexpr Operation sbb{"sbb", 3};
constexpr Operation and_{"and", 4};
constexpr Operation sub{"sub", 5};
constexpr Operation xor_{"xor", 6};
constexpr Operation cmp{"cmp", 7};

std::uint8_t opcode_of(Operation op, unsigned way) {
  return static_cast<std::uint8_t>(op.number << 3U | way);
}

/// r/m, r and r, r/m.
void add_registers(Writer& w, std::initializer_list<Operation> operations) {
  for (const Operation op : operations) {
    const unsigned a = w.any_register();
    const unsigned b = w.any_register();
    const std::string text = fmt::format("{} {}, {}", op.name, w.name(a), w.name(b));
    w.add(text, {opcode_of(op, 1), modrm(b, a)});
    w.add(text, {opcode_of(op, 3), modrm(a, b)});
  }
}

/// The three ways of an immediate: for the accumulator, of the operand's size, of one byte.
void add_immediates(Writer& w, std::initializer_list<Operation> operations) {
  for (const Operation op : operations) {
    std::uint32_t value = w.any_word();
    Bytes code{opcode_of(op, 5)};
    append(code, value, w.bits());
    w.add(fmt::format("{} {}, {:x}h", op.name, w.name(ax), value), code);

    value = w.any_word();
    unsigned r = w.any_register();
    code = {0x81, modrm(op.number, r)};
    append(code, value, w.bits());
    w.add(fmt::format("{} {}, {:x}h", op.name, w.name(r), value), code);

    value = w.any_word() & 0xFFU;
    r = w.any_register();
    w.add(fmt::format("{} {}, byte {:x}h", op.name, w.name(r), value),
          {0x83, modrm(op.number, r), static_cast<std::uint8_t>(value)});
  }
}

void add_moves(Writer& w) {
  const unsigned a = w.any_register();
  const unsigned b = w.any_register();
  const std::string text = fmt::format("mov {}, {}", w.name(a), w.name(b));
  w.add(text, {0x89, modrm(b, a)});
  w.add(text, {0x8B, modrm(a, b)});
}

/// Between bytes, high and low ones.
void add_byte_moves(Writer& w) {
  w.add("mov al, dh", {0x88, modrm(6, ax)});
  w.add("mov ch, bl", {0x8A, modrm(5, bx)});
}

/// Group F7h: NEG is 3, MUL 4, IMUL 5.
void add_unary(Writer& w, std::string_view name, unsigned number) {
  for (int i = 0; i < 2; ++i) {
    const unsigned r = w.any_register();
    w.add(fmt::format("{} {}", name, w.name(r)), {0xF7, modrm(number, r)});
  }
}

void add_count(Writer& w, std::string_view name, unsigned number) {
  const unsigned r = w.any_register();
  const std::string text = fmt::format("{} {}", name, w.name(r));
  w.add(text, {static_cast<std::uint8_t>(0x40U | number << 3U | r)});
  w.add(text, {0xFF, modrm(number, r)});
}

void add_shift_by_one(Writer& w, std::string_view name, unsigned number) {
  const unsigned r = w.any_register();
  w.add(fmt::format("{} {}, 1", name, w.name(r)), {0xD1, modrm(number, r)});
}

void add_shifts(Writer& w, std::string_view name, unsigned number,
                std::initializer_list<std::uint8_t> counts) {
  for (const std::uint8_t count : counts) {
    const unsigned r = w.any_register();
    w.add(fmt::format("{} {}, {}", name, w.name(r), count), {0xC1, modrm(number, r), count});
  }
}

void add_double_shifts(Writer& w, std::string_view name, std::uint8_t opcode,
                       std::initializer_list<std::uint8_t> counts) {
  for (const std::uint8_t count : counts) {
    const unsigned a = w.any_register();
    const unsigned b = w.any_register();
    w.add(fmt::format("{} {}, {}, {}", name, w.name(a), w.name(b), count),
          {0x0F, opcode, modrm(b, a), count});
  }
}

/// Group F7h: DIV is 6, IDIV 7; by BX, with quotients of every length, one of them just too large,
/// and by 0.
void add_divides(Writer& w, std::string_view name, unsigned number) {
  const std::string text = fmt::format("{} {}", name, w.name(bx));
  const Bytes code{0xF7, modrm(number, bx)};
  const bool is_signed = number == 7;
  const std::uint32_t ones = w.bits() == 32 ? 0xFFFFFFFFU : 0xFFFFU;
  const auto divide = [&](std::uint32_t high, std::uint32_t low, std::uint32_t by) {
    return [=](Registers& r) {
      for (const auto& [place, value] : {std::pair{dx, high}, {ax, low}, {bx, by}}) {
        r.general[place] = (r.general[place] & ~ones) | value;
      }
    };
  };
  for (int i = 0; i < 3; ++i) w.add(text, code);
  w.add(text, code, Writer::Wanted::fault);
  w.add(text, code, Writer::Wanted::fault, divide(0, 1, 0));
  if (is_signed) {
    const std::uint32_t top = ones / 2 + 1;
    w.add(text, code, Writer::Wanted::value, divide(0, top - 1, 1));
    w.add(text, code, Writer::Wanted::fault, divide(0, top, 1));
    w.add(text, code, Writer::Wanted::value, divide(ones, top, 1));
    w.add(text, code, Writer::Wanted::fault, divide(top, 0, ones));
  } else {
    w.add(text, code, Writer::Wanted::value, divide(1, ones, 2));
    w.add(text, code, Writer::Wanted::fault, divide(2, 0, 2));
  }
}

/// One or more for each reason to skip a case.
void add_skipped(Writer& w) {
  w.add("or ax, bx", {0x09, modrm(bx, ax)});
  w.add("xor ax, bx", {0x31, modrm(bx, ax)});
  w.add("mov bx, 1234h", {0xBB, 0x34, 0x12});
  w.add("add al, cl", {0x00, modrm(1, ax)});
  w.add("neg dh", {0xF6, modrm(3, 6)});
  w.add("es add ax, bx", {0x26, 0x01, modrm(bx, ax)});
  w.add_known("mov ax, [ds:bx]", {0x8B, 0x07}, [](State& start, State& after) {
    start.registers.general[bx] &= 0x7FFE;
    after.registers.general[bx] = start.registers.general[bx];
    const std::uint32_t address = start.rest.ds * 16 + start.registers.general[bx];
    store(start, address & 0xFFFFFU, 0x1234);
    after.registers.general[ax] = (start.registers.general[ax] & 0xFFFF0000U) | 0x1234U;
  });
  w.add_known("push ax", {0x50}, [](State& start, State& after) {
    after.registers.general[sp] -= 2;
    store(after, start.rest.ss * 16 + after.registers.general[sp],
          start.registers.general[ax] & 0xFFFFU);
  });
  w.add_known("jmp short +5", {0xEB, 0x05},
              [](State& /*start*/, State& after) { after.rest.ip += 5; });
}

File make_8088() {
  Writer w(false, 8088);
  add_registers(w, {add, adc, and_, sub, cmp});
  add_immediates(w, {add, adc, sbb, sub, xor_, cmp});
  add_moves(w);
  add_count(w, "inc", 0);
  add_count(w, "dec", 1);
  add_unary(w, "neg", 3);
  add_unary(w, "mul", 4);
  add_divides(w, "div", 6);
  add_shift_by_one(w, "shl", 4);
  add_shift_by_one(w, "shr", 5);
  add_skipped(w);
  add_byte_moves(w);
  return {"8088.json", w.text(), false};
}

File make_386() {
  Writer w(true, 386);
  add_registers(w, {add, adc, and_, sub, cmp});
  add_immediates(w, {cmp});
  add_shifts(w, "shl", 4, {1, 2, 7, 32});
  add_shift_by_one(w, "shr", 5);
  w.widen(true);
  add_registers(w, {add, and_, sub, cmp});
  add_immediates(w, {add, adc});
  add_moves(w);
  w.add("dec ebx", {0x4B});
  w.add("dec esp", {0xFF, modrm(1, sp)});
  add_unary(w, "neg", 3);
  add_unary(w, "imul", 5);
  add_shift_by_one(w, "shr", 5);
  add_shifts(w, "rol", 0, {2, 16, 31});
  add_shifts(w, "shr", 5, {1, 16, 40});
  add_shifts(w, "sar", 7, {2, 16, 0});
  add_double_shifts(w, "shld", 0xA4, {1, 16, 31});
  add_double_shifts(w, "shrd", 0xAC, {1, 16, 64});
  // An immediate that ends as the HLT after it does.
  w.add("add eax, 0f4000001h", {0x05, 0x01, 0x00, 0x00, 0xF4});
  w.widen(false);
  add_skipped(w);
  add_byte_moves(w);
  return {"386.json", w.text(), false};
}

File make_386_divide() {
  Writer w(true, 387);
  add_divides(w, "div", 6);
  w.widen(true);
  add_divides(w, "div", 6);
  add_divides(w, "idiv", 7);
  return {"386-divide.json.gz", w.text(), true};
}

}  // namespace

std::vector<File> make_files() { return {make_8088(), make_386(), make_386_divide()}; }

void write(const std::string& path, const File& file) {
  if (file.compressed) {
    auto* out = gzopen(path.c_str(), "wb9");
    if (out == nullptr) throw std::runtime_error("cannot write " + path);
    const auto size = static_cast<unsigned>(file.text.size());
    const bool written = gzwrite(out, file.text.data(), size) == static_cast<int>(size);
    if (gzclose(out) != Z_OK || !written) throw std::runtime_error("cannot write " + path);
    return;
  }
  std::ofstream out(path, std::ios::binary);
  out << file.text;
  out.close();
  if (!out) throw std::runtime_error("cannot write " + path);
}

}  // namespace vectors
