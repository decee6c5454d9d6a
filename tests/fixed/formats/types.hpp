/// \file
/// The formats that the tests of this folder cover: every width, signed and unsigned, with no, few,
/// all but one and all bits after the point.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "fixed/number.hpp"
#include "tests/support/test.hpp"

namespace formats {

inline constexpr fixproof::policy even_saturate{.multiply = fixproof::rounding::half_even,
                                                .divide = fixproof::rounding::half_even,
                                                .range = fixproof::overflow::saturate};
inline constexpr fixproof::policy away_trap{.multiply = fixproof::rounding::half_away,
                                            .divide = fixproof::rounding::half_away,
                                            .range = fixproof::overflow::trap};
inline constexpr fixproof::policy truncate_saturate{.multiply = fixproof::rounding::truncate,
                                                    .divide = fixproof::rounding::truncate,
                                                    .range = fixproof::overflow::saturate};
inline constexpr fixproof::policy floor_wrap{.multiply = fixproof::rounding::floor,
                                             .divide = fixproof::rounding::floor};
/// Products wrap and quotients saturate, as those of Doom; sums throw.
inline constexpr fixproof::policy mixed{.multiply = fixproof::rounding::floor,
                                        .divide = fixproof::rounding::truncate,
                                        .range = fixproof::overflow::trap,
                                        .products = fixproof::overflow::wrap,
                                        .quotients = fixproof::overflow::saturate};

/// The divides of processors.
inline constexpr fixproof::policy whole_divisor{.multiply = fixproof::rounding::floor,
                                                .divide = fixproof::rounding::half_away,
                                                .divisor = fixproof::divisor_width::whole_part,
                                                .fault = fixproof::divide_fault::zero_divisor};
inline constexpr fixproof::policy signed_fault{.divide = fixproof::rounding::truncate,
                                               .fault = fixproof::divide_fault::signed_quotient};
inline constexpr fixproof::policy unsigned_fault{
    .divide = fixproof::rounding::half_away, .fault = fixproof::divide_fault::unsigned_quotient};

using fixproof::number;

using narrow =
    testing::Types<number<std::int8_t, 0, even_saturate>, number<std::int8_t, 4>,
                   number<std::int8_t, 7, away_trap>, number<std::int8_t, 8, truncate_saturate>,
                   number<std::int8_t, 8, floor_wrap>, number<std::uint8_t, 0, mixed>,
                   number<std::uint8_t, 3, even_saturate>, number<std::uint8_t, 8>,
                   number<std::int8_t, 4, whole_divisor>, number<std::int8_t, 5, signed_fault>,
                   number<std::int8_t, 3, unsigned_fault>, number<std::uint8_t, 4, unsigned_fault>>;

using wide = testing::Types<
    number<std::int8_t, 4, mixed>, number<std::int16_t, 8, even_saturate>, number<std::int16_t, 15>,
    number<std::uint16_t, 16, away_trap>, number<std::int32_t, 0, mixed>,
    number<std::int32_t, 0, even_saturate>, number<std::int32_t, 8, floor_wrap>,
    number<std::int32_t, 16, even_saturate>, number<std::int32_t, 16, mixed>,
    number<std::int32_t, 24, truncate_saturate>, number<std::int32_t, 30>,
    number<std::int32_t, 31, even_saturate>, number<std::int32_t, 32, away_trap>,
    number<std::uint32_t, 0>, number<std::uint32_t, 16, mixed>,
    number<std::uint32_t, 32, even_saturate>, number<std::int64_t, 0, away_trap>,
    number<std::int64_t, 16>, number<std::int64_t, 32, even_saturate>,
    number<std::int64_t, 62, truncate_saturate>, number<std::int64_t, 63, floor_wrap>,
    number<std::int64_t, 64, even_saturate>, number<std::uint64_t, 0, mixed>,
    number<std::uint64_t, 32>, number<std::uint64_t, 64, away_trap>>;

/// A test that gets a type as a `Calls`: a table of functions that Calls::of makes for each type.
template <class Calls>
class TestOfCalls : public testing::Test {
 public:
  using Body = void (*)(const Calls&);
  TestOfCalls(Body body, Calls calls) : body_(body), calls_(std::move(calls)) {}
  void TestBody() override { body_(calls_); }

 private:
  Body body_;
  Calls calls_;
};

/// How to make the name and the calls of a type.
template <class Calls>
struct Maker {
  std::string (*name)();
  Calls (*calls)();
};
template <class Calls, class... N>
std::vector<Maker<Calls>> makers(testing::Types<N...> /*formats*/) {
  return {{testing::internal::GetTypeName<N>, Calls::template of<N>}...};
}

/// Registers a test for each of the formats under the names that TYPED_TEST gives. Its body is
/// compiled once, and not for every format: only what calls the operations has to be.
template <class Formats, class Calls>
bool test_each(const char* suite, const char* test, void (*body)(const Calls&),
               const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  int number = 0;
  for (const auto& maker : makers<Calls>(Formats())) {
    const std::string suite_of_type = suite + std::string("/") + std::to_string(number++);
    testing::RegisterTest(
        suite_of_type.c_str(), test, maker.name().c_str(), nullptr, file, line,
        [=]() -> testing::Test* { return new TestOfCalls<Calls>(body, maker.calls()); });
  }
  return true;
}

}  // namespace formats
