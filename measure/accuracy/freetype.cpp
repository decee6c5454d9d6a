// FreeType's arithmetic. Its fixed-point numbers have the C type long, as in FreeType's users.
#include <freetype/freetype.h>

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

bool has_freetype() { return true; }

}  // namespace fixproof::measure
