#include "measure/accuracy/subjects.hpp"

#include <array>

#include "fixed/fixed.hpp"
#include "measure/accuracy/number_subject.hpp"
#include "oracle/format.hpp"
#include "oracle/real.hpp"

namespace fixproof::measure {

namespace {

using oracle::Integer;

/// Bits below one ulp for irrational results.
constexpr int digits = 48;

/// Only the type has it.
constexpr auto rounded_sum = []<class N>(const N* x) {
  return fixproof::dot(std::array{x[0], x[1], x[2]}, std::array{x[3], x[4], x[5]});
};

Integer units(CaseWords in, std::size_t i) { return oracle::ulps(in[i], 16); }

std::optional<ExactResult> exact_product(CaseWords in) {
  return ExactResult{units(in, 0) * units(in, 1), oracle::one(16)};
}
std::optional<ExactResult> exact_quotient(CaseWords in) {
  const Integer n = units(in, 0) * oracle::one(16);
  const Integer d = units(in, 1);
  if (d == 0) return std::nullopt;
  return d < 0 ? ExactResult{-n, -d} : ExactResult{n, d};
}
std::optional<ExactResult> exact_root(CaseWords in) {
  if (units(in, 0) < 0) return std::nullopt;
  return ExactResult{oracle::scaled_sqrt(in[0], digits), Integer(1) << digits};
}
std::optional<ExactResult> exact_cosine(CaseWords in) {
  return ExactResult{oracle::scaled_cos(static_cast<std::int32_t>(in[0]), digits), Integer(1)
                                                                                       << digits};
}
std::optional<ExactResult> exact_sine(CaseWords in) {
  // sin(x) = cos(x + 270 degrees)
  return ExactResult{oracle::scaled_cos(static_cast<std::int32_t>(in[0]) + 2700, digits),
                     Integer(1) << digits};
}
std::optional<ExactResult> exact_sine_of_radians(CaseWords in) {
  return ExactResult{oracle::scaled_sin_of_radians(in[0], digits), Integer(1) << digits};
}
std::optional<ExactResult> exact_dot(CaseWords in) {
  Integer sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += units(in, k) * units(in, 3 + k);
  return ExactResult{sum, oracle::one(16)};
}

/// The presets that differ in the rounding of products.
/// @param alike presets that return the same as `q16_16`
template <class Operation>
std::vector<Subject> by_product(Operation o, const char* alike) {
  using namespace fixproof;
  return {
      subject_of<q16_16>(o, "q16_16", alike),
      subject_of<q16_16_i386_unrounded>(o, "q16_16_i386_unrounded", "_i386_div_rounded"),
      subject_of<q16_16_i8088>(o, "q16_16_i8088", "_i8088_mul_rounded"),
      subject_of<q16_16_i8088_unrounded>(o, "q16_16_i8088_unrounded", "_i8088_div_rounded"),
  };
}

/// The presets that differ in the divide.
std::vector<Subject> by_divide() {
  using namespace fixproof;
  using operations::quotient;
  return {
      subject_of<q16_16>(quotient, "q16_16", "_saturating _trapping"),
      subject_of<q16_16_i386>(quotient, "q16_16_i386", "_i386_div_rounded"),
      subject_of<q16_16_i386_unrounded>(quotient, "q16_16_i386_unrounded", "_i386_mul_rounded"),
      subject_of<q16_16_i8088>(quotient, "q16_16_i8088", "_i8088_div_rounded"),
      subject_of<q16_16_i8088_unrounded>(quotient, "q16_16_i8088_unrounded", "_i8088_mul_rounded"),
  };
}

/// One subject for all presets, because all return the same.
template <class Operation>
std::vector<Subject> by_none(Operation o) {
  return {subject_of<fixproof::q16_16>(o, "q16_16", "every preset")};
}

}  // namespace

std::vector<MeasuredOperation> measured_operations() {
  using enum OperandKind;
  using namespace operations;
  constexpr const char* one_rounding = "_saturating _trapping _i386 _i386_mul_rounded";
  // If a sum fits, its products may still overflow, so only presets that wrap agree.
  constexpr const char* wrapping = "_i386 _i386_mul_rounded";
  std::vector<MeasuredOperation> all{
      {"mul", factors, 2, exact_product, by_product(product, one_rounding)},
      {"div", quotients, 2, exact_quotient, by_divide()},
      {"sqrt", radicand, 1, exact_root, by_none(root)},
      {"cos", angle, 1, exact_cosine, by_none(cosine)},
      {"sin", angle, 1, exact_sine, by_none(sine)},
      {"sin of radians", radians, 1, exact_sine_of_radians, by_none(sine_of_radians)},
      {"dot of rounded products", terms, 6, exact_dot, by_product(rounded_products, wrapping)},
      {"dot rounded once", terms, 6, exact_dot, by_product(rounded_sum, one_rounding)},
  };
  for (MeasuredOperation& o : all) {
    for (auto other :
         {libfixmath_subject(o.name), freetype_subject(o.name),
          subject_of_number<float>("float", o.name), subject_of_number<double>("double", o.name)}) {
      if (other) o.subjects.push_back(std::move(*other));
    }
  }
  return all;
}

}  // namespace fixproof::measure
