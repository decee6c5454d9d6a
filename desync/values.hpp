/// @file
/// Records as operations with operands and results, and as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "desync/log_file.hpp"
#include "record/kinds.hpp"

namespace fixproof::desync {

/// An operand or a result: its type in the upper 24 bits of `type`, its class in the lower 8.
struct Value {
  std::uint32_t type = 0;
  word bits = 0;

  friend bool operator==(const Value&, const Value&) = default;
};

/// What a record says.
struct Operation {
  record::kind kind{};
  std::uint32_t type = 0;  ///< Of the number whose operation it is.
  std::vector<Value> operands;
  std::vector<Value> results;
  bool threw = false;

  friend bool operator==(const Operation&, const Operation&) = default;
};

/// Reads the words of a record of a known kind and of the right length.
Operation operation_of(const std::vector<word>& words);

/// The value and its bits: `1.5 (00018000)`.
std::string text_of(const Value& value);
/// The format and the rules that are not those of q16_16: `q16_16`, `u8_8 saturating`.
std::string type_text(std::uint32_t type);
/// The operation with its operands and results: `a + b: 1.5 (00018000), 2 (00020000) -> ...`.
std::string text_of(const Operation& operation);

}  // namespace fixproof::desync
