/// @file
/// The polynomials of fixed/batch/detail/elementary_lanes.hpp. tests/tools/batch-polynomials writes
/// this file.
#pragma once

#include <array>

namespace fixproof::detail {

/// 2^r for |r| <= 1/2, the lowest power first. The error is below 2^-34.
inline constexpr std::array<double, 8> few_power_terms{
    0x1.ffffffffa7135p-1, 0x1.62e42fef9cc69p-1,  0x1.ebfbe0aa03df0p-3,  0x1.c6b08da70cce3p-5,
    0x1.3b29d8bb0b97ep-7, 0x1.5d877598350dep-10, 0x1.446c79efd4834p-13, 0x1.00c0e4e15189cp-16};

/// 2^r for |r| <= 1/2, the lowest power first. The error is below 2^-45.
inline constexpr std::array<double, 10> many_power_terms{
    0x1.000000000003dp+0,  0x1.62e42fefa39f7p-1,  0x1.ebfbdff8149f2p-3,  0x1.c6b08d7044119p-5,
    0x1.3b2ab72b175eep-7,  0x1.5d87fe908f88ap-10, 0x1.43088e257f341p-13, 0x1.ffcb76789860fp-17,
    0x1.63ef969a64d3cp-20, 0x1.b6571de2f2351p-24};

/// log2((1 + s) / (1 - s)) / s in powers of s^2, for 0 <= s^2 <= 0.02944. The error is below 2^-28.
inline constexpr std::array<double, 4> few_logarithm_terms{
    0x1.7154764e7a3bep+1, 0x1.ec70e5c137569p-1, 0x1.2747342b31f7cp-1, 0x1.ba14b2b48645fp-2};

/// log2((1 + s) / (1 - s)) / s in powers of s^2, for 0 <= s^2 <= 0.02944. The error is below 2^-43.
inline constexpr std::array<double, 6> many_logarithm_terms{
    0x1.71547652b8252p+1, 0x1.ec709dc53a191p-1, 0x1.2776c295b26e6p-1,
    0x1.a61a2cf64013dp-2, 0x1.47959d3c06f22p-2, 0x1.21ad23db025b1p-2};

/// atan(z) / z in powers of z^2, for 0 <= z^2 <= 0.17158. The error is below 2^-30.
inline constexpr std::array<double, 6> few_arctangent_terms{
    0x1.fffffffa98fe9p-1,  -0x1.555543960efc6p-2, 0x1.9990128d91d9cp-3,
    -0x1.23a0227152480p-3, 0x1.b0f04af62ffe9p-4,  -0x1.edaabd926e862p-5};

/// atan(z) / z in powers of z^2, for 0 <= z^2 <= 0.17158. The error is below 2^-45.
inline constexpr std::array<double, 9> many_arctangent_terms{
    0x1.fffffffffff0fp-1,  -0x1.55555554e608ap-2, 0x1.99999911ce515p-3,
    -0x1.2492291bdb860p-3, 0x1.c714d467be8dep-4,  -0x1.73d9d25f008fep-4,
    0x1.35cf0ab85eb3fp-4,  -0x1.e13c40931e3fcp-5, 0x1.f65c4f3fe8298p-6};

/// sin(pi t) / t in powers of t^2, for |t| <= 1/2. The error is below 2^-33.
inline constexpr std::array<double, 6> few_sine_terms{0x1.921fb54425516p+1, -0x1.4abbce51c31dap+2,
                                                      0x1.466bc06900900p+1, -0x1.32d12ebe6b560p-1,
                                                      0x1.5014072bd9ca2p-4, -0x1.cc9b5f3456b49p-8};

/// sin(pi t) / t in powers of t^2, for |t| <= 1/2. The error is below 2^-50.
inline constexpr std::array<double, 8> many_sine_terms{
    0x1.921fb54442d17p+1, -0x1.4abbce625bd83p+2, 0x1.466bc677522bdp+1,  -0x1.32d2cce1ea145p-1,
    0x1.5078327046959p-4, -0x1.e30631bdf732dp-8, 0x1.e89f6fe44fe7bp-12, -0x1.62903d02bb153p-16};

/// log2(e), to nearest, and the rest.
inline constexpr std::array<double, 2> two_log2_e{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};

/// 1 / pi, to nearest, and the rest.
inline constexpr std::array<double, 2> half_turns_per_radian{0x1.45f306dc9c883p-2,
                                                             -0x1.6b01ec5417056p-56};

/// 1 / 180, to nearest, and the rest.
inline constexpr std::array<double, 2> half_turns_per_degree{0x1.6c16c16c16c17p-8,
                                                             -0x1.f49f49f49f49fp-63};

/// log(2), log10(2) and pi, to nearest.
inline constexpr double log_2 = 0x1.62e42fefa39efp-1;
inline constexpr double log10_2 = 0x1.34413509f79ffp-2;
inline constexpr double double_pi = 0x1.921fb54442d18p+1;
}  // namespace fixproof::detail
