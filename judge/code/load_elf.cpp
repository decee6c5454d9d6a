#include <elf.h>
#include <fmt/format.h>

#include <cstring>
#include <map>
#include <optional>

#include "judge/code/call.hpp"
#include "judge/code/load.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

/// The address of the first section. It keeps 0 an invalid pointer.
constexpr std::uint32_t load_address = 0x1000;
/// More than there is room for; sections of a damaged file may add up to any size.
constexpr std::size_t max_code_bytes = 0x100000;
/// The names that are read, together. Those of C++ may be long, those of a damaged file of any
/// length.
constexpr std::size_t max_name_bytes = std::size_t{1} << 22U;
/// A name that the object lacks gets an address beyond all memory, so that its use faults, and this
/// many bytes around the address, so that the fault tells the name.
constexpr std::uint32_t first_missing = 0x40000000;
constexpr std::uint32_t bytes_of_missing = 2 * Symbol::reach;
constexpr std::size_t max_missing = first_missing / bytes_of_missing;

/// GCC's function for position-independent code. No user asks for it.
bool is_thunk(const std::string& name) { return name.starts_with("__x86.get_pc_thunk."); }

/// What both classes of objects have.
struct Section {
  std::uint32_t type = 0;
  std::uint32_t link = 0;
  std::uint32_t info = 0;
  std::uint64_t flags = 0;
  std::uint64_t offset = 0;  ///< in the file
  std::uint64_t size = 0;
  std::uint64_t alignment = 0;
  std::uint32_t place = 0;  ///< in memory
};
struct ElfSymbol {
  std::uint32_t name = 0;
  std::uint16_t section = 0;
  unsigned binding = 0;
  std::uint32_t value = 0;
  std::uint64_t size = 0;
};
struct Relocation {
  std::uint32_t type = 0;
  std::uint32_t symbol = 0;
  std::uint64_t offset = 0;
  std::optional<std::int64_t> addend{};  ///< if it does not stand in the section
};

template <class Theirs>
Section section_of(const Theirs& s) {
  return {s.sh_type, s.sh_link, s.sh_info, s.sh_flags, s.sh_offset, s.sh_size, s.sh_addralign, 0};
}
template <class Theirs>
ElfSymbol symbol_of(const Theirs& s) {
  return {s.st_name, s.st_shndx, static_cast<unsigned>(ELF32_ST_BIND(s.st_info)),
          static_cast<std::uint32_t>(s.st_value), s.st_size};
}

class Object {
 public:
  Object(Image& image, const std::string& bytes)
      : image_(image), bytes_(bytes), is_64_(image.bits == 64) {}

  void load() {
    const auto header = at<Elf32_Ehdr>(0);  // in 64 bits, too, these members have their places
    if (header.e_type == ET_DYN) {
      throw UsageError(
          "the ELF file is linked; give the object from before linking, or call a function of a "
          "shared library with eval --by FILE:FUNCTION (docs/judge.md)");
    }
    if (header.e_type != ET_REL) {
      throw UsageError("the ELF file is linked; give the object from before linking");
    }
    if (is_64_) {
      const auto wide = at<Elf64_Ehdr>(0);
      read_sections<Elf64_Shdr>(wide.e_shoff, wide.e_shnum, wide.e_shentsize);
    } else {
      read_sections<Elf32_Shdr>(header.e_shoff, header.e_shnum, header.e_shentsize);
    }
    expect_sound_tables();
    place();
    read_symbols();
    const std::uint32_t unused_list = is_64_ ? SHT_REL : SHT_RELA;
    for (const Section& section : sections_) {
      if (section.type == list_type()) relocate(section);
      if (section.type == unused_list && is_placed(section.info)) {
        throw UsageError(is_64_ ? "the ELF file has relocations without addends, which x86-64 code "
                                  "does not use"
                                : "the ELF file has relocations with addends, which i386 code does "
                                  "not use");
      }
    }
  }

 private:
  [[nodiscard]] std::uint32_t list_type() const { return is_64_ ? SHT_RELA : SHT_REL; }
  /// The bytes of an entry of the global offset table.
  [[nodiscard]] std::uint32_t entry_bytes() const { return is_64_ ? 8 : 4; }

  template <class Theirs>
  void read_sections(std::uint64_t offset, std::uint32_t count, std::uint32_t entry_size) {
    if (entry_size != sizeof(Theirs)) throw damaged();
    for (std::uint32_t i = 0; i < count; ++i) {
      sections_.push_back(section_of(at<Theirs>(offset + std::uint64_t{i} * sizeof(Theirs))));
    }
  }

  [[nodiscard]] std::uint64_t symbols_in(const Section& table) const {
    return table.size / (is_64_ ? sizeof(Elf64_Sym) : sizeof(Elf32_Sym));
  }
  [[nodiscard]] ElfSymbol symbol_at(const Section& table, std::uint64_t number) const {
    return is_64_ ? symbol_of(at<Elf64_Sym>(table.offset + number * sizeof(Elf64_Sym)))
                  : symbol_of(at<Elf32_Sym>(table.offset + number * sizeof(Elf32_Sym)));
  }
  [[nodiscard]] std::uint64_t relocations_in(const Section& list) const {
    return list.size / (is_64_ ? sizeof(Elf64_Rela) : sizeof(Elf32_Rel));
  }
  [[nodiscard]] Relocation relocation_at(const Section& list, std::uint64_t number) const {
    if (!is_64_) {
      const auto one = at<Elf32_Rel>(list.offset + number * sizeof(Elf32_Rel));
      return {ELF32_R_TYPE(one.r_info), ELF32_R_SYM(one.r_info), one.r_offset};
    }
    const auto one = at<Elf64_Rela>(list.offset + number * sizeof(Elf64_Rela));
    return {static_cast<std::uint32_t>(ELF64_R_TYPE(one.r_info)),
            static_cast<std::uint32_t>(ELF64_R_SYM(one.r_info)), one.r_offset, one.r_addend};
  }

  static UsageError damaged() { return UsageError{"the ELF file is damaged"}; }

  template <class T>
  [[nodiscard]] T at(std::uint64_t offset) const {
    T value{};
    if (offset > bytes_.size() || bytes_.size() - offset < sizeof value) throw damaged();
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return value;
  }

  [[nodiscard]] std::string text_at(const Section& strings, std::uint32_t offset) {
    std::string text;
    for (std::uint64_t i = strings.offset + offset;; ++i) {
      const char c = at<char>(i);
      if (c == '\0') return text;
      if (name_bytes_++ == max_name_bytes) {
        throw UsageError("the names in the ELF file have more than 4 MiB");
      }
      text += c;
    }
  }

  [[nodiscard]] bool is_placed(std::uint32_t section) const {
    return section < sections_.size() && (sections_[section].flags & SHF_ALLOC) != 0;
  }

  /// Appends zeros to the code and data, and returns where they start.
  static std::uint32_t reserve(std::string& flat, std::uint64_t alignment, std::uint64_t size) {
    if (alignment > 0x1000) throw damaged();
    if (size > max_code_bytes || flat.size() + alignment + size > max_code_bytes) {
      throw UsageError("the ELF file has more than 1 MiB of code and data");
    }
    if (alignment > 1) flat.resize((flat.size() + alignment - 1) / alignment * alignment);
    const auto start = static_cast<std::uint32_t>(flat.size());
    flat.resize(flat.size() + size);
    return start;
  }

  /// Places the sections one after the other.
  void place() {
    std::string flat;
    for (Section& section : sections_) {
      if ((section.flags & SHF_ALLOC) == 0) continue;
      const std::uint32_t start = reserve(flat, section.alignment, section.size);
      section.place = load_address + start;
      if (section.type == SHT_NOBITS) continue;
      if (section.offset > bytes_.size() || bytes_.size() - section.offset < section.size) {
        throw damaged();
      }
      flat.replace(start, section.size, bytes_, section.offset, section.size);
    }
    if (flat.empty()) throw UsageError("the ELF file has no code");
    place_common_symbols(flat);
    place_offset_table(flat);
    image_.container = "ELF object";
    load_flat(image_, flat, load_address);
  }

  /// Places variables without a section, which older compilers make of `int counter;` in C.
  void place_common_symbols(std::string& flat) {
    for (const Section& table : sections_) {
      if (table.type != SHT_SYMTAB) continue;
      for (std::uint64_t i = 0; i < symbols_in(table); ++i) {
        const ElfSymbol symbol = symbol_at(table, i);
        if (symbol.section != SHN_COMMON) continue;
        common_[i] = load_address + reserve(flat, symbol.value, symbol.size);
      }
    }
  }

  /// Places the global offset table of position-independent code. Each relocation that needs an
  /// entry gets one of its own.
  void place_offset_table(std::string& flat) {
    flat.resize((flat.size() + 7) / 8 * 8);
    offset_table_ = next_entry_ = load_address + static_cast<std::uint32_t>(flat.size());
    for (const Section& list : sections_) {
      if (list.type != list_type() || !is_placed(list.info)) continue;
      for (std::uint64_t i = 0; i < relocations_in(list); ++i) {
        if (needs_entry(relocation_at(list, i).type)) flat.append(entry_bytes(), '\0');
      }
    }
  }

  [[nodiscard]] bool needs_entry(std::uint32_t type) const {
    if (!is_64_) return type == R_386_GOT32 || type == R_386_GOT32X;
    return type == R_X86_64_GOTPCREL || type == R_X86_64_GOTPCRELX ||
           type == R_X86_64_REX_GOTPCRELX;
  }

  /// One table of symbols, and relocations that do not share bytes: otherwise a small file could
  /// ask for any amount of work.
  void expect_sound_tables() const {
    std::uint64_t symbol_tables = 0;
    std::uint64_t relocation_bytes = 0;
    for (const Section& table : sections_) {
      if (table.type == SHT_SYMTAB) ++symbol_tables;
      if (table.type != list_type()) continue;
      if (table.size > bytes_.size()) throw damaged();
      relocation_bytes += table.size;
    }
    if (symbol_tables > 1 || relocation_bytes > bytes_.size()) throw damaged();
  }

  [[nodiscard]] const Section& section(std::uint32_t number) const {
    if (number >= sections_.size()) throw damaged();
    return sections_[number];
  }

  void read_symbols() {
    for (const Section& table : sections_) {
      if (table.type != SHT_SYMTAB) continue;
      for (std::uint64_t i = 0; i < symbols_in(table); ++i) {
        const ElfSymbol symbol = symbol_at(table, i);
        const bool is_code =
            is_placed(symbol.section) && (section(symbol.section).flags & SHF_EXECINSTR) != 0;
        if (!is_code || symbol.name == 0 || symbol.binding == STB_LOCAL) continue;
        std::string name = text_at(section(table.link), symbol.name);
        if (is_thunk(name)) continue;
        image_.symbols.push_back({std::move(name), section(symbol.section).place + symbol.value});
      }
    }
  }

  [[nodiscard]] std::uint32_t value_of(const Section& table, std::uint32_t number) {
    if (number >= symbols_in(table)) throw damaged();
    const ElfSymbol symbol = symbol_at(table, number);
    if (symbol.section == SHN_ABS) return symbol.value;
    if (const auto place = common_.find(number); place != common_.end()) return place->second;
    if (is_placed(symbol.section)) return section(symbol.section).place + symbol.value;
    if (symbol.binding == STB_WEAK) return 0;
    const auto [known, is_new] = missing_.try_emplace(number, 0);
    if (is_new) {
      if (image_.missing.size() == max_missing) throw damaged();
      known->second = first_missing + Symbol::reach +
                      static_cast<std::uint32_t>(image_.missing.size()) * bytes_of_missing;
      image_.missing.push_back({text_at(section(table.link), symbol.name), known->second});
    }
    return known->second;
  }

  /// All 16-bit addresses have memory, so no fault tells that a name is missing.
  void expect_present(const Section& table, std::uint32_t number) {
    if (!missing_.contains(number)) return;
    const std::string name = text_at(section(table.link), symbol_at(table, number).name);
    throw UsageError(
        fmt::format("the code uses {}, which the object does not have", support::quoted(name)));
  }

  [[nodiscard]] std::uint32_t entry_for(std::uint32_t value) {
    store(image_.memory.data() + next_entry_, value, static_cast<int>(entry_bytes()));
    next_entry_ += entry_bytes();
    return next_entry_ - entry_bytes();
  }

  /// Returns what a relocation adds to the bytes at `place`.
  [[nodiscard]] std::uint32_t addend_of(const Relocation& one, const Section& symbols,
                                        std::uint32_t place) {
    const std::uint32_t type = one.type;
    if (type == R_386_GOTPC) return offset_table_ - place;
    const std::uint32_t value = value_of(symbols, one.symbol);
    switch (type) {
      case R_386_16:
      case R_386_PC16:
        expect_present(symbols, one.symbol);
        return type == R_386_16 ? value : value - place;
      case R_386_32:
        return value;
      case R_386_PC32:
      case R_386_PLT32:
        return value - place;
      case R_386_GOTOFF:
        return value - offset_table_;
      case R_386_GOT32:
      case R_386_GOT32X: {
        // Without a base register, the ModR/M byte before the place asks for an absolute address.
        const bool is_absolute = (image_.memory[place - 1] & 0xC7U) == 5;
        return entry_for(value) - (is_absolute ? 0 : offset_table_);
      }
      default:
        throw UsageError(fmt::format(
            "the object has a relocation of type {}; compile with -fno-pic -fno-pie", type));
    }
  }

  /// The same for x86-64, whose addresses here have less than 32 bits.
  [[nodiscard]] std::uint32_t addend_of_64_bits(const Relocation& one, const Section& symbols,
                                                std::uint32_t place) {
    const std::uint32_t value = value_of(symbols, one.symbol);
    switch (one.type) {
      case R_X86_64_64:
      case R_X86_64_32:
      case R_X86_64_32S:
        return value;
      case R_X86_64_PC32:
      case R_X86_64_PLT32:
      case R_X86_64_PC64:
        return value - place;
      case R_X86_64_GOTPCREL:
      case R_X86_64_GOTPCRELX:
      case R_X86_64_REX_GOTPCRELX:
        return entry_for(value) - place;
      default:
        throw UsageError(fmt::format(
            "the object has a relocation of type {}; compile with -fno-pic -fno-pie", one.type));
    }
  }

  [[nodiscard]] std::uint32_t bytes_of(const Relocation& one) const {
    if (is_64_) return one.type == R_X86_64_64 || one.type == R_X86_64_PC64 ? 8 : 4;
    return one.type == R_386_16 || one.type == R_386_PC16 ? 2 : 4;
  }

  void relocate(const Section& list) {
    if (!is_placed(list.info)) return;  // debugging information
    const Section& to = section(list.info);
    for (std::uint64_t i = 0; i < relocations_in(list); ++i) {
      const Relocation one = relocation_at(list, i);
      const std::uint32_t size = bytes_of(one);
      if (one.offset > to.size || to.size - one.offset < size) throw damaged();
      const std::uint32_t place = to.place + static_cast<std::uint32_t>(one.offset);
      std::uint8_t* const bytes = image_.memory.data() + place;
      const Section& symbols = section(list.link);
      if (one.addend) {
        const std::uint32_t added = addend_of_64_bits(one, symbols, place);
        const auto sum = static_cast<std::int64_t>(static_cast<std::int32_t>(added)) + *one.addend;
        store(bytes, static_cast<std::uint64_t>(sum), static_cast<int>(size));
      } else {
        const std::uint32_t added = addend_of(one, symbols, place);
        store(bytes, std::uint64_t{fetch(bytes, static_cast<int>(size))} + added,
              static_cast<int>(size));
      }
    }
  }

  Image& image_;
  const std::string& bytes_;
  bool is_64_;
  std::vector<Section> sections_;
  std::size_t name_bytes_ = 0;
  std::map<std::uint32_t, std::uint32_t> missing_;  ///< the addresses of missing symbols
  std::map<std::uint64_t, std::uint32_t> common_;   ///< those of variables without a section
  std::uint32_t offset_table_ = 0;
  std::uint32_t next_entry_ = 0;  ///< the first free one of the table
};

}  // namespace

void load_elf(Image& image, const std::string& bytes) { Object(image, bytes).load(); }

std::optional<int> bits_of_elf(std::string_view bytes) {
  Elf32_Ehdr header{};  // in 64 bits, too, these members have their places
  if (bytes.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.e_ident[EI_DATA] != ELFDATA2LSB) return std::nullopt;
  if (header.e_ident[EI_CLASS] == ELFCLASS32 && header.e_machine == EM_386) return 32;
  if (header.e_ident[EI_CLASS] == ELFCLASS64 && header.e_machine == EM_X86_64) return 64;
  return std::nullopt;
}

}  // namespace fixproof::judge
