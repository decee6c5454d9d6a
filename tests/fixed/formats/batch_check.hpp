/// @file
/// Checks a batch operation against exact results: every length to 40 at unaligned addresses, all
/// operands at once, in place, on every path of this processor, with marks and without.
#pragma once

#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "fixed/batch/batch.hpp"
#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/support/test.hpp"

namespace batch_formats {

using fixproof::overflow;
using fixproof::policy;
using fixproof::batch::path;
using reference::Fault;
using reference::integer;
using reference::narrowed;
using reference::product;
using reference::quotient;
using reference::Result;
using reference::Type;

/// A projection may have a divide error in one coordinate while the other only overflows.
inline constexpr policy saturate_or_fault{.range = overflow::saturate,
                                          .fault = fixproof::divide_fault::signed_quotient};

template <class N, class... Others>
inline constexpr bool is_one_of = (std::is_same_v<N, Others> || ...);

/// Every format that fixed/number.hpp and fixed/formats.hpp name.
using formats_8 =
    std::tuple<fixproof::q8_0, fixproof::q4_4, fixproof::q1_7, fixproof::u4_4, fixproof::u0_8>;
using formats_16 = std::tuple<fixproof::q12_4, fixproof::q8_8, fixproof::q4_12, fixproof::q2_14,
                              fixproof::q1_15, fixproof::u8_8, fixproof::u1_15, fixproof::u0_16>;
using formats_32 = std::tuple<fixproof::q32_0, fixproof::q26_6, fixproof::q24_8, fixproof::q20_12,
                              fixproof::q16_16, fixproof::q8_24, fixproof::q4_28, fixproof::q2_30,
                              fixproof::q1_31, fixproof::u24_8, fixproof::u16_16, fixproof::u8_24,
                              fixproof::u1_31, fixproof::u0_32>;
using formats_64 = std::tuple<fixproof::q48_16, fixproof::q40_24, fixproof::q32_32,
                              fixproof::q16_48, fixproof::q2_62, fixproof::q1_63, fixproof::u48_16,
                              fixproof::u32_32, fixproof::u0_64>;
/// And those with no or all bits after the point that have no name.
using formats_at_the_ends =
    std::tuple<fixproof::number<std::int16_t, 0>, fixproof::number<std::int16_t, 16>,
               fixproof::number<std::uint16_t, 0>, fixproof::number<std::int32_t, 1>,
               fixproof::number<std::int32_t, 32>, fixproof::number<std::uint32_t, 0>>;
using every_format = decltype(std::tuple_cat(formats_8(), formats_16(), formats_32(), formats_64(),
                                             formats_at_the_ends()));

/// These stand for the others under every policy: with vector code for products and quotients, for
/// products alone, and without; of every width; with half, all but two and all but one of the bits
/// after the point.
template <class N>
inline constexpr bool stands_for_others =
    is_one_of<N, fixproof::q4_4, fixproof::q8_8, fixproof::q1_15, fixproof::q16_16, fixproof::q2_30,
              fixproof::q1_31, fixproof::u16_16, fixproof::q32_32>;

/// The place of a policy in its group of tests. A format that stands for no other takes part under
/// one policy of a group; in a build for all combinations, under each.
template <std::size_t number, std::size_t of>
struct Turn {};
/// Of a policy under which only formats take part that stand for others.
using NoTurn = Turn<1, 1>;

#ifdef FIXPROOF_NIGHTLY
inline constexpr bool all_combinations = true;
#else
inline constexpr bool all_combinations = false;
#endif

/// Whether format N, the i-th, takes part under policy `number` of a group of `of`.
template <class N, std::size_t i, std::size_t number, std::size_t of>
constexpr bool takes_part() {
#ifdef FIXPROOF_FEW_TYPES
  // Sanitizers watch each format under one policy of a group, and each policy.
  if (of > 1) return i % of == number;
#endif
  return all_combinations || stands_for_others<N> || i % of == number;
}

/// Calls `check` for the policy in one format.
template <policy P, class N, bool has_turn, class Check>
void in_format(const Check& check) {
  if constexpr (has_turn) check.template operator()<fixproof::with_policy<N, P>>();
}

/// Calls `check` for the policy in the formats whose turn it is.
template <policy P, std::size_t number, std::size_t of, class Check, class... N, std::size_t... i>
void in_formats(const Check& check, Turn<number, of> /*turn*/,
                std::type_identity<std::tuple<N...>> /*formats*/, std::index_sequence<i...>) {
  (in_format<P, N, takes_part<N, i, number, of>()>(check), ...);
}
template <policy P, class Which, class Formats = every_format, class Check>
void under(const Check& check) {
  in_formats<P>(check, Which(), std::type_identity<Formats>(),
                std::make_index_sequence<std::tuple_size_v<Formats>>());
}

/// Whether an operation of overflow rule O throws for a fault.
template <overflow O>
bool throws_by(Fault fault) {
  return fault != Fault::none && O == overflow::trap;
}

/// The first fault of several steps.
Fault first(std::initializer_list<Fault> faults);

/// The paths of this processor.
std::vector<path> paths();

/// Edges and random numbers as stored integers.
std::vector<integer> operands(const Type& type, std::size_t count, unsigned seed);

/// Stored integers in memory at any address that suits the type.
class Column {
 public:
  Column(const Type& type, const std::vector<integer>& values);

  [[nodiscard]] integer operator[](std::size_t i) const;
  [[nodiscard]] std::size_t size() const { return bytes_.size() / type_.size; }
  template <class N>
  [[nodiscard]] std::span<N> numbers() {
    // NOLINTNEXTLINE(*-reinterpret-cast): bytes become numbers
    return {reinterpret_cast<N*>(bytes_.data()), size()};
  }

 private:
  Type type_;
  std::vector<std::byte> bytes_;
};

/// `count` elements of four columns; those of the results begin elsewhere.
struct Spans {
  std::array<Column*, 4> columns;
  std::size_t at;
  std::size_t at_result;
  std::size_t count;

  template <class N>
  [[nodiscard]] std::span<const N> in(std::size_t which) const {
    return columns[which]->numbers<N>().subspan(at, count);
  }
  template <class N>
  [[nodiscard]] std::span<N> out() const {
    return columns[3]->numbers<N>().subspan(at_result, count);
  }
};

/// One operation on numbers of one type.
struct Operation {
  Type type;
  /// Of the stored integers of three operands.
  std::function<Result(const integer&, const integer&, const integer&)> expect;
  std::function<fixproof::batch::report(const Spans&, const fixproof::batch::options&)> call;
  /// Whether an element with this fault throws if there are no marks.
  std::function<bool(Fault)> throws;
};

void check(const Operation& operation);

}  // namespace batch_formats
