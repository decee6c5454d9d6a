/// @file
/// Numbers as the scalars of Eigen 3.4 and later. This header includes `<Eigen/Core>`, and
/// fixed/fixed.hpp does not include it. docs/libraries.md says what works.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <type_traits>

#include "fixed/detail/storage.hpp"
#include "fixed/limits.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"
#include "fixed/sine.hpp"

/// What Eigen leaves to the authors of scalar types.
namespace Eigen {

/// What Eigen asks about a scalar type. Eigen finds abs, sqrt, floor and the other functions by
/// argument-dependent lookup.
template <class Raw, int FractionBits, fixproof::policy Rules>
struct NumTraits<fixproof::number<Raw, FractionBits, Rules>>
    : GenericNumTraits<fixproof::number<Raw, FractionBits, Rules>> {
  static_assert(FractionBits < std::numeric_limits<Raw>::digits,
                "Eigen multiplies by 1, which this number type cannot represent");

  /// The number type.
  using number = fixproof::number<Raw, FractionBits, Rules>;
  /// Results that need a fraction have the same type, also without fraction bits.
  using NonInteger = number;

  /// Costs in the units of Eigen, where reading a float costs 1.
  enum {
    AddCost = Rules.range == fixproof::overflow::wrap ? 1 : 3,
    MulCost = (fixproof::detail::bits_of<Raw> < 64 ? 3 : 12) + AddCost,
  };

  /// The highest number.
  static constexpr number highest() noexcept { return (std::numeric_limits<number>::max)(); }
  /// The lowest number.
  static constexpr number lowest() noexcept { return std::numeric_limits<number>::lowest(); }
};

/// A matrix or array times an integer, which has its exact value.
template <class Raw, int FractionBits, fixproof::policy Rules, fixproof::detail::integer Int>
struct ScalarBinaryOpTraits<
    fixproof::number<Raw, FractionBits, Rules>, Int,
    internal::scalar_product_op<fixproof::number<Raw, FractionBits, Rules>, Int>> {
  /// The type of the product.
  using ReturnType = fixproof::number<Raw, FractionBits, Rules>;
};

/// An integer times a matrix or array.
template <class Raw, int FractionBits, fixproof::policy Rules, fixproof::detail::integer Int>
struct ScalarBinaryOpTraits<
    Int, fixproof::number<Raw, FractionBits, Rules>,
    internal::scalar_product_op<Int, fixproof::number<Raw, FractionBits, Rules>>> {
  /// The type of the product.
  using ReturnType = fixproof::number<Raw, FractionBits, Rules>;
};

/// A matrix or array divided by an integer.
template <class Raw, int FractionBits, fixproof::policy Rules, fixproof::detail::integer Int>
struct ScalarBinaryOpTraits<
    fixproof::number<Raw, FractionBits, Rules>, Int,
    internal::scalar_quotient_op<fixproof::number<Raw, FractionBits, Rules>, Int>> {
  /// The type of the quotient.
  using ReturnType = fixproof::number<Raw, FractionBits, Rules>;
};

}  // namespace Eigen
