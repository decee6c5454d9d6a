/// @file
/// A number whose multiplies, divides, sines and transforms run the listings on the model, in the
/// build that InBuild sets.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <numeric>
#include <optional>

#include "measure/player/model_call.hpp"
#include "verify/cases/variant.hpp"
#include "xsharp/arithmetic.hpp"

namespace fixproof::player {

/// A 16.16 number. Sums, differences and comparisons call no routine; they wrap.
class ModelNumber {
 public:
  constexpr ModelNumber() = default;

  static constexpr ModelNumber from_word(std::uint32_t word) {
    ModelNumber result;
    result.word_ = word;
    return result;
  }
  [[nodiscard]] constexpr std::uint32_t word() const { return word_; }
  [[nodiscard]] constexpr std::int32_t raw() const { return static_cast<std::int32_t>(word_); }

  static cases::Variant variant(cases::Operation operation) {
    return cases::variant_of(operation, InBuild::current());
  }

  friend constexpr ModelNumber operator+(ModelNumber a, ModelNumber b) {
    return from_word(a.word_ + b.word_);
  }
  friend constexpr ModelNumber operator-(ModelNumber a, ModelNumber b) {
    return from_word(a.word_ - b.word_);
  }
  constexpr ModelNumber operator-() const { return from_word(0U - word_); }
  friend ModelNumber operator*(ModelNumber a, ModelNumber b) {
    const std::array in{a.word_, b.word_};
    std::array<std::uint32_t, 1> out{};
    call_model(variant(cases::Operation::mul), in, out);
    return from_word(out[0]);
  }
  friend constexpr bool operator==(ModelNumber, ModelNumber) = default;
  friend constexpr auto operator<=>(ModelNumber a, ModelNumber b) { return a.raw() <=> b.raw(); }
  explicit constexpr operator double() const { return raw() / 65536.0; }

 private:
  std::uint32_t word_ = 0;
};

}  // namespace fixproof::player

namespace xsharp {

template <>
struct Arithmetic<fixproof::player::ModelNumber> {
  using N = fixproof::player::ModelNumber;
  using Operation = fixproof::cases::Operation;

  static std::int32_t raw(N x) { return x.raw(); }
  static N from_raw(std::int32_t raw) { return N::from_word(static_cast<std::uint32_t>(raw)); }
  static N constant(double value, Conversion conversion) {
    return from_raw(raw_constant(value, conversion));
  }
  static std::optional<N> divide(N n, N d) {
    const std::array in{n.word(), d.word()};
    std::array<std::uint32_t, 1> out{};
    if (!fixproof::player::call_model(N::variant(Operation::div), in, out)) return std::nullopt;
    return N::from_word(out[0]);
  }
  static bool divides_by_whole_part() {
    return fixproof::player::InBuild::current().target == fixproof::cases::Target::i8088;
  }
  static Turn<N> turn(std::int32_t tenths) {
    const std::array in{static_cast<std::uint32_t>(tenths) & 0xFFFFU};
    std::array<std::uint32_t, 2> out{};
    fixproof::player::call_model(N::variant(Operation::cossin), in, out);
    return {N::from_word(out[0]), N::from_word(out[1])};
  }
  static N midpoint(N a, N b) { return from_raw(std::midpoint(a.raw(), b.raw())); }

  static Vec3<N> apply(const Transform<N>& t, const Vec3<N>& v) {
    std::array<std::uint32_t, 15> in{};
    put(t, in.data());
    in[12] = v.x.word();
    in[13] = v.y.word();
    in[14] = v.z.word();
    std::array<std::uint32_t, 3> out{};
    fixproof::player::call_model(N::variant(Operation::xformvec), in, out);
    return {N::from_word(out[0]), N::from_word(out[1]), N::from_word(out[2])};
  }

  static Transform<N> concatenate(const Transform<N>& first, const Transform<N>& second,
                                  Concatenation how) {
    std::array<std::uint32_t, 24> in{};
    put(first, in.data());
    put(second, in.data() + 12);
    std::array<std::uint32_t, 12> out{};
    fixproof::cases::Build chosen = fixproof::player::InBuild::current();
    chosen.repaired = how == Concatenation::repaired;
    fixproof::player::call_model(fixproof::cases::variant_of(Operation::concat, chosen), in, out);
    Transform<N> result;
    for (std::size_t i = 0; i < 12; ++i) result.rows[i / 4][i % 4] = N::from_word(out[i]);
    return result;
  }

  // No listing has a root or a power. These use those of the type, which are the same in every
  // build.
  static N length(const Vec3<N>& v) {
    const Vec3<Type> of{type_of(v.x), type_of(v.y), type_of(v.z)};
    return from_raw(Arithmetic<Type>::length(of).raw());
  }
  static N power(N base, N exponent) {
    return from_raw(Arithmetic<Type>::power(type_of(base), type_of(exponent)).raw());
  }

 private:
  using Type = fixproof::q16_16;

  static Type type_of(N x) { return Type::from_raw(x.raw()); }

  static void put(const Transform<N>& t, std::uint32_t* words) {
    for (std::size_t i = 0; i < 12; ++i) words[i] = t.rows[i / 4][i % 4].word();
  }
};

}  // namespace xsharp
