#include "app/web/number.hpp"

#include "app/web/json.hpp"
#include "app/web/operand.hpp"
#include "app/web/words.hpp"

namespace fixproof::web {

namespace {

using oracle::Integer;

/// The number of digits after the point in an error. It makes the error exact for every word of at
/// most 32 bits.
constexpr std::size_t error_digits = 40;

/// Writes the value of `units`, or nothing if it is out of range.
void write_neighbour(Json& json, std::string_view name, const Integer& units,
                     const NumberFormat& format) {
  const auto f = format.format.as<oracle::Format>();
  if (!oracle::fits(units, f)) return;
  json.field(name, format.write(oracle::wrap(units, f)));
}

void write_row(Json& json, const NumberFormat& format, const Operand& operand) {
  const auto f = format.format.as<oracle::Format>();
  json.field("name", format_name(format.format));
  json.field("bits", format.format.word_bits);
  json.field("fraction", format.format.fraction_bits);
  json.field("signed", format.format.is_signed);
  json.field("range", range_of(format));
  // The oracle rounds the exact number without the type.
  const Integer expected =
      oracle::to_ulps(operand.exact, oracle::Rounding::half_up, f.fraction_bits);
  const Reading reading = format.read(operand.decimal);
  const bool fits = oracle::fits(expected, f);
  json.field("fits", reading.word.has_value());
  json.field("agrees", reading.word.has_value() == fits &&
                           (!fits || *reading.word == oracle::wrap(expected, f)));
  if (!reading.word) return;
  const Integer units = oracle::ulps(*reading.word, f);
  json.field("word", hex(*reading.word, f.bits));
  json.field("value", format.write(*reading.word));
  write_neighbour(json, "below", units - 1, format);
  write_neighbour(json, "above", units + 1, format);
  const Integer one = Integer(1) << f.fraction_bits;
  const Integer off = units * operand.exact.denominator - operand.exact.numerator * one;
  json.field("error", decimal_text(off, operand.exact.denominator * one, error_digits));
  json.field("units", decimal_text(off, operand.exact.denominator, 4));
}

}  // namespace

std::string number_view(std::string_view request) {
  const auto lines = lines_of(request);
  const NumberFormat* const format = format_named(lines[0]);
  Json json;
  json.object([&] {
    if (format == nullptr || lines.size() != 2) {
      json.field("error", "Choose one of the formats.");
      return;
    }
    const Operand operand = operand_of(lines[1], *format);
    if (!operand.error.empty()) {
      json.field("error", operand.error);
      return;
    }
    json.field("exact", decimal_text(operand.exact.numerator, operand.exact.denominator, 120));
    json.array("rows", [&] {
      for (const NumberFormat& each : formats())
        json.object([&] { write_row(json, each, operand); });
    });
  });
  return json.text();
}

}  // namespace fixproof::web
