#include "judge/desync/values.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "fixed/record/layout.hpp"

namespace fixproof::desync {

namespace {

using record::value_class;

std::size_t bits_of(std::uint32_t type) {
  return std::size_t{8} << (type >> record::tag_size_shift & 3);
}

int fraction_of(std::uint32_t type) {
  return static_cast<int>(type >> record::tag_fraction_shift & 0x7f);
}

bool is_unsigned(std::uint32_t type) { return (type & record::tag_is_unsigned) != 0; }

/// Returns half a word of a short record, extended by its sign.
word extended(word low, std::uint32_t type) {
  const auto half = static_cast<std::uint32_t>(low);
  if (is_unsigned(type)) return half;
  return static_cast<word>(std::int64_t{static_cast<std::int32_t>(half)});
}

constexpr std::uint32_t integer_type =
    3 << record::tag_size_shift | static_cast<std::uint32_t>(value_class::integer);

Operation short_operation(const std::vector<word>& words, Operation operation) {
  word a = words[1];
  word b = 0;
  word result = 0;
  if (words.size() == 4) {
    b = words[2];
    result = words[3];
  } else {
    b = extended(a >> 32, record::has_integer(operation.kind) ? 0 : operation.type);
    a = extended(a, operation.type);
    result = extended(words[0] >> 32, operation.type);
  }
  const std::size_t operands = record::short_operands(operation.kind);
  if (operands > 0) operation.operands.push_back({operation.type, a});
  if (operands > 1) {
    operation.operands.push_back(
        {record::has_integer(operation.kind) ? integer_type : operation.type, b});
  }
  operation.results.push_back({operation.type, result});
  return operation;
}

}  // namespace

Operation operation_of(const std::vector<word>& words) {
  Operation operation;
  const word first = words[0];
  operation.kind = record::kind_of(first);
  operation.type = static_cast<std::uint32_t>(first) & ~std::uint32_t{0xff};
  if (!record::is_operation(operation.kind)) {
    operation.operands.push_back({integer_type, words[1]});
    return operation;
  }
  if ((first & record::tag_is_long) == 0) return short_operation(words, operation);
  const std::size_t operands = first >> record::long_operands_shift & 0xff;
  const std::size_t results = first >> record::long_results_shift & 0xff;
  const std::size_t values = 1 + (operands + results + 1) / 2;
  operation.threw = (first & record::long_threw) != 0;
  for (std::size_t i = 0; i < operands + results; ++i) {
    const auto type = static_cast<std::uint32_t>(words[1 + i / 2] >> (i % 2 == 0 ? 0 : 32));
    (i < operands ? operation.operands : operation.results).push_back({type, words[values + i]});
  }
  return operation;
}

std::string text_of(const Value& value) {
  const std::size_t bits = bits_of(value.type);
  switch (static_cast<value_class>(value.type & 0xff)) {
    case value_class::number: {
      const double raw = is_unsigned(value.type)
                             ? static_cast<double>(value.bits)
                             : static_cast<double>(static_cast<std::int64_t>(value.bits));
      const word shown = bits == 64 ? value.bits : value.bits & ((word{1} << bits) - 1);
      return fmt::format("{} ({:0{}x})", std::ldexp(raw, -fraction_of(value.type)), shown,
                         bits / 4);
    }
    case value_class::integer:
      return is_unsigned(value.type) ? fmt::format("{}", value.bits)
                                     : fmt::format("{}", static_cast<std::int64_t>(value.bits));
    case value_class::boolean:
      return value.bits != 0 ? "true" : "false";
    case value_class::digest:
      return fmt::format("hash {:016x}", value.bits);
    case value_class::none:
      return "nothing";
  }
  return fmt::format("?{:016x}", value.bits);
}

std::string type_text(std::uint32_t type) {
  const int fraction = fraction_of(type);
  std::string text = fmt::format("{}{}_{}", is_unsigned(type) ? 'u' : 'q',
                                 static_cast<int>(bits_of(type)) - fraction, fraction);
  const std::uint32_t rules = type >> record::tag_policy_shift;
  constexpr std::array roundings{"half-up", "half-away", "floor", "truncate", "half-even"};
  constexpr std::array ranges{"wrap", "saturate", "trap", "as-range"};
  const std::uint32_t multiply = rules >> 9 & 0x1f;
  const std::uint32_t range = rules >> 7 & 3;
  const std::uint32_t products = rules >> 5 & 3;
  const std::uint32_t quotients = rules >> 3 & 3;
  if (multiply != 0 && multiply < 25) {
    text += fmt::format(", multiply {}, divide {}", roundings.at(multiply / 5),
                        roundings.at(multiply % 5));
  }
  if (range != 0) text += fmt::format(", range {}", ranges.at(range));
  if (products != 3) text += fmt::format(", products {}", ranges.at(products));
  if (quotients != 3) text += fmt::format(", quotients {}", ranges.at(quotients));
  if ((rules & 7) != 0) {
    constexpr std::array faults{"", ", #DE for zero", ", #DE unsigned", ", #DE signed"};
    text += (rules & 4) != 0 ? ", whole divisor" : "";
    text += faults.at(rules & 3);
  }
  return text;
}

std::string text_of(const Operation& operation) {
  const char* const name = record::text_of(operation.kind);
  if (!record::is_operation(operation.kind)) {
    return fmt::format("{} {}", name == nullptr ? "?" : name,
                       static_cast<std::int64_t>(operation.operands.at(0).bits));
  }
  std::string text =
      fmt::format("{} [{}]", name == nullptr ? "?" : name, type_text(operation.type));
  const char* separator = ": ";
  for (const Value& operand : operation.operands) {
    text += separator + text_of(operand);
    separator = ", ";
  }
  if (operation.threw) return text + " -> throws";
  separator = " -> ";
  for (const Value& result : operation.results) {
    text += separator + text_of(result);
    separator = ", ";
  }
  return text;
}

}  // namespace fixproof::desync
