#include "measure/accuracy/subjects.hpp"

#include <array>

#include "fixed/fixed.hpp"
#include "measure/accuracy/number_subject.hpp"
#include "oracle/real.hpp"
#include "oracle/unbounded.hpp"

namespace fixproof::measure {

namespace {

using oracle::Integer;

/// Bits below one ulp for irrational results.
constexpr int digits = 48;

template <class N>
N operand(CaseWords in, std::size_t i) {
  return N::from_raw(static_cast<std::int32_t>(in[i]));
}
template <class N>
std::optional<double> word(N x) {
  return x.raw();
}

constexpr auto product = []<class N>(CaseWords in) {
  return word(operand<N>(in, 0) * operand<N>(in, 1));
};
constexpr auto quotient = []<class N>(CaseWords in) {
  const auto q = fixed::try_divide(operand<N>(in, 0), operand<N>(in, 1));
  return q ? word(*q) : std::nullopt;
};
constexpr auto root = []<class N>(CaseWords in) { return word(fixed::sqrt(operand<N>(in, 0))); };
constexpr auto cosine = []<class N>(CaseWords in) {
  return word(fixed::cos<N>(static_cast<std::int32_t>(in[0])));
};
constexpr auto sine = []<class N>(CaseWords in) {
  return word(fixed::sin<N>(static_cast<std::int32_t>(in[0])));
};
constexpr auto sine_of_radians = []<class N>(CaseWords in) {
  return word(fixed::sin(operand<N>(in, 0)));
};
constexpr auto rounded_products = []<class N>(CaseWords in) {
  N sum;
  for (std::size_t k = 0; k < 3; ++k) sum += operand<N>(in, k) * operand<N>(in, 3 + k);
  return word(sum);
};
constexpr auto rounded_sum = []<class N>(CaseWords in) {
  const std::array a{operand<N>(in, 0), operand<N>(in, 1), operand<N>(in, 2)};
  const std::array b{operand<N>(in, 3), operand<N>(in, 4), operand<N>(in, 5)};
  return word(fixed::dot(a, b));
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

template <class N, class Function>
Subject preset(Function /*of the type*/, std::string name, std::string alike) {
  return {std::move(name), std::move(alike),
          [](CaseWords in) { return Function{}.template operator()<N>(in); }};
}

/// The presets that differ in the rounding of products.
/// @param alike presets that return the same as `q16_16`
template <class Function>
std::vector<Subject> by_product(Function f, std::string alike) {
  using namespace fixed;
  return {
      preset<q16_16>(f, "q16_16", std::move(alike)),
      preset<q16_16_i386_unrounded>(f, "q16_16_i386_unrounded", "_i386_div_rounded"),
      preset<q16_16_i8088>(f, "q16_16_i8088", "_i8088_mul_rounded"),
      preset<q16_16_i8088_unrounded>(f, "q16_16_i8088_unrounded", "_i8088_div_rounded"),
  };
}

/// The presets that differ in the divide.
template <class Function>
std::vector<Subject> by_divide(Function f) {
  using namespace fixed;
  return {
      preset<q16_16>(f, "q16_16", "_saturating _trapping"),
      preset<q16_16_i386>(f, "q16_16_i386", "_i386_div_rounded"),
      preset<q16_16_i386_unrounded>(f, "q16_16_i386_unrounded", "_i386_mul_rounded"),
      preset<q16_16_i8088>(f, "q16_16_i8088", "_i8088_div_rounded"),
      preset<q16_16_i8088_unrounded>(f, "q16_16_i8088_unrounded", "_i8088_mul_rounded"),
  };
}

/// One subject for all presets, because all return the same.
template <class Function>
std::vector<Subject> by_none(Function f) {
  return {preset<fixed::q16_16>(f, "q16_16", "every preset")};
}

}  // namespace

std::vector<MeasuredOperation> measured_operations() {
  using enum OperandKind;
  constexpr const char* one_rounding = "_saturating _trapping _i386 _i386_mul_rounded";
  // If a sum fits, its products may still overflow, so only presets that wrap agree.
  constexpr const char* wrapping = "_i386 _i386_mul_rounded";
  std::vector<MeasuredOperation> all{
      {"mul", factors, 2, exact_product, by_product(product, one_rounding)},
      {"div", quotients, 2, exact_quotient, by_divide(quotient)},
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
