/// @file
/// Vector registers, and the instructions that the compiler's vector types do not cover.
///
/// fixed/batch/detail/parts.hpp includes this file once per instruction set. FIXED_LANES is the
/// namespace, FIXED_LANE_BYTES the register size in bytes (16 NEON, 32 AVX2, 64 AVX-512), and
/// FIXED_LANE_TARGET the attribute that enables the instructions in a function. Every function here
/// needs that attribute, so templates on the instruction set are not possible.
///
/// A block is `width` elements in one register of 32-bit lanes. Loads widen stored integers of 16
/// bits. A register of 64-bit values holds the even lanes, the odd lanes, or half a block.

#if defined(FIXED_LANES)
#define FIXED_LANE_FUNCTION FIXED_LANE_TARGET __attribute__((always_inline)) inline

namespace fixproof::detail::FIXED_LANES {

inline constexpr std::size_t width = FIXED_LANE_BYTES / 4;

using i32 [[gnu::vector_size(FIXED_LANE_BYTES)]] = std::int32_t;
using u32 [[gnu::vector_size(FIXED_LANE_BYTES)]] = std::uint32_t;
using i64 [[gnu::vector_size(FIXED_LANE_BYTES)]] = std::int64_t;
using u64 [[gnu::vector_size(FIXED_LANE_BYTES)]] = std::uint64_t;
using f64 [[gnu::vector_size(FIXED_LANE_BYTES)]] = double;
using f32 [[gnu::vector_size(FIXED_LANE_BYTES)]] = float;
using half_i32 [[gnu::vector_size(FIXED_LANE_BYTES / 2)]] = std::int32_t;
using half_u32 [[gnu::vector_size(FIXED_LANE_BYTES / 2)]] = std::uint32_t;
using narrow_i16 [[gnu::vector_size(FIXED_LANE_BYTES / 2)]] = std::int16_t;
using half_narrow_i16 [[gnu::vector_size(FIXED_LANE_BYTES / 4)]] = std::int16_t;

/// A 64-bit lane for each 32-bit lane: the even ones first, then the odd ones. On NEON, which
/// multiplies adjacent lanes, the lower half first, then the upper half.
struct wide_lanes {
  i64 first;
  i64 second;
};

/// One integer per lane.
using lane_array = std::array<std::int32_t, width>;

FIXED_LANE_FUNCTION i32 lanes(const lane_array& values) {
  i32 x;
  __builtin_memcpy(&x, &values, sizeof x);
  return x;
}

// products(a, b)        products of all lanes, in wide lanes
// products_by(x, b)     the same; all lanes of x are equal
// upper_words(x)        the upper halves of wide lanes
// mul_even(a, b)        products of the lower halves, in 64-bit lanes, signed or unsigned by type
// unknown(x)            x in a register, hidden from the optimiser. Otherwise clang loses track of
//                       operands that have 32 bits, and multiplies 64 bits in three products;
//                       g++ loads a block again for each use
// negative(x)           all ones in the lanes below zero
// blend<mask>(a, b)     lane i of b if bit i of mask is set, else of a
// permute(x, from)      lane i is x[from[i]]
// permute(x, from, y)   the same, with the lanes of y behind those of x (AVX-512)
// lower, upper, join    the halves of a block
// low_words(x)          the lower halves of 64-bit lanes
// widened(x)            converts to 64-bit lanes
// doubles(x)            converts to double
// bits(x)               the sign bits, one per lane
// any_bit(x)            whether a bit is set
// sum_of(x)             the sum of the lanes, modulo 2^64
// zero_bits(x)          one bit per lane, set if the lane is zero
// bits_at_least(a, b)   one bit per lane, set if a >= b
// bits_below(a, b)      one bit per lane, set if a < b
// clamp(x, low, high)   x limited to [low, high]
// root(x)               the square root, rounded once
// floats(x)             converts to float
// integers(x)           converts to integers, to the nearest or truncated (has_nearest_floats)
// has_nearest_floats    whether floats(), root() of floats and integers() round to nearest, ties to
//                       even, in every rounding mode of the processor
// whole<by_floor>(x)    floor(x) or trunc(x) for |x| < 2^51, modulo 2^32 in the lower halves, in
//                       every rounding mode
// store_past(to, x)     stores x past the caches, at a multiple of the register size, if there is
//                       such an instruction (can_store_past)
// wait_for_stores()     orders the stores of store_past() before later stores

#if FIXED_LANE_BYTES == 64

// This uses the forms with a full mask, because the others make g++ 12 warn of uninitialised values
// in its own headers.
FIXED_LANE_FUNCTION i64 mul_even(i64 a, i64 b) {
  return i64(_mm512_maskz_mul_epi32(0xff, __m512i(a), __m512i(b)));
}
FIXED_LANE_FUNCTION u64 mul_even(u64 a, u64 b) {
  return u64(_mm512_maskz_mul_epu32(0xff, __m512i(a), __m512i(b)));
}
template <class Lanes>
FIXED_LANE_FUNCTION Lanes unknown(Lanes x) {
  asm("" : "+v"(x));
  return x;
}
/// Selects 16-bit words of two registers: `from` has their numbers, from 32 on for those of b.
FIXED_LANE_FUNCTION i32 words_of(const std::array<std::int16_t, 32>& from, i64 a, i64 b) {
  i32 numbers;
  __builtin_memcpy(&numbers, &from, sizeof numbers);
  return i32(_mm512_permutex2var_epi16(__m512i(a), __m512i(numbers), __m512i(b)));
}
/// The 16-bit words that middle<16>() selects from each pair of registers. Aligned, so that its
/// load crosses no cache line. Not by alignas(i32), which g++ takes for 16 bytes without AVX-512.
alignas(FIXED_LANE_BYTES) inline constexpr std::array<std::int16_t, 32> middle_words = [] {
  std::array<std::int16_t, 32> from{};
  for (std::int16_t i = 0; i < 32; i += 4) {
    const auto at = static_cast<std::size_t>(i);
    from[at] = static_cast<std::int16_t>(i + 1);
    from[at + 1] = static_cast<std::int16_t>(i + 2);
    from[at + 2] = static_cast<std::int16_t>(32 + i + 1);
    from[at + 3] = static_cast<std::int16_t>(32 + i + 2);
  }
  return from;
}();
FIXED_LANE_FUNCTION i32 middle_16(i64 even, i64 odd) { return words_of(middle_words, even, odd); }
/// The 16-bit words that middles() selects, aligned like those.
alignas(FIXED_LANE_BYTES) inline constexpr std::array<std::int16_t, 32> adjacent_middle_words = [] {
  std::array<std::int16_t, 32> from{};
  for (std::size_t i = 0; i < 32; ++i) {
    from[i] = static_cast<std::int16_t>(i / 2 * 4 + 1 + i % 2);
  }
  return from;
}();
/// The 32 bits in the middle of each 64-bit lane, those of `low` first.
FIXED_LANE_FUNCTION i32 middles(i64 low, i64 high) {
  return words_of(adjacent_middle_words, low, high);
}
FIXED_LANE_FUNCTION i64 negative(i64 x) { return x >> 63; }
template <unsigned mask>
FIXED_LANE_FUNCTION i32 blend(i32 a, i32 b) {
  return i32(_mm512_mask_blend_epi32(mask, __m512i(a), __m512i(b)));
}
FIXED_LANE_FUNCTION i32 permute(i32 x, i32 from) {
  return i32(_mm512_maskz_permutexvar_epi32(0xffff, __m512i(from), __m512i(x)));
}
FIXED_LANE_FUNCTION i32 permute(i32 x, i32 from, i32 y) {
  return i32(_mm512_permutex2var_epi32(__m512i(x), __m512i(from), __m512i(y)));
}
FIXED_LANE_FUNCTION half_i32 lower(i32 x) {
  return half_i32(_mm512_maskz_extracti64x4_epi64(0xf, __m512i(x), 0));
}
FIXED_LANE_FUNCTION half_i32 upper(i32 x) {
  return half_i32(_mm512_maskz_extracti64x4_epi64(0xf, __m512i(x), 1));
}
FIXED_LANE_FUNCTION i32 join(half_i32 low, half_i32 high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
}
FIXED_LANE_FUNCTION half_i32 low_words(i64 x) {
  return half_i32(_mm512_maskz_cvtepi64_epi32(0xff, __m512i(x)));
}
// g++ 12 converts halves of the lanes and joins them.
FIXED_LANE_FUNCTION i64 widened(half_i32 x) {
  return i64(_mm512_maskz_cvtepi32_epi64(0xff, __m256i(x)));
}
FIXED_LANE_FUNCTION f64 doubles(half_i32 x) { return _mm512_maskz_cvtepi32_pd(0xff, __m256i(x)); }
FIXED_LANE_FUNCTION std::uint32_t bits(i32 x) { return _mm512_movepi32_mask(__m512i(x)); }
FIXED_LANE_FUNCTION std::uint32_t bits(half_i32 x) { return _mm256_movepi32_mask(__m256i(x)); }
FIXED_LANE_FUNCTION bool any_bit(u64 x) {
  return _mm512_test_epi64_mask(__m512i(x), __m512i(x)) != 0;
}
FIXED_LANE_FUNCTION bool any_of_upper_16_bits(i64 x) {
  return _mm512_test_epi64_mask(__m512i(x), __m512i(i64{} + (std::int64_t{-1} << 48))) != 0;
}
FIXED_LANE_FUNCTION std::uint64_t sum_of(u64 x) {
  x += __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3);
  x += __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5);
  x += __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6);
  return x[0];
}
FIXED_LANE_FUNCTION std::uint32_t zero_bits(i32 x) {
  return _mm512_testn_epi32_mask(__m512i(x), __m512i(x));
}
FIXED_LANE_FUNCTION std::uint32_t zero_bits(half_i32 x) {
  return _mm256_testn_epi32_mask(__m256i(x), __m256i(x));
}
FIXED_LANE_FUNCTION std::uint32_t bits_at_least(f64 a, f64 b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_GE_OQ);
}
FIXED_LANE_FUNCTION std::uint32_t bits_below(f64 a, f64 b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}
FIXED_LANE_FUNCTION f64 clamp(f64 x, f64 low, f64 high) {
  return _mm512_maskz_min_pd(0xff, _mm512_maskz_max_pd(0xff, x, low), high);
}
FIXED_LANE_FUNCTION f64 root(f64 x) { return _mm512_maskz_sqrt_pd(0xff, x); }
inline constexpr bool can_store_past = true;
FIXED_LANE_FUNCTION void store_past(void* to, i32 x) {
  _mm512_stream_si512(static_cast<__m512i*>(to), __m512i(x));
}
FIXED_LANE_FUNCTION void wait_for_stores() { _mm_sfence(); }
// Without optimisation, g++ 12 implements these as macros that warn about their mask.
#if !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Woverflow"
#pragma GCC diagnostic ignored "-Wconversion"
#endif
inline constexpr bool has_nearest_floats = true;
FIXED_LANE_FUNCTION f32 floats(i32 x) {
  return _mm512_maskz_cvt_roundepi32_ps(0xffff, __m512i(x),
                                        _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
FIXED_LANE_FUNCTION f32 root(f32 x) {
  return _mm512_maskz_sqrt_round_ps(0xffff, x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
FIXED_LANE_FUNCTION i32 integers(f32 x) {
  return i32(
      _mm512_maskz_cvt_roundps_epi32(0xffff, x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
}
/// x + y, rounded down in every rounding mode of the processor.
FIXED_LANE_FUNCTION f64 sum_down(f64 x, f64 y) {
  return _mm512_maskz_add_round_pd(0xff, x, y, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
template <bool by_floor>
FIXED_LANE_FUNCTION i64 whole(f64 x) {
  if constexpr (by_floor) {
    return i64(_mm512_maskz_cvt_roundpd_epi64(0xff, x, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC));
  } else {
    return i64(_mm512_maskz_cvtt_roundpd_epi64(0xff, x, _MM_FROUND_NO_EXC));
  }
}
#if !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#elif FIXED_LANE_BYTES == 32

FIXED_LANE_FUNCTION i64 mul_even(i64 a, i64 b) {
  return i64(_mm256_mul_epi32(__m256i(a), __m256i(b)));
}
FIXED_LANE_FUNCTION u64 mul_even(u64 a, u64 b) {
  return u64(_mm256_mul_epu32(__m256i(a), __m256i(b)));
}
template <class Lanes>
FIXED_LANE_FUNCTION Lanes unknown(Lanes x) {
  asm("" : "+x"(x));
  return x;
}
FIXED_LANE_FUNCTION i64 negative(i64 x) {
  return i64(_mm256_cmpgt_epi64(_mm256_setzero_si256(), __m256i(x)));
}
template <unsigned mask>
FIXED_LANE_FUNCTION i32 blend(i32 a, i32 b) {
  return i32(_mm256_blend_epi32(__m256i(a), __m256i(b), mask & 0xff));
}
FIXED_LANE_FUNCTION i32 permute(i32 x, i32 from) {
  return i32(_mm256_permutevar8x32_epi32(__m256i(x), __m256i(from)));
}
FIXED_LANE_FUNCTION half_i32 lower(i32 x) { return half_i32(_mm256_castsi256_si128(__m256i(x))); }
FIXED_LANE_FUNCTION half_i32 upper(i32 x) {
  return half_i32(_mm256_extracti128_si256(__m256i(x), 1));
}
FIXED_LANE_FUNCTION i32 join(half_i32 low, half_i32 high) {
  return i32(_mm256_inserti128_si256(_mm256_castsi128_si256(__m128i(low)), __m128i(high), 1));
}
FIXED_LANE_FUNCTION half_i32 low_words(i64 x) {
  const i32 even_first = {0, 2, 4, 6, 0, 2, 4, 6};
  return lower(permute(i32(x), even_first));
}
FIXED_LANE_FUNCTION i64 widened(half_i32 x) { return __builtin_convertvector(x, i64); }
FIXED_LANE_FUNCTION f64 doubles(half_i32 x) { return _mm256_cvtepi32_pd(__m128i(x)); }
FIXED_LANE_FUNCTION std::uint32_t bits(i32 x) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(__m256(x)));
}
FIXED_LANE_FUNCTION std::uint32_t bits(half_i32 x) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(__m128(x)));
}
FIXED_LANE_FUNCTION bool any_bit(u64 x) { return _mm256_testz_si256(__m256i(x), __m256i(x)) == 0; }
FIXED_LANE_FUNCTION std::uint64_t sum_of(u64 x) { return (x[0] + x[2]) + (x[1] + x[3]); }
FIXED_LANE_FUNCTION std::uint32_t zero_bits(i32 x) { return bits(x == 0); }
FIXED_LANE_FUNCTION std::uint32_t zero_bits(half_i32 x) { return bits(x == 0); }
FIXED_LANE_FUNCTION std::uint32_t bits_at_least(f64 a, f64 b) {
  return static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GE_OQ)));
}
FIXED_LANE_FUNCTION std::uint32_t bits_below(f64 a, f64 b) {
  return static_cast<std::uint32_t>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LT_OQ)));
}
FIXED_LANE_FUNCTION f64 clamp(f64 x, f64 low, f64 high) {
  return _mm256_min_pd(_mm256_max_pd(x, low), high);
}
FIXED_LANE_FUNCTION f64 root(f64 x) { return _mm256_sqrt_pd(x); }
inline constexpr bool has_nearest_floats = false;
FIXED_LANE_FUNCTION f32 floats(i32 x) { return __builtin_convertvector(x, f32); }
FIXED_LANE_FUNCTION f32 root(f32 x) { return _mm256_sqrt_ps(x); }
FIXED_LANE_FUNCTION i32 integers(f32 x) { return __builtin_convertvector(x, i32); }
inline constexpr bool can_store_past = true;
FIXED_LANE_FUNCTION void store_past(void* to, i32 x) {
  _mm256_stream_si256(static_cast<__m256i*>(to), __m256i(x));
}
FIXED_LANE_FUNCTION void wait_for_stores() { _mm_sfence(); }
template <bool by_floor>
FIXED_LANE_FUNCTION i64 whole(f64 x) {
  constexpr int mode = by_floor ? _MM_FROUND_TO_NEG_INF : _MM_FROUND_TO_ZERO;
  const f64 integer = _mm256_round_pd(x, mode | _MM_FROUND_NO_EXC);
  // The sum is exact: its last bit has weight one, and the corresponding bits of the constant are
  // zero.
  return i64(integer + 0x1.8p52);
}

#else

FIXED_LANE_FUNCTION wide_lanes products(i32 a, i32 b) {
  const int32x4_t x(a);
  const int32x4_t y(b);
  return {i64(vmull_s32(vget_low_s32(x), vget_low_s32(y))), i64(vmull_high_s32(x, y))};
}
FIXED_LANE_FUNCTION wide_lanes products_by(i32 x, i32 b) { return products(x, b); }
FIXED_LANE_FUNCTION i32 upper_words(wide_lanes x) {
  return i32(vuzp2q_s32(int32x4_t(x.first), int32x4_t(x.second)));
}
FIXED_LANE_FUNCTION i64 mul_even(i64 a, i64 b) {
  return i64(vmull_s32(vmovn_s64(int64x2_t(a)), vmovn_s64(int64x2_t(b))));
}
FIXED_LANE_FUNCTION u64 mul_even(u64 a, u64 b) {
  return u64(vmull_u32(vmovn_u64(uint64x2_t(a)), vmovn_u64(uint64x2_t(b))));
}
template <class Lanes>
FIXED_LANE_FUNCTION Lanes unknown(Lanes x) {
  asm("" : "+w"(x));
  return x;
}
FIXED_LANE_FUNCTION i64 negative(i64 x) { return x >> 63; }
template <unsigned mask>
FIXED_LANE_FUNCTION i32 blend(i32 a, i32 b) {
  const u32 from_b = {mask & 1 ? ~0U : 0U, mask & 2 ? ~0U : 0U, mask & 4 ? ~0U : 0U,
                      mask & 8 ? ~0U : 0U};
  return i32(vbslq_s32(uint32x4_t(from_b), int32x4_t(b), int32x4_t(a)));
}
FIXED_LANE_FUNCTION i32 permute(i32 x, i32 from) {
  return i32{x[from[0]], x[from[1]], x[from[2]], x[from[3]]};
}
FIXED_LANE_FUNCTION half_i32 lower(i32 x) { return half_i32(vget_low_s32(int32x4_t(x))); }
FIXED_LANE_FUNCTION half_i32 upper(i32 x) { return half_i32(vget_high_s32(int32x4_t(x))); }
FIXED_LANE_FUNCTION i32 join(half_i32 low, half_i32 high) {
  return i32(vcombine_s32(int32x2_t(low), int32x2_t(high)));
}
FIXED_LANE_FUNCTION half_i32 low_words(i64 x) { return half_i32(vmovn_s64(int64x2_t(x))); }
FIXED_LANE_FUNCTION i64 widened(half_i32 x) { return __builtin_convertvector(x, i64); }
FIXED_LANE_FUNCTION f64 doubles(half_i32 x) { return __builtin_convertvector(x, f64); }
FIXED_LANE_FUNCTION std::uint32_t bits(i32 x) {
  const u32 places = {1, 2, 4, 8};
  return vaddvq_u32(uint32x4_t(u32(x >> 31) & places));
}
FIXED_LANE_FUNCTION std::uint32_t bits(half_i32 x) { return bits(join(x, half_i32{})); }
FIXED_LANE_FUNCTION bool any_bit(u64 x) { return vmaxvq_u32(uint32x4_t(x)) != 0; }
FIXED_LANE_FUNCTION std::uint64_t sum_of(u64 x) { return x[0] + x[1]; }
FIXED_LANE_FUNCTION std::uint32_t zero_bits(i32 x) { return bits(x == 0); }
FIXED_LANE_FUNCTION std::uint32_t zero_bits(half_i32 x) { return bits(x == 0); }
FIXED_LANE_FUNCTION std::uint32_t bits_at_least(f64 a, f64 b) {
  return bits(low_words(i64(vcgeq_f64(float64x2_t(a), float64x2_t(b)))));
}
FIXED_LANE_FUNCTION std::uint32_t bits_below(f64 a, f64 b) {
  return bits(low_words(i64(vcltq_f64(float64x2_t(a), float64x2_t(b)))));
}
FIXED_LANE_FUNCTION f64 clamp(f64 x, f64 low, f64 high) {
  return f64(vminq_f64(vmaxq_f64(float64x2_t(x), float64x2_t(low)), float64x2_t(high)));
}
FIXED_LANE_FUNCTION f64 root(f64 x) { return f64(vsqrtq_f64(float64x2_t(x))); }
inline constexpr bool has_nearest_floats = false;
FIXED_LANE_FUNCTION f32 floats(i32 x) { return __builtin_convertvector(x, f32); }
FIXED_LANE_FUNCTION f32 root(f32 x) { return f32(vsqrtq_f32(float32x4_t(x))); }
FIXED_LANE_FUNCTION i32 integers(f32 x) { return __builtin_convertvector(x, i32); }
inline constexpr bool can_store_past = false;
FIXED_LANE_FUNCTION void store_past(void* to, i32 x) { __builtin_memcpy(to, &x, sizeof x); }
FIXED_LANE_FUNCTION void wait_for_stores() {}
template <bool by_floor>
FIXED_LANE_FUNCTION i64 whole(f64 x) {
  return i64(by_floor ? vcvtmq_s64_f64(float64x2_t(x)) : vcvtq_s64_f64(float64x2_t(x)));
}

#endif

/// Takes even lanes from the first operand, odd lanes from the second.
FIXED_LANE_FUNCTION i32 interleaved(u64 even, u64 odd) {
  return blend<0xaaaa>(i32(even), i32(odd));
}

FIXED_LANE_FUNCTION i64 odd_lanes(i32 x) { return i64(u64(x) >> 32); }

#if FIXED_LANE_BYTES > 16
FIXED_LANE_FUNCTION wide_lanes products(i32 a, i32 b) {
  return {mul_even(i64(a), i64(b)), mul_even(odd_lanes(a), odd_lanes(b))};
}
FIXED_LANE_FUNCTION wide_lanes products_by(i32 x, i32 b) {
  return {mul_even(i64(x), i64(b)), mul_even(i64(x), odd_lanes(b))};
}
FIXED_LANE_FUNCTION i32 upper_words(wide_lanes x) {
  return interleaved(u64(x.first) >> 32, u64(x.second));
}
#endif

/// Returns the bits `low` to `low` + 31 of wide lanes.
template <int low>
FIXED_LANE_FUNCTION i32 middle(wide_lanes x) {
#if FIXED_LANE_BYTES == 64
  if constexpr (low == 16) return middle_16(x.first, x.second);
#endif
#if FIXED_LANE_BYTES == 16
  const int64x2_t first(x.first);
  const int64x2_t second(x.second);
  if constexpr (low == 0) return i32(vmovn_high_s64(vmovn_s64(first), second));
  if constexpr (low != 0) return i32(vshrn_high_n_s64(vshrn_n_s64(first, low), second, low));
#else
  return interleaved(u64(x.first) >> low, u64(x.second) << (32 - low));
#endif
}

}  // namespace fixproof::detail::FIXED_LANES
#endif
