#include "verify/singlestep/read.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/file.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "verify/singlestep/formats.hpp"
#include "verify/singlestep/gunzip.hpp"

namespace fixproof::singlestep {

namespace {

using x86model::Cpu;

constexpr std::array<std::string_view, place_count> names_386{
    "eax", "ecx", "edx",    "ebx", "esp", "ebp", "esi", "edi", "cs",  "ss", "ds",
    "es",  "eip", "eflags", "fs",  "gs",  "cr0", "cr2", "cr3", "dr6", "dr7"};

constexpr std::size_t required_count = static_cast<std::size_t>(Place::flags) + 1;

}  // namespace

std::string_view name_of(Place place, Cpu cpu) {
  const std::string_view name = names_386.at(static_cast<std::size_t>(place));
  if (cpu >= Cpu::i386) return name;
  if (place > Place::flags) return {};
  return name.starts_with('e') && name != "es" ? name.substr(1) : name;
}

int bits_of(Place place, Cpu cpu) {
  static constexpr std::array segments{Place::cs, Place::ss, Place::ds,
                                       Place::es, Place::fs, Place::gs};
  const bool segment = std::find(segments.begin(), segments.end(), place) != segments.end();
  return cpu >= Cpu::i386 && !segment ? 32 : 16;
}

int address_bits(Cpu cpu) {
  if (cpu == Cpu::i8088) return 20;
  return cpu == Cpu::i286 ? 24 : 32;
}

std::string label_of(const Case& c) {
  if (c.name.empty()) return fmt::format("case {}", c.index);
  return fmt::format("case {} {}", c.index, support::quoted(c.name));
}

void finish(Case& c, Cpu cpu, const UseCase& use) {
  for (std::size_t i = 0; i < place_count; ++i) {
    const auto& before = c.initial.registers[i];
    auto& after = c.final.registers[i];
    if (!before && (after || i < required_count)) {
      throw support::UsageError(fmt::format("{}: initial.regs.{} is missing", label_of(c),
                                            name_of(static_cast<Place>(i), cpu)));
    }
    if (!after) after = before;
  }
  try {
    use(c);
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format("{}: {}", label_of(c), error.what()));
  }
}

void read_cases(const std::string& path, Cpu cpu, const UseCase& use) {
  try {
    const std::string text = gunzip(support::read_file(path));
    if (text.empty()) throw support::UsageError("empty");
    if (text.starts_with(moo_magic)) return read_moo(text, cpu, use);
    read_json(text, cpu, use);
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace fixproof::singlestep
