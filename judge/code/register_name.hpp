/// @file
/// The general registers of 16-, 32- and 64-bit code and their parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "x86model/instruction.hpp"

namespace fixproof::judge {

/// The registers of 64-bit code; other code has the first eight.
inline constexpr std::size_t register_count = 16;

/// A register or a part of one. Numbers are those of instructions: 8 to 15 are R8 to R15. Of a
/// byte, 4 to 7 are AH, CH, DH and BH, and `low_bytes` more are SPL, BPL, SIL and DIL.
struct RegisterName {
  x86model::Register number = x86model::Register::ax;
  x86model::Size size = x86model::Size::word;

  static constexpr unsigned low_bytes = 16;

  /// The register that it is a part of: 0 to 15.
  [[nodiscard]] constexpr std::size_t holder() const {
    const auto n = static_cast<std::size_t>(number);
    return is_high_byte() ? n - 4 : n % low_bytes;
  }
  /// Its lowest bit in that register.
  [[nodiscard]] constexpr int shift() const { return is_high_byte() ? 8 : 0; }
  [[nodiscard]] constexpr bool is_high_byte() const {
    const auto n = static_cast<unsigned>(number);
    return size == x86model::Size::byte && n >= 4 && n < 8;
  }
  /// Whether code of 16 and 32 bits has it.
  [[nodiscard]] constexpr bool is_legacy() const {
    return static_cast<unsigned>(number) < x86model::register_count &&
           size != x86model::Size::qword;
  }

  friend bool operator==(const RegisterName&, const RegisterName&) = default;
};

/// Returns the register of a number as code of that width has it whole.
constexpr RegisterName whole_register(std::size_t number, int code_bits) {
  const auto size = code_bits == 16   ? x86model::Size::word
                    : code_bits == 32 ? x86model::Size::dword
                                      : x86model::Size::qword;
  return {static_cast<x86model::Register>(number), size};
}

constexpr int bits_of(x86model::Size size) {
  return size == x86model::Size::byte    ? 8
         : size == x86model::Size::word  ? 16
         : size == x86model::Size::dword ? 32
                                         : 64;
}
constexpr int bits_of(const RegisterName& name) { return bits_of(name.size); }

std::string name_of(const RegisterName& name);
/// Returns the register of a name in lower case, or nothing for any other text.
std::optional<RegisterName> register_named(std::string_view text);

}  // namespace fixproof::judge
