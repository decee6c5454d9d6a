/// Tests which operations throw, and the text of their errors.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using trapping = q16_16_trapping;

template <class Error, class Call>
std::string text_of(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing thrown";
}

constexpr trapping highest_trapping = std::numeric_limits<trapping>::max();
constexpr trapping lowest_trapping = std::numeric_limits<trapping>::lowest();

TEST(Errors, SayTheOperationAndTheOperands) {
  const auto overflow = [](const auto& call) { return text_of<overflow_error>(call); };
  EXPECT_EQ(overflow([] { return trapping(32767) + trapping(2.5); }),
            "fixed-point overflow: operator+(32767, 2.5)");
  EXPECT_EQ(overflow([] { return lowest_trapping - trapping(1); }),
            "fixed-point overflow: operator-(-32768, 1)");
  EXPECT_EQ(overflow([] { return -lowest_trapping; }), "fixed-point overflow: operator-(-32768)");
  EXPECT_EQ(overflow([] { return trapping(200) * trapping(-300.5); }),
            "fixed-point overflow: operator*(200, -300.5)");
  EXPECT_EQ(overflow([] { return trapping(200) / trapping::from_raw(1); }),
            "fixed-point overflow: operator/(200, 0.0000152587890625)");
  EXPECT_EQ(overflow([] { return abs(lowest_trapping); }), "fixed-point overflow: abs(-32768)");
  EXPECT_EQ(overflow([] { return ceil(highest_trapping); }),
            "fixed-point overflow: ceil(32767.9999847412109375)");
  EXPECT_EQ(overflow([] { return round(highest_trapping); }),
            "fixed-point overflow: round(32767.9999847412109375)");
  EXPECT_EQ(overflow([] { return mul_add(trapping(200), trapping(200), trapping(1)); }),
            "fixed-point overflow: mul_add(200, 200, 1)");
  EXPECT_EQ(overflow([] { return lerp(trapping(0), trapping(200), trapping(200)); }),
            "fixed-point overflow: lerp(0, 200, 200)");
  const std::array<trapping, 3> terms{trapping(200), trapping(200), trapping()};
  EXPECT_EQ(overflow([&] { return dot(terms, terms); }), "fixed-point overflow: dot(3 terms)");
  EXPECT_EQ(overflow([] { return trapping(40000); }), "fixed-point overflow: conversion(40000)");
  EXPECT_EQ(overflow([] { return trapping(1e9); }), "fixed-point overflow: conversion(1e+09)");
  EXPECT_EQ(overflow([] { return trapping(std::numeric_limits<double>::infinity()); }),
            "fixed-point overflow: conversion(inf)");
  EXPECT_EQ(overflow([] { return q8_8_trapping(q16_16(1000)); }),
            "fixed-point overflow: conversion(1000)");
}

TEST(Errors, DivideErrors) {
  const auto divide = [](const auto& call) { return text_of<divide_error>(call); };
  EXPECT_EQ(divide([] { return trapping(1.5) / trapping(); }),
            "fixed-point divide error: operator/(1.5, 0)");
  EXPECT_EQ(divide([] { return q16_16_i8088(1) / q16_16_i8088(0.5); }),
            "fixed-point divide error: operator/(1, 0.5)");
  EXPECT_EQ(divide([] { return q16_16_i386(1) / q16_16_i386::from_raw(1); }),
            "fixed-point divide error: operator/(1, 0.0000152587890625)");
}

TEST(Errors, RemaindersByZero) {
  const auto divide = [](const auto& call) { return text_of<divide_error>(call); };
  const trapping one(1);
  const trapping zero;
  int quotient = 0;
  EXPECT_EQ(divide([&] { return one % zero; }), "fixed-point divide error: operator%(1, 0)");
  EXPECT_EQ(divide([&] { return fmod(one, zero); }), "fixed-point divide error: fmod(1, 0)");
  EXPECT_EQ(divide([&] { return remainder(one, zero); }),
            "fixed-point divide error: remainder(1, 0)");
  EXPECT_EQ(divide([&] { return remquo(one, zero, &quotient); }),
            "fixed-point divide error: remquo(1, 0)");
}

TEST(Errors, DomainErrors) {
  const auto domain = [](const auto& call) { return text_of<domain_error>(call); };
  EXPECT_EQ(domain([] { return sqrt(trapping(-4)); }), "fixed-point domain error: sqrt(-4)");
  EXPECT_EQ(domain([] { return trapping(std::numeric_limits<double>::quiet_NaN()); }),
            "fixed-point domain error: conversion(nan)");
  EXPECT_EQ(domain([] { return trapping(std::numeric_limits<float>::quiet_NaN()); }),
            "fixed-point domain error: conversion(nan)");
}

TEST(Errors, AreOfTheStandard) {
  EXPECT_THROW(static_cast<void>(highest_trapping + highest_trapping), std::overflow_error);
  EXPECT_THROW(static_cast<void>(highest_trapping / trapping()), std::domain_error);
  EXPECT_THROW(static_cast<void>(sqrt(lowest_trapping)), std::domain_error);
}

TEST(Errors, LeaveTheOperandAsItWas) {
  trapping x = highest_trapping;
  EXPECT_THROW(x += trapping(1), overflow_error);
  EXPECT_THROW(x *= trapping(2), overflow_error);
  EXPECT_THROW(x /= trapping(), divide_error);
  EXPECT_EQ(x, highest_trapping);
}

}  // namespace
