/// @file
/// Our side: the number type one by one, and batches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fixed/batch/batch.hpp"
#include "fixed/batch/conversions.hpp"
#include "fixed/batch/radian.hpp"
#include "fixed/batch/vectorizable.hpp"
#include "fixed/fixed.hpp"
#include "measure/bench/fair/columns.hpp"
#include "measure/bench/fair/transforms.hpp"

namespace fair {

using fixproof::q16_16;
using fixproof::q16_16_saturating;
namespace batch = fixproof::batch;

/// Functions take numbers by reference: g++ 12 does not vectorise a loop that copies them first.
template <class In, class Out = In>
struct Type {
  using in = In;
  using out = Out;
  static constexpr const char* name = "type";
};
template <class In, class Out = In>
struct Batch {
  using in = In;
  using out = Out;
  static constexpr const char* name = "batch";
};

template <class N>
struct TypeMultiply : Type<N> {
  static N of(const N& a, const N& b) { return a * b; }
};
struct TypeDivide : Type<q16_16> {
  static q16_16 of(const q16_16& a, const q16_16& b) { return a / b; }
};
struct VectorizableDivide : Type<q16_16> {
  static constexpr const char* name = "vectorizable_divide";
  static q16_16 of(const q16_16& a, const q16_16& b) { return fixproof::vectorizable_divide(a, b); }
};
struct TypeRoot : Type<q16_16> {
  static q16_16 of(const q16_16& a, const q16_16& /*b*/ = {}) { return fixproof::sqrt(a); }
};
struct TypeSine : Type<q16_16> {
  static q16_16 of(const q16_16& a, const q16_16& /*b*/ = {}) { return fixproof::sin(a); }
};
struct TypeSineCosine : Type<q16_16> {
  static std::array<q16_16, 2> of(const q16_16& a) {
    const auto both = fixproof::sin_cos(a);
    return {both.cos, both.sin};
  }
};
struct TypeFromDouble : Type<double, q16_16> {
  static q16_16 of(double a) { return q16_16(a); }
};
struct VectorizableFromDouble : Type<double, q16_16> {
  static constexpr const char* name = "vectorizable_from";
  static q16_16 of(double a) { return fixproof::vectorizable_from<q16_16>(a); }
};
struct TypeToDouble : Type<q16_16, double> {
  static double of(const q16_16& a) { return static_cast<double>(a); }
};
struct TypeThereAndBack : Type<q16_16> {
  static q16_16 of(const q16_16& a, const q16_16& /*b*/) { return q16_16(static_cast<double>(a)); }
};
struct TypeDot : Type<q16_16> {
  static void run(const View<in, out>& v, std::size_t count) {
    v.x[0] = fixproof::dot(std::span(v.a, count), std::span(v.b, count));
  }
};

struct TypeRow {
  using number = q16_16;
  static constexpr const char* name = "type";
  static q16_16 of(const std::array<q16_16, 4>& row, const q16_16& x, const q16_16& y,
                   const q16_16& z) {
    return row[0] * x + row[1] * y + row[2] * z + row[3];
  }
};
using TypeTransform = Columns<TypeRow>;
using TypeTransformInterleaved = Interleaved<TypeRow>;

template <class N>
struct BatchMultiply : Batch<N> {
  static void run(const View<N, N>& v, std::size_t n) {
    batch::multiply(std::span(v.a, n), std::span(v.b, n), std::span(v.x, n));
  }
};
struct BatchDivide : Batch<q16_16> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::divide(std::span(v.a, n), std::span(v.b, n), std::span(v.x, n));
  }
};
struct BatchRoot : Batch<q16_16> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::sqrt(std::span(v.a, n), std::span(v.x, n));
  }
};
struct BatchSine : Batch<q16_16> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::sin(std::span(v.a, n), std::span(v.x, n));
  }
};
struct BatchSineCosine : Batch<q16_16> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::sin_cos(std::span(v.a, n), std::span(v.y, n), std::span(v.x, n));
  }
};
struct BatchFromDouble : Batch<double, q16_16> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::from_floats(std::span(v.a, n), std::span(v.x, n));
  }
};
struct BatchToDouble : Batch<q16_16, double> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::to_floats(std::span(v.a, n), std::span(v.x, n));
  }
};
struct BatchDot : Batch<q16_16> {
  static void run(const View<in, out>& v, std::size_t n) {
    v.x[0] = batch::dot(std::span(v.a, n), std::span(v.b, n));
  }
};
struct BatchTransform : Batch<q16_16> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::transform(v.rows, std::span(v.a, n), std::span(v.b, n), std::span(v.c, n),
                     std::span(v.x, n), std::span(v.y, n), std::span(v.z, n));
  }
};
struct BatchTransformInterleaved : Batch<std::array<q16_16, 3>> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::transform(v.rows, std::span(v.a, n), std::span(v.x, n));
  }
};

struct BatchFused : Batch<q16_16> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::fused_transform(v.rows, std::span(v.a, n), std::span(v.b, n), std::span(v.c, n),
                           std::span(v.x, n), std::span(v.y, n), std::span(v.z, n));
  }
};
struct BatchFusedInterleaved : Batch<std::array<q16_16, 3>> {
  static void run(const View<in, out>& v, std::size_t n) {
    batch::fused_transform(v.rows, std::span(v.a, n), std::span(v.x, n));
  }
};

}  // namespace fair
