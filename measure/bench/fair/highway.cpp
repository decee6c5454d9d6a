// Highway includes this file once for each instruction set.
#include "measure/bench/fair/highway.hpp"

#if defined(FAIR_HIGHWAY)

// Includes what AVX-512 of this processor needs, which version 1.0 leaves out of its list.
#define HWY_WANT_AVX3_DL 1
// Replaces plain SSE2, for which version 1.0 has no vectors.
#define HWY_WANT_SSSE3 1
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "measure/bench/fair/highway.cpp"
#include <hwy/foreach_target.h>
// After the line above, as Highway demands.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "measure/bench/fair/columns.hpp"
#include "measure/bench/fair/plain.hpp"

HWY_BEFORE_NAMESPACE();
namespace fair::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Words32 = hn::ScalableTag<std::int32_t>;
using Words64 = hn::Repartition<std::int64_t, Words32>;
using Unsigned64 = hn::Repartition<std::uint64_t, Words32>;
using Doubles = hn::ScalableTag<double>;
using HalfWords = hn::Rebind<std::int32_t, Doubles>;
using Lanes32 = hn::Vec<Words32>;
using Lanes64 = hn::Vec<Words64>;

/// Products of the even and of the odd lanes.
struct Products {
  Lanes64 even, odd;
};
HWY_INLINE Lanes32 odd_lanes(Lanes32 x) {
  return hn::BitCast(Words32(), hn::ShiftRight<32>(hn::BitCast(Unsigned64(), x)));
}
HWY_INLINE Products products(Lanes32 a, Lanes32 b) {
  return {hn::MulEven(a, b), hn::MulEven(odd_lanes(a), odd_lanes(b))};
}
/// Rounds half up and takes the 32 bits above the fraction.
HWY_INLINE Lanes32 rounded(Products p) {
  const Lanes64 half = hn::Set(Words64(), 0x8000);
  const auto even = hn::ShiftRight<16>(hn::BitCast(Unsigned64(), hn::Add(p.even, half)));
  const auto odd = hn::ShiftLeft<16>(hn::Add(p.odd, half));
  return hn::OddEven(hn::BitCast(Words32(), odd), hn::BitCast(Words32(), even));
}

void multiply_loop(const View<HighwayMultiply::in, HighwayMultiply::out>& v, std::size_t count) {
  const Words32 d;
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    hn::StoreU(rounded(products(hn::LoadU(d, v.a + i), hn::LoadU(d, v.b + i))), d, v.x + i);
  }
  for (; i < count; ++i) v.x[i] = IdiomMultiply::of(v.a[i], v.b[i]);
}

/// The limits of the product, before it is shifted, make its low words the nearest in range.
void multiply_saturating_loop(
    const View<HighwayMultiplySaturating::in, HighwayMultiplySaturating::out>& v,
    std::size_t count) {
  const Words32 d;
  const Words64 wide;
  const auto low = hn::Set(wide, -0x800000000000);
  const auto high = hn::Set(wide, 0x7fffffff0000);
  const auto limited = [&](Lanes64 x) HWY_ATTR { return hn::Min(hn::Max(x, low), high); };
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    const Products p = products(hn::LoadU(d, v.a + i), hn::LoadU(d, v.b + i));
    hn::StoreU(rounded({limited(p.even), limited(p.odd)}), d, v.x + i);
  }
  for (; i < count; ++i) v.x[i] = IdiomMultiplySaturating::of(v.a[i], v.b[i]);
}

HWY_INLINE auto load_doubles(const Word* from) {
  return hn::PromoteTo(Doubles(), hn::LoadU(HalfWords(), from));
}
template <class Vector>
void store_nearest(Vector x, Word* to) {
  hn::StoreU(hn::DemoteTo(HalfWords(), hn::Round(x)), HalfWords(), to);
}

void divide_loop(const View<HighwayDivide::in, HighwayDivide::out>& v, std::size_t count) {
  const auto one = hn::Set(Doubles(), 65536.0);
  std::size_t i = 0;
  for (; i + hn::Lanes(Doubles()) <= count; i += hn::Lanes(Doubles())) {
    store_nearest(hn::Div(hn::Mul(load_doubles(v.a + i), one), load_doubles(v.b + i)), v.x + i);
  }
  for (; i < count; ++i) v.x[i] = DoubleDivide::of(v.a[i], v.b[i]);
}

void root_loop(const View<HighwayRoot::in, HighwayRoot::out>& v, std::size_t count) {
  const auto one = hn::Set(Doubles(), 65536.0);
  std::size_t i = 0;
  for (; i + hn::Lanes(Doubles()) <= count; i += hn::Lanes(Doubles())) {
    store_nearest(hn::Sqrt(hn::Mul(load_doubles(v.a + i), one)), v.x + i);
  }
  for (; i < count; ++i) v.x[i] = DoubleRoot::of(v.a[i]);
}

void sine_loop(const View<HighwaySine::in, HighwaySine::out>& v, std::size_t count) {
  const Doubles d;
  const auto one = hn::Set(d, 65536.0);
  const auto unit = hn::Set(d, 1 / 65536.0);
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    store_nearest(hn::Mul(hn::Sin(d, hn::Mul(load_doubles(v.a + i), unit)), one), v.x + i);
  }
  for (; i < count; ++i) v.x[i] = DoubleSine::of(v.a[i]);
}
void sine_cosine_loop(const View<HighwaySineCosine::in, HighwaySineCosine::out>& v,
                      std::size_t count) {
  const Doubles d;
  const auto one = hn::Set(d, 65536.0);
  const auto unit = hn::Set(d, 1 / 65536.0);
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    const auto x = hn::Mul(load_doubles(v.a + i), unit);
    store_nearest(hn::Mul(hn::Cos(d, x), one), v.x + i);
    store_nearest(hn::Mul(hn::Sin(d, x), one), v.y + i);
  }
  for (; i < count; ++i) {
    const auto both = DoubleSineCosine::of(v.a[i]);
    v.x[i] = both[0];
    v.y[i] = both[1];
  }
}

void from_double_loop(const View<HighwayFromDouble::in, HighwayFromDouble::out>& v,
                      std::size_t count) {
  const Doubles d;
  const auto one = hn::Set(d, 65536.0);
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    store_nearest(hn::Mul(hn::LoadU(d, v.a + i), one), v.x + i);
  }
  for (; i < count; ++i) v.x[i] = RintFromDouble::of(v.a[i]);
}
void to_double_loop(const View<HighwayToDouble::in, HighwayToDouble::out>& v, std::size_t count) {
  const Doubles d;
  const auto unit = hn::Set(d, 1 / 65536.0);
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    hn::StoreU(hn::Mul(load_doubles(v.a + i), unit), d, v.x + i);
  }
  for (; i < count; ++i) v.x[i] = IdiomToDouble::of(v.a[i]);
}

/// Four sums, so that additions do not wait for each other.
void dot_loop(const View<HighwayDot::in, HighwayDot::out>& v, std::size_t count) {
  const Words32 d;
  const std::size_t lanes = hn::Lanes(d);
  Lanes64 s0 = hn::Zero(Words64());
  Lanes64 s1 = s0;
  Lanes64 s2 = s0;
  Lanes64 s3 = s0;
  std::size_t i = 0;
  for (; i + 2 * lanes <= count; i += 2 * lanes) {
    const Products p = products(hn::LoadU(d, v.a + i), hn::LoadU(d, v.b + i));
    const Products q = products(hn::LoadU(d, v.a + i + lanes), hn::LoadU(d, v.b + i + lanes));
    s0 = hn::Add(s0, p.even);
    s1 = hn::Add(s1, p.odd);
    s2 = hn::Add(s2, q.even);
    s3 = hn::Add(s3, q.odd);
  }
  const auto all = hn::SumOfLanes(Words64(), hn::Add(hn::Add(s0, s1), hn::Add(s2, s3)));
  Wide sum = hn::GetLane(all);
  for (; i < count; ++i) sum += Wide{v.a[i]} * v.b[i];
  v.x[0] = static_cast<Word>((sum + 0x8000) >> 16);
}

/// The two ways to round coordinate k of vertices: each product, or the sum once.
struct EachProduct {
  HWY_INLINE static Lanes32 of(const std::array<Word, 4>& row, const std::array<Lanes32, 3>& at) {
    const Words32 d;
    Lanes32 sum = hn::Set(d, row[3]);
    for (std::size_t j = 0; j < 3; ++j) {
      sum = hn::Add(sum, rounded(products(at[j], hn::Set(d, row[j]))));
    }
    return sum;
  }
  static Word of(const std::array<Word, 4>& row, Word x, Word y, Word z) {
    return IdiomMultiply::of(row[0], x) + IdiomMultiply::of(row[1], y) +
           IdiomMultiply::of(row[2], z) + row[3];
  }
};
struct EachSum {
  HWY_INLINE static Lanes32 of(const std::array<Word, 4>& row, const std::array<Lanes32, 3>& at) {
    const Words32 d;
    Products sum = products(at[0], hn::Set(d, row[0]));
    for (std::size_t j = 1; j < 3; ++j) {
      const Products p = products(at[j], hn::Set(d, row[j]));
      sum = {hn::Add(sum.even, p.even), hn::Add(sum.odd, p.odd)};
    }
    return hn::Add(rounded(sum), hn::Set(d, row[3]));
  }
  static Word of(const std::array<Word, 4>& row, Word x, Word y, Word z) {
    const Wide sum = Wide{row[0]} * x + Wide{row[1]} * y + Wide{row[2]} * z;
    return static_cast<Word>((sum + 0x8000) >> 16) + row[3];
  }
};
template <class Row>
HWY_INLINE void transform_columns(const View<Word, Word>& v, std::size_t count) {
  const Words32 d;
  const auto by = v.rows;
  const std::array<Word*, 3> to{v.x, v.y, v.z};
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    const std::array<Lanes32, 3> at{hn::LoadU(d, v.a + i), hn::LoadU(d, v.b + i),
                                    hn::LoadU(d, v.c + i)};
    for (std::size_t k = 0; k < 3; ++k) hn::StoreU(Row::of(by[k], at), d, to[k] + i);
  }
  for (; i < count; ++i) {
    const Word x = v.a[i];
    const Word y = v.b[i];
    const Word z = v.c[i];
    for (std::size_t k = 0; k < 3; ++k) to[k][i] = Row::of(by[k], x, y, z);
  }
}
using WordVertex = std::array<Word, 3>;
template <class Row>
HWY_INLINE void transform_interleaved(const View<WordVertex, WordVertex>& v, std::size_t count) {
  const Words32 d;
  const auto by = v.rows;
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    std::array<Lanes32, 3> at;
    hn::LoadInterleaved3(d, v.a[i].data(), at[0], at[1], at[2]);
    hn::StoreInterleaved3(Row::of(by[0], at), Row::of(by[1], at), Row::of(by[2], at), d,
                          v.x[i].data());
  }
  for (; i < count; ++i) {
    const auto [x, y, z] = v.a[i];
    for (std::size_t k = 0; k < 3; ++k) v.x[i][k] = Row::of(by[k], x, y, z);
  }
}
void transform_loop(const View<Word, Word>& v, std::size_t count) {
  transform_columns<EachProduct>(v, count);
}
void fused_loop(const View<Word, Word>& v, std::size_t count) {
  transform_columns<EachSum>(v, count);
}
void transform_interleaved_loop(const View<WordVertex, WordVertex>& v, std::size_t count) {
  transform_interleaved<EachProduct>(v, count);
}
void fused_interleaved_loop(const View<WordVertex, WordVertex>& v, std::size_t count) {
  transform_interleaved<EachSum>(v, count);
}

}  // namespace fair::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fair {

HWY_EXPORT(multiply_loop);
void HighwayMultiply::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(multiply_loop)(v, count);
}
HWY_EXPORT(multiply_saturating_loop);
void HighwayMultiplySaturating::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(multiply_saturating_loop)(v, count);
}
HWY_EXPORT(divide_loop);
void HighwayDivide::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(divide_loop)(v, count);
}
HWY_EXPORT(root_loop);
void HighwayRoot::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(root_loop)(v, count);
}
HWY_EXPORT(sine_loop);
void HighwaySine::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(sine_loop)(v, count);
}
HWY_EXPORT(sine_cosine_loop);
void HighwaySineCosine::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(sine_cosine_loop)(v, count);
}
HWY_EXPORT(from_double_loop);
void HighwayFromDouble::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(from_double_loop)(v, count);
}
HWY_EXPORT(to_double_loop);
void HighwayToDouble::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(to_double_loop)(v, count);
}
HWY_EXPORT(dot_loop);
void HighwayDot::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(dot_loop)(v, count);
}
HWY_EXPORT(transform_loop);
void HighwayTransform::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(transform_loop)(v, count);
}
HWY_EXPORT(transform_interleaved_loop);
void HighwayTransformInterleaved::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(transform_interleaved_loop)(v, count);
}

HWY_EXPORT(fused_loop);
void HighwayFused::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(fused_loop)(v, count);
}
HWY_EXPORT(fused_interleaved_loop);
void HighwayFusedInterleaved::run(const View<in, out>& v, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(fused_interleaved_loop)(v, count);
}

}  // namespace fair
#endif

#endif
