// The type in the formats that fixed/formats.hpp names.
#include <array>
#include <system_error>

#include "verify/parties/formats.hpp"
#include "verify/parties/with_format.hpp"

namespace fixproof::parties {

namespace {

using Result = std::optional<std::uint64_t>;

template <class Number>
Result through_text(Number x) {
  std::array<char, fixproof::max_chars<Number>> text{};
  const auto written = fixproof::to_chars(text.data(), text.data() + text.size(), x);
  Number back;
  const auto read = fixproof::from_chars(text.data(), written.ptr, back);
  if (read.ec != std::errc{} || read.ptr != written.ptr) return std::nullopt;
  return bits_of(back);
}

template <class Number>
void answer(const cases::Variant& v, const Cases& asked) {
  const auto each = [&](const auto& one) {
    each_number(v, asked, [&](std::uint64_t a, std::uint64_t b) -> Result {
      return one(number_from<Number>(a), number_from<Number>(b));
    });
  };
  switch (v.operation) {
    case cases::Operation::add:
      return each([](Number a, Number b) -> Result { return bits_of<Number>(a + b); });
    case cases::Operation::sub:
      return each([](Number a, Number b) -> Result { return bits_of<Number>(a - b); });
    case cases::Operation::mul:
      return each([](Number a, Number b) -> Result { return bits_of<Number>(a * b); });
    case cases::Operation::div:
      return each([](Number a, Number b) -> Result {
        const auto quotient = fixproof::try_divide(a, b);
        if (!quotient) return std::nullopt;
        return bits_of<Number>(*quotient);
      });
    case cases::Operation::sqrt:
      return each([](Number a, Number /*b*/) -> Result { return bits_of(fixproof::sqrt(a)); });
    case cases::Operation::binary64:
      return each(
          [](Number a, Number /*b*/) -> Result { return bits_of(Number(static_cast<double>(a))); });
    default:
      return each([](Number a, Number /*b*/) { return through_text(a); });
  }
}

}  // namespace

bool is_of_type(const cases::Variant& v) {
  if (v.from) return is_of_type_mixed(v);
  return with_number_in(v.format, [](auto /*type*/) {});
}

void answer_by_type(const cases::Variant& v, const Cases& asked) {
  if (v.from) return answer_mixed_by_type(v, asked);
  if (cases::is_function(v.operation)) return answer_function_by_type(v, asked);
  if (cases::is_quotient_function(v.operation)) return answer_quotient_by_type(v, asked);
  with_number_in(v.format, [&]<class Number>(std::type_identity<Number> /*type*/) {
    answer<Number>(v, asked);
  });
}

}  // namespace fixproof::parties
