/// @file
/// The functions of fixed/batch/functions.hpp as tags: the function of one number, and the limit of
/// its results.
#pragma once

#include "fixed/angle.hpp"
#include "fixed/exponential.hpp"
#include "fixed/power.hpp"
#include "fixed/trigonometry.hpp"

namespace fixproof::detail {

// No magnitude of a result is above the limit.
struct unlimited {
  static constexpr double limit = 0x1p100;
};
template <int Limit>
struct limited_to {
  static constexpr double limit = Limit;
};

// What the functions of angles have in common in all units.
template <angle_unit Unit>
struct of_sine : limited_to<1> {};
template <angle_unit Unit>
struct of_cosine : limited_to<1> {};
template <angle_unit Unit>
struct of_tangent : unlimited {};

struct of_exp : unlimited {
  static auto scalar(auto x) { return fixproof::exp(x); }
};
struct of_exp2 : unlimited {
  static auto scalar(auto x) { return fixproof::exp2(x); }
};
struct of_expm1 : unlimited {
  static auto scalar(auto x) { return fixproof::expm1(x); }
};
struct of_log : limited_to<32> {
  static auto scalar(auto x) { return fixproof::log(x); }
};
struct of_log2 : limited_to<32> {
  static auto scalar(auto x) { return fixproof::log2(x); }
};
struct of_log10 : limited_to<32> {
  static auto scalar(auto x) { return fixproof::log10(x); }
};
struct of_log1p : limited_to<32> {
  static auto scalar(auto x) { return fixproof::log1p(x); }
};
struct of_sinh : unlimited {
  static auto scalar(auto x) { return fixproof::sinh(x); }
};
struct of_cosh : unlimited {
  static auto scalar(auto x) { return fixproof::cosh(x); }
};
struct of_tanh : limited_to<1> {
  static auto scalar(auto x) { return fixproof::tanh(x); }
};
struct of_sin : of_sine<angle_unit::radian> {
  static auto scalar(auto x) { return fixproof::sin(x); }
};
struct of_cos : of_cosine<angle_unit::radian> {
  static auto scalar(auto x) { return fixproof::cos(x); }
};
struct of_tan : of_tangent<angle_unit::radian> {
  static auto scalar(auto x) { return fixproof::tan(x); }
};
struct of_sin_of_degrees : of_sine<angle_unit::degree> {
  static auto scalar(auto x) { return fixproof::sin_of_degrees(x); }
};
struct of_cos_of_degrees : of_cosine<angle_unit::degree> {
  static auto scalar(auto x) { return fixproof::cos_of_degrees(x); }
};
struct of_tan_of_degrees : of_tangent<angle_unit::degree> {
  static auto scalar(auto x) { return fixproof::tan_of_degrees(x); }
};
struct of_sin_of_turns : of_sine<angle_unit::turn> {
  static auto scalar(auto x) { return fixproof::sin_of_turns(x); }
};
struct of_cos_of_turns : of_cosine<angle_unit::turn> {
  static auto scalar(auto x) { return fixproof::cos_of_turns(x); }
};
struct of_tan_of_turns : of_tangent<angle_unit::turn> {
  static auto scalar(auto x) { return fixproof::tan_of_turns(x); }
};
struct of_atan : limited_to<2> {
  static auto scalar(auto x) { return fixproof::atan(x); }
};
struct of_asin : limited_to<2> {
  static auto scalar(auto x) { return fixproof::asin(x); }
};
struct of_acos : limited_to<4> {
  static auto scalar(auto x) { return fixproof::acos(x); }
};
struct of_cbrt : unlimited {
  static auto scalar(auto x) { return fixproof::cbrt(x); }
};
struct of_rsqrt : unlimited {
  static auto scalar(auto x) { return fixproof::rsqrt(x); }
};
struct of_reciprocal : unlimited {
  static auto scalar(auto x) { return fixproof::reciprocal(x); }
};
struct of_atan2 : limited_to<4> {
  static auto scalar(auto y, auto x) { return fixproof::atan2(y, x); }
};
struct of_hypot : unlimited {
  static auto scalar(auto x, auto y) { return fixproof::hypot(x, y); }
};
struct of_pow : unlimited {
  static auto scalar(auto x, auto y) { return fixproof::pow(x, y); }
};

}  // namespace fixproof::detail
