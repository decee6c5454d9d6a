// FreeType's arithmetic. Its fixed-point numbers have the C type long, as in FreeType's users.
#include <freetype/freetype.h>
#include <freetype/fttrigon.h>

#include "measure/accuracy/number_subject.hpp"
#include "measure/host/host_contenders.hpp"

namespace fixproof::measure {

namespace {

struct FreeTypeNumber {
  FT_Fixed value = 0;

  friend FreeTypeNumber operator+(FreeTypeNumber a, FreeTypeNumber b) {
    return {a.value + b.value};
  }
  friend FreeTypeNumber operator*(FreeTypeNumber a, FreeTypeNumber b) {
    return {FT_MulFix(a.value, b.value)};
  }
  friend FreeTypeNumber operator/(FreeTypeNumber n, FreeTypeNumber d) {
    return {FT_DivFix(n.value, d.value)};
  }
};

constexpr const char* freetype = "FreeType";

/// A function of an angle in degrees. The angle is a long, too.
template <FT_Fixed (*Function)(FT_Angle)>
std::uint32_t of_word(std::uint32_t x, std::uint32_t /*y*/) {
  return static_cast<std::uint32_t>(Function(static_cast<std::int32_t>(x)));
}

}  // namespace

template <>
struct MeasuredNumber<FreeTypeNumber> {
  static FreeTypeNumber of_word(std::uint32_t word) { return {static_cast<std::int32_t>(word)}; }
  static double in_units(FreeTypeNumber x) { return static_cast<double>(x.value); }
};

std::optional<Subject> freetype_subject(const std::string& operation) {
  return subject_of_number<FreeTypeNumber>(freetype, operation);
}

std::vector<HostContender> freetype_contenders(const std::string& operation) {
  using oracle::Rounding;
  std::vector<HostContender> all;
  if (operation == "mul") {
    all.push_back(
        product_contender<FreeTypeNumber, Rounding::half_away>(freetype, "", HostKind::library));
  } else if (operation == "div") {
    all.push_back(array_contender<FreeTypeNumber, HostQuotient>(
        freetype, "", HostKind::library, rounding_text(Rounding::half_away),
        quotient_rounded<Rounding::half_away>));
  } else if (operation == "vertex") {
    all.push_back(
        vertex_contender<FreeTypeNumber, Rounding::half_away>(freetype, "", HostKind::library));
  }
  return all;
}

WordFunction freetype_function(std::string_view function) {
  if (function == "sin_of_degrees") return of_word<FT_Sin>;
  if (function == "cos_of_degrees") return of_word<FT_Cos>;
  if (function == "tan_of_degrees") return of_word<FT_Tan>;
  return nullptr;
}

bool has_freetype() { return true; }

}  // namespace fixproof::measure
