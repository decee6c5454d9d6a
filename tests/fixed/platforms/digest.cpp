// Prints one digest of everything that the type computes; any differing bit changes it. Draws
// operands from a counter, so every machine uses the same ones in the same order.
// usage: digest [OPERATIONS]
#ifdef _WIN32
#include <windows.h>  // its macros must not reach the type
#endif

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string_view>
#include <type_traits>

#include "fixed/fixed.hpp"

namespace {

/// SplitMix64 (Steele, Lea, Flood 2014): maps a counter to a word that looks random.
constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

class Digest {
 public:
  void add(std::uint64_t word) { state_ = std::rotl(state_ ^ word, 23) * 0x9fb21c651e98df25U; }
  template <class Raw, int F, fixproof::policy P>
  void add(fixproof::number<Raw, F, P> x) {
    add(static_cast<std::uint64_t>(static_cast<std::int64_t>(x.raw())));
  }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<unsigned char>(c));
  }
  [[nodiscard]] std::uint64_t value() const { return mix(state_); }

 private:
  std::uint64_t state_ = 0;
};

/// Operands of one case, of every magnitude; one in eight is at an edge of the range.
class Draws {
 public:
  explicit Draws(std::uint64_t number) : state_(mix(number)) {}
  std::uint64_t word() { return state_ = mix(state_); }
  template <class Number>
  Number number() {
    using raw = typename Number::raw_type;
    constexpr int bits = Number::fraction_bits;
    constexpr std::uint64_t one = bits < 64 ? std::uint64_t{1} << bits : 0;
    constexpr std::uint64_t half = bits > 0 ? std::uint64_t{1} << (bits - 1) : 0;
    static constexpr std::array edges{raw{0},
                                      raw{1},
                                      static_cast<raw>(-1),
                                      std::numeric_limits<raw>::min(),
                                      std::numeric_limits<raw>::max(),
                                      static_cast<raw>(one),
                                      static_cast<raw>(half),
                                      static_cast<raw>(0 - half)};
    const std::uint64_t w = word();
    if ((w & 7U) == 0) return Number::from_raw(edges.at((w >> 3U) & 7U));
    const auto narrower = (w >> 8U) % std::numeric_limits<raw>::digits;
    const std::uint64_t random = sizeof(raw) == 8 ? word() : w >> 32U;
    return Number::from_raw(static_cast<raw>(static_cast<raw>(random) >> narrower));
  }

 private:
  std::uint64_t state_;
};

/// The operations of the presets, numbered. A trapping type takes part only where it does not
/// throw; the tests cover its exceptions.
constexpr std::uint64_t operations = 17;
/// Those of the other formats: also exact intermediate results, and overflow as a value.
constexpr std::uint64_t format_operations = 19;

/// Whether the number has angles in tenths of a degree, and in radians.
template <class N>
constexpr bool has_tenths = std::is_signed_v<typename N::raw_type> &&
                            sizeof(N) <= 4 && N::fraction_bits > 0 &&
                            N::fraction_bits < std::numeric_limits<typename N::raw_type>::digits;
template <class N>
constexpr bool has_radians = has_tenths<N> && sizeof(N) * 4 == N::fraction_bits && sizeof(N) > 1;

template <class N>
void compute(std::uint64_t operation, Draws& draw, Digest& digest) {
  using namespace fixproof;
  const N a = draw.number<N>();
  const N b = draw.number<N>();
  const N c = draw.number<N>();
  const auto returning = [&](auto f) {
    if constexpr (N::never_throws) f();
  };
  switch (operation) {
    case 0:
      return returning([&] { digest.add(a * b); });
    case 1: {
      const auto quotient = try_divide(a, b);
      quotient ? digest.add(*quotient) : digest.add("none");
      return;
    }
    case 2:
      return returning([&] {
        digest.add(a + b);
        digest.add(a - b);
        digest.add(-a);
      });
    case 3:
      return returning([&] { digest.add(mul_add(a, b, c)); });
    case 4:
      return returning([&] { digest.add(dot(std::array{a, b, c}, std::array{c, a, b})); });
    case 5:
      return returning([&] { digest.add(lerp(a, b, c)); });
    case 6:
      return returning([&] { digest.add(sqrt(a)); });
    case 7: {
      if constexpr (!has_tenths<N>) {
        digest.add(a % (b == N() ? N::from_raw(1) : b));
      } else {
        const auto [sine, cosine] = sin_cos_of_tenths<N>(static_cast<std::int32_t>(draw.word()));
        digest.add(cosine);
        digest.add(sine);
      }
      return;
    }
    case 8:
      return returning([&] {
        digest.add(floor(a));
        digest.add(ceil(a));
        digest.add(round(a));
        digest.add(trunc(a));
        digest.add(abs(a));
      });
    case 9:
      digest.add((a < b ? 1U : 0U) | (a == b ? 2U : 0U));
      digest.add(min(a, c));
      digest.add(max(b, c));
      return;
    case 10:
      return returning([&] { digest.add(N(std::bit_cast<double>(draw.word()))); });
    case 11:
      return returning(
          [&] { digest.add(N(std::bit_cast<float>(static_cast<std::uint32_t>(draw.word())))); });
    case 12:
      // Near the range, where rounding decides.
      return returning([&] {
        digest.add(N(std::bit_cast<double>((draw.word() >> 12U) | (0x3e0ULL << 52U) |
                                           (draw.word() % 48U) << 52U)));
      });
    case 13:
      digest.add(std::bit_cast<std::uint64_t>(static_cast<double>(a)));
      digest.add(std::bit_cast<std::uint32_t>(static_cast<float>(b)));
      digest.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(c)));
      return;
    case 14: {
      std::array<char, max_chars<N>> text{};
      const auto [end, error] = to_chars(text.data(), text.data() + text.size(), a);
      digest.add(std::string_view(text.data(), static_cast<std::size_t>(end - text.data())));
      N back;
      from_chars(text.data(), end, back);
      digest.add(back);
      return;
    }
    case 15: {
      if constexpr (!has_radians<N>) {
        digest.add(a << static_cast<int>(draw.word() % 8));
        digest.add(b >> static_cast<int>(draw.word() % 8));
      } else {
        const auto [sine, cosine] = sin_cos(a);
        digest.add(cosine);
        digest.add(sine);
      }
      return;
    }
    case 17: {
      digest.add(mul_div(a, b, c == N() ? N::from_raw(1) : c));
      digest.add(multiply<q32_32>(a, b));
      digest.add(accumulator<N>().add_product(a, b).subtract_product(b, c).add(c).result());
      return;
    }
    case 18: {
      const auto product = overflowing_multiply(a, b);
      digest.add(product.value);
      digest.add(product.overflow ? 1U : 0U);
      digest.add(saturating_add(a, b));
      digest.add(saturating_multiply(b, c));
      const auto difference = checked_subtract(a, c);
      difference ? digest.add(*difference) : digest.add("none");
      return;
    }
    default:
      return returning([&] {
        using other = std::conditional_t<N::fraction_bits == 16, q8_8, q16_16>;
        digest.add(N(other::from_raw(static_cast<typename other::raw_type>(draw.word()))));
      });
  }
}

/// The functions of real numbers, and the remainder of fixed/cmath.hpp, numbered.
constexpr std::uint64_t functions = 30;

template <class N>
void compute_function(std::uint64_t function, Draws& draw, Digest& digest) {
  using namespace fixproof;
  const N a = draw.number<N>();
  const N b = draw.number<N>();
  switch (function) {
    case 0:
      return digest.add(exp(a));
    case 1:
      return digest.add(exp2(a));
    case 2:
      return digest.add(expm1(a));
    case 3:
      return digest.add(log(a));
    case 4:
      return digest.add(log2(a));
    case 5:
      return digest.add(log10(a));
    case 6:
      return digest.add(log1p(a));
    case 7:
      return digest.add(sinh(a));
    case 8:
      return digest.add(cosh(a));
    case 9:
      return digest.add(tanh(a));
    case 10:
      return digest.add(sin(a));
    case 11:
      return digest.add(cos(a));
    case 12:
      return digest.add(tan(a));
    case 13:
      return digest.add(sin_of_degrees(a));
    case 14:
      return digest.add(cos_of_degrees(a));
    case 15:
      return digest.add(tan_of_degrees(a));
    case 16:
      return digest.add(sin_of_turns(a));
    case 17:
      return digest.add(cos_of_turns(a));
    case 18:
      return digest.add(tan_of_turns(a));
    case 19:
      return digest.add(asin(a));
    case 20:
      return digest.add(acos(a));
    case 21:
      return digest.add(atan(a));
    case 22:
      return digest.add(cbrt(a));
    case 23:
      return digest.add(rsqrt(a));
    case 24:
      return digest.add(reciprocal(a));
    case 25:
      return digest.add(atan2(a, b));
    case 26:
      return digest.add(hypot(a, b));
    case 27:
      return digest.add(hypot(a, b, draw.number<N>()));
    case 28:
      if constexpr (std::is_signed_v<typename N::raw_type>) digest.add(remainder(a, b));
      return;
    default:
      return digest.add(pow(a, b));
  }
}

using Computation = void (*)(std::uint64_t, Draws&, Digest&);

/// @param kinds the number of operations of each type
template <std::size_t size>
std::uint64_t digest_of(const std::array<Computation, size>& types, std::uint64_t kinds,
                        std::uint64_t count) {
  Digest digest;
  for (std::uint64_t i = 0; i < count; ++i) {
    Draws draw(i);
    types.at(i / kinds % size)(i % kinds, draw, digest);
  }
  return digest.value();
}

template <class... Numbers>
constexpr std::array<Computation, sizeof...(Numbers)> operations_of{compute<Numbers>...};
template <class... Numbers>
constexpr std::array<Computation, sizeof...(Numbers)> functions_of{compute_function<Numbers>...};

}  // namespace

int main(int argc, char** argv) {
  using namespace fixproof;
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const std::uint64_t value = digest_of(
      operations_of<q16_16, q16_16_saturating, q16_16_trapping, q16_16_i386,
                    q16_16_i386_mul_rounded, q16_16_i386_div_rounded, q16_16_i386_unrounded,
                    q16_16_i8088, q16_16_i8088_mul_rounded, q16_16_i8088_div_rounded,
                    q16_16_i8088_unrounded, q8_8, q8_8_saturating, q8_8_trapping, q8_8_i386,
                    q8_8_i386_mul_rounded, q8_8_i386_div_rounded, q8_8_i386_unrounded, q8_8_i8088,
                    q8_8_i8088_mul_rounded, q8_8_i8088_div_rounded, q8_8_i8088_unrounded>,
      operations, count);
  const std::uint64_t of_formats =
      digest_of(operations_of<q8_0, q4_4, q1_7, u4_4, u0_8, q12_4, q4_12, q2_14, q1_15, u8_8, u1_15,
                              u0_16, q32_0, q26_6, q24_8, q20_12, q8_24, q4_28, q2_30, q1_31, u24_8,
                              u16_16, u8_24, u1_31, u0_32, q48_16, q40_24, q32_32, q16_48, q2_62,
                              q1_63, u48_16, u32_32, u0_64>,
                format_operations, count);
  // They take ten times as long.
  const std::uint64_t of_functions =
      digest_of(functions_of<q4_4, q8_8, u0_16, q32_0, q24_8, q16_16, q8_24, q2_30, u16_16, u0_32>,
                functions, count / 10);
  std::cout << count << " operations: " << std::hex << value << ", formats " << of_formats
            << ", functions " << of_functions << '\n';
}
