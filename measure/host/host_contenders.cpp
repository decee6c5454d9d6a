#include "measure/host/host_contenders.hpp"

#include <stdexcept>

#include "oracle/format.hpp"

namespace fixproof::measure {

namespace {

using oracle::DivideRule;
using oracle::Rounding;

/// The contenders with distinct products. Calls `make` with a number type and its rounding as
/// template arguments.
template <class Make>
std::vector<HostContender> by_product(Make make) {
  using namespace fixproof;
  using enum HostKind;
  return {
      make.template operator()<q16_16, Rounding::half_up>("q16_16", "_i386 _i386_mul_rounded",
                                                          type),
      make.template operator()<q16_16_saturating, Rounding::half_up>("q16_16_saturating", "", type),
      make.template operator()<q16_16_trapping, Rounding::half_up>("q16_16_trapping", "", type),
      make.template operator()<q16_16_i386_unrounded, Rounding::floor>("q16_16_i386_unrounded",
                                                                       "_i386_div_rounded", type),
      make.template operator()<q16_16_i8088, Rounding::half_away>("q16_16_i8088",
                                                                  "_i8088_mul_rounded", type),
      make.template operator()<q16_16_i8088_unrounded, Rounding::truncate>(
          "q16_16_i8088_unrounded", "_i8088_div_rounded", type),
      make.template operator()<PlainNumber, Rounding::half_up>("idiom", "", plain)};
}

std::vector<HostContender> multipliers() {
  return by_product([]<class N, Rounding R>(auto... of) { return product_contender<N, R>(of...); });
}

std::vector<HostContender> vertex_makers() {
  return by_product([]<class N, Rounding R>(auto... of) { return vertex_contender<N, R>(of...); });
}

template <class N>
constexpr auto* divider = &array_contender<N, HostQuotient>;

std::vector<HostContender> dividers() {
  using namespace fixproof;
  using enum HostKind;
  using enum Rounding;
  const std::string up = rounding_text(half_up);
  const std::string away = rounding_text(half_away);
  const std::string cut = rounding_text(truncate);
  const std::string by_whole = ", by the whole part of the divisor";
  return {divider<q16_16>("q16_16", "", type, up, quotient_rounded<half_up>),
          divider<q16_16_saturating>("q16_16_saturating", "", type, up, quotient_rounded<half_up>),
          divider<q16_16_trapping>("q16_16_trapping", "", type, up, quotient_rounded<half_up>),
          divider<q16_16_i386>("q16_16_i386", "_i386_div_rounded", type, away,
                               quotient_of_fixed_asm<DivideRule::i386_rounded>),
          divider<q16_16_i386_unrounded>("q16_16_i386_unrounded", "_i386_mul_rounded", type, cut,
                                         quotient_of_fixed_asm<DivideRule::i386_unrounded>),
          divider<q16_16_i8088>("q16_16_i8088", "_i8088_div_rounded", type, away + by_whole,
                                quotient_of_fixed_asm<DivideRule::i8088_rounded>),
          divider<q16_16_i8088_unrounded>("q16_16_i8088_unrounded", "_i8088_mul_rounded", type,
                                          cut + by_whole,
                                          quotient_of_fixed_asm<DivideRule::i8088_unrounded>),
          divider<PlainNumber>("idiom", "", plain, cut, quotient_rounded<truncate>)};
}

/// The type, for which every preset runs the same code.
template <class Operation>
std::vector<HostContender> every_preset(HostJudgement (*judge)(const HostCase&)) {
  return {array_contender<fixproof::q16_16, Operation>("q16_16", "every preset", HostKind::type,
                                                       "to nearest", judge)};
}

template <template <class> class Loop>
std::vector<HostContender> floating_point(HostJudgement (*of_floats)(const HostCase&),
                                          HostJudgement (*of_doubles)(const HostCase&)) {
  using enum HostKind;
  return {{"float", "", floating, "to 24 bits", of_floats, std::make_shared<Loop<float>>()},
          {"double", "", floating, "to 53 bits", of_doubles, std::make_shared<Loop<double>>()}};
}

/// The exact result as in --accuracy. It exists for all operands here.
std::function<ExactResult(CaseWords, std::size_t)> exact_of(const std::string& operation) {
  for (const MeasuredOperation& measured : measured_operations()) {
    if (measured.name != operation) continue;
    return [exact = measured.exact](CaseWords in, std::size_t) { return exact(in).value(); };
  }
  throw std::invalid_argument("unknown operation " + operation);
}

ExactResult exact_coordinate(CaseWords in, std::size_t result) {
  const CaseWords row = in.subspan(4 * result, 4);
  oracle::Integer sum = oracle::ulps(row[3], 16) * oracle::one(16);
  for (std::size_t k = 0; k < 3; ++k) {
    sum += oracle::ulps(row[k], 16) * oracle::ulps(in[12 + k], 16);
  }
  return {sum, oracle::one(16)};
}

/// Orders the contenders: the type and the idiom, libraries, floating point.
HostOperation with_contenders(HostOperation operation, const std::vector<HostContender>& ours,
                              const std::vector<HostContender>& floats) {
  for (const auto& some :
       {ours, libfixmath_contenders(operation.name), freetype_contenders(operation.name), floats}) {
    operation.contenders.insert(operation.contenders.end(), some.begin(), some.end());
  }
  return operation;
}

template <class N>
using ProductLoop = ArrayLoop<HostProduct, N>;
template <class N>
using QuotientLoop = ArrayLoop<HostQuotient, N>;
template <class N>
using RootLoop = ArrayLoop<HostRoot, N>;
template <class N>
using CosineLoop = ArrayLoop<HostCosine, N>;

}  // namespace

std::string rounding_text(Rounding rounding) {
  switch (rounding) {
    case Rounding::half_up:
      return "to nearest, halves up";
    case Rounding::half_away:
      return "to nearest, halves away from zero";
    case Rounding::half_even:
      return "to nearest, halves to even";
    case Rounding::floor:
      return "toward minus infinity";
    case Rounding::truncate:
      return "toward zero";
    case Rounding::ceiling:
      return "toward plus infinity";
  }
  throw std::invalid_argument("unknown rounding");
}

std::vector<HostOperation> host_operations(std::uint64_t seed, std::size_t blocks) {
  return {
      with_contenders(
          {.name = "mul",
           .operands_are = "uniform to 128",
           .chain_is = "each product is multiplied by a factor of 1 to 2, the next by its "
                       "reciprocal",
           .words = 2,
           .exact = exact_of("mul"),
           .operands = product_operands(seed, blocks)},
          multipliers(), floating_point<ProductLoop>(product_in<float>, product_in<double>)),
      with_contenders(
          {.name = "div",
           .operands_are = "uniform to 2048, divisors from 1.0",
           .chain_is = "each quotient divides the next numerator; these come in equal pairs, and "
                       "quotients stay near 100 to 200",
           .words = 2,
           .exact = exact_of("div"),
           .operands = quotient_operands(seed, blocks)},
          dividers(), floating_point<QuotientLoop>(quotient_in<float>, quotient_in<double>)),
      with_contenders({.name = "sqrt",
                       .operands_are = "uniform",
                       .chain_is = "each root is added to the next operand",
                       .exact = exact_of("sqrt"),
                       .operands = root_operands(seed, blocks)},
                      every_preset<HostRoot>(root_rounded),
                      floating_point<RootLoop>(root_in<float>, root_in<double>)),
      with_contenders({.name = "cos",
                       .operands_are = "tenths of a degree",
                       .exact = exact_of("cos"),
                       .operands = cosine_operands(seed, blocks)},
                      every_preset<HostCosine>(cosine_rounded),
                      floating_point<CosineLoop>(cosine_in<float>, cosine_in<double>)),
      with_contenders({.name = "vertex",
                       .operands_are = "rotations, and coordinates uniform to 128",
                       .words = 15,
                       .results = 3,
                       .exact = exact_coordinate,
                       .operands = vertex_operands(seed, blocks)},
                      vertex_makers(),
                      floating_point<VertexLoop>(coordinate_in<float>, coordinate_in<double>)),
  };
}

}  // namespace fixproof::measure
