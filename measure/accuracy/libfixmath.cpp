// libfixmath, as packaged by Debian.
#include <libfixmath/fix16.h>

#include <array>
#include <cmath>

#include "measure/accuracy/number_subject.hpp"
#include "measure/host/host_contenders.hpp"

namespace fixproof::measure {

namespace {

struct Fix16Number {
  fix16_t value = 0;

  friend Fix16Number operator+(Fix16Number a, Fix16Number b) {
    return {fix16_add(a.value, b.value)};
  }
  friend Fix16Number operator*(Fix16Number a, Fix16Number b) {
    return {fix16_mul(a.value, b.value)};
  }
  friend Fix16Number operator/(Fix16Number n, Fix16Number d) {
    return {fix16_div(n.value, d.value)};
  }
};

constexpr const char* libfixmath = "libfixmath";

/// With divisors of 2^20 units or more, the first estimate of the long division can lose a unit of
/// the remainder. The error then exceeds half a unit by up to a sixteenth.
HostJudgement fix16_quotient(const HostCase& c) {
  const HostJudgement plain = quotient_rounded<oracle::Rounding::half_away>(c);
  if (plain == HostJudgement::right) return plain;
  const auto divisor = static_cast<std::int64_t>(c.operands[1]);
  const auto off = static_cast<std::int64_t>(c.result) * divisor -
                   static_cast<std::int64_t>(c.operands[0]) * 65536;
  return 16 * std::abs(off) <= 9 * std::abs(divisor) ? HostJudgement::exception
                                                     : HostJudgement::wrong;
}

/// For roots of 2^23 units or more, libfixmath uses (r + 1/2)^2 for r^2 + r + 1/2, a quarter of a
/// unit too much. The error then exceeds half a unit by up to 2^-10.
HostJudgement fix16_root(const HostCase& c) {
  const HostJudgement plain = root_rounded(c);
  if (plain == HostJudgement::right) return plain;
  const double exact = std::sqrt(c.operands[0] * 65536);
  return std::fabs(c.result - exact) <= 0.501 ? HostJudgement::exception : HostJudgement::wrong;
}

/// A function of one word.
template <fix16_t (*Function)(fix16_t)>
std::uint32_t of_word(std::uint32_t x, std::uint32_t /*y*/) {
  return static_cast<std::uint32_t>(Function(static_cast<fix16_t>(x)));
}

std::uint32_t arctangent(std::uint32_t y, std::uint32_t x) {
  return static_cast<std::uint32_t>(fix16_atan2(static_cast<fix16_t>(y), static_cast<fix16_t>(x)));
}

struct NamedFunction {
  std::string_view name;
  WordFunction of;
};
constexpr std::array functions{
    NamedFunction{"exp", of_word<fix16_exp>},   NamedFunction{"log", of_word<fix16_log>},
    NamedFunction{"log2", of_word<fix16_log2>}, NamedFunction{"sin", of_word<fix16_sin>},
    NamedFunction{"cos", of_word<fix16_cos>},   NamedFunction{"tan", of_word<fix16_tan>},
    NamedFunction{"asin", of_word<fix16_asin>}, NamedFunction{"acos", of_word<fix16_acos>},
    NamedFunction{"atan", of_word<fix16_atan>}, NamedFunction{"atan2", arctangent},
};

}  // namespace

template <>
struct MeasuredNumber<Fix16Number> {
  static Fix16Number of_word(std::uint32_t word) { return {static_cast<fix16_t>(word)}; }
  static double in_units(Fix16Number x) { return x.value; }
  static Fix16Number root(Fix16Number x) { return {fix16_sqrt(x.value)}; }
  static Fix16Number sine_of_radians(Fix16Number x) { return {fix16_sin(x.value)}; }
};

std::optional<Subject> libfixmath_subject(const std::string& operation) {
  return subject_of_number<Fix16Number>(libfixmath, operation);
}

std::vector<HostContender> libfixmath_contenders(const std::string& operation) {
  using enum oracle::Rounding;
  std::vector<HostContender> all;
  if (operation == "mul") {
    all.push_back(product_contender<Fix16Number, half_away>(libfixmath, "", HostKind::library));
  } else if (operation == "div") {
    all.push_back(array_contender<Fix16Number, HostQuotient>(
        libfixmath, "", HostKind::library, rounding_text(half_away), fix16_quotient));
  } else if (operation == "sqrt") {
    all.push_back(array_contender<Fix16Number, HostRoot>(libfixmath, "", HostKind::library,
                                                         "to nearest", fix16_root));
  } else if (operation == "vertex") {
    all.push_back(vertex_contender<Fix16Number, half_away>(libfixmath, "", HostKind::library));
  }
  return all;
}

WordFunction libfixmath_function(std::string_view function) {
  for (const auto& [name, of] : functions) {
    if (name == function) return of;
  }
  return nullptr;
}

bool has_libfixmath() { return true; }

}  // namespace fixproof::measure
