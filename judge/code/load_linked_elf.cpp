#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "judge/code/bytes.hpp"
#include "judge/code/elf_file.hpp"
#include "judge/code/load.hpp"
#include "judge/code/mips_table.hpp"
#include "support/plain_text.hpp"

namespace fixproof::judge::elf {

namespace {

using support::UsageError;

constexpr std::uint32_t page = 0x1000;
/// Addresses have 32 bits, and the stack is above the code.
constexpr std::uint64_t most_address = 0xFFF00000;
/// The newest kind of a list of relocations, which <elf.h> of Debian 12 has, but others do not.
constexpr std::uint32_t packed_list = 19;

/// What a relocation of a linked file puts into its place.
enum class Put : std::uint8_t {
  nothing,
  entry,        ///< the symbol's address, in a table
  symbol,       ///< the symbol's address, and the addend
  distance,     ///< the same, less the place
  own_address,  ///< an address in the file that is known before loading
  chosen,       ///< the address of a function that the program chooses as it is loaded
  per_thread,   ///< where a variable of a thread is
  copied,       ///< a variable of a shared library is copied there
  unknown,
};

/// What a relocation of a processor other than x86 puts into its place. Its unknown ones are those
/// of functions that a program chooses as it starts, and of variables of threads.
Put put_of(std::uint32_t type, const Architecture& architecture) {
  const auto& [own_address, symbol, entry, call] = architecture.relocations;
  if (type == 0) return Put::nothing;
  if (type == own_address) return Put::own_address;
  if (type == symbol) return Put::symbol;
  return type == entry || type == call ? Put::entry : Put::unknown;
}

Put put_of(std::uint32_t type, bool is_64) {
  if (is_64) {
    switch (type) {
      case R_X86_64_NONE:
        return Put::nothing;
      case R_X86_64_64:
        return Put::symbol;
      case R_X86_64_GLOB_DAT:
      case R_X86_64_JUMP_SLOT:
        return Put::entry;
      case R_X86_64_RELATIVE:
        return Put::own_address;
      case R_X86_64_IRELATIVE:
        return Put::chosen;
      case R_X86_64_DTPMOD64:
      case R_X86_64_DTPOFF64:
      case R_X86_64_TPOFF64:
      case R_X86_64_TLSDESC:
        return Put::per_thread;
      case R_X86_64_COPY:
        return Put::copied;
      default:
        return Put::unknown;
    }
  }
  switch (type) {
    case R_386_NONE:
      return Put::nothing;
    case R_386_32:
      return Put::symbol;
    case R_386_GLOB_DAT:
    case R_386_JMP_SLOT:
      return Put::entry;
    case R_386_PC32:
      return Put::distance;
    case R_386_RELATIVE:
      return Put::own_address;
    case R_386_IRELATIVE:
      return Put::chosen;
    case R_386_TLS_DTPMOD32:
    case R_386_TLS_DTPOFF32:
    case R_386_TLS_TPOFF:
    case R_386_TLS_TPOFF32:
    case R_386_TLS_DESC:
      return Put::per_thread;
    case R_386_COPY:
      return Put::copied;
    default:
      return Put::unknown;
  }
}

/// All addresses here have 32 bits: those of a file are counted from its first page.
class Linked {
 public:
  Linked(Image& image, File& file) : image_(image), file_(file), segments_(file.segments()) {}

  void load() {
    if (image_.bits == 16) {
      throw UsageError("--bits 16: a linked ELF file has 32-bit code; leave --bits out");
    }
    if (file_.sections().empty()) {
      throw UsageError(
          "the ELF file has no section headers, which tell its relocations; link it "
          "again and keep them");
    }
    file_.expect_sound_tables();
    place();
    read_symbols();
    for (const Section& list : file_.sections()) {
      // Lists for a later link are not in memory.
      if ((list.flags & SHF_ALLOC) == 0) continue;
      if (file_.is_unused_list(list)) throw file_.unused_list();
      if (list.type == packed_list) {
        throw UsageError(
            "the ELF file has packed relocations; link it without "
            "-z pack-relative-relocs");
      }
      if (file_.is_list(list)) relocate(list);
    }
    if (is_other() && image_.architecture->machine == EM_MIPS) relocate_mips_table();
  }

 private:
  [[nodiscard]] bool is_other() const { return image_.architecture != nullptr; }
  [[nodiscard]] bool has_data_apart() const {
    return is_other() && image_.architecture->data.first != 0;
  }

  /// Expects segments in order and apart, so that their bytes add up to no more than there is room
  /// for.
  void expect_order() const {
    std::uint64_t end = 0;
    for (const Segment& s : segments_) {
      if (s.address < end || s.memory_bytes > ~s.address || s.file_bytes > s.memory_bytes ||
          s.offset > file_.bytes().size() || file_.bytes().size() - s.offset < s.file_bytes) {
        throw damaged();
      }
      end = s.address + s.memory_bytes;
    }
  }

  /// Takes the segments from `segments_` that are far from the first: the RAM of a microcontroller.
  void place_far_segments(std::uint64_t first) {
    constexpr std::uint64_t all_addresses = std::uint64_t{1} << 32U;
    std::size_t bytes = 0;
    while (segments_.back().address - first > max_code_bytes) {
      const Segment s = segments_.back();
      segments_.pop_back();
      const bool shares_page =
          !has_data_apart() && !image_.regions.empty() &&
          image_.regions.back().address / page <= (s.address + s.memory_bytes - 1) / page;
      if (shares_page)
        throw UsageError(
            "two parts of the ELF file share a page of memory; give "
            "the object of the routine from before linking");
      bytes += s.memory_bytes;
      if (bytes > max_code_bytes || s.address + s.memory_bytes > all_addresses) {
        throw UsageError(
            "the ELF file has more than 1 MiB of data far from its code, or above "
            "4 GiB; give the object of the routine from before linking");
      }
      Region region{.address = static_cast<std::uint32_t>(s.address), .bytes = {}};
      region.bytes.assign(s.memory_bytes, 0);
      std::copy_n(file_.bytes().begin() + static_cast<std::ptrdiff_t>(s.offset), s.file_bytes,
                  region.bytes.begin());
      image_.regions.push_back(std::move(region));
    }
  }

  void place() {
    std::erase_if(segments_, [](const Segment& s) { return s.memory_bytes == 0; });
    if (segments_.empty()) throw UsageError("the ELF file has no code");
    if (is_other()) std::ranges::stable_sort(segments_, {}, &Segment::address);
    expect_order();
    const std::uint64_t first = segments_.front().address / page * page;
    if (is_other() && file_.kind() == ET_EXEC) place_far_segments(first);
    const std::uint64_t end = segments_.back().address + segments_.back().memory_bytes;
    if (end - first > max_code_bytes) {
      throw UsageError(fmt::format(
          "the ELF file has {} KiB of code and data, and there is room for less than 1 MiB; give "
          "the object of the routine from before linking",
          (end - first + 1023) / 1024));
    }
    if (file_.kind() == ET_EXEC && !has_data_apart()) {
      const std::uint64_t most = is_other() ? most_address : first_missing;
      if (first > most - max_code_bytes) {
        throw UsageError(
            fmt::format("the ELF file is linked for {:x}h, and programs have room up "
                        "to {:x}h; link it with -static-pie",
                        first, most));
      }
      image_.base = static_cast<std::uint32_t>(first);
    }
    const auto origin = file_.kind() == ET_EXEC ? static_cast<std::uint32_t>(first) : load_address;
    shift_ = origin - static_cast<std::uint32_t>(first);
    std::string flat(end - first, '\0');
    for (const Segment& s : segments_) {
      flat.replace(s.address - first, s.file_bytes, file_.bytes(), s.offset, s.file_bytes);
    }
    image_.container = linked_container;
    load_flat(image_, flat, origin);
    if (has_data_apart()) place_data_apart();
  }

  /// Puts variables into the memory for data. What the file has beyond it, such as fuses, is none.
  void place_data_apart() {
    const std::uint32_t first = image_.architecture->data.first;
    const std::uint32_t room = image_.stack_top - stack_bytes;
    std::erase_if(image_.regions,
                  [&](const Region& r) { return r.address >= first + DataSpace::bytes; });
    for (const Region& region : image_.regions) {
      if (region.address < first || region.address > room ||
          region.bytes.size() > room - region.address) {
        throw UsageError(
            fmt::format("the variables at {:x}h to {:x}h are outside the memory for data, {:x}h to "
                        "{:x}h",
                        region.address, region.address + region.bytes.size(), first, room));
      }
      std::ranges::copy(region.bytes, image_.memory.begin() + image_.index_of(region.address));
    }
  }

  [[nodiscard]] std::uint32_t placed(std::uint64_t address) const {
    return static_cast<std::uint32_t>(address) + shift_;
  }

  [[nodiscard]] bool is_code(std::uint32_t place) const {
    const auto has = [&](const Segment& s) {
      return (s.flags & PF_X) != 0 && place - placed(s.address) < s.memory_bytes;
    };
    return std::ranges::any_of(segments_, has);
  }

  void read_symbols() {
    const auto table_of = [this](std::uint32_t type) {
      return std::ranges::find(file_.sections(), type, &Section::type);
    };
    auto table = table_of(SHT_SYMTAB);
    if (table == file_.sections().end()) table = table_of(SHT_DYNSYM);
    if (table == file_.sections().end()) return;
    for (std::uint64_t i = 0; i < file_.symbols_in(*table); ++i) {
      const Symbol symbol = file_.symbol_at(*table, i);
      if (symbol.section == SHN_UNDEF || symbol.name == 0) continue;
      if (is_other() && symbol.type != STT_FUNC) note_base(*table, symbol);
      if (symbol.section == SHN_ABS) continue;
      const std::uint32_t place = placed(symbol.value);
      if (symbol.type == STT_GNU_IFUNC) {
        choosers_.try_emplace(place, file_.name_of(*table, symbol));
        continue;
      }
      const bool is_local = symbol.binding == STB_LOCAL;
      if (symbol.type == STT_TLS || symbol.type == STT_OBJECT || !is_code(place)) continue;
      if (is_local && symbol.type != STT_FUNC) continue;
      std::string name = file_.name_of(*table, symbol);
      if (!is_routine(name)) continue;
      (is_local ? image_.hidden : image_.symbols).push_back({std::move(name), place});
    }
  }

  /// Keeps the value of a symbol that a register of the processor points to.
  void note_base(const Section& table, const Symbol& symbol) {
    for (const BaseRegister& base : image_.architecture->bases) {
      if (base.name.empty() || file_.name_of(table, symbol) != base.symbol) continue;
      image_.bases.push_back({std::string(base.name), placed(symbol.value)});
    }
  }

  /// Returns the address of a symbol. Its use faults if the file lacks it.
  [[nodiscard]] std::uint32_t value_of(const Section& table, std::uint32_t number) {
    const Symbol symbol = file_.symbol_at(table, number);
    const bool is_undefined = symbol.section == SHN_UNDEF;
    if (is_undefined && symbol.binding == STB_WEAK) return 0;
    if (is_undefined || symbol.type == STT_GNU_IFUNC) {
      return missing_.address_of(number, [&] { return file_.name_of(table, symbol); });
    }
    return symbol.section == SHN_ABS ? symbol.value : placed(symbol.value);
  }

  /// Returns an address for a function that is known only while the program runs.
  std::uint32_t chosen_by(std::uint32_t chooser) {
    return missing_.address_of(std::uint64_t{1} << 32U | chooser, [&] {
      const auto known = choosers_.find(chooser);
      return known != choosers_.end() ? known->second
                                      : fmt::format("the function that {:x}h chooses", chooser);
    });
  }

  std::uint32_t variable_of_thread(const Section& list, std::uint32_t number) {
    return missing_.address_of(std::uint64_t{2} << 32U | number, [&]() -> std::string {
      if (number == 0) return "a variable of a thread";
      const Section& table = file_.section(list.link);
      return file_.name_of(table, file_.symbol_at(table, number));
    });
  }

  void relocate_mips_table() {
    const auto table = mips_table(file_, image_.is_big_endian());
    if (!table) return;
    const auto symbols = std::ranges::find(file_.sections(), SHT_DYNSYM, &Section::type);
    const std::uint32_t first = placed(table->address);
    if (symbols == file_.sections().end() || first < image_.first || first > image_.end ||
        (image_.end - first) / 4 < table->entries()) {
      throw damaged();
    }
    for (std::uint32_t i = 0; i < table->entries(); ++i) {
      std::uint8_t* const entry = image_.memory.data() + image_.index_of(first + 4 * i);
      const auto known = static_cast<std::uint32_t>(fetch(entry, 4, image_.is_big_endian()));
      const bool is_own = i < table->own;
      // The first entries are those of the loader.
      if (i == 0 || (i == 1 && known >> 31U != 0)) continue;
      store(entry,
            is_own ? placed(known) : value_of(*symbols, table->first_symbol + i - table->own), 4,
            image_.is_big_endian());
    }
  }

  void relocate(const Section& list) {
    for (std::uint64_t i = 0; i < file_.relocations_in(list); ++i) {
      relocate(list, file_.relocation_at(list, i));
    }
  }

  void relocate(const Section& list, const Relocation& one) {
    Put put = is_other() ? put_of(one.type, *image_.architecture) : put_of(one.type, file_.is_64());
    // MIPS has one type for both.
    if (is_other() && put == Put::own_address && one.symbol != 0) put = Put::symbol;
    if (put == Put::nothing) return;
    const auto symbols = [&]() -> const Section& { return file_.section(list.link); };
    if (put == Put::copied) {
      throw UsageError(fmt::format(
          "the ELF file has the variable {} from a shared library; link it with -static-pie",
          support::quoted(file_.name_of(symbols(), file_.symbol_at(symbols(), one.symbol)))));
    }
    if (put == Put::unknown && (!is_other() || file_.kind() == ET_DYN)) {
      throw UsageError(
          fmt::format("the ELF file has a relocation of type {}; give the object of "
                      "the routine from before linking",
                      one.type));
    }
    const bool is_big = image_.is_big_endian();
    const int size = file_.is_64() ? 8 : 4;
    if (put == Put::unknown) return;
    const std::uint32_t place = placed(one.offset);
    if (place < image_.first || place > image_.end ||
        image_.end - place < static_cast<unsigned>(size)) {
      throw damaged();
    }
    std::uint8_t* const bytes = image_.memory.data() + image_.index_of(place);
    const std::int64_t addend =
        one.addend ? *one.addend : static_cast<std::int32_t>(fetch(bytes, 4, is_big));
    const auto put_address = [&](std::uint32_t address) { store(bytes, address, size, is_big); };
    switch (put) {
      case Put::own_address:
        return put_address(placed(static_cast<std::uint64_t>(addend)));
      case Put::chosen:
        return put_address(chosen_by(placed(static_cast<std::uint64_t>(addend))));
      case Put::per_thread:
        return put_address(variable_of_thread(list, one.symbol));
      case Put::entry:
        return put_address(value_of(symbols(), one.symbol));
      default:
        break;
    }
    const std::uint32_t value = one.symbol == 0 ? 0 : value_of(symbols(), one.symbol);
    const std::int64_t sum = value + addend - (put == Put::distance ? std::int64_t{place} : 0);
    store(bytes, static_cast<std::uint64_t>(sum), size, is_big);
  }

  Image& image_;
  File& file_;
  std::vector<Segment> segments_;  ///< those that are near the first
  MissingNames missing_{image_};
  std::uint32_t shift_ = 0;                        ///< from the file's addresses to those here
  std::map<std::uint32_t, std::string> choosers_;  ///< of functions, by their address
};

}  // namespace

void load_linked(Image& image, File& file) { Linked(image, file).load(); }

}  // namespace fixproof::judge::elf
