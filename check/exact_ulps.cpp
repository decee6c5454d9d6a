#include "check/exact_ulps.hpp"

#include <stdexcept>

#include "check/word.hpp"
#include "oracle/fast.hpp"
#include "oracle/format.hpp"

namespace fixproof::check {

namespace {

[[noreturn]] void refuse_operation() {
  throw std::invalid_argument("only mul, div, sqrt, add and sub are judged");
}

}  // namespace

std::optional<oracle::Integer> exact_ulps(cases::Operation operation, const cases::Format& format,
                                          std::span<const std::uint64_t> words,
                                          oracle::Rounding rule) {
  const oracle::Format wide = oracle_format(format);
  switch (operation) {
    case cases::Operation::mul:
      return oracle::exact_product(words[0], words[1], rule, wide);
    case cases::Operation::div:
      return oracle::exact_quotient(words[0], words[1], rule, wide);
    case cases::Operation::sqrt:
      return oracle::exact_root(words[0], rule, wide);
    case cases::Operation::add:
      return oracle::ulps(words[0], wide) + oracle::ulps(words[1], wide);
    case cases::Operation::sub:
      return oracle::ulps(words[0], wide) - oracle::ulps(words[1], wide);
    default:
      refuse_operation();
  }
}

std::optional<std::int64_t> narrow_ulps(cases::Operation operation,
                                        std::span<const std::uint64_t> words,
                                        oracle::Rounding rule) {
  const auto a = static_cast<std::uint32_t>(words[0]);
  const auto b = static_cast<std::uint32_t>(words.back());
  switch (operation) {
    case cases::Operation::mul:
      return oracle::fast::exact_product(a, b, rule, 16);
    case cases::Operation::div:
      return oracle::fast::exact_quotient(a, b, rule, 16);
    case cases::Operation::sqrt:
      return oracle::fast::exact_root(a, rule, 16);
    case cases::Operation::add:
      return oracle::fast::exact_sum(a, b, 16);
    case cases::Operation::sub:
      return oracle::fast::exact_difference(a, b, 16);
    default:
      refuse_operation();
  }
}

}  // namespace fixproof::check
