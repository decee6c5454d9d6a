// Operations with results in a format of their own: the oracle and the type.
#include <array>
#include <span>

#include "fixed/fixed.hpp"
#include "oracle/format.hpp"
#include "oracle/function_names.hpp"
#include "verify/cases/exact_value.hpp"
#include "verify/cases/value.hpp"
#include "verify/parties/formats.hpp"
#include "verify/parties/with_format.hpp"

namespace fixproof::parties {

namespace {

using cases::Operation;
using Operands = std::array<std::uint64_t, 3>;
using Result = std::optional<std::uint64_t>;

/// Every ordered pair of these has its own functions, so there are few.
using Mixed = NumberList<q8_8, q24_8, q16_16, q2_30, u16_16>;

/// The result; empty for a zero divisor. Calls `lacking` for a function that has no results of
/// another format, such as cbrt.
template <class To, class From, class Lacking>
std::optional<To> computed(Operation operation, From x, From y, From z, const Lacking& lacking) {
  switch (operation) {
    case Operation::add:
      return fixproof::add<To>(x, y);
    case Operation::sub:
      return fixproof::subtract<To>(x, y);
    case Operation::mul:
      return fixproof::multiply<To>(x, y);
    case Operation::div:
      if (y == From()) return std::nullopt;
      return fixproof::divide<To>(x, y);
    case Operation::sqrt:
      return fixproof::sqrt<To>(x);
    case Operation::hypot3:
      return fixproof::hypot<To>(x, y, z);
// NOLINTBEGIN(cppcoreguidelines-macro-usage): cases of a switch
#define WITH(name, ...)                                            \
  case Operation::name:                                            \
    if constexpr (requires { fixproof::name<To>(__VA_ARGS__); }) { \
      return fixproof::name<To>(__VA_ARGS__);                      \
    }                                                              \
    break;
#define OF_ONE(name) WITH(name, x)
#define OF_TWO(name) WITH(name, x, y)
      // NOLINTEND(cppcoreguidelines-macro-usage)
      ORACLE_FUNCTIONS_OF_ONE(OF_ONE)
      ORACLE_FUNCTIONS_OF_TWO(OF_TWO)
#undef OF_TWO
#undef OF_ONE
#undef WITH
    default:
      break;
  }
  lacking();
  return std::nullopt;
}

/// Tells whether the type has results of another format. It is the same for every pair.
bool has_mixed(Operation operation) {
  bool has = true;
  static_cast<void>(
      computed<q2_30>(operation, q16_16(1), q16_16(1), q16_16(1), [&] { has = false; }));
  return has;
}

}  // namespace

void answer_mixed_exactly(const cases::Variant& v, const Cases& asked) {
  const auto results = v.format.as<oracle::Format>();
  const bool saturates = cases::is_function(v.operation) || v.operation == Operation::sqrt;
  each_case_in(v, asked, [&](const Operands& in) -> Result {
    const auto words = std::span(in).first(cases::operands_of(v));
    const auto exact = cases::exact_value(v, words).value;
    if (!exact) {
      if (!saturates) return std::nullopt;
      return oracle::saturate(outside_domain(v.operation, words[0] == 0, results), results);
    }
    const oracle::Integer ulps = cases::to_ulps(*exact, oracle::Rounding::half_up, v.format);
    return saturates ? oracle::saturate(ulps, results) : oracle::wrap(ulps, results);
  });
}

bool is_of_type_mixed(const cases::Variant& v) {
  const auto is_mixed = [](const cases::Format& format) {
    return with_number_in(
        format, [](auto /*type*/) {}, Mixed());
  };
  return has_mixed(v.operation) && is_mixed(*v.from) && is_mixed(v.format);
}

void answer_mixed_by_type(const cases::Variant& v, const Cases& asked) {
  const auto answer = [&]<class From, class To>(std::type_identity<From> /*type*/,
                                                std::type_identity<To> /*type*/) {
    if constexpr (!std::is_same_v<From, To>) {
      each_case_in(v, asked, [&](const Operands& in) -> Result {
        const auto result = computed<To>(v.operation, number_from<From>(in[0]),
                                         number_from<From>(in[1]), number_from<From>(in[2]), [] {});
        if (!result) return std::nullopt;
        return bits_of(*result);
      });
    }
  };
  with_number_in(
      *v.from,
      [&](auto from) {
        with_number_in(
            v.format, [&](auto to) { answer(from, to); }, Mixed());
      },
      Mixed());
}

}  // namespace fixproof::parties
