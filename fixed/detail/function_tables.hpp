/// \file
/// The tables and constants of the functions. scripts/function-tables writes this file.
#pragma once

#include <array>
#include <cstdint>

namespace fixproof::detail {

/// A constant of 192 bits, the lowest word first.
using real_words = std::array<std::uint64_t, 3>;

/// 2^(i/32) in units of 2^-63, rounded down.
inline constexpr std::array<std::uint64_t, 32> powers_of_two{
    0x8000000000000000, 0x82cd8698ac2ba1d7, 0x85aac367cc487b14, 0x88980e8092da8527,
    0x8b95c1e3ea8bd6e6, 0x8ea4398b45cd53c0, 0x91c3d373ab11c336, 0x94f4efa8fef70961,
    0x9837f0518db8a96f, 0x9b8d39b9d54e5538, 0x9ef5326091a111ad, 0xa27043030c496818,
    0xa5fed6a9b15138ea, 0xa9a15ab4ea7c0ef8, 0xad583eea42a14ac6, 0xb123f581d2ac258f,
    0xb504f333f9de6484, 0xb8fbaf4762fb9ee9, 0xbd08a39f580c36be, 0xc12c4cca66709456,
    0xc5672a115506dadd, 0xc9b9bd866e2f27a2, 0xce248c151f8480e3, 0xd2a81d91f12ae45a,
    0xd744fccad69d6af4, 0xdbfbb797daf23755, 0xe0ccdeec2a94e111, 0xe5b906e77c8348a8,
    0xeac0c6e7dd24392e, 0xefe4b99bdcdaf5cb, 0xf5257d152486cc2c, 0xfa83b2db722a033a};

/// Coefficient n is (log(2)/32)^n / n! in units of 2^-64, rounded down, for n from 1.
inline constexpr std::array<std::uint64_t, 8> power_coefficients{
    0x58b90bfbe8e7bcd, 0xf5fdeffc162c7, 0x1c6b08d704a0, 0x276556df74,
    0x2bb0ffcf,        0x286122,        0x1ffc,         0x16};

/// 1 / (1 + i/64) in units of 2^-32, rounded up.
inline constexpr std::array<std::uint64_t, 64> reciprocals{
    0x100000000, 0xfc0fc0fd, 0xf83e0f84, 0xf4898d60, 0xf0f0f0f1, 0xed7303b6, 0xea0ea0eb,
    0xe6c2b449,  0xe38e38e4, 0xe070381d, 0xdd67c8a7, 0xda740da8, 0xd79435e6, 0xd4c77b04,
    0xd20d20d3,  0xcf6474a9, 0xcccccccd, 0xca4587e7, 0xc7ce0c7d, 0xc565c87c, 0xc30c30c4,
    0xc0c0c0c1,  0xbe82fa0c, 0xbc52640c, 0xba2e8ba3, 0xb81702e1, 0xb60b60b7, 0xb40b40b5,
    0xb21642c9,  0xb02c0b03, 0xae4c415d, 0xac769185, 0xaaaaaaab, 0xa8e83f58, 0xa72f053a,
    0xa57eb503,  0xa3d70a3e, 0xa237c32c, 0xa0a0a0a1, 0x9f1165e8, 0x9d89d89e, 0x9c09c09d,
    0x9a90e7da,  0x991f1a52, 0x97b425ee, 0x964fda6d, 0x94f20950, 0x939a85c5, 0x92492493,
    0x90fdbc0a,  0x8fb823ef, 0x8e78356e, 0x8d3dcb09, 0x8c08c08d, 0x8ad8f2fc, 0x89ae408a,
    0x88888889,  0x8767ab60, 0x864b8a7e, 0x85340854, 0x84210843, 0x83126e98, 0x82082083,
    0x81020409};

/// -log2 of the reciprocals in units of 2^-64, to nearest.
inline constexpr std::array<std::uint64_t, 64> logarithms{0x0,
                                                          0x5b9e5a010b0099c,
                                                          0xb5d69ba995434ce,
                                                          0x10eb389ee9f55f8b,
                                                          0x1663f6fab1fdcf18,
                                                          0x1bc842405ce14082,
                                                          0x2118b1183814ad28,
                                                          0x2655d3c385cd0fc6,
                                                          0x2b8034733f02d416,
                                                          0x3098579ecfd8566b,
                                                          0x359ebc59d5e4c676,
                                                          0x3a93dc972188f80a,
                                                          0x3f782d7065510f2b,
                                                          0x444c1f6a20193709,
                                                          0x49101eaa8d133d3a,
                                                          0x4dc49339b2283b4c,
                                                          0x5269e12ed8190e65,
                                                          0x570068e76a9fc3f9,
                                                          0x5b8887363a7e46e1,
                                                          0x6002958b2c5cb0a8,
                                                          0x646eea22aeb28eed,
                                                          0x68cdd82984518ba3,
                                                          0x6d1fafdcb3dff3c6,
                                                          0x7164beb43202f500,
                                                          0x759d4f809d7dad2f,
                                                          0x79c9aa8654640ed0,
                                                          0x7dea15a13bd1bc3b,
                                                          0x81fed45ac6bd28c6,
                                                          0x86082805579603d7,
                                                          0x8a064fd48a6fc26b,
                                                          0x8df988f3d33648dd,
                                                          0x91e20e9f2c1a2804,
                                                          0x95c01a39432c4c76,
                                                          0x9993e353a9111393,
                                                          0x9d5d9fd3d4f69644,
                                                          0xa11d83f3d6bb2f6c,
                                                          0xa4d3c25d25b2706a,
                                                          0xa8808c36325e5cda,
                                                          0xac241133e99f77dc,
                                                          0xafbe7f9ef4795316,
                                                          0xb3500471274705ac,
                                                          0xb6d8cb5169f10413,
                                                          0xba58feb0e7d0e080,
                                                          0xbdd0c7c81422bee6,
                                                          0xc1404eab9b5a569a,
                                                          0xc4a7ba55d98dc7e6,
                                                          0xc80730add617b678,
                                                          0xcb5ed692fc3679af,
                                                          0xceaecfe8b2dc074d,
                                                          0xd1f73f9a0d0d128d,
                                                          0xd53847a985dd708b,
                                                          0xd8720933828f7ac6,
                                                          0xdba4a47a362c6d61,
                                                          0xded038e3a7da4cc1,
                                                          0xe1f4e516262ddfa8,
                                                          0xe512c6e46e4e8b6f,
                                                          0xe829fb67ed1acc11,
                                                          0xeb3a9eff6d51c678,
                                                          0xee44cd59ba6b8cc4,
                                                          0xf148a16e5d2096e8,
                                                          0xf446359875ea7edd,
                                                          0xf73da38c5a209c64,
                                                          0xfa2f045bb829a8e7,
                                                          0xfd1a70890f588f15};

/// Coefficient n is log2(e) / (n 32^n) in units of 2^-64, to nearest, for n from 1.
inline constexpr std::array<std::uint64_t, 10> logarithm_coefficients{
    0xb8aa3b295c17f0c, 0x2e2a8eca5705fc, 0xf6384ee1d020, 0x5c551d94ae1, 0x24eed8a1df,
    0xf6384ee2,        0x6985d8b,        0x2e2a8f,       0x1484b,       0x93c};

/// log2(e) in units of 2^-63, rounded down.
inline constexpr std::uint64_t log2_e = 0xb8aa3b295c17f0bb;

/// log2(e) in units of 2^-184, to nearest.
inline constexpr real_words real_log2_e{0x11d6aef551bad2b5, 0x777d0ffda0d23a7d, 0x171547652b82fe1};

/// log(2) in units of 2^-184, to nearest.
inline constexpr real_words real_log_2{0xaf40f343267298b6, 0xabc9e3b39803f2f6, 0xb17217f7d1cf79};

/// log10(2) in units of 2^-184, to nearest.
inline constexpr real_words real_log10_2{0xbc13569862a1e8fa, 0xcc47c4acd605be48, 0x4d104d427de7fb};

/// The arctangent of i/32 in units of 2^-58, to nearest.
inline constexpr std::array<std::uint64_t, 33> arctangents{0x0,
                                                           0x1ffd55bba97625,
                                                           0x3feab76e59fbd4,
                                                           0x5fb860980bc43a,
                                                           0x7f56ea6ab0bdb7,
                                                           0x9eb77746331363,
                                                           0xbdcbda5e72d811,
                                                           0xdc86ba94930510,
                                                           0xfadbafc96406eb,
                                                           0x118bf5a30bf1782,
                                                           0x1362773707ebcbd,
                                                           0x1530ad9951cd49e,
                                                           0x16f61941e4def09,
                                                           0x18b24d394a1b257,
                                                           0x1a64eec3cc23fcb,
                                                           0x1c0db4c94ec9ef9,
                                                           0x1dac670561bb4f7,
                                                           0x1f40dd0b541417d,
                                                           0x20cafd29b6619f9,
                                                           0x224abb37f7a551f,
                                                           0x23c01757bdfd67e,
                                                           0x252b1cb2611c61c,
                                                           0x268be0399c6f769,
                                                           0x27e27f713d2de88,
                                                           0x292f1f464d3dc25,
                                                           0x2a71eaf7120c3d7,
                                                           0x2bab130e2d36302,
                                                           0x2cdacc7247c10da,
                                                           0x2e014f8af08c67a,
                                                           0x2f1ed77aba62bca,
                                                           0x3033a16e2b14999,
                                                           0x313febfeafe3ef5,
                                                           0x3243f6a8885a309};

/// Coefficient n is 1 / ((2n + 1) 1024^n) in units of 2^-64, to nearest, for n from 1.
inline constexpr std::array<std::uint64_t, 4> arctangent_coefficients{
    0x15555555555555, 0x33333333333, 0x92492492, 0x1c71c7};

/// Pi in units of 2^-58, to nearest.
inline constexpr std::uint64_t pi_58 = 0xc90fdaa22168c23;

/// Pi in units of 2^-184, to nearest.
inline constexpr real_words real_pi{0x44a4093822299f32, 0xd313198a2e037073, 0x3243f6a8885a308};

/// 2/pi in units of 2^-184, to nearest.
inline constexpr real_words real_2_over_pi{0xc0db6295993c4390, 0x29fc2757d1f534dd,
                                           0xa2f9836e4e4415};

/// 1 / (2 pi) in units of 2^-128, rounded down: the upper 64 bits.
inline constexpr std::uint64_t turns_high = 0x28be60db9391054a;

/// The lower 64 bits.
inline constexpr std::uint64_t turns_low = 0x7f09d5f47d4d3770;

}  // namespace fixproof::detail
