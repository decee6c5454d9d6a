/// @file
/// The functions in formats of up to 64 bits by the C interface of MPFR, which rounds each of them
/// correctly and says whether a result is exact.
#pragma once

#include <mpfr.h>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "oracle/function.hpp"

namespace mpfr_result {

using oracle::Function;

/// Whether this MPFR has angles in degrees and turns, and powers of ten (from 4.2 on).
inline constexpr bool has_units = MPFR_VERSION >= MPFR_VERSION_NUM(4, 2, 0);

/// A variable of MPFR.
class Real {
 public:
  explicit Real(mpfr_prec_t bits) { mpfr_init2(value_, bits); }
  ~Real() { mpfr_clear(value_); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  Real(Real&&) = delete;
  Real& operator=(Real&&) = delete;
  operator mpfr_ptr() { return value_; }  // NOLINT(google-explicit-constructor)

 private:
  mpfr_t value_;  // NOLINT(*-avoid-c-arrays): the type of MPFR
};

/// A format at run time. Words are its stored integers, extended to 64 bits.
struct LongFormat {
  int fraction_bits;
  bool is_signed;
  int bits = 64;
};

/// The words of results. One object keeps its variables for many of them.
class Results {
 public:
  /// @param rounding to nearest, down, up or toward zero
  explicit Results(LongFormat format, mpfr_rnd_t rounding = MPFR_RNDN)
      : format_(format), rounding_(rounding) {
    mpfr_set_emin(mpfr_get_emin_min());
    mpfr_set_emax(mpfr_get_emax_max());
    const std::uint64_t most = ~std::uint64_t{0} >> (64 - format.bits);
    put(highest_, format.is_signed ? most >> 1 : most, 0);
    put(lowest_, format.is_signed ? ~(most >> 1) : 0, 0);
  }

  /// The word of the result, saturated, ties up; empty outside the domain.
  /// @throws std::runtime_error for an irrational result that is within 2^-180 ulps of a tie
  std::optional<std::uint64_t> of(Function function, std::uint64_t x, std::uint64_t y) {
    put(x_, x, format_.fraction_bits);
    put(y_, y, format_.fraction_bits);
    const int over = compute(function);
    const bool is_exact = over == 0;
    if (mpfr_number_p(value_) == 0) return std::nullopt;
    mpfr_mul_2si(value_, value_, format_.fraction_bits, MPFR_RNDN);
    if (mpfr_cmp(value_, highest_) >= 0) return word_of(highest_);
    if (mpfr_cmp(value_, lowest_) <= 0) return word_of(lowest_);
    if (rounding_ != MPFR_RNDN) return bound(over);
    mpfr_add_d(sum_, value_, 0.5, MPFR_RNDN);
    mpfr_floor(whole_, sum_);
    mpfr_sub(sum_, sum_, whole_, MPFR_RNDN);
    if (!is_exact && (mpfr_cmp_d(sum_, 0x1p-180) < 0 || mpfr_cmp_d(sum_, 1 - 0x1p-53) > 0)) {
      mpfr_ui_sub(sum_, 1, sum_, MPFR_RNDN);
      const bool is_above = mpfr_cmp_d(sum_, 0.5) < 0;
      if (!is_above || mpfr_cmp_d(sum_, 0x1p-180) < 0) {
        throw std::runtime_error("MPFR does not decide");
      }
    }
    return word_of(whole_);
  }

 private:
  /// The word below or above the value. @param over the sign of the value less the exact result
  std::uint64_t bound(int over) {
    const bool is_negative =
        mpfr_sgn(mpfr_ptr(value_)) < 0 || (mpfr_zero_p(mpfr_ptr(value_)) != 0 && over > 0);
    const bool is_up = rounding_ == MPFR_RNDU || (rounding_ == MPFR_RNDZ && is_negative);
    const bool is_whole = mpfr_integer_p(mpfr_ptr(value_)) != 0;
    if (is_up) {
      mpfr_ceil(whole_, value_);
      if (is_whole && over < 0) mpfr_add_ui(whole_, whole_, 1, MPFR_RNDN);
    } else {
      mpfr_floor(whole_, value_);
      if (is_whole && over > 0) mpfr_sub_ui(whole_, whole_, 1, MPFR_RNDN);
    }
    if (mpfr_cmp(whole_, highest_) > 0) return word_of(highest_);
    return word_of(mpfr_cmp(whole_, lowest_) < 0 ? mpfr_ptr(lowest_) : mpfr_ptr(whole_));
  }

  void put(mpfr_ptr to, std::uint64_t word, int places) const {
    if (format_.is_signed) {
      mpfr_set_sj(to, static_cast<std::int64_t>(word), MPFR_RNDN);
    } else {
      mpfr_set_uj(to, word, MPFR_RNDN);
    }
    mpfr_div_2si(to, to, places, MPFR_RNDN);
  }

  std::uint64_t word_of(mpfr_ptr whole) const {
    return format_.is_signed ? static_cast<std::uint64_t>(mpfr_get_sj(whole, MPFR_RNDN))
                             : mpfr_get_uj(whole, MPFR_RNDN);
  }

  /// 0 if the result is exact.
  int compute(Function function) {
    const auto by = [&](auto of_one) { return of_one(value_, x_, MPFR_RNDN); };
    const auto in = [&](auto of_unit, unsigned long turn) {
      return of_unit(value_, x_, turn, MPFR_RNDN);
    };
    switch (function) {
      case Function::exp2:
        return by(mpfr_exp2);
      case Function::exp:
        return by(mpfr_exp);
      case Function::expm1:
        return by(mpfr_expm1);
      case Function::log2:
        return by(mpfr_log2);
      case Function::log:
        return by(mpfr_log);
      case Function::log10:
        return by(mpfr_log10);
      case Function::log1p:
        return by(mpfr_log1p);
      case Function::sinh:
        return by(mpfr_sinh);
      case Function::cosh:
        return by(mpfr_cosh);
      case Function::tanh:
        return by(mpfr_tanh);
      case Function::sin:
        return by(mpfr_sin);
      case Function::cos:
        return by(mpfr_cos);
      case Function::tan:
        return by(mpfr_tan);
      case Function::asin:
        return by(mpfr_asin);
      case Function::acos:
        return by(mpfr_acos);
      case Function::atan:
        return by(mpfr_atan);
      case Function::cbrt:
        return by(mpfr_cbrt);
      case Function::rsqrt:
        return by(mpfr_rec_sqrt);
      case Function::reciprocal:
        return mpfr_ui_div(value_, 1, x_, MPFR_RNDN);
      case Function::exp10:
        return by(mpfr_exp10);
      case Function::asinh:
        return by(mpfr_asinh);
      case Function::acosh:
        return by(mpfr_acosh);
      case Function::atanh:
        return by(mpfr_atanh);
      case Function::atan2:
        return mpfr_atan2(value_, x_, y_, MPFR_RNDN);
      case Function::hypot:
        return mpfr_hypot(value_, x_, y_, MPFR_RNDN);
      case Function::pow:
        return mpfr_pow(value_, x_, y_, MPFR_RNDN);
#if MPFR_VERSION >= MPFR_VERSION_NUM(4, 2, 0)
      case Function::sin_of_degrees:
        return in(mpfr_sinu, 360);
      case Function::cos_of_degrees:
        return in(mpfr_cosu, 360);
      case Function::tan_of_degrees:
        return in(mpfr_tanu, 360);
      case Function::sin_of_turns:
        return in(mpfr_sinu, 1);
      case Function::cos_of_turns:
        return in(mpfr_cosu, 1);
      case Function::tan_of_turns:
        return in(mpfr_tanu, 1);
      case Function::asin_in_degrees:
        return in(mpfr_asinu, 360);
      case Function::acos_in_degrees:
        return in(mpfr_acosu, 360);
      case Function::atan_in_degrees:
        return in(mpfr_atanu, 360);
      case Function::asin_in_turns:
        return in(mpfr_asinu, 1);
      case Function::acos_in_turns:
        return in(mpfr_acosu, 1);
      case Function::atan_in_turns:
        return in(mpfr_atanu, 1);
      case Function::atan2_in_degrees:
        return mpfr_atan2u(value_, x_, y_, 360, MPFR_RNDN);
      case Function::atan2_in_turns:
        return mpfr_atan2u(value_, x_, y_, 1, MPFR_RNDN);
#endif
      default:
        mpfr_set_nan(value_);
        return 0;
    }
  }

  static constexpr mpfr_prec_t precision = 320;

  LongFormat format_;
  mpfr_rnd_t rounding_;
  Real x_{64};
  Real y_{64};
  Real value_{precision};
  Real sum_{precision + 128};
  Real whole_{precision + 128};
  Real highest_{64};
  Real lowest_{64};
};

}  // namespace mpfr_result
