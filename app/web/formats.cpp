#include "app/web/formats.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "fixed/fixed.hpp"
#include "fixed/text.hpp"
#include "verify/parties/with_format.hpp"

namespace fixproof::web {

namespace {

constexpr policy by_rule(rounding rule) { return {.multiply = rule, .divide = rule}; }

template <class Number>
std::optional<std::uint64_t> answer(Operation operation, std::uint64_t first,
                                    std::uint64_t second) {
  const auto a = parties::number_from<Number>(first);
  const auto b = parties::number_from<Number>(second);
  switch (operation) {
    case Operation::add:
      return parties::bits_of(a + b);
    case Operation::sub:
      return parties::bits_of(a - b);
    case Operation::mul:
      return parties::bits_of(a * b);
    case Operation::div:
      if (const auto quotient = try_divide(a, b)) return parties::bits_of(*quotient);
      return std::nullopt;
    case Operation::sqrt:
      break;
  }
  return parties::bits_of(sqrt(a));
}

template <class Number>
Reading read(std::string_view text) {
  Number number;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = from_chars(text.data(), end, number);
  if (stop != end || error == std::errc::invalid_argument) return {};
  if (error != std::errc()) return {.is_number = true};
  return {.is_number = true, .word = parties::bits_of(number)};
}

template <class Number>
std::string write(std::uint64_t word) {
  return to_string(parties::number_from<Number>(word));
}

template <class Number>
constexpr NumberFormat format_of() {
  NumberFormat format{
      .format = parties::format_of<Number>(), .read = read<Number>, .write = write<Number>};
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((format.answer[i] = answer<with_policy<Number, by_rule(rules[i])>>), ...);
  }
  (std::make_index_sequence<rules.size()>());
  format.saturated = answer<with_policy<Number, policies::saturating>>;
  return format;
}

template <class... Numbers>
constexpr std::array<NumberFormat, sizeof...(Numbers)> formats_of(
    parties::NumberList<Numbers...> /*numbers*/) {
  return {format_of<Numbers>()...};
}

constexpr auto all_formats = formats_of(parties::NamedNumbers());

}  // namespace

std::optional<Operation> operation_named(std::string_view name) {
  const auto* const found = std::find(operation_names.begin(), operation_names.end(), name);
  if (found == operation_names.end()) return std::nullopt;
  return static_cast<Operation>(found - operation_names.begin());
}

std::span<const NumberFormat> formats() { return all_formats; }

const NumberFormat* format_named(std::string_view name) {
  for (const NumberFormat& known : all_formats) {
    if (format_name(known.format) == name) return &known;
  }
  return nullptr;
}

std::string format_name(const cases::Format& format) {
  return (format.is_signed ? "q" : "u") + std::to_string(format.word_bits - format.fraction_bits) +
         '_' + std::to_string(format.fraction_bits);
}

}  // namespace fixproof::web
