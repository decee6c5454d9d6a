/// @file
/// Instantiates the loops of fixed/batch/batch.hpp and fixed/batch/radian.hpp for each instruction
/// set that the compiler supports, and selects one at run time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/batch/detail/element.hpp"
#include "fixed/batch/detail/report.hpp"
#include "fixed/batch/detail/transforms.hpp"
#include "fixed/detail/divide.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/quotient.hpp"
#include "fixed/detail/radian.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/wide_sum.hpp"
#include "fixed/policy.hpp"

namespace fixproof::batch {

/// How a batch is computed. All paths give the same results and reports.
enum class path : std::uint8_t {
  portable,  ///< a plain loop over the number type, with any compiler and processor
  neon,      ///< programs compiled for little-endian AArch64
  avx2,      ///< x86-64 processors with AVX2
  avx512,    ///< x86-64 processors with AVX-512 F, BW, DQ and VL
  fastest,   ///< the fastest of these that the program can take, chosen when a batch needs it
};

}  // namespace fixproof::batch

namespace fixproof::detail {

/// Whether vector registers multiply and add the numbers, which needs signed stored integers of 16
/// or 32 bits.
template <class Number>
inline constexpr bool has_lanes = std::is_signed_v<typename Number::raw_type> &&
                                  (sizeof(Number) == 2 || sizeof(Number) == 4);

/// The same for functions, whose lanes have no bounds.
template <class Number>
inline constexpr bool has_function_lanes =
    has_lanes<Number>&& Number::rules.functions == rounding::nearest;

/// The same for multiply-add, whose sums must fit into twice the width.
template <class Number>
inline constexpr bool has_mul_add_lanes =
    has_lanes<Number>&& Number::fraction_bits <= bits_of<typename Number::raw_type> - 2;

/// The same for conversions, which need exact doubles.
template <class Number>
inline constexpr bool has_float_lanes = has_lanes<Number>&& hardware_double;

/// The same for quotients, whose numerators must fit into 48 bits.
template <class Number>
inline constexpr bool has_quotient_lanes = has_float_lanes<Number>&&
    has_fast_quotient<typename Number::raw_type, Number::fraction_bits, Number::rules>;

/// The same for square roots.
template <class Number>
inline constexpr bool has_root_lanes = has_float_lanes<Number>&& has_function_lanes<Number>&&
    has_fast_root<typename Number::raw_type, Number::fraction_bits>;

}  // namespace fixproof::detail

// The vector code needs g++ 12 or clang, for vector types, their conversions, and targets of single
// functions. Other compilers take the portable path.
#if defined(__GNUC__) && defined(__has_builtin)
#if __has_builtin(__builtin_convertvector) && __has_builtin(__builtin_shufflevector)
#if defined(__x86_64__)
#define FIXED_BATCH_X86
#elif defined(__aarch64__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define FIXED_BATCH_NEON
#endif
#endif
#endif

// What the flags of the compiler promise is not asked for at run time.
#if defined(__AVX2__)
#define FIXED_SURE_OF_AVX2 true
#else
#define FIXED_SURE_OF_AVX2 false
#endif
#if defined(FIXED_BATCH_X86) && defined(__AVX512F__) && defined(__AVX512BW__) && \
    defined(__AVX512DQ__) && defined(__AVX512VL__)
#define FIXED_SURE_OF_AVX512 1
#else
#define FIXED_SURE_OF_AVX512 0
#endif

#if defined(FIXED_BATCH_X86)
#include <immintrin.h>

#define FIXED_LANES avx2
#define FIXED_LANE_BYTES 32  // NOLINT(cppcoreguidelines-macro-usage): undefined by parts.hpp
#define FIXED_LANE_TARGET __attribute__((target("avx2")))
#include "fixed/batch/detail/parts.hpp"

#define FIXED_LANES avx512
#define FIXED_LANE_BYTES 64  // NOLINT(cppcoreguidelines-macro-usage): undefined by parts.hpp
#define FIXED_LANE_TARGET __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl")))
#include "fixed/batch/detail/parts.hpp"

#elif defined(FIXED_BATCH_NEON)
#include <arm_neon.h>

#define FIXED_LANES neon
#define FIXED_LANE_BYTES 16
#define FIXED_LANE_TARGET
#include "fixed/batch/detail/parts.hpp"
#endif

namespace fixproof::batch {

/// Whether the compiler and the processor both support a path.
inline bool has(path which) noexcept {
  switch (which) {
    case path::portable:
    case path::fastest:
      return true;
    case path::neon:
#if defined(FIXED_BATCH_NEON)
      return true;
#else
      return false;
#endif
#if defined(FIXED_BATCH_X86)
    case path::avx2:
      return FIXED_SURE_OF_AVX2 || static_cast<bool>(__builtin_cpu_supports("avx2"));
    case path::avx512:
      if (FIXED_SURE_OF_AVX512) return true;
      return static_cast<bool>(__builtin_cpu_supports("avx512f")) &&
             static_cast<bool>(__builtin_cpu_supports("avx512bw")) &&
             static_cast<bool>(__builtin_cpu_supports("avx512dq")) &&
             static_cast<bool>(__builtin_cpu_supports("avx512vl"));
#else
    default:
      return false;
#endif
  }
  return false;
}

/// Returns the fastest path that this program can take.
inline path best() noexcept {
  // This reads one word of the compiler's run-time library, so no result is stored.
  return has(path::avx512) ? path::avx512
         : has(path::avx2) ? path::avx2
         : has(path::neon) ? path::neon
                           : path::portable;
}

}  // namespace fixproof::batch

namespace fixproof::detail {

/// Whether the first blocks need no call, because the flags promise AVX-512, which has masks. Then
/// even two elements are faster together.
inline constexpr bool sure_of_masks = FIXED_SURE_OF_AVX512 == 1;

/// Whether the compiler vectorises short loops at every level that optimises; g++ 12 does at -O3.
#if defined(__clang__)
inline constexpr bool loops_in_vectors = true;
#else
inline constexpr bool loops_in_vectors = false;
#endif

#undef FIXED_SURE_OF_AVX2
#undef FIXED_SURE_OF_AVX512

/// Returns call(loops) with the loops of a path. On the portable path and on unavailable paths,
/// returns rest().
/// @tparam has whether the loops cover the operation on the numbers
template <bool has, class Call, class Rest>
FIXED_ALWAYS_INLINE auto on_path(batch::path which, const Call& call, const Rest& rest) {
  if constexpr (has) {
#if defined(FIXED_BATCH_X86)
    // The path that most calls take, without a jump.
    const bool fastest = which == batch::path::fastest;
    if (fastest && batch::has(batch::path::avx512)) [[likely]] {
      return call(avx512::loops{});
    }
    if (fastest) which = batch::best();
    if (which == batch::path::avx512 && batch::has(which)) return call(avx512::loops{});
    if (which == batch::path::avx2 && batch::has(which)) return call(avx2::loops{});
#elif defined(FIXED_BATCH_NEON)
    if (which == batch::path::neon || which == batch::path::fastest) return call(neon::loops{});
#endif
  }
  (void)which;
  (void)call;
  return rest();
}

/// The same for loops that return the number of elements done: without loops, none is.
template <bool has, class Call>
FIXED_ALWAYS_INLINE std::size_t on_path(batch::path which, const Call& call) {
  return on_path<has>(which, call, [] { return std::size_t{0}; });
}

}  // namespace fixproof::detail
