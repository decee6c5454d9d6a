/// @file
/// The processors other than x86 that emulators run, as data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fixproof::judge {

/// What a caller leaves in a register or on the stack above a number that is narrower.
enum class Above : std::uint8_t {
  noise,            ///< anything
  extension,        ///< the extension of the number, by its sign
  extension_of_32,  ///< the same up to 32 bits, then that of a signed number of 32 bits
};

/// Registers whose numbers follow each other in Unicorn.
struct RegisterRun {
  std::string_view names{};  ///< separated by spaces
  int first = 0;             ///< Unicorn's number of the first
};

/// A register that code expects to have the value of a symbol, if the file has the symbol.
struct BaseRegister {
  std::string_view name{};
  std::string_view symbol{};
};

/// A control register, and the bits of it that a system sets for its programs.
struct Setting {
  int number = -1;  ///< Unicorn's
  std::uint64_t bits = 0;
};

/// Code that runs once before all calls, for a control register that Unicorn has no number for.
struct FirstCode {
  std::string_view code{};  ///< its bytes
  std::string_view base{};  ///< a register that points to the value
  std::uint64_t value = 0;
};

/// Registers that are no operands, such as those of flags and of floating point, which a caller
/// leaves as they happen to be.
struct Scratch {
  int first = 0;  ///< Unicorn's number of the first
  int count = 0;
  std::uint64_t bits = ~std::uint64_t{0};  ///< those that may be anything
};

/// Instructions that have the same bits in some places.
struct Pattern {
  std::uint64_t mask = 0;  ///< of the first eight bytes, the first byte in the lowest place
  std::uint64_t bits = 0;
};

/// How a call leaves the return address on the stack.
struct PushedReturn {
  std::uint32_t above = 0;  ///< bytes from the stack pointer to it
  int bytes = 4;            ///< the highest first
  std::uint32_t unit = 1;   ///< bytes of code that it counts as one
};

/// Memory for data with addresses of its own, as the linker numbers it.
struct DataSpace {
  std::uint32_t first = 0;      ///< 0 if code and data share their addresses
  std::uint32_t variables = 0;  ///< where a program's variables begin
  std::uint32_t code_end = 0;   ///< after the code that return addresses reach

  static constexpr std::uint32_t bytes = 0x10000;
};

/// A kind of processor and its C calling convention. Names of registers are separated by spaces.
struct Architecture {
  std::string_view name;  ///< as messages have it
  // The file.
  unsigned machine;  ///< e_machine of ELF
  bool is_64;
  bool is_big_endian;
  /// What the bits `kind_bits` of e_flags may be; any value if there are no such bits.
  std::array<unsigned, 8> kinds{};
  unsigned kind_bits = 0;
  int word_bits;  ///< of a register
  int pointer_bits;
  DataSpace data{};
  // The emulator.
  bool is_on_simavr = false;  ///< rather than on Unicorn
  int emulator = 0;           ///< uc_arch
  int mode = 0;               ///< uc_mode
  int model = -1;             ///< the processor's number in Unicorn; -1 for its default
  std::array<RegisterRun, 4> runs;
  int program_counter = 0;
  std::uint32_t beyond_stop = 0;  ///< bytes from where a run stops to the program counter after it
  std::array<Setting, 2> settings{};
  FirstCode first_code{};
  std::array<Scratch, 4> scratch{};
  /// Exceptions by their numbers in Unicorn; -1 if there are none.
  std::array<int, 2> divide_errors{-1, -1};
  std::array<int, 2> system_calls{-1, -1};
  std::array<int, 2> bad_instructions{-1, -1};
  /// Instructions that divide, where a bad instruction has the same exception.
  std::array<Pattern, 8> divides{};
  bool has_marked_entries = false;  ///< bit 0 of an address says that Thumb code is there
  // The convention.
  std::string_view stack_pointer;
  std::string_view link{};        ///< receives the return address; empty if it is pushed
  std::uint32_t behind_link = 0;  ///< bytes from what is in `link` to where a call returns
  PushedReturn pushed{};
  std::string_view callee{};     ///< holds the address of the function that is called
  std::string_view arguments{};  ///< in their order
  std::string_view results;      ///< in the order of arguments, for one number
  std::string_view kept;         ///< preserved by a call, as is the stack pointer
  std::array<BaseRegister, 2> bases{};
  Above above = Above::extension;
  std::string_view zero{};      ///< is 0 whenever a function begins or ends
  bool has_even_pairs = false;  ///< a number of two registers begins in one with an even place
  /// Numbers take an even count of registers, the highest byte in the first.
  bool has_falling_numbers = false;
  std::uint32_t first_on_stack = 0;  ///< bytes from the stack pointer to the first argument there
  // The toolchains of Debian whose linker and libgcc fit, and the package of the first.
  std::array<std::string_view, 3> toolchains{};
  std::string_view package;
  bool has_library = true;       ///< whether the package has a libgcc for it
  std::string_view linked_as{};  ///< the linker's emulation if its default is another one, without
                                 ///< a number of `kinds`
  /// Relocations of a shared library: an address in the file; a symbol with an addend; a symbol.
  std::array<std::uint32_t, 4> relocations{};
};

/// The registers of a processor, numbered as in its runs.
struct RegisterFile {
  std::vector<std::string> names{};
  std::vector<int> numbers{};  ///< Unicorn's

  explicit RegisterFile(const Architecture& architecture);
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  /// @param names of registers that exist
  [[nodiscard]] std::vector<std::size_t> all(std::string_view names) const;
};

/// Returns the processor of an ELF file, or null if it is x86 or none of the table.
const Architecture* architecture_of_elf(std::string_view bytes);
/// Returns the bits `kind_bits` of e_flags of an ELF file of a processor.
unsigned kind_of_elf(const Architecture& architecture, std::string_view bytes);
/// Returns the name of what runs a processor's code, such as "Unicorn".
std::string_view emulator_of(const Architecture* architecture);
/// Returns the names of all processors, such as "ARM, AArch64"; empty without Unicorn.
std::string names_of_architectures();

}  // namespace fixproof::judge
