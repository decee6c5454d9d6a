#include <elf.h>
#include <fmt/format.h>

#include <cstring>
#include <map>

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
constexpr std::uint32_t first_missing = 0x80000000;
constexpr std::uint32_t bytes_of_missing = 2 * Symbol::reach;
constexpr std::size_t max_missing = first_missing / bytes_of_missing;

/// GCC's function for position-independent code. No user asks for it.
bool is_thunk(const std::string& name) { return name.starts_with("__x86.get_pc_thunk."); }

class Object {
 public:
  Object(Image& image, const std::string& bytes) : image_(image), bytes_(bytes) {}

  void load() {
    const auto header = at<Elf32_Ehdr>(0);  // in 64 bits, too, the type has this place
    if (header.e_type == ET_DYN) {
      throw UsageError(
          "the ELF file is linked; give the object from before linking, or call a function of a "
          "shared library with eval --by FILE:FUNCTION (docs/judge.md)");
    }
    if (header.e_ident[EI_CLASS] != ELFCLASS32 || header.e_ident[EI_DATA] != ELFDATA2LSB ||
        header.e_machine != EM_386) {
      throw UsageError("the ELF file is not i386 code; compile with -m32, assemble with -f elf32");
    }
    if (header.e_type != ET_REL) {
      throw UsageError("the ELF file is linked; give the object from before linking");
    }
    if (header.e_shentsize != sizeof(Elf32_Shdr)) throw damaged();
    for (std::uint32_t i = 0; i < header.e_shnum; ++i) {
      sections_.push_back(at<Elf32_Shdr>(header.e_shoff + std::uint64_t{i} * sizeof(Elf32_Shdr)));
    }
    expect_sound_tables();
    place();
    read_symbols();
    for (const Elf32_Shdr& section : sections_) {
      if (section.sh_type == SHT_REL) relocate(section);
      if (section.sh_type == SHT_RELA && is_placed(section.sh_info)) {
        throw UsageError("the ELF file has relocations with addends, which i386 code does not use");
      }
    }
  }

 private:
  static UsageError damaged() { return UsageError{"the ELF file is damaged"}; }

  template <class T>
  [[nodiscard]] T at(std::uint64_t offset) const {
    T value{};
    if (offset > bytes_.size() || bytes_.size() - offset < sizeof value) throw damaged();
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return value;
  }

  [[nodiscard]] std::string text_at(const Elf32_Shdr& strings, std::uint32_t offset) {
    std::string text;
    for (std::uint64_t i = std::uint64_t{strings.sh_offset} + offset;; ++i) {
      const char c = at<char>(i);
      if (c == '\0') return text;
      if (name_bytes_++ == max_name_bytes) {
        throw UsageError("the names in the ELF file have more than 4 MiB");
      }
      text += c;
    }
  }

  [[nodiscard]] bool is_placed(std::uint32_t section) const {
    return section < sections_.size() && (sections_[section].sh_flags & SHF_ALLOC) != 0;
  }

  /// Appends zeros to the code and data, and returns where they start.
  static std::uint32_t reserve(std::string& flat, std::uint32_t alignment, std::uint32_t size) {
    if (alignment > 0x1000) throw damaged();
    if (std::uint64_t{flat.size()} + alignment + size > max_code_bytes) {
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
    for (Elf32_Shdr& section : sections_) {
      if ((section.sh_flags & SHF_ALLOC) == 0) continue;
      const std::uint32_t start = reserve(flat, section.sh_addralign, section.sh_size);
      section.sh_addr = load_address + start;
      if (section.sh_type == SHT_NOBITS) continue;
      if (section.sh_offset > bytes_.size() ||
          bytes_.size() - section.sh_offset < section.sh_size) {
        throw damaged();
      }
      flat.replace(start, section.sh_size, bytes_, section.sh_offset, section.sh_size);
    }
    if (flat.empty()) throw UsageError("the ELF file has no code");
    place_common_symbols(flat);
    place_offset_table(flat);
    image_.container = "ELF object";
    load_flat(image_, flat, load_address);
  }

  /// Places variables without a section, which older compilers make of `int counter;` in C.
  void place_common_symbols(std::string& flat) {
    for (const Elf32_Shdr& table : sections_) {
      if (table.sh_type != SHT_SYMTAB) continue;
      for (std::uint32_t i = 0; i < table.sh_size / sizeof(Elf32_Sym); ++i) {
        const auto symbol = at<Elf32_Sym>(table.sh_offset + i * sizeof(Elf32_Sym));
        if (symbol.st_shndx != SHN_COMMON) continue;
        common_[i] = load_address + reserve(flat, symbol.st_value, symbol.st_size);
      }
    }
  }

  /// Places the global offset table of position-independent code. Each relocation that needs an
  /// entry gets one of its own.
  void place_offset_table(std::string& flat) {
    flat.resize((flat.size() + 3) / 4 * 4);
    offset_table_ = next_entry_ = load_address + static_cast<std::uint32_t>(flat.size());
    for (const Elf32_Shdr& list : sections_) {
      if (list.sh_type != SHT_REL || !is_placed(list.sh_info)) continue;
      for (std::uint32_t i = 0; i < list.sh_size / sizeof(Elf32_Rel); ++i) {
        const auto one = at<Elf32_Rel>(list.sh_offset + i * sizeof(Elf32_Rel));
        const std::uint32_t type = ELF32_R_TYPE(one.r_info);
        if (type == R_386_GOT32 || type == R_386_GOT32X) flat.append(4, '\0');
      }
    }
  }

  /// One table of symbols, and relocations that do not share bytes: otherwise a small file could
  /// ask for any amount of work.
  void expect_sound_tables() const {
    std::uint64_t symbol_tables = 0;
    std::uint64_t relocation_bytes = 0;
    for (const Elf32_Shdr& table : sections_) {
      if (table.sh_type == SHT_SYMTAB) ++symbol_tables;
      if (table.sh_type == SHT_REL) relocation_bytes += table.sh_size;
    }
    if (symbol_tables > 1 || relocation_bytes > bytes_.size()) throw damaged();
  }

  [[nodiscard]] const Elf32_Shdr& section(std::uint32_t number) const {
    if (number >= sections_.size()) throw damaged();
    return sections_[number];
  }

  void read_symbols() {
    for (const Elf32_Shdr& table : sections_) {
      if (table.sh_type != SHT_SYMTAB) continue;
      for (std::uint32_t i = 0; i < table.sh_size / sizeof(Elf32_Sym); ++i) {
        const auto symbol = at<Elf32_Sym>(table.sh_offset + i * sizeof(Elf32_Sym));
        const bool is_code =
            is_placed(symbol.st_shndx) && (section(symbol.st_shndx).sh_flags & SHF_EXECINSTR) != 0;
        const auto binding = ELF32_ST_BIND(symbol.st_info);
        if (!is_code || symbol.st_name == 0 || binding == STB_LOCAL) continue;
        std::string name = text_at(section(table.sh_link), symbol.st_name);
        if (is_thunk(name)) continue;
        image_.symbols.push_back(
            {std::move(name), section(symbol.st_shndx).sh_addr + symbol.st_value});
      }
    }
  }

  [[nodiscard]] std::uint32_t value_of(const Elf32_Shdr& table, std::uint32_t number) {
    if (number >= table.sh_size / sizeof(Elf32_Sym)) throw damaged();
    const auto symbol = at<Elf32_Sym>(table.sh_offset + number * sizeof(Elf32_Sym));
    if (symbol.st_shndx == SHN_ABS) return symbol.st_value;
    if (const auto place = common_.find(number); place != common_.end()) return place->second;
    if (is_placed(symbol.st_shndx)) return section(symbol.st_shndx).sh_addr + symbol.st_value;
    if (ELF32_ST_BIND(symbol.st_info) == STB_WEAK) return 0;
    const auto [known, is_new] = missing_.try_emplace(number, 0);
    if (is_new) {
      if (image_.missing.size() == max_missing) throw damaged();
      known->second = first_missing + Symbol::reach +
                      static_cast<std::uint32_t>(image_.missing.size()) * bytes_of_missing;
      image_.missing.push_back({text_at(section(table.sh_link), symbol.st_name), known->second});
    }
    return known->second;
  }

  /// All 16-bit addresses have memory, so no fault tells that a name is missing.
  void expect_present(const Elf32_Shdr& table, std::uint32_t number) {
    if (!missing_.contains(number)) return;
    const auto symbol = at<Elf32_Sym>(table.sh_offset + number * sizeof(Elf32_Sym));
    throw UsageError(fmt::format("the code uses {}, which the object does not have",
                                 support::quoted(text_at(section(table.sh_link), symbol.st_name))));
  }

  [[nodiscard]] std::uint32_t entry_for(std::uint32_t value) {
    store(image_.memory.data() + next_entry_, value, 4);
    next_entry_ += 4;
    return next_entry_ - 4;
  }

  /// Returns what a relocation adds to the bytes at `place`.
  [[nodiscard]] std::uint32_t addend_of(const Elf32_Rel& one, const Elf32_Shdr& symbols,
                                        std::uint32_t place) {
    const std::uint32_t type = ELF32_R_TYPE(one.r_info);
    if (type == R_386_GOTPC) return offset_table_ - place;
    const std::uint32_t value = value_of(symbols, ELF32_R_SYM(one.r_info));
    switch (type) {
      case R_386_16:
      case R_386_PC16:
        expect_present(symbols, ELF32_R_SYM(one.r_info));
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

  void relocate(const Elf32_Shdr& list) {
    if (!is_placed(list.sh_info)) return;  // debugging information
    const Elf32_Shdr& to = section(list.sh_info);
    for (std::uint32_t i = 0; i < list.sh_size / sizeof(Elf32_Rel); ++i) {
      const auto one = at<Elf32_Rel>(list.sh_offset + i * sizeof(Elf32_Rel));
      const std::uint32_t type = ELF32_R_TYPE(one.r_info);
      const std::uint32_t size = type == R_386_16 || type == R_386_PC16 ? 2 : 4;
      if (one.r_offset > to.sh_size || to.sh_size - one.r_offset < size) throw damaged();
      const std::uint32_t place = to.sh_addr + one.r_offset;
      std::uint8_t* const bytes = image_.memory.data() + place;
      const std::uint32_t addend = addend_of(one, section(list.sh_link), place);
      store(bytes, fetch(bytes, static_cast<int>(size)) + addend, static_cast<int>(size));
    }
  }

  Image& image_;
  const std::string& bytes_;
  std::vector<Elf32_Shdr> sections_;
  std::size_t name_bytes_ = 0;
  std::map<std::uint32_t, std::uint32_t> missing_;  ///< the addresses of missing symbols
  std::map<std::uint32_t, std::uint32_t> common_;   ///< those of variables without a section
  std::uint32_t offset_table_ = 0;
  std::uint32_t next_entry_ = 0;  ///< the first free one of the table
};

}  // namespace

void load_elf(Image& image, const std::string& bytes) { Object(image, bytes).load(); }

}  // namespace fixproof::judge
