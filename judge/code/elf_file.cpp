#include "judge/code/elf_file.hpp"

#include <elf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>
#include <utility>

#include "support/plain_text.hpp"

namespace fixproof::judge::elf {

namespace {

using support::UsageError;

/// The names that are read, together. Those of C++ may be long, those of a damaged file of any
/// length.
constexpr std::size_t max_name_bytes = std::size_t{1} << 22U;
constexpr std::uint32_t bytes_of_missing = 2 * judge::Symbol::reach;
constexpr std::size_t max_missing = first_missing / bytes_of_missing;

template <class Theirs>
Section section_of(const Theirs& s) {
  return {s.sh_type, s.sh_link, s.sh_info, s.sh_flags, s.sh_offset, s.sh_size, s.sh_addralign, 0};
}

template <class Theirs>
Symbol symbol_of(const Theirs& s) {
  return {s.st_name,
          s.st_shndx,
          static_cast<unsigned>(ELF32_ST_BIND(s.st_info)),
          static_cast<unsigned>(ELF32_ST_TYPE(s.st_info)),
          static_cast<std::uint32_t>(s.st_value),
          s.st_size};
}

}  // namespace

template <class... Field>
void reverse(Field&... fields) {
  const auto reverse_one = [](auto& field) {
    auto bytes = std::bit_cast<std::array<std::uint8_t, sizeof field>>(field);
    std::ranges::reverse(bytes);
    field = std::bit_cast<std::remove_reference_t<decltype(field)>>(bytes);
  };
  (reverse_one(fields), ...);
}

// Only the fields that are read.
template <class T>
void reverse_fields(T& s) {
  if constexpr (std::is_same_v<T, Elf32_Ehdr> || std::is_same_v<T, Elf64_Ehdr>) {
    reverse(s.e_type, s.e_phoff, s.e_phnum, s.e_phentsize, s.e_shoff, s.e_shnum, s.e_shentsize);
  } else if constexpr (std::is_same_v<T, Elf32_Shdr> || std::is_same_v<T, Elf64_Shdr>) {
    reverse(s.sh_type, s.sh_link, s.sh_info, s.sh_flags, s.sh_offset, s.sh_size, s.sh_addralign);
  } else if constexpr (std::is_same_v<T, Elf32_Phdr> || std::is_same_v<T, Elf64_Phdr>) {
    reverse(s.p_type, s.p_flags, s.p_offset, s.p_vaddr, s.p_filesz, s.p_memsz);
  } else if constexpr (std::is_same_v<T, Elf32_Sym> || std::is_same_v<T, Elf64_Sym>) {
    reverse(s.st_name, s.st_shndx, s.st_value, s.st_size);
  } else if constexpr (std::is_same_v<T, Elf32_Rel> || std::is_same_v<T, Elf64_Rel>) {
    reverse(s.r_offset, s.r_info);
  } else if constexpr (std::is_same_v<T, Elf32_Rela> || std::is_same_v<T, Elf64_Rela>) {
    reverse(s.r_offset, s.r_info, s.r_addend);
  } else {
    static_assert(sizeof(T) == 1);
  }
}

UsageError damaged() { return UsageError{"the ELF file is damaged"}; }

File::File(const std::string& bytes, bool is_64, bool is_big_endian, bool others_processor)
    : bytes_(bytes),
      is_64_(is_64),
      is_big_endian_(is_big_endian),
      others_processor_(others_processor) {
  if (is_64) {
    read_header<Elf64_Ehdr>();
  } else {
    read_header<Elf32_Ehdr>();
  }
}

template <class Header>
void File::read_header() {
  using Theirs = std::conditional_t<std::is_same_v<Header, Elf64_Ehdr>, Elf64_Shdr, Elf32_Shdr>;
  const auto header = at<Header>(0);
  kind_ = header.e_type;
  first_segment_ = header.e_phoff;
  segments_ = header.e_phnum;
  bytes_of_segment_ = header.e_phentsize;
  if (header.e_shnum > 0 && header.e_shentsize != sizeof(Theirs)) throw damaged();
  for (std::uint32_t i = 0; i < header.e_shnum; ++i) {
    sections_.push_back(section_of(at<Theirs>(header.e_shoff + std::uint64_t{i} * sizeof(Theirs))));
  }
}

template <class Theirs>
std::vector<Segment> File::segments_of() const {
  if (segments_ > 0 && bytes_of_segment_ != sizeof(Theirs)) throw damaged();
  std::vector<Segment> all;
  for (unsigned i = 0; i < segments_; ++i) {
    const auto s = at<Theirs>(first_segment_ + std::uint64_t{i} * sizeof(Theirs));
    if (s.p_type != PT_LOAD) continue;
    all.push_back({s.p_flags, s.p_offset, s.p_vaddr, s.p_filesz, s.p_memsz});
  }
  return all;
}

std::vector<Segment> File::segments() const {
  return is_64_ ? segments_of<Elf64_Phdr>() : segments_of<Elf32_Phdr>();
}

const Section& File::section(std::uint32_t number) const {
  if (number >= sections_.size()) throw damaged();
  return sections_[number];
}

bool File::is_placed(std::uint32_t section) const {
  return section < sections_.size() && (sections_[section].flags & SHF_ALLOC) != 0;
}

std::uint64_t File::symbols_in(const Section& table) const {
  return table.size / (is_64_ ? sizeof(Elf64_Sym) : sizeof(Elf32_Sym));
}

Symbol File::symbol_at(const Section& table, std::uint64_t number) const {
  if (number >= symbols_in(table)) throw damaged();
  return is_64_ ? symbol_of(at<Elf64_Sym>(table.offset + number * sizeof(Elf64_Sym)))
                : symbol_of(at<Elf32_Sym>(table.offset + number * sizeof(Elf32_Sym)));
}

bool File::is_list(const Section& section) const {
  if (others_processor_) return section.type == SHT_REL || section.type == SHT_RELA;
  return section.type == (is_64_ ? SHT_RELA : SHT_REL);
}

bool File::is_unused_list(const Section& section) const {
  return !others_processor_ && section.type == (is_64_ ? SHT_REL : SHT_RELA);
}

UsageError File::unused_list() const {
  return UsageError{is_64_ ? "the ELF file has relocations without addends, which x86-64 code does "
                             "not use"
                           : "the ELF file has relocations with addends, which i386 code does not "
                             "use"};
}

std::uint64_t File::relocations_in(const Section& list) const {
  if (list.type == SHT_RELA) return list.size / (is_64_ ? sizeof(Elf64_Rela) : sizeof(Elf32_Rela));
  return list.size / (is_64_ ? sizeof(Elf64_Rel) : sizeof(Elf32_Rel));
}

namespace {

template <class Theirs>
Relocation relocation_of(const Theirs& one) {
  Relocation relocation{.offset = one.r_offset};
  if constexpr (sizeof one.r_info == 8) {
    relocation.type = static_cast<std::uint32_t>(ELF64_R_TYPE(one.r_info));
    relocation.symbol = static_cast<std::uint32_t>(ELF64_R_SYM(one.r_info));
  } else {
    relocation.type = ELF32_R_TYPE(one.r_info);
    relocation.symbol = ELF32_R_SYM(one.r_info);
  }
  if constexpr (requires { one.r_addend; }) relocation.addend = one.r_addend;
  return relocation;
}

}  // namespace

Relocation File::relocation_at(const Section& list, std::uint64_t number) const {
  const auto read = [&]<class Theirs>(Theirs /*type*/) {
    return relocation_of(at<Theirs>(list.offset + number * sizeof(Theirs)));
  };
  if (list.type == SHT_RELA) return is_64_ ? read(Elf64_Rela{}) : read(Elf32_Rela{});
  return is_64_ ? read(Elf64_Rel{}) : read(Elf32_Rel{});
}

std::string File::name_of(const Section& table, const Symbol& symbol) {
  std::string text;
  for (std::uint64_t i = section(table.link).offset + symbol.name;; ++i) {
    const char c = at<char>(i);
    if (c == '\0') return text;
    if (name_bytes_++ == max_name_bytes) {
      throw UsageError("the names in the ELF file have more than 4 MiB");
    }
    text += c;
  }
}

void File::expect_sound_tables() const {
  std::map<std::uint32_t, int> tables;
  std::uint64_t relocation_bytes = 0;
  for (const Section& table : sections_) {
    const bool is_table = table.type == SHT_SYMTAB || table.type == SHT_DYNSYM;
    if (is_table && ++tables[table.type] > 1) throw damaged();
    if (!is_list(table)) continue;
    if (table.size > bytes_.size()) throw damaged();
    relocation_bytes += table.size;
  }
  if (relocation_bytes > bytes_.size()) throw damaged();
}

std::uint32_t MissingNames::add(std::string name) {
  if (image_.missing.size() == max_missing) throw damaged();
  const auto number = static_cast<std::uint32_t>(image_.missing.size());
  const std::uint32_t address = first_missing + judge::Symbol::reach + number * bytes_of_missing;
  image_.missing.push_back({std::move(name), address});
  return address;
}

bool is_routine(const std::string& name) {
  constexpr std::array<std::string_view, 3> of_linker{"_init", "_fini", "_start"};
  for (const std::string_view other : of_linker) {
    if (name == other) return false;
  }
  // GCC's functions for position-independent code.
  return !name.starts_with("__x86.get_pc_thunk.");
}

}  // namespace fixproof::judge::elf
