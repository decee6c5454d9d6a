#include "judge/code/mips_table.hpp"

#include <elf.h>

#include <algorithm>
#include <array>
#include <map>

namespace fixproof::judge::elf {

std::optional<MipsTable> mips_table(const File& file, bool is_big_endian) {
  const auto& sections = file.sections();
  const auto dynamic = std::ranges::find(sections, std::uint32_t{SHT_DYNAMIC}, &Section::type);
  if (dynamic == sections.end()) return std::nullopt;
  const std::string& bytes = file.bytes();
  if (dynamic->offset > bytes.size() || bytes.size() - dynamic->offset < dynamic->size) {
    throw damaged();
  }
  const auto number_at = [&](std::uint64_t at) {
    std::uint32_t value = 0;
    for (std::uint64_t i = 0; i < 4; ++i) {
      value = value << 8U | static_cast<unsigned char>(bytes[at + (is_big_endian ? i : 3 - i)]);
    }
    return value;
  };
  std::map<std::uint32_t, std::uint32_t> values;
  for (std::uint64_t at = 0; at + sizeof(Elf32_Dyn) <= dynamic->size; at += sizeof(Elf32_Dyn)) {
    const std::uint64_t place = dynamic->offset + at;
    values.try_emplace(number_at(place), number_at(place + 4));
  }
  constexpr std::array<std::uint32_t, 4> needed{DT_PLTGOT, DT_MIPS_LOCAL_GOTNO, DT_MIPS_GOTSYM,
                                                DT_MIPS_SYMTABNO};
  const auto is_there = [&](std::uint32_t tag) { return values.contains(tag); };
  if (!std::ranges::all_of(needed, is_there)) return std::nullopt;
  const MipsTable table{.address = values[DT_PLTGOT],
                        .own = values[DT_MIPS_LOCAL_GOTNO],
                        .first_symbol = values[DT_MIPS_GOTSYM],
                        .symbols = values[DT_MIPS_SYMTABNO]};
  constexpr std::uint32_t most = max_code_bytes / 4;
  if (table.own > most || table.symbols > most || table.first_symbol > table.symbols) {
    throw damaged();
  }
  return table;
}

}  // namespace fixproof::judge::elf
