#include "judge/code/c_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <span>
#include <string>
#include <vector>

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

/// Returns the bits of an int, which has 16 on a processor whose registers have fewer.
int bits_of_int(int code_bits) { return std::clamp(code_bits, 16, 32); }

/// Returns the type of a number by its words, as `unsigned long`.
std::optional<Parameter> number_type(std::span<const std::string_view> words, int code_bits) {
  Parameter type;
  std::string text;
  bool has_sign = false;
  for (const std::string_view word : words) {
    if (word == "unsigned" || word == "signed") {
      if (has_sign) return std::nullopt;
      has_sign = true;
      type.is_signed = word == "signed";
      continue;
    }
    text += fmt::format("{}{}", text.empty() ? "" : " ", word);
  }
  if (has_sign && text.empty()) text = "int";
  const int int_bits = bits_of_int(code_bits);
  const std::array<std::pair<std::string_view, int>, 5> names{{{"char", 8},
                                                               {"short", 16},
                                                               {"int", int_bits},
                                                               {"long", std::max(code_bits, 32)},
                                                               {"long long", 64}}};
  for (const auto& [name, bits] : names) {
    const bool may_have_int = name.ends_with("short") || name.ends_with("long");
    if (text != name && !(may_have_int && text == fmt::format("{} int", name))) continue;
    type.bits = bits;
    return type;
  }
  std::string_view fixed = text;
  if (fixed.starts_with("std::")) fixed.remove_prefix(5);
  for (const int bits : {8, 16, 32, 64}) {
    const std::string name = fmt::format("int{}_t", bits);
    if (has_sign || (fixed != name && fixed != "u" + name)) continue;
    type.bits = bits;
    type.is_signed = fixed == name;
    return type;
  }
  return std::nullopt;
}

bool is_identifier(std::string_view text) {
  return std::ranges::all_of(text,
                             [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

/// The words of a declaration up to its star, how many stars there are, and the words after them.
/// Words that change no type are left out.
struct Declaration {
  std::vector<std::string_view> words{};
  std::size_t stars = 0;
  std::vector<std::string_view> after{};
};
Declaration declaration_of(std::string_view text) {
  constexpr std::array<std::string_view, 5> idle{"const", "volatile", "restrict", "__restrict",
                                                 "register"};
  Declaration all;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ' || text[at] == '*') {
      if (text[at++] == '*') ++all.stars;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" *", at), text.size());
    const std::string_view word = text.substr(at, end - at);
    at = end;
    if (std::ranges::find(idle, word) != idle.end()) continue;
    (all.stars > 0 ? all.after : all.words).push_back(word);
  }
  return all;
}

/// Returns the type of a place: a number, a pointer, an array, or a constant. The name of a
/// parameter may follow, as in `const int16_t *a`.
std::optional<Parameter> type_of(const PlaceText& place, int code_bits) {
  if (place.is_pointer || place.parts.size() != 1) return std::nullopt;
  std::string_view text = place.parts.front();
  if (const auto constant = whole_number<std::int32_t>(text)) {
    return Parameter{.bits = bits_of_int(code_bits), .constant = *constant};
  }
  std::size_t numbers = 0;  // none: no array
  if (const std::size_t bracket = text.find('['); bracket != std::string_view::npos) {
    if (!text.ends_with(']')) return std::nullopt;
    numbers =
        whole_number<std::size_t>(text.substr(bracket + 1, text.size() - bracket - 2)).value_or(0);
    if (numbers == 0) return std::nullopt;
    text = text.substr(0, bracket);
  }
  const Declaration read = declaration_of(text);
  if (read.stars + (numbers > 0 ? 1 : 0) > 1 || read.after.size() > 1) return std::nullopt;
  std::span<const std::string_view> words = read.words;
  auto type = number_type(words, code_bits);
  const std::string_view name = !read.after.empty() ? read.after[0]
                                : words.size() > 1  ? words.back()
                                                    : std::string_view();
  if (!type && read.after.empty() && !name.empty()) {
    words = words.first(words.size() - 1);
    type = number_type(words, code_bits);
  }
  const bool is_name = is_identifier(name) && !number_type(std::span(&name, 1), code_bits);
  if (!type || ((!read.after.empty() || words.size() < read.words.size()) && !is_name)) {
    return std::nullopt;
  }
  if (read.stars == 0 && numbers == 0) return type;
  type->is_pointer = true;
  type->numbers = std::max<std::size_t>(numbers, 1);
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
                    "short, long* or int16_t[2], for a typedef the type that it stands for",
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
