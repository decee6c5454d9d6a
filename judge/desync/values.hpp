/// @file
/// Records as operations with operands and results, and as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fixed/record/kinds.hpp"
#include "judge/desync/log_file.hpp"

namespace fixproof::desync {

/// An operand or a result. The upper 24 bits of `type` are its type, the lower 8 its class.
struct Value {
  std::uint32_t type = 0;
  word bits = 0;

  friend bool operator==(const Value&, const Value&) = default;
};

/// A record as an operation.
struct Operation {
  record::kind kind{};
  std::uint32_t type = 0;  ///< The number type whose operation it is.
  std::vector<Value> operands;
  std::vector<Value> results;
  bool threw = false;

  friend bool operator==(const Operation&, const Operation&) = default;
};

/// Returns the operation of a record, which must have a known kind and the right length.
Operation operation_of(const std::vector<word>& words);

/// Returns a value and its bits, such as `1.5 (00018000)`.
std::string text_of(const Value& value);
/// Returns the format, and the rules that differ from those of q16_16:
/// `u8_8, range saturate`.
std::string type_text(std::uint32_t type);
/// Returns an operation with its operands and results:
/// `a + b [q16_16]: 1.5 (00018000), 2 (00020000) -> 3.5 (00038000)`.
std::string text_of(const Operation& operation);

}  // namespace fixproof::desync
