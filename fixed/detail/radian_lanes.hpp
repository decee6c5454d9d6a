/// \file
/// detail::nearest_sine() on vector registers.
///
/// fixed/batch_radian.hpp includes this file once for each instruction set: FIXED_RADIAN_LANES is
/// the namespace, FIXED_RADIAN_BYTES the size of a register, FIXED_RADIAN_FUNCTION what makes the
/// compiler use the instructions in a function. Every function here has to carry that attribute,
/// which is why these are no templates on the instruction set.
///
/// A block is one register of 32-bit lanes, also for 8.8, whose stored integers are widened when
/// loaded. Its even and its odd lanes are calculated in a register of 64-bit lanes each.

#if defined(FIXED_RADIAN_LANES)
namespace fixed::detail::FIXED_RADIAN_LANES {

inline constexpr std::size_t width = FIXED_RADIAN_BYTES / 4;

using i32 [[gnu::vector_size(FIXED_RADIAN_BYTES)]] = std::int32_t;
using u64 [[gnu::vector_size(FIXED_RADIAN_BYTES)]] = std::uint64_t;
using narrow_i16 [[gnu::vector_size(FIXED_RADIAN_BYTES / 2)]] = std::int16_t;

// product(a, b)           of the lower halves of 64-bit lanes
// signed_product(a, b)    the same, as signed integers
// interleaved(even, odd)  the lower halves of one, the upper halves of the other
// any_zero(x)             whether a lane is zero
// unknown(x)              x, of which the compiler knows nothing: where clang can prove that
//                         operands have 32 bits it forgets it, and multiplies 64 in three products

#if FIXED_RADIAN_BYTES == 64

// The forms with a full mask: without one, g++ 12 warns of undefined values in its own headers.
FIXED_RADIAN_FUNCTION u64 product(u64 a, u64 b) {
  return u64(_mm512_maskz_mul_epu32(0xff, __m512i(a), __m512i(b)));
}
FIXED_RADIAN_FUNCTION u64 signed_product(u64 a, u64 b) {
  return u64(_mm512_maskz_mul_epi32(0xff, __m512i(a), __m512i(b)));
}
FIXED_RADIAN_FUNCTION i32 interleaved(u64 even, u64 odd) {
  return i32(_mm512_mask_blend_epi32(0xaaaa, __m512i(even), __m512i(odd)));
}
FIXED_RADIAN_FUNCTION bool any_zero(i32 x) {
  return _mm512_testn_epi32_mask(__m512i(x), __m512i(x)) != 0;
}
FIXED_RADIAN_FUNCTION u64 unknown(u64 x) {
  asm("" : "+v"(x));
  return x;
}

#elif FIXED_RADIAN_BYTES == 32

FIXED_RADIAN_FUNCTION u64 product(u64 a, u64 b) {
  return u64(_mm256_mul_epu32(__m256i(a), __m256i(b)));
}
FIXED_RADIAN_FUNCTION u64 signed_product(u64 a, u64 b) {
  return u64(_mm256_mul_epi32(__m256i(a), __m256i(b)));
}
FIXED_RADIAN_FUNCTION i32 interleaved(u64 even, u64 odd) {
  return i32(_mm256_blend_epi32(__m256i(even), __m256i(odd), 0xaa));
}
FIXED_RADIAN_FUNCTION bool any_zero(i32 x) { return _mm256_movemask_ps(__m256(x == 0)) != 0; }
FIXED_RADIAN_FUNCTION u64 unknown(u64 x) {
  asm("" : "+x"(x));
  return x;
}

#else

FIXED_RADIAN_FUNCTION u64 product(u64 a, u64 b) {
  return u64(vmull_u32(vmovn_u64(uint64x2_t(a)), vmovn_u64(uint64x2_t(b))));
}
FIXED_RADIAN_FUNCTION u64 signed_product(u64 a, u64 b) {
  return u64(vmull_s32(vmovn_s64(int64x2_t(a)), vmovn_s64(int64x2_t(b))));
}
FIXED_RADIAN_FUNCTION i32 interleaved(u64 even, u64 odd) {
  return i32(vbslq_u64(uint64x2_t(u64{} + 0xffffffff), uint64x2_t(even), uint64x2_t(odd)));
}
FIXED_RADIAN_FUNCTION bool any_zero(i32 x) { return vminvq_u32(uint32x4_t(x)) == 0; }
FIXED_RADIAN_FUNCTION u64 unknown(u64 x) { return x; }

#endif

template <int F>
FIXED_RADIAN_FUNCTION i32 load(const raw_t<F>* from) {
  if constexpr (F == 16) {
    i32 x;
    __builtin_memcpy(&x, from, sizeof x);
    return x;
  } else {
    narrow_i16 x;
    __builtin_memcpy(&x, from, sizeof x);
    return __builtin_convertvector(x, i32) << 8;
  }
}

template <int F>
FIXED_RADIAN_FUNCTION void store(raw_t<F>* to, i32 x) {
  if constexpr (F == 16) {
    __builtin_memcpy(to, &x, sizeof x);
  } else {
    const narrow_i16 low = __builtin_convertvector(x, narrow_i16);
    __builtin_memcpy(to, &low, sizeof low);
  }
}

/// The turns of the angles in the lower halves.
FIXED_RADIAN_FUNCTION u64 turns_of(u64 angle) {
  const u64 lower = signed_product(angle, u64{} + (turns_of_unit & 0xffffffff));
  const u64 upper = unknown(signed_product(angle, u64{} + (turns_of_unit >> 32)));
  return lower + (upper << 32) + turns_bias;
}

/// detail::quick_cosine().
FIXED_RADIAN_FUNCTION u64 quick_cosine_of(u64 d) {
  const u64 z = unknown(signed_product(d, d) >> 31);
  u64 factor = quick_coefficients[4] - (product(z, u64{} + quick_coefficients[5]) >> 31);
  factor = quick_coefficients[3] - (product(z, factor) >> 31);
  factor = quick_coefficients[2] - (product(z, factor) >> 31);
  factor = quick_coefficients[1] - (product(z, factor) >> 32);
  return quick_coefficients[0] - product(z, factor);
}

/// The sines of a block whose turns these are; `doubtful` is set if one of them may be wrong.
template <int F>
FIXED_RADIAN_FUNCTION i32 sines_of(u64 even, u64 odd, bool& doubtful) {
  using rounding = quick_rounding<F>;
  const i32 sign = interleaved(even >> 32, odd) >> 31;
  even = quick_cosine_of((even - quarter_turn) >> 31) + rounding::bias;
  odd = quick_cosine_of((odd - quarter_turn) >> 31) + rounding::bias;
  // The bits of quick_rounding::doubtful, brought into 32.
  constexpr int unneeded = 34;
  constexpr auto mask = static_cast<std::int32_t>(rounding::doubtful >> unneeded);
  doubtful |= any_zero(interleaved(even >> unneeded, odd >> (unneeded - 32)) & mask);
  const i32 magnitude = interleaved(even >> rounding::dropped, odd >> (rounding::dropped - 32));
  return (magnitude ^ sign) - sign;
}

/// Whole blocks of nearest_sine() from the first on.
/// \return how many elements they are
template <int F>
FIXED_RADIAN_TARGET std::size_t sines(const raw_t<F>* angles, raw_t<F>* results, std::size_t count,
                                      std::uint64_t ahead) {
  std::size_t i = 0;
  for (; i + width <= count; i += width) {
    const i32 x = load<F>(angles + i);
    bool doubtful = false;
    const i32 y = sines_of<F>(turns_of(u64(x)) + ahead, turns_of(u64(x) >> 32) + ahead, doubtful);
    if (!doubtful) [[likely]] {
      store<F>(results + i, y);
    } else {
      nearest_sines<F>(angles + i, results + i, width, ahead);
    }
  }
  return i;
}

/// As sines(), of cosines and sines; `cosines` may be where the angles are.
template <int F>
FIXED_RADIAN_TARGET std::size_t both(const raw_t<F>* angles, raw_t<F>* cosines, raw_t<F>* sines,
                                     std::size_t count) {
  std::size_t i = 0;
  for (; i + width <= count; i += width) {
    const i32 x = load<F>(angles + i);
    const u64 even = turns_of(u64(x));
    const u64 odd = turns_of(u64(x) >> 32);
    bool doubtful = false;
    const i32 sin = sines_of<F>(even, odd, doubtful);
    const i32 cos = sines_of<F>(even + quarter_turn, odd + quarter_turn, doubtful);
    if (!doubtful) [[likely]] {
      store<F>(sines + i, sin);
      store<F>(cosines + i, cos);
    } else {
      nearest_of_both<F>(angles + i, cosines + i, sines + i, width);
    }
  }
  return i;
}

}  // namespace fixed::detail::FIXED_RADIAN_LANES
#endif
