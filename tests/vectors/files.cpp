#include "tests/vectors/files.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "tests/cli/draw.hpp"
#include "tests/vectors/processor.hpp"

namespace vectors {

namespace {

using Json = nlohmann::ordered_json;
using Bytes = std::vector<std::uint8_t>;

constexpr unsigned ax = 0;
constexpr unsigned dx = 2;
constexpr unsigned bx = 3;
constexpr unsigned sp = 4;
constexpr std::uint32_t df = 0x400;
constexpr std::uint32_t six_flags = 0x8D5;
constexpr std::array<std::string_view, 8> names{"ax", "cx", "dx", "bx", "sp", "bp", "si", "di"};

/// What the sets record beside the registers that an instruction computes with.
struct Rest {
  std::uint32_t cs = 0;
  std::uint32_t ss = 0;
  std::uint32_t ds = 0;
  std::uint32_t es = 0;
  std::uint32_t ip = 0;
};

struct State {
  Registers registers;
  Rest rest;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ram;
};

/// The encoding for a 64-bit processor: 66h means the other size there, and INC and DEC of a
/// register are a byte longer.
Bytes host_code(Bytes code) {
  const auto opcode = std::find_if(code.begin(), code.end(),
                                   [](std::uint8_t byte) { return (byte & 0xE7U) != 0x26U; });
  const auto at = opcode - code.begin();
  if (*opcode == 0x66) {
    code.erase(opcode);
  } else {
    code.insert(opcode, 0x66);
  }
  const auto first =
      std::find_if(code.begin() + at, code.end(), [](std::uint8_t byte) { return byte != 0x66; });
  if (*first >= 0x40 && *first < 0x50) {
    const auto modrm = static_cast<std::uint8_t>(0xC0U | (*first & 0xFU));
    *first = 0xFF;
    code.insert(first + 1, modrm);
  }
  return code;
}

void append(Bytes& bytes, std::uint32_t value, int bits) {
  for (int i = 0; i < bits; i += 8) bytes.push_back(static_cast<std::uint8_t>(value >> i));
}

std::uint8_t modrm(unsigned reg, unsigned rm) {
  return static_cast<std::uint8_t>(0xC0U | reg << 3U | rm);
}

void store(State& state, std::uint32_t address, std::uint32_t word) {
  state.ram.emplace_back(address, word & 0xFFU);
  state.ram.emplace_back(address + 1, word >> 8U & 0xFFU);
}

/// Writes one file, case by case.
class Writer {
 public:
  Writer(bool i386, std::uint64_t seed) : i386_(i386), random_(seed) {}

  [[nodiscard]] bool i386() const { return i386_; }
  /// Operands from here on are of 32 bits.
  void widen(bool wide) { wide_ = wide; }
  [[nodiscard]] int bits() const { return wide_ ? 32 : 16; }

  unsigned any_register() { return static_cast<unsigned>(random_() % names.size()); }
  std::uint32_t any_word() { return cli::draw_word(random_, static_cast<std::uint32_t>(bits())); }

  [[nodiscard]] std::string name(unsigned r) const {
    return fmt::format("{}{}", wide_ ? "e" : "", names[r]);
  }

  enum class Wanted { value, fault };

  /// A case of an instruction, its result the processor's; operands are drawn until it faults, or
  /// does not, as wanted. `set` may choose operands.
  void add(const std::string& text, Bytes code, Wanted wanted = Wanted::value,
           const std::function<void(Registers&)>& set = {}) {
    if (wide_) code.insert(code.begin(), 0x66);
    for (int tries = 0; tries < 10'000; ++tries) {
      State start = draw(code, wanted == Wanted::fault);
      if (set) set(start.registers);
      State after = start;
      after.ram.clear();
      const bool value = execute(host_code(code), after.registers);
      if (value != (wanted == Wanted::value)) continue;
      const std::uint32_t next = start.rest.ip + static_cast<std::uint32_t>(code.size());
      after.rest.ip = next + halt();
      if (!value) fault(start, after, next);
      return write(text, code, start, after);
    }
    throw std::logic_error("no operands found for " + text);
  }

  /// A case whose result `change` knows: what the processor cannot be asked.
  void add_known(const std::string& text, const Bytes& code,
                 const std::function<void(State& start, State& after)>& change) {
    State start = draw(code, false);
    State after = start;
    after.ram.clear();
    after.rest.ip += static_cast<std::uint32_t>(code.size()) + halt();
    change(start, after);
    write(text, code, start, after);
  }

  [[nodiscard]] std::string text() const { return fmt::format("[\n{}\n]\n", lines_); }

 private:
  /// The sets of the 386 end every case with a HLT.
  [[nodiscard]] std::uint32_t halt() const { return i386_ ? 1 : 0; }

  std::uint32_t between(std::uint32_t first, std::uint32_t last) {
    return first + static_cast<std::uint32_t>(random_() % (last - first + 1));
  }

  /// Code, stack and the interrupt vectors keep out of each other's way.
  State draw(const Bytes& code, bool with_vector) {
    State state;
    for (std::uint32_t& word : state.registers.general) {
      word = cli::draw_word(random_, i386_ ? 32 : 16);
    }
    state.registers.general[sp] = between(0x80, 0x7FFF) * 2;
    const auto fixed = i386_ ? 0xFFFC0002U : 0xF002U;
    state.registers.flags = fixed | (static_cast<std::uint32_t>(random_()) & (six_flags | df));
    state.rest = {.cs = between(0x1000, 0x6FFF),
                  .ss = between(0x8000, 0xEFFF),
                  .ds = between(0, 0xFFFF),
                  .es = between(0, 0xFFFF),
                  .ip = between(0x100, 0xFF00)};
    if (with_vector) {
      // The sets of the 8088 have the handler at 0000:0400, those of the 386 anywhere.
      const std::uint32_t offset = i386_ ? between(0, 0xFFF0) : 0x400;
      const std::uint32_t segment = i386_ ? between(0x100, 0xFFFF) : 0;
      store(state, 0, offset);
      store(state, 2, segment);
    }
    std::uint32_t address = state.rest.cs * 16 + state.rest.ip;
    for (const std::uint8_t byte : code) state.ram.emplace_back(address++, byte);
    state.ram.emplace_back(address, i386_ ? 0xF4 : 0x90);
    return state;
  }

  /// The divide error as interrupt 0. The 8088 pushes the address of the next instruction, the 386
  /// that of the divide.
  void fault(const State& start, State& after, std::uint32_t next) {
    const std::uint32_t stack = start.rest.ss * 16 + start.registers.general[sp];
    store(after, stack - 2, start.registers.flags & 0xFFFFU);
    store(after, stack - 4, start.rest.cs);
    store(after, stack - 6, i386_ ? start.rest.ip : next);
    flag_address_ = stack - 2;
    after.registers.general[sp] -= 6;
    after.rest.ip = (start.ram[0].second | start.ram[1].second << 8U) + halt();
    after.rest.cs = start.ram[2].second | start.ram[3].second << 8U;
  }

  /// All registers, or those that differ from `before`.
  [[nodiscard]] Json json_of(const State& state, const State* before) const {
    Json registers = Json::object();
    const auto put = [&](std::string_view name, bool extended, std::uint32_t value,
                         std::uint32_t old) {
      if (before != nullptr && value == old) return;
      registers[fmt::format("{}{}", i386_ && extended ? "e" : "", name)] = value;
    };
    const State& old = before != nullptr ? *before : state;
    for (std::size_t i = 0; i < names.size(); ++i) {
      put(names[i], true, state.registers.general[i], old.registers.general[i]);
    }
    put("cs", false, state.rest.cs, old.rest.cs);
    put("ss", false, state.rest.ss, old.rest.ss);
    put("ds", false, state.rest.ds, old.rest.ds);
    put("es", false, state.rest.es, old.rest.es);
    put("ip", true, state.rest.ip, old.rest.ip);
    put("flags", true, state.registers.flags, old.registers.flags);
    Json ram = Json::array();
    for (const auto& [address, byte] : state.ram) ram.push_back({address, byte});
    return {{"regs", registers}, {"ram", ram}, {"queue", Json::array()}};
  }

  void write(const std::string& text, Bytes code, const State& start, const State& after) {
    if (i386_) code.push_back(0xF4);
    Json json{{"name", text},
              {"bytes", code},
              {"initial", json_of(start, nullptr)},
              {"final", json_of(after, &start)},
              {"idx", count_}};
    if (i386_ && after.rest.cs != start.rest.cs) {
      json["exception"] = {{"number", 0}, {"flag_address", flag_address_}};
    }
    if (count_ > 0) lines_ += ",\n";
    lines_ += json.dump();
    ++count_;
  }

  bool i386_;
  bool wide_ = false;
  cli::Random random_;
  std::string lines_;
  std::size_t count_ = 0;
  std::uint32_t flag_address_ = 0;
};

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
    const gzFile out = gzopen(path.c_str(), "wb9");
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
