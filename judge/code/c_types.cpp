#include "judge/code/c_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "support/plain_text.hpp"
#include "support/split.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

template <class Number>
std::optional<Number> whole_number(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// Removes a word and what separates it from the next one.
bool remove_first(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  const std::string_view rest = text.substr(word.size());
  if (!rest.empty() && rest.front() != ' ') return false;
  text = support::trimmed(rest);
  return true;
}

/// Returns the type of a number, as `unsigned long`.
std::optional<Parameter> number_type(std::string_view text, int code_bits) {
  remove_first(text, "const");
  Parameter type;
  const bool is_unsigned = remove_first(text, "unsigned");
  const bool has_sign = is_unsigned || remove_first(text, "signed");
  type.is_signed = !is_unsigned && !text.starts_with("uint");
  const int int_bits = std::min(code_bits, 32);
  const std::array<std::pair<std::string_view, int>, 5> names{{{"char", 8},
                                                               {"short", 16},
                                                               {"int", int_bits},
                                                               {"long", std::max(code_bits, 32)},
                                                               {"long long", 64}}};
  if (has_sign && text.empty()) text = "int";
  for (const auto& [name, bits] : names) {
    if (text != name) continue;
    type.bits = bits;
    return type;
  }
  for (const int bits : {8, 16, 32, 64}) {
    const std::string name = fmt::format("int{}_t", bits);
    if (has_sign || (text != name && text != "u" + name)) continue;
    type.bits = bits;
    return type;
  }
  return std::nullopt;
}

/// Returns the type of a place: a number, a pointer, an array, or a constant.
std::optional<Parameter> type_of(const PlaceText& place, int code_bits) {
  if (place.is_pointer || place.parts.size() != 1) return std::nullopt;
  std::string_view text = place.parts.front();
  if (const auto constant = whole_number<std::int32_t>(text)) {
    return Parameter{.bits = std::min(code_bits, 32), .constant = *constant};
  }
  std::size_t numbers = 0;  // none: no pointer
  const std::size_t bracket = text.find('[');
  if (text.ends_with('*')) {
    numbers = 1;
    text.remove_suffix(1);
  } else if (bracket != std::string_view::npos && text.ends_with(']')) {
    numbers =
        whole_number<std::size_t>(text.substr(bracket + 1, text.size() - bracket - 2)).value_or(0);
    if (numbers == 0) return std::nullopt;
    text = text.substr(0, bracket);
  }
  auto type = number_type(support::trimmed(text), code_bits);
  if (!type || numbers == 0) return type;
  type->is_pointer = true;
  type->numbers = numbers;
  return type;
}

/// Takes the places of a frame one after the other.
class Reader {
 public:
  Reader(const cases::Variant& variant, int code_bits)
      : variant_(variant),
        code_bits_(code_bits),
        operands_(cases::operands_of(variant)),
        results_(cases::words_out(variant.operation)) {}

  void take(const PlaceText& place) {
    Parameter p = known(place);
    if (p.constant) {
      signature_.operands.push_back(p);
      return;
    }
    p.is_result = taken_ == operands_;
    const cases::Format format = p.is_result ? variant_.format : cases::operand_format(variant_);
    expect_room(p, place, p.is_result ? format.word_bits : cases::operand_bits(variant_), format);
    (p.is_result ? given_ : taken_) += p.numbers;
    if (taken_ > operands_ || (p.is_result && !p.is_pointer) || given_ > results_) refuse();
    signature_.operands.push_back(p);
  }

  Signature with_results(const std::vector<PlaceText>& out) {
    if (taken_ != operands_ || out.size() > 1) refuse();
    // A routine that leaves its result behind a pointer may return something else, as a status.
    if (given_ > 0) {
      if (given_ != results_) refuse();
      return std::move(signature_);
    }
    if (out.empty() || results_ != 1) refuse();
    const Parameter result = known(out.front());
    if (result.is_pointer || result.constant) refuse();
    expect_room(result, out.front(), variant_.format.word_bits, variant_.format);
    signature_.result_bits = result.bits;
    return std::move(signature_);
  }

 private:
  [[nodiscard]] Parameter known(const PlaceText& place) const {
    if (const auto type = type_of(place, code_bits_)) return *type;
    throw UsageError(
        fmt::format("--frame: {} is no type that judge knows; write one such as int32_t, unsigned "
                    "short, long* or int16_t[2]",
                    support::quoted(place.parts.front())));
  }

  static void expect_room(const Parameter& p, const PlaceText& place, int bits,
                          const cases::Format& format) {
    if (p.bits >= bits) return;
    throw UsageError(fmt::format("--frame: {} has {} bits, and a number of {} has {}",
                                 support::quoted(place.parts.front()), p.bits,
                                 cases::name_of(format), bits));
  }

  [[noreturn]] void refuse() const {
    throw UsageError(fmt::format(
        "--frame: {} takes {} operand{} and gives {} result{}; write their types, then -> and that "
        "of the result, or a pointer to it after the operands, as in 'int32_t, int32_t* ->'",
        cases::name_of(variant_.operation), operands_, operands_ == 1 ? "" : "s", results_,
        results_ == 1 ? "" : "s"));
  }

  const cases::Variant& variant_;
  int code_bits_;
  std::size_t operands_;
  std::size_t results_;
  std::size_t taken_ = 0;
  std::size_t given_ = 0;
  Signature signature_{};
};

}  // namespace

std::optional<Signature> signature_in_c(const FrameText& text, const cases::Variant& variant,
                                        int bits) {
  const auto names_type = [bits](const PlaceText& place) {
    const auto type = type_of(place, bits);
    return type && !type->constant;
  };
  if (!std::ranges::any_of(text.in, names_type) && !std::ranges::any_of(text.out, names_type)) {
    return std::nullopt;
  }
  Reader reader(variant, bits);
  for (const PlaceText& place : text.in) reader.take(place);
  return reader.with_results(text.out);
}

}  // namespace fixproof::judge
