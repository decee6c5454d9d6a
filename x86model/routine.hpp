/// @file
/// The routines, their processors, and their assembled programs.
#pragma once

#include <cstdint>

#include "x86model/assemble.hpp"
#include "x86model/routines/concat_xforms.hpp"
#include "x86model/routines/cos_sin.hpp"
#include "x86model/routines/fixed_div.hpp"
#include "x86model/routines/fixed_mul.hpp"
#include "x86model/routines/xform_vec.hpp"

namespace x86model {

enum class Routine : std::uint8_t { mul, div, cossin, xformvec, concat };
inline constexpr int routine_count = 5;

/// The printed routine for one processor, followed by FixedMul if it calls FixedMul.
constexpr const Listing& listing(Routine routine, Target target) {
  const bool i386 = target == Target::i386;
  switch (routine) {
    case Routine::mul:
      return i386 ? routines::fixed_mul_i386 : routines::fixed_mul_i8088;
    case Routine::div:
      return i386 ? routines::fixed_div_i386 : routines::fixed_div_i8088;
    case Routine::cossin:
      return i386 ? routines::cos_sin_i386 : routines::cos_sin_i8088;
    case Routine::xformvec:
      return i386 ? routines::xform_vec_i386 : routines::xform_vec_i8088;
    case Routine::concat:
      break;
  }
  return i386 ? routines::concat_xforms_i386 : routines::concat_xforms_i8088;
}

/// The number of operands and results of a routine. Each is 2 machine words, except CosSin's angle,
/// which is one.
struct Arity {
  int in;
  int out;
};
constexpr Arity arity(Routine routine) {
  switch (routine) {
    case Routine::mul:
    case Routine::div:
      return {2, 1};
    case Routine::cossin:
      return {1, 2};
    case Routine::xformvec:
      return {15, 3};
    case Routine::concat:
      break;
  }
  return {24, 12};
}

/// The program of a routine, assembled at compile time.
template <Routine routine, Target target, Build build>
inline constexpr Program program = assemble(listing(routine, target), build);

}  // namespace x86model
