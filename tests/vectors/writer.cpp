#include "tests/vectors/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

namespace vectors {

namespace {

constexpr std::uint32_t df = 0x400;
constexpr std::array<std::string_view, 8> names{"ax", "cx", "dx", "bx", "sp", "bp", "si", "di"};

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

}  // namespace

void store(State& state, std::uint32_t address, std::uint32_t word) {
  state.ram.emplace_back(address, word & 0xFFU);
  state.ram.emplace_back(address + 1, word >> 8U & 0xFFU);
}

unsigned Writer::any_register() { return static_cast<unsigned>(random_() % names.size()); }

std::uint32_t Writer::any_word() {
  return command::draw_word(random_, static_cast<std::uint32_t>(bits()));
}

std::string Writer::name(unsigned r) const {
  return fmt::format("{}{}", wide_ ? "e" : "", names[r]);
}

std::string Writer::text() const { return fmt::format("[\n{}\n]\n", lines_); }

std::uint32_t Writer::between(std::uint32_t first, std::uint32_t last) {
  return first + static_cast<std::uint32_t>(random_() % (last - first + 1));
}

/// Code, stack and the interrupt vectors keep out of each other's way.
State Writer::draw(const Bytes& code, bool with_vector) {
  State state;
  for (std::uint32_t& word : state.registers.general) {
    word = command::draw_word(random_, i386_ ? 32 : 16);
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
void Writer::fault(const State& start, State& after, std::uint32_t next) {
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
Writer::Json Writer::json_of(const State& state, const State* before) const {
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

void Writer::add(const std::string& text, Bytes code, Wanted wanted,
                 const std::function<void(Registers&)>& set) {
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

void Writer::add_known(const std::string& text, const Bytes& code,
                       const std::function<void(State& start, State& after)>& change) {
  State start = draw(code, false);
  State after = start;
  after.ram.clear();
  after.rest.ip += static_cast<std::uint32_t>(code.size()) + halt();
  change(start, after);
  write(text, code, start, after);
}

void Writer::write(const std::string& text, Bytes code, const State& start, const State& after) {
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

}  // namespace vectors
