#include "judge/code/abstract_functions.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <optional>

#include "x86model/symbolic/evaluate.hpp"

namespace fixproof::judge {

namespace {

__extension__ using Unsigned128 = unsigned __int128;
__extension__ using Signed128 = __int128;

std::int64_t as_signed(std::uint64_t word) { return static_cast<std::int64_t>(word); }
std::uint64_t low_word(Unsigned128 value) { return static_cast<std::uint64_t>(value); }
std::uint64_t high_word(Unsigned128 value) { return static_cast<std::uint64_t>(value >> 64U); }

struct Division {
  std::uint64_t quotient;
  std::uint64_t remainder;
};

/// Nothing if DIV faults.
std::optional<Division> unsigned_division(Unsigned128 n, std::uint64_t d) {
  if (high_word(n) >= d) return std::nullopt;
  return Division{low_word(n / d), low_word(n % d)};
}

/// Nothing if IDIV faults.
std::optional<Division> signed_division(Signed128 n, std::int64_t d) {
  using Limits = std::numeric_limits<std::int64_t>;
  // -n may not fit, but then the quotient by -1 does not either.
  if (d == 0 || (d == -1 && n < -Signed128{Limits::max()})) return std::nullopt;
  const Signed128 quotient = n / d;
  if (quotient < Limits::min() || quotient > Limits::max()) return std::nullopt;
  return Division{low_word(static_cast<Unsigned128>(quotient)),
                  low_word(static_cast<Unsigned128>(n % d))};
}

/// A function in SMT-LIB.
struct Definition {
  const char* name;
  int arguments;      ///< words of 64 bits, called x, y and z
  const char* sort;   ///< of the result
  const char* value;  ///< in exact arithmetic
};
constexpr const char* word_sort = "(_ BitVec 64)";
constexpr std::array definitions{
    Definition{low_product_64, 2, word_sort, "(bvmul x y)"},
    Definition{unsigned_high_product_64, 2, word_sort,
               "((_ extract 127 64) (bvmul ((_ zero_extend 64) x) ((_ zero_extend 64) y)))"},
    Definition{signed_high_product_64, 2, word_sort,
               "((_ extract 127 64) (bvmul ((_ sign_extend 64) x) ((_ sign_extend 64) y)))"},
    Definition{quotient_64, 2, word_sort, "(bvsdiv x y)"},
    Definition{remainder_64, 2, word_sort, "(bvsrem x y)"},
    Definition{unsigned_quotient_64, 2, word_sort, "(bvudiv x y)"},
    Definition{unsigned_remainder_64, 2, word_sort, "(bvurem x y)"},
    Definition{unsigned_quotient_128, 3, word_sort,
               "((_ extract 63 0) (bvudiv (concat x y) ((_ zero_extend 64) z)))"},
    Definition{unsigned_remainder_128, 3, word_sort,
               "((_ extract 63 0) (bvurem (concat x y) ((_ zero_extend 64) z)))"},
    Definition{signed_quotient_128, 3, word_sort,
               "((_ extract 63 0) (bvsdiv (concat x y) ((_ sign_extend 64) z)))"},
    Definition{signed_remainder_128, 3, word_sort,
               "((_ extract 63 0) (bvsrem (concat x y) ((_ sign_extend 64) z)))"},
    // The one quotient that does not fit 128 bits is -2^127, which is no extension of its low word.
    Definition{signed_quotient_overflows_128, 3, "Bool",
               "(or (= z (_ bv0 64)) (not (= (bvsdiv (concat x y) ((_ sign_extend 64) z)) "
               "((_ sign_extend 64) (sdiv128 x y z)))))"}};

}  // namespace

std::uint64_t concrete_function(const std::string& name, std::span<const std::uint64_t> arguments) {
  const std::uint64_t x = arguments[0];
  const std::uint64_t y = arguments.size() > 1 ? arguments[1] : 0;
  const std::uint64_t z = arguments.size() > 2 ? arguments[2] : 0;
  if (name == low_product_64) return x * y;
  if (name == unsigned_high_product_64) return high_word(Unsigned128{x} * y);
  if (name == signed_high_product_64) {
    return high_word(static_cast<Unsigned128>(Signed128{as_signed(x)} * as_signed(y)));
  }
  const auto part = [&](const std::optional<Division>& division, const char* quotient) {
    return !division ? 0 : name == quotient ? division->quotient : division->remainder;
  };
  if (name == quotient_64 || name == remainder_64) {
    return part(signed_division(as_signed(x), as_signed(y)), quotient_64);
  }
  if (name == unsigned_quotient_64 || name == unsigned_remainder_64) {
    return part(unsigned_division(x, y), unsigned_quotient_64);
  }
  const Unsigned128 wide = Unsigned128{x} << 64U | y;
  if (name == unsigned_quotient_128 || name == unsigned_remainder_128) {
    return part(unsigned_division(wide, z), unsigned_quotient_128);
  }
  const auto is_signed_128 = {signed_quotient_128, signed_remainder_128,
                              signed_quotient_overflows_128};
  for (const char* const each : is_signed_128) {
    if (name != each) continue;
    const auto division = signed_division(static_cast<Signed128>(wide), as_signed(z));
    if (each == signed_quotient_overflows_128) return division ? 0 : 1;
    return part(division, signed_quotient_128);
  }
  return x86model::symbolic::concrete(name, arguments);
}

std::string declare_functions(proof::Arithmetic arithmetic) {
  std::string text;
  for (const Definition& each : definitions) {
    const bool is_exact = arithmetic == proof::Arithmetic::exact;
    std::string arguments;
    for (int i = 0; i < each.arguments; ++i) {
      if (i > 0) arguments += ' ';
      arguments += is_exact ? fmt::format("({} {})", "xyz"[i], word_sort) : word_sort;
    }
    text += is_exact ? fmt::format("(define-fun {} ({}) {} {})\n", each.name, arguments, each.sort,
                                   each.value)
                     : fmt::format("(declare-fun {} ({}) {})\n", each.name, arguments, each.sort);
  }
  return text;
}

}  // namespace fixproof::judge
