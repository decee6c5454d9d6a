/// @file
/// Loads and stores of blocks; see fixed/batch/detail/lanes.hpp.
///
/// `base` points to element 0. Raw may be a number, its stored integer, or the floating-point
/// number in the lanes. AVX-512 can also load and store the first elements of a block without
/// touching the others (has_masks).

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// All elements of a block.
struct whole_block {
  static constexpr std::uint32_t bits = ~0U;

  [[nodiscard]] whole_block upper() const { return {}; }
};

/// The first `count` elements of a block, with a bit set for each.
struct first_elements {
  std::size_t count;
  std::uint32_t bits = (1U << count) - 1;

  explicit first_elements(std::size_t n) : count(n) {}
  /// The part of the upper half of a block. Where there are masks, the lower half takes `*this`: it
  /// ignores the bits of the upper half.
  [[nodiscard]] first_elements upper() const {
    first_elements part = *this;
    part.bits >>= width / 2;
    return part;
  }
  /// The part of register i of three that holds as many vertices. The upper bits mean nothing.
  [[nodiscard]] first_elements third(std::size_t i) const {
    first_elements part = *this;
    part.bits = static_cast<std::uint32_t>(((std::uint64_t{1} << 3 * count) - 1) >> i * width);
    return part;
  }
};

// g++ 12 does not see that a short span does not get to a whole block.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds"
#endif

/// Loads half a block.
template <class Raw>
FIXED_LANE_FUNCTION half_i32 load_half(const void* base, std::size_t index, whole_block = {}) {
  const auto* from = static_cast<const Raw*>(base) + index;
  if constexpr (sizeof(Raw) == 4) {
    half_i32 x;
    __builtin_memcpy(&x, from, sizeof x);
    return x;
  } else {
    half_narrow_i16 x;
    __builtin_memcpy(&x, from, sizeof x);
    return __builtin_convertvector(x, half_i32);
  }
}

template <class Raw>
FIXED_LANE_FUNCTION void store(void* base, std::size_t index, half_i32 x, whole_block = {}) {
  void* const to = static_cast<Raw*>(base) + index;
  if constexpr (sizeof(Raw) == 4) {
    __builtin_memcpy(to, &x, sizeof x);
  } else {
    const half_narrow_i16 low = __builtin_convertvector(x, half_narrow_i16);
    __builtin_memcpy(to, &low, sizeof low);
  }
}

FIXED_LANE_FUNCTION f64 load_half_doubles(const void* base, std::size_t index, whole_block = {}) {
  f64 x;
  __builtin_memcpy(&x, static_cast<const double*>(base) + index, sizeof x);
  return x;
}

template <class Raw>
FIXED_LANE_FUNCTION void store(void* base, std::size_t index, f64 x, whole_block = {}) {
  __builtin_memcpy(static_cast<double*>(base) + index, &x, sizeof x);
}

template <class Raw>
FIXED_LANE_FUNCTION i32 load(const void* base, std::size_t index, whole_block = {}) {
  const auto* from = static_cast<const Raw*>(base) + index;
  if constexpr (sizeof(Raw) == 4) {
    i32 x;
    __builtin_memcpy(&x, from, sizeof x);
    return unknown(x);
  } else {
    narrow_i16 x;
    __builtin_memcpy(&x, from, sizeof x);
    return __builtin_convertvector(x, i32);
  }
}

template <class Raw>
FIXED_LANE_FUNCTION void store(void* base, std::size_t index, i32 x, whole_block = {}) {
  void* const to = static_cast<Raw*>(base) + index;
  if constexpr (sizeof(Raw) == 4) {
    __builtin_memcpy(to, &x, sizeof x);
  } else {
    const narrow_i16 low = __builtin_convertvector(x, narrow_i16);
    __builtin_memcpy(to, &low, sizeof low);
  }
}

#if FIXED_LANE_BYTES == 64

inline constexpr bool has_masks = true;

template <class Raw>
FIXED_LANE_FUNCTION half_i32 load_half(const void* base, std::size_t index, first_elements some) {
  const auto* from = static_cast<const Raw*>(base) + index;
  const auto mask = static_cast<__mmask8>(some.bits);
  if constexpr (sizeof(Raw) == 4) {
    return half_i32(_mm256_maskz_loadu_epi32(mask, from));
  } else {
    return __builtin_convertvector(half_narrow_i16(_mm_maskz_loadu_epi16(mask, from)), half_i32);
  }
}

template <class Raw>
FIXED_LANE_FUNCTION void store(void* base, std::size_t index, half_i32 x, first_elements some) {
  void* const to = static_cast<Raw*>(base) + index;
  const auto mask = static_cast<__mmask8>(some.bits);
  if constexpr (sizeof(Raw) == 4) {
    _mm256_mask_storeu_epi32(to, mask, __m256i(x));
  } else {
    _mm_mask_storeu_epi16(to, mask, __m128i(__builtin_convertvector(x, half_narrow_i16)));
  }
}

FIXED_LANE_FUNCTION f64 load_half_doubles(const void* base, std::size_t index,
                                          first_elements some) {
  return _mm512_maskz_loadu_pd(static_cast<__mmask8>(some.bits),
                               static_cast<const double*>(base) + index);
}

template <class Raw>
FIXED_LANE_FUNCTION void store(void* base, std::size_t index, f64 x, first_elements some) {
  _mm512_mask_storeu_pd(static_cast<double*>(base) + index, static_cast<__mmask8>(some.bits), x);
}

template <class Raw>
FIXED_LANE_FUNCTION i32 load(const void* base, std::size_t index, first_elements some) {
  const auto* from = static_cast<const Raw*>(base) + index;
  const auto mask = static_cast<__mmask16>(some.bits);
  if constexpr (sizeof(Raw) == 4) {
    return i32(_mm512_maskz_loadu_epi32(mask, from));
  } else {
    return __builtin_convertvector(narrow_i16(_mm256_maskz_loadu_epi16(mask, from)), i32);
  }
}

template <class Raw>
FIXED_LANE_FUNCTION void store(void* base, std::size_t index, i32 x, first_elements some) {
  void* const to = static_cast<Raw*>(base) + index;
  const auto mask = static_cast<__mmask16>(some.bits);
  if constexpr (sizeof(Raw) == 4) {
    _mm512_mask_storeu_epi32(to, mask, __m512i(x));
  } else {
    _mm256_mask_storeu_epi16(to, mask, __m256i(__builtin_convertvector(x, narrow_i16)));
  }
}

#else

inline constexpr bool has_masks = false;

#endif

template <class Raw, class Part = whole_block>
FIXED_LANE_FUNCTION void store(void* base, std::size_t index, f32 x, Part part = {}) {
  store<std::int32_t>(base, index, i32(x), part);
}

/// Whether results go to the caches or bypass them. Only 32-bit integers can bypass them.
enum class stores : bool { cached, past_caches };
template <class Raw>
inline constexpr bool may_store_past = can_store_past && sizeof(Raw) == 4;

/// @pre To bypass the caches: may_store_past, and element `index` is aligned to the register size
template <class Raw, stores how>
FIXED_LANE_FUNCTION void store(void* base, std::size_t index, i32 x) {
  if constexpr (how == stores::past_caches) {
    store_past(static_cast<Raw*>(base) + index, x);
  } else {
    store<Raw>(base, index, x);
  }
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

}  // namespace fixproof::detail::FIXED_LANES
#endif
