#include "measure/host/host_contenders.hpp"

#include <iterator>
#include <stdexcept>

#include "oracle/unbounded.hpp"

namespace fixproof::measure {

namespace {

using oracle::DivideRule;
using oracle::Rounding;

constexpr const char* of_float = "to 24 bits";
constexpr const char* of_double = "to 53 bits";

template <class... All>
std::vector<HostContender> contender_list(All... all) {
  std::vector<HostContender> contenders;
  (contenders.push_back(std::move(all)), ...);
  return contenders;
}

/// The contenders with distinct products. Calls `make` with a number type and its rounding as
/// template arguments.
template <class Make>
std::vector<HostContender> by_product(Make make) {
  using namespace fixed;
  using enum HostKind;
  return contender_list(
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
      make.template operator()<PlainNumber, Rounding::half_up>("idiom", "", plain));
}

std::vector<HostContender> multipliers() {
  return by_product([]<class N, Rounding R>(auto... of) { return product_contender<N, R>(of...); });
}

std::vector<HostContender> vertex_makers() {
  return by_product([]<class N, Rounding R>(auto... of) { return vertex_contender<N, R>(of...); });
}

template <class N>
HostContender divider(std::string name, std::string alike, HostKind kind, Rounding rounding,
                      HostJudgement (*judge)(const HostCase&)) {
  return array_contender<N, HostQuotient>(std::move(name), std::move(alike), kind,
                                          rounding_text(rounding), judge);
}

/// The 8088 divide, which divides by the whole part.
template <class N>
HostContender whole_divider(std::string name, std::string alike, Rounding rounding,
                            HostJudgement (*judge)(const HostCase&)) {
  return array_contender<N, HostQuotient>(
      std::move(name), std::move(alike), HostKind::type,
      rounding_text(rounding) + ", by the whole part of the divisor", judge);
}

std::vector<HostContender> dividers() {
  using namespace fixed;
  using enum HostKind;
  using enum Rounding;
  return contender_list(
      divider<q16_16>("q16_16", "", type, half_up, quotient_rounded<half_up>),
      divider<q16_16_saturating>("q16_16_saturating", "", type, half_up, quotient_rounded<half_up>),
      divider<q16_16_trapping>("q16_16_trapping", "", type, half_up, quotient_rounded<half_up>),
      divider<q16_16_i386>("q16_16_i386", "_i386_div_rounded", type, half_away,
                           quotient_of_fixed_asm<DivideRule::i386_rounded>),
      divider<q16_16_i386_unrounded>("q16_16_i386_unrounded", "_i386_mul_rounded", type, truncate,
                                     quotient_of_fixed_asm<DivideRule::i386_unrounded>),
      whole_divider<q16_16_i8088>("q16_16_i8088", "_i8088_div_rounded", half_away,
                                  quotient_of_fixed_asm<DivideRule::i8088_rounded>),
      whole_divider<q16_16_i8088_unrounded>("q16_16_i8088_unrounded", "_i8088_mul_rounded",
                                            truncate,
                                            quotient_of_fixed_asm<DivideRule::i8088_unrounded>),
      divider<PlainNumber>("idiom", "", plain, truncate, quotient_rounded<truncate>));
}

template <class Operation>
std::vector<HostContender> every_preset(HostJudgement (*judge)(const HostCase&)) {
  return contender_list(array_contender<fixed::q16_16, Operation>(
      "q16_16", "every preset", HostKind::type, "to nearest", judge));
}

template <class Operation>
std::vector<HostContender> floating_point(HostJudgement (*of_floats)(const HostCase&),
                                          HostJudgement (*of_doubles)(const HostCase&)) {
  return contender_list(
      array_contender<float, Operation>("float", "", HostKind::floating, of_float, of_floats),
      array_contender<double, Operation>("double", "", HostKind::floating, of_double, of_doubles));
}

std::vector<HostContender> floating_vertices() {
  return contender_list(
      HostContender{"float", "", HostKind::floating, of_float, coordinate_in<float>,
                    std::make_unique<VertexLoop<float>>()},
      HostContender{"double", "", HostKind::floating, of_double, coordinate_in<double>,
                    std::make_unique<VertexLoop<double>>()});
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

void append(std::vector<HostContender>& to, std::vector<HostContender> more) {
  to.insert(to.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
}

/// Orders the contenders: the type and the idiom, libraries, floating point.
HostOperation host_operation(HostOperation operation, std::vector<HostContender> ours,
                             std::vector<HostContender> floats) {
  operation.contenders = std::move(ours);
  append(operation.contenders, libfixmath_contenders(operation.name));
  append(operation.contenders, freetype_contenders(operation.name));
  append(operation.contenders, std::move(floats));
  return operation;
}

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
  }
  throw std::invalid_argument("unknown rounding");
}

std::vector<HostOperation> host_operations(std::uint64_t seed, std::size_t blocks) {
  std::vector<HostOperation> all;
  all.push_back(host_operation(
      {"mul",
       "uniform to 128",
       "each product is multiplied by a factor of 1 to 2, the next by its reciprocal",
       2,
       1,
       exact_of("mul"),
       product_operands(seed, blocks),
       {}},
      multipliers(), floating_point<HostProduct>(product_in<float>, product_in<double>)));
  all.push_back(host_operation(
      {"div",
       "uniform to 2048, divisors from 1.0",
       "each quotient divides the next numerator; these come in equal pairs, and quotients stay "
       "near 100 to 200",
       2,
       1,
       exact_of("div"),
       quotient_operands(seed, blocks),
       {}},
      dividers(), floating_point<HostQuotient>(quotient_in<float>, quotient_in<double>)));
  all.push_back(host_operation({"sqrt",
                                "uniform",
                                "each root is added to the next operand",
                                1,
                                1,
                                exact_of("sqrt"),
                                root_operands(seed, blocks),
                                {}},
                               every_preset<HostRoot>(root_rounded),
                               floating_point<HostRoot>(root_in<float>, root_in<double>)));
  all.push_back(host_operation(
      {"cos", "tenths of a degree", "", 1, 1, exact_of("cos"), cosine_operands(seed, blocks), {}},
      every_preset<HostCosine>(cosine_rounded),
      floating_point<HostCosine>(cosine_in<float>, cosine_in<double>)));
  all.push_back(host_operation({"vertex",
                                "rotations, and coordinates uniform to 128",
                                "",
                                15,
                                3,
                                exact_coordinate,
                                vertex_operands(seed, blocks),
                                {}},
                               vertex_makers(), floating_vertices()));
  return all;
}

}  // namespace fixproof::measure
