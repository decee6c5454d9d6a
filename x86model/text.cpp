#include "x86model/text.hpp"

#include <array>
#include <cstddef>
#include <set>

#include "x86model/cosine_table.hpp"
#include "x86model/instruction_table.hpp"
#include "x86model/machine.hpp"
#include "x86model/originals.hpp"

namespace x86model {

namespace {

constexpr std::array<std::string_view, register_count> dword_names{"eax", "ecx", "edx", "ebx",
                                                                   "esp", "ebp", "esi", "edi"};

constexpr std::array<std::string_view, register_count> byte_names{"al", "cl", "dl", "bl",
                                                                  "ah", "ch", "dh", "bh"};

std::string_view size_prefix(Size size) {
  if (size == Size::byte) return "byte ";
  return size == Size::word ? "word " : "dword ";
}

std::string_view name_of(Symbol symbol) {
  constexpr std::array<std::string_view, 6> names{"",        "CosTable", "IncJ",
                                                  "Texture", "Screen",   "ZBuff"};
  return names.at(static_cast<std::size_t>(symbol));
}

std::string address_text(const Operand& o) {
  // NASM may encode edi*2 as edi+edi, which is shorter but differs from the sources' assemblers.
  std::string text = o.addressing == Addressing::index_twice ? "[nosplit " : "[";
  if (o.segment == SegmentOverride::cs) text += "cs:";
  text += name_of(o.symbol);
  if (o.addressing != Addressing::direct) {
    if (o.symbol != Symbol::none) text += '+';
    text += name_of(o.reg, o.addressing == Addressing::base ? Size::word : Size::dword);
    if (o.addressing == Addressing::index_twice) text += "*2";
  }
  if (o.value > 0 && !text.ends_with('[')) text += '+';
  if (o.value != 0) text += std::to_string(o.value);
  return text + ']';
}

std::string immediate_text(const Operand& o) {
  switch (o.scaling) {
    case Scaling::half_unit:
      return "0x8000";
    case Scaling::word_bits:
      return "16";
    case Scaling::literal:
    case Scaling::bytes:
      break;
  }
  return std::to_string(o.value);
}

/// @param sized whether a register operand already determines the size of a memory operand
std::string operand_text(const Instruction& i, const Operand& o, bool sized) {
  switch (o.kind) {
    case Operand::Kind::reg:
      return std::string(name_of(o.reg, o.size));
    case Operand::Kind::immediate:
      return immediate_text(o);
    case Operand::Kind::memory:
      return sized ? address_text(o) : std::string(size_prefix(o.size)) + address_text(o);
    case Operand::Kind::label:
      return std::string(i.mnemonic == Mnemonic::call ? "" : ".").append(o.name);
    case Operand::Kind::none:
      break;
  }
  return {};
}

/// Appends the instruction, after its label if it has one.
void append_row(std::string& source, const Instruction& instruction) {
  if (instruction.label != nullptr) {
    source += instruction.is_procedure ? "\n" : ".";
    source += instruction.label;
    source += ":\n";
  }
  source += "        " + text_of(instruction) + '\n';
}

void append_cosine_table(std::string& source) {
  constexpr std::size_t per_line = 8;
  source += "\n; cosines of 0.0 to 90.0 degrees, each the nearest 16.16 value\nCosTable:\n";
  for (std::size_t i = 0; i < cosine_table.size(); ++i) {
    source += i % per_line == 0 ? "        dd " : ", ";
    source += std::to_string(cosine_table[i]);
    if (i % per_line == per_line - 1 || i + 1 == cosine_table.size()) source += '\n';
  }
}

}  // namespace

std::string_view name_of(Register r, Size size) {
  if (size == Size::byte) return byte_names.at(static_cast<std::size_t>(r));
  const std::string_view name = dword_names.at(static_cast<std::size_t>(r));
  return size == Size::word ? name.substr(1) : name;
}

std::string_view name_of(Mnemonic m) { return mnemonic_rows.at(static_cast<std::size_t>(m)).name; }

std::optional<Mnemonic> mnemonic_named(std::string_view name) {
  for (const MnemonicRow& row : mnemonic_rows) {
    if (row.name == name) return row.mnemonic;
  }
  return std::nullopt;
}

std::string_view name_of(Routine r) { return listing(r, Target::i386).rows.front().label; }

std::string_view name_of(Counting counting) {
  constexpr std::array<std::string_view, 3> names{"loop", "dec-jnz", "unrolled"};
  return names.at(static_cast<std::size_t>(counting));
}

std::string text_of(const Instruction& instruction) {
  std::string text(name_of(instruction.mnemonic));
  bool sized = false;
  for (const Operand& o : instruction.operands) sized |= o.kind == Operand::Kind::reg;
  bool first = true;
  for (const Operand& o : instruction.operands) {
    if (o.kind == Operand::Kind::none) break;
    text += first ? " " : ", ";
    text += operand_text(instruction, o, sized);
    first = false;
  }
  return text;
}

std::string nasm_source(Routine routine, Target target, const Build& build) {
  const Program program = assemble(listing(routine, target), build);
  std::string source = "; ";
  source += name_of(routine);
  source += target == Target::i386 ? " for the 386" : " for the 8088";
  if (build.chapter_52) {
    // Chapter 52 prints ConcatXforms as C, and only multiply and divide as assembly.
    source +=
        routine == Routine::concat
            ? ": listing 54.1 changed to give the results of chapter 52's C, not printed there"
            : ", as chapter 52 has it";
  }
  if (build.endif_as_scanned) source += ", with its last ADC after the endif";
  if (build.repaired) source += ", repaired: with the carry that the listing loses";
  if (build.shl_as_printed) source += ", with the shifts by two that an 8088 does not have";
  source += '\n';
  source += source_comment(routine, target, build);
  const bool assembles_for_386 = target == Target::i386 || build.shl_as_printed;
  source += assembles_for_386 ? "        cpu 386\n" : "        cpu 8086\n";
  source += "        bits 16\n";
  for (const Instruction& i : program.instructions()) append_row(source, i);
  if (routine == Routine::cossin) append_cosine_table(source);
  return source;
}

std::string nasm_source(const LoopForm& form) {
  const Program program = assemble(listing(form), {});
  const auto rows = program.instructions();
  std::string source = "; ";
  source.append(name_of(form.loop)).append(", ").append(name_of(form.counting));
  source += form.target == Target::i386 ? ", for the 386" : ", for the 8088";
  if (form.as_printed) source += ", as printed";
  source += '\n';
  std::set<Symbol> symbols;
  for (const Instruction& i : rows) {
    for (const Operand& o : i.operands) symbols.insert(o.symbol);
  }
  symbols.erase(Symbol::none);
  for (const Symbol symbol : symbols) {
    source.append(name_of(symbol)).append(" equ ").append(std::to_string(address_of(symbol)));
    source += '\n';
  }
  source += form.target == Target::i386 ? "        cpu 386\n" : "        cpu 8086\n";
  source += "        bits 16\n";
  source.append("\n").append(name_of(form.loop)).append(":\n");
  const bool unrolled = form.counting == Counting::unrolled;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (unrolled && i + 1 == rows.size()) source += "        %endrep\n";
    append_row(source, rows[i]);
    if (unrolled && i == 0) {
      source += "        %rep " + std::to_string(copies_of(form.loop)) + '\n';
    }
  }
  return source;
}

}  // namespace x86model
