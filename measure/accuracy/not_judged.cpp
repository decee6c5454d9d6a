#include <array>

#include "measure/clocks/claims.hpp"

namespace fixproof::measure {

namespace {

constexpr std::array statements{
    NotJudged{
        "A fixed-point multiply is up to 100 times as fast as an emulated floating-point one.",
        "chapter 52, three keys to real-time performance", "the emulator's code is not printed"},
    NotJudged{"All three keys make the animation more than ten times as fast as with the emulator.",
              "chapter 52, three keys to real-time performance",
              "the emulator's code is not printed, and drawing is part of it"},
    NotJudged{"Sine and cosine of the emulator took over half of the time.",
              "chapter 53, look it up", "the emulator's code is not printed"},
    NotJudged{"At first, matrix and projection math took more than 90 % of the time.",
              "chapter 53, look it up",
              "the program of that time is floating-point C, which these chapters do not print"},
};

}  // namespace

std::span<const NotJudged> not_judged() { return statements; }

}  // namespace fixproof::measure
