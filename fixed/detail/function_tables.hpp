/// @file
/// The tables and constants of the functions. tests/tools/function-tables writes this file.
#pragma once

#include <array>
#include <cstdint>

#include "fixed/detail/gpu.hpp"

namespace fixproof::detail {

/// A constant of 192 bits, the lowest word first.
using real_words = std::array<std::uint64_t, 3>;

/// 2^(i/32) in units of 2^-63, rounded down.
FIXED_CONSTANT std::array<std::uint64_t, 32> powers_of_two{
    0x8000000000000000, 0x82cd8698ac2ba1d7, 0x85aac367cc487b14, 0x88980e8092da8527,
    0x8b95c1e3ea8bd6e6, 0x8ea4398b45cd53c0, 0x91c3d373ab11c336, 0x94f4efa8fef70961,
    0x9837f0518db8a96f, 0x9b8d39b9d54e5538, 0x9ef5326091a111ad, 0xa27043030c496818,
    0xa5fed6a9b15138ea, 0xa9a15ab4ea7c0ef8, 0xad583eea42a14ac6, 0xb123f581d2ac258f,
    0xb504f333f9de6484, 0xb8fbaf4762fb9ee9, 0xbd08a39f580c36be, 0xc12c4cca66709456,
    0xc5672a115506dadd, 0xc9b9bd866e2f27a2, 0xce248c151f8480e3, 0xd2a81d91f12ae45a,
    0xd744fccad69d6af4, 0xdbfbb797daf23755, 0xe0ccdeec2a94e111, 0xe5b906e77c8348a8,
    0xeac0c6e7dd24392e, 0xefe4b99bdcdaf5cb, 0xf5257d152486cc2c, 0xfa83b2db722a033a};

/// Coefficient n is (log(2)/32)^n / n! in units of 2^-64, rounded down, for n from 1.
FIXED_CONSTANT std::array<std::uint64_t, 8> power_coefficients{
    0x58b90bfbe8e7bcd, 0xf5fdeffc162c7, 0x1c6b08d704a0, 0x276556df74,
    0x2bb0ffcf,        0x286122,        0x1ffc,         0x16};

/// 1 / (1 + i/64) in units of 2^-32, rounded up.
FIXED_CONSTANT std::array<std::uint64_t, 64> reciprocals{
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
FIXED_CONSTANT std::array<std::uint64_t, 64> logarithms{0x0,
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
FIXED_CONSTANT std::array<std::uint64_t, 10> logarithm_coefficients{
    0xb8aa3b295c17f0c, 0x2e2a8eca5705fc, 0xf6384ee1d020, 0x5c551d94ae1, 0x24eed8a1df,
    0xf6384ee2,        0x6985d8b,        0x2e2a8f,       0x1484b,       0x93c};

/// The cube roots of 1 divided by the reciprocals in units of 2^-63, to nearest.
FIXED_CONSTANT std::array<std::uint64_t, 64> cube_roots{
    0x8000000000000000, 0x80a9c910c1841cd6, 0x8151d6977616d668, 0x81f833b8bbc83cc3,
    0x829ceb290672df0e, 0x8340073145218c0f, 0x83e191b557e444ad, 0x84819439637b0eea,
    0x852017e62664bc73, 0x85bd258dbb1566d0, 0x8658c5b0a5cb6d25, 0x86f3008100800822,
    0x878bdde68d2dbc07, 0x88236582a6a118e2, 0x88b99eb2e6ebb49e, 0x894e909531f0e732,
    0x89e24209b804f0d4, 0x8a74b9b65ce3ca99, 0x8b05fe096746e188, 0x8b96153b71da4465,
    0x8c25055286643844, 0x8cb2d423f0ab095a, 0x8d3f8755bc5f3fd8, 0x8dcb2461b765c188,
    0x8e55b096f6e3f09d, 0x8edf311b25f7e7e3, 0x8f67aaed1309618a, 0x8fef22e597c49ccb,
    0x90759db94cf1e7d1, 0x90fb1ff9f3240188, 0x917fae17bcb28fef, 0x92034c62f502f030,
    0x9285ff0d6babfd4c, 0x9307ca2a1a6949f8, 0x9388b1b0ade24905, 0x9408b97c53e71495,
    0x9487e54e0fbd6ecf, 0x950638cd5e4e35b5, 0x9583b78970b74ee5, 0x960064f8ce5f35e1,
    0x967c447c47e262e7, 0x96f7595d7071a9c3, 0x9771a6d1a4dc29c8, 0x97eb2ff8c07acdb5,
    0x9863f7df1e09ef77, 0x98dc017e141cc128, 0x99534fbc23019254, 0x99c9e56dd283c3d5,
    0x9a3fc556957d684c, 0x9ab4f2289cf819de, 0x9b296e86600873c9, 0x9b9d3d02547d7c9a,
    0x9c10601ffdb0d75d, 0x9c82da530f996d0b, 0x9cf4ae02e2203395, 0x9d65dd871b8ee2df,
    0x9dd66b2ae1f1b7f1, 0x9e46592c2df6d870, 0x9eb5a9bcd51d0418, 0x9f245f0109c50855,
    0x9f927b12c25aa7fb, 0x9fffffffd1555555, 0xa06cefca12ef25d7, 0xa0d94c69d84f179d};

/// The cube roots of 1, 2 and 4 in units of 2^-62, to nearest.
FIXED_CONSTANT std::array<std::uint64_t, 3> roots_of_powers{0x4000000000000000, 0x50a28be635ca2b89,
                                                            0x6597fa94f5b8f20b};

/// Coefficient n is that of r^n in (1 + r)^(1/3), without its sign and divided by 32^n, in units of
/// 2^-64, to nearest, for n from 1.
FIXED_CONSTANT std::array<std::uint64_t, 4> cube_root_coefficients{
    0x2aaaaaaaaaaaaab, 0x71c71c71c71c7, 0x1f9add3c0ca4, 0xa88f469599};

/// log2(e) in units of 2^-63, rounded down.
FIXED_CONSTANT std::uint64_t log2_e = 0xb8aa3b295c17f0bb;

/// log2(e) in units of 2^-184, to nearest.
FIXED_CONSTANT real_words real_log2_e{0x11d6aef551bad2b5, 0x777d0ffda0d23a7d, 0x171547652b82fe1};

/// log(2) in units of 2^-184, to nearest.
FIXED_CONSTANT real_words real_log_2{0xaf40f343267298b6, 0xabc9e3b39803f2f6, 0xb17217f7d1cf79};

/// log10(2) in units of 2^-184, to nearest.
FIXED_CONSTANT real_words real_log10_2{0xbc13569862a1e8fa, 0xcc47c4acd605be48, 0x4d104d427de7fb};

/// The arctangent of i/64 in units of 2^-58, to nearest.
FIXED_CONSTANT std::array<std::uint64_t, 65> arctangents{0x0,
                                                         0xfffaaadddb94d,
                                                         0x1ffd55bba97625,
                                                         0x2ff7030861b454,
                                                         0x3feab76e59fbd4,
                                                         0x4fd67c39f15676,
                                                         0x5fb860980bc43a,
                                                         0x6f8e7af9bc1f0e,
                                                         0x7f56ea6ab0bdb7,
                                                         0x8f0fd7d821b937,
                                                         0x9eb77746331363,
                                                         0xae4c08f1f6134f,
                                                         0xbdcbda5e72d811,
                                                         0xcd35474b643131,
                                                         0xdc86ba94930510,
                                                         0xebbeaef902b9b4,
                                                         0xfadbafc96406eb,
                                                         0x109dc597d863626,
                                                         0x118bf5a30bf1782,
                                                         0x1278372057ef45c,
                                                         0x1362773707ebcbd,
                                                         0x144aa436c2af09b,
                                                         0x1530ad9951cd49e,
                                                         0x1614840309cfe19,
                                                         0x16f61941e4def09,
                                                         0x17d5604b63b3f76,
                                                         0x18b24d394a1b257,
                                                         0x198cd5454d6b186,
                                                         0x1a64eec3cc23fcb,
                                                         0x1b3a911da65c6c7,
                                                         0x1c0db4c94ec9ef9,
                                                         0x1cde53432c13509,
                                                         0x1dac670561bb4f7,
                                                         0x1e77eb7f175a344,
                                                         0x1f40dd0b541417d,
                                                         0x200738e78348172,
                                                         0x20cafd29b6619f9,
                                                         0x218c28b6b687b42,
                                                         0x224abb37f7a551f,
                                                         0x2306b5117cf826e,
                                                         0x23c01757bdfd67e,
                                                         0x2476e3c5993cd44,
                                                         0x252b1cb2611c61c,
                                                         0x25dcc5080d9794e,
                                                         0x268be0399c6f769,
                                                         0x27387239a82e337,
                                                         0x27e27f713d2de88,
                                                         0x288a0cb6f2b6ab8,
                                                         0x292f1f464d3dc25,
                                                         0x29d1bcb76dd808a,
                                                         0x2a71eaf7120c3d7,
                                                         0x2b0fb03ee65f75b,
                                                         0x2bab130e2d36302,
                                                         0x2c441a22baf71be,
                                                         0x2cdacc7247c10da,
                                                         0x2d6f3124167b313,
                                                         0x2e014f8af08c67a,
                                                         0x2e912f1f751c1e1,
                                                         0x2f1ed77aba62bca,
                                                         0x2faa50513f4126b,
                                                         0x3033a16e2b14999,
                                                         0x30bad2aed9858a3,
                                                         0x313febfeafe3ef5,
                                                         0x31c2f5533980bb8,
                                                         0x3243f6a8885a309};

/// The tangent of i/64 of a quarter turn in units of 2^-62, to nearest, for i to 32.
FIXED_CONSTANT std::array<std::uint64_t, 33> tangents{0x0,
                                                      0x192346247a91f00,
                                                      0x324e4f147622c40,
                                                      0x4b88e733fce0c58,
                                                      0x64daee316cb6898,
                                                      0x7e4c60ea36e7a37,
                                                      0x97e5639d3032013,
                                                      0xb1ae4c867069ae6,
                                                      0xcbafaf02a98ac04,
                                                      0xe5f2675a5a67929,
                                                      0x1007fa758626ae2b,
                                                      0x11b6103d3597e939,
                                                      0x136a08355c63dbc5,
                                                      0x15248ae1701b1770,
                                                      0x16e649f7d786492f,
                                                      0x18b00196b3d021d2,
                                                      0x1a827999fcef3242,
                                                      0x1c5e87185e67b610,
                                                      0x1e450e0d273e7a50,
                                                      0x20370336b4f9ee86,
                                                      0x22356e321069d70d,
                                                      0x24416bde08f04a1b,
                                                      0x265c311208fff978,
                                                      0x28870db739cbb52c,
                                                      0x2ac370556ff320bd,
                                                      0x2d12ea28ea3b6c51,
                                                      0x2f7733da53219d2b,
                                                      0x31f232f7f0bdd5a2,
                                                      0x34860055c8509f96,
                                                      0x3734ef831835e45c,
                                                      0x3a01978e709a5c63,
                                                      0x3ceedd5f922e0cc9,
                                                      0x4000000000000000};

/// Coefficient n is that of z^(2n + 1) in tan(z), divided by 1024^n, in units of 2^-64, to nearest,
/// for n from 1.
FIXED_CONSTANT std::array<std::uint64_t, 4> tangent_coefficients{0x15555555555555, 0x22222222222,
                                                                 0x37437437, 0x5993d};

/// Coefficient n is 1 / ((2n + 1) 1024^n) in units of 2^-64, to nearest, for n from 1.
FIXED_CONSTANT std::array<std::uint64_t, 4> arctangent_coefficients{0x15555555555555, 0x33333333333,
                                                                    0x92492492, 0x1c71c7};

/// Pi in units of 2^-58, to nearest.
FIXED_CONSTANT std::uint64_t pi_58 = 0xc90fdaa22168c23;

/// What pi_58 lacks in units of 2^-90, to nearest.
FIXED_CONSTANT std::int32_t pi_rest = 0x4c4c6629;

/// What the arctangents of i/64 lack in units of 2^-90, to nearest.
FIXED_CONSTANT std::array<std::int32_t, 64> arctangent_rests{
    0x0,         0x5bbe78c5,  -0x57b10c51, -0xc377c7c,  -0x724d361b, -0x53b31d7a, 0x3049ab3f,
    -0x8470d66,  0x19644bcc,  0x25bd3759,  -0x3cb89e63, -0x54ab2c0,  0x347b0b50,  -0x184ff0c2,
    0x22f621a6,  -0x736e5d59, 0x156dc79f,  -0x746e31bd, 0x61948e91,  -0x1df374db, -0x2c74a897,
    -0x75790f15, -0x4acc9011, 0x636a3aa4,  -0x18eab9be, -0x58dde8f5, -0x24bd1723, 0x79b2623f,
    0x6c84f92c,  -0x479e138d, -0x30739c25, 0x74c16efa,  -0x75203774, 0x394f7070,  -0x47325b87,
    0x669b5b1b,  -0x56d257d9, -0x68b05ec5, -0x2bdaee1c, 0x310e7600,  0x6d720d78,  -0x77bc6c19,
    -0x279cec32, 0x2eaf4ff8,  -0x7ef7641c, -0x182198ec, -0x4c1d2db6, 0x224bfa70,  -0x6f995e03,
    0x519edf5a,  0x2245aa13,  -0x79727631, 0x51c979,    -0x56f0a6a2, 0x45640506,  -0x401c30c4,
    -0x30d3496b, -0x426acf4d, 0x35044c0,   -0x4fbef0e8, 0x227758b,   -0x29323007, 0x5232d0f4,
    0x4f9f553f};

/// Coefficient n is 2 / ((2n + 3) 4096^(n - 1)) in units of 2^-64, to nearest, for n from 1.
FIXED_CONSTANT std::array<std::uint64_t, 5> long_arctangent_coefficients{
    0x6666666666666666, 0x4924924924925, 0x38e38e38e4, 0x2e8ba2f, 0x2762};

/// The arcsine of i/64 in units of 2^-62, to nearest, for i to 45.
FIXED_CONSTANT std::array<std::uint64_t, 46> arcsines{0x0,
                                                      0x10002aabdde94c1,
                                                      0x2001557bc173904,
                                                      0x30048123fb61526,
                                                      0x400aaf7a54d8652,
                                                      0x5014e409039bf52,
                                                      0x602424a44f94b87,
                                                      0x70397a03dc5cb5e,
                                                      0x8055f06094f0f06,
                                                      0x907a98184660fc2,
                                                      0xa0a8865808a116f,
                                                      0xb0e0d5ceaae97cd,
                                                      0xc124a76873c7dd7,
                                                      0xd1752315a4cc6d6,
                                                      0xe1d3789d5742551,
                                                      0xf240e07e7389a02,
                                                      0x102be9ce0b87cd1e,
                                                      0x1134dfa980514691,
                                                      0x123f0523c5dc2b0a,
                                                      0x134a709597aab0a4,
                                                      0x1457393b90e2aa6c,
                                                      0x1565774cb66f018f,
                                                      0x1675441329986e74,
                                                      0x1786ba074fef92a3,
                                                      0x1899f4edc962d305,
                                                      0x19af11f89ba61c6a,
                                                      0x1ac62fec0b2a9273,
                                                      0x1bdf6f47ae69047a,
                                                      0x1cfaf27460fe9ecf,
                                                      0x1e18ddf7da106aea,
                                                      0x1f3958aecddef3e0,
                                                      0x205c8c0eaf0b4274,
                                                      0x2182a4705ae6cb09,
                                                      0x22abd1654000a437,
                                                      0x23d84618e2952ca1,
                                                      0x250839c10c52e941,
                                                      0x263be81f7a639a04,
                                                      0x277392188652d9a2,
                                                      0x28af7e631fca2d4f,
                                                      0x29effa5785f66714,
                                                      0x2b355ae39da01de5,
                                                      0x2c7ffdada331ecdb,
                                                      0x2dd04a7079881647,
                                                      0x2f26b4a035f4ef2d,
                                                      0x3083bd6a2297675b,
                                                      0x31e7f629c92d68ba};

/// The cosine of the arcsine of i/64 in units of 2^-63, to nearest.
FIXED_CONSTANT std::array<std::uint64_t, 46> arcsine_cosines{
    0x8000000000000000, 0x7ffbffefff7ffb00, 0x7feffeffdffaff20, 0x7fdbfaee92ffa876,
    0x7fbfeff7fafc7d5e, 0x7f9bd8d15d91dbf8, 0x7f6faea45f0fd52c, 0x7f3b69087bf6d3ea,
    0x7efefdfaf1d57a4d, 0x7eba61d50525fd9a, 0x7e6d87408dc941d4, 0x7e185f2aaf5bd8e7,
    0x7dbad8b49dcc32c0, 0x7d54e122493a04ba, 0x7ce663c6c621b16b, 0x7c6f49ee400b10ab,
    0x7bef7ac53d3b66c6, 0x7b66db3cf1198c1a, 0x7ad54dec50d3663e, 0x7a3ab2ed92243ed3,
    0x7996e7b7ae8e3791, 0x78e9c6f3758f76e6, 0x7833284ba5e252cf, 0x7772e03770216b91,
    0x76a8bfbeab875fd8, 0x75d49436e71e491e, 0x74f626f85d81c8aa, 0x740d3d09a608514a,
    0x731996c0ca1886e4, 0x721aef5826897fbb, 0x7110fc75348abb88, 0x6ffb6d9ef84eca2f,
    0x6ed9eba16132a9cf, 0x6dac17da59ae6b2f, 0x6c718b6c9593f9ed, 0x6b29d6535132f29d,
    0x69d47e511edc9096, 0x6870fdb2807ca319, 0x66fec1db48dbab2c, 0x657d29937b369ff8,
    0x63eb83056b4e2789, 0x6249095afd1514b1, 0x6094e1e2b8b82223, 0x5ece189e75efcc17,
    0x5cf39c13edec8d14, 0x5b04382a7975954c};

/// Coefficient n is that of z^(2n + 1) in asin(z), divided by 4096^n, in units of 2^-64, to
/// nearest, for n from 1.
FIXED_CONSTANT std::array<std::uint64_t, 3> arcsine_coefficients{0x2aaaaaaaaaaab, 0x1333333333,
                                                                 0xb6db6e};

/// Pi in units of 2^-184, to nearest.
FIXED_CONSTANT real_words real_pi{0x44a4093822299f32, 0xd313198a2e037073, 0x3243f6a8885a308};

/// 2/pi in units of 2^-184, to nearest.
FIXED_CONSTANT real_words real_2_over_pi{0xc0db6295993c4390, 0x29fc2757d1f534dd, 0xa2f9836e4e4415};

/// 1 / (2 pi) in units of 2^-128, rounded down: the upper 64 bits.
FIXED_CONSTANT std::uint64_t turns_high = 0x28be60db9391054a;

/// The lower 64 bits.
FIXED_CONSTANT std::uint64_t turns_low = 0x7f09d5f47d4d3770;

}  // namespace fixproof::detail
