// Finds the vectors whose angle is nearest to a tie:
//
//     find_hard_pairs FRACTION_BITS WORD_BITS DISTANCE [FIRST LAST]
//
// Prints what tests/fixed/functions/hard_pairs prints, which is too slow for millions of ties. Of
// the two vectors nearest to each tie, it prints those with y >= 0 within 2^-DISTANCE ulps of the
// tie. Tie k is the angle k + 1/2 ulps. FIRST and LAST select ties. Without them it tries all ties
// from 0 to pi, or to the highest number if that is lower. It writes to stderr the number of ties,
// the nearest vector and its distance. Words of 33 bits include the signed and the unsigned words
// of 32 bits.
//
// Let S and C be the magnitudes of a tie's sine and cosine. A vector (x, y) in its octant has the
// angle atan(n/d), and |n C - d S| / |(x, y)| is the sine of its distance. The Stern-Brocot tree
// gives the fractions nearest to S/C with d <= 2^32: Euclid's algorithm on S and C - S, in units of
// 2^-127. S and C are off by less than 16 units, which moves n C - d S by less than 2^37 units. The
// program stops with status 1 if an n C - d S is not above 2^40 units, where a fraction would be
// uncertain.
//
// Vectors along an axis (n = 0) have the angles 0, pi/2 and pi. The distances of pi/2 and pi count
// for the nearest vector; that of 0 is half an ulp.
#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace {

using Decimal100 = boost::multiprecision::cpp_bin_float_100;
__extension__ using Wide = unsigned __int128;

/// floor(a * b / 2^128).
Wide multiply_high(Wide a, Wide b) {
  const auto low = [](Wide x) { return static_cast<std::uint64_t>(x); };
  const auto high = [](Wide x) { return static_cast<std::uint64_t>(x >> 64); };
  const Wide middle = Wide{high(a)} * low(b) + high(Wide{low(a)} * low(b));
  const Wide carry = Wide{low(a)} * high(b) + low(middle);
  return Wide{high(a)} * high(b) + high(middle) + high(carry);
}

/// A number from -1 to 1: a magnitude in units of 2^-127 and a sign.
struct Unit {
  Wide magnitude = 0;
  bool is_negative = false;
};

Unit unit_of(const Decimal100& x) {
  using boost::multiprecision::cpp_int;
  const cpp_int units(floor(ldexp(abs(x), 127)));
  return {static_cast<Wide>(units), x < 0};
}

/// Twice the rounded-down product. Off by less than 2 units.
Unit product(const Unit& a, const Unit& b) {
  return {multiply_high(a.magnitude, b.magnitude) << 1, a.is_negative != b.is_negative};
}

Unit sum(const Unit& a, const Unit& b) {
  if (a.is_negative == b.is_negative) return {a.magnitude + b.magnitude, a.is_negative};
  if (a.magnitude < b.magnitude) return {b.magnitude - a.magnitude, b.is_negative};
  return {a.magnitude - b.magnitude, a.is_negative};
}

struct Direction {
  Unit cosine;
  Unit sine;
};

Direction direction_of(const Decimal100& angle) {
  return {unit_of(cos(angle)), unit_of(sin(angle))};
}

/// `from`, turned by a small angle. Off by less than 8 units.
Direction turned(const Direction& from, const Direction& by) {
  const Unit product_of_sines = product(from.sine, by.sine);
  return {sum(product(from.cosine, by.cosine),
              {product_of_sines.magnitude, !product_of_sines.is_negative}),
          sum(product(from.sine, by.cosine), product(from.cosine, by.sine))};
}

/// A fraction n/d and the magnitude of n C - d S.
struct Neighbour {
  std::uint64_t n;
  std::uint64_t d;
  Wide off;
};

struct Neighbours {
  Neighbour below;
  Neighbour above;
};

/// floor(a / b). The upper halves say it up to 1 if b >= 2^84 and the quotient is below 2^19.
std::uint64_t quotient_of(Wide a, Wide b) {
  const auto high_a = static_cast<std::uint64_t>(a >> 64);
  const auto high_b = static_cast<std::uint64_t>(b >> 64);
  constexpr std::uint64_t small = 1U << 19U;
  if (high_b < 2 * small || high_a / high_b >= small) {
    const Wide quotient = a / b;
    constexpr std::uint64_t most = ~std::uint64_t{0};
    return quotient > most ? most : static_cast<std::uint64_t>(quotient);
  }
  const std::uint64_t quotient = high_a / high_b;
  const Wide product = quotient * b;
  if (product > a) return quotient - 1;
  return a - product < b ? quotient : quotient + 1;
}

/// Adds `by` to `to` as often as `to` stays on its side of S/C and d is not above `highest`.
void approach(Neighbour& to, const Neighbour& by, std::uint64_t highest) {
  if (to.off < by.off) return;
  const std::uint64_t room = highest - to.d;
  const std::uint64_t quotient = std::min(quotient_of(to.off, by.off), room);
  const std::uint64_t steps = quotient * by.d <= room ? quotient : room / by.d;
  to.n += steps * by.n;
  to.d += steps * by.d;
  to.off -= steps * by.off;
}

/// The fractions nearest to sine / cosine with d <= highest. @pre 0 < sine < cosine
Neighbours neighbours_of(Wide sine, Wide cosine, std::uint64_t highest) {
  constexpr Wide uncertain = Wide{1} << 40;
  Neighbour below{0, 1, sine};
  Neighbour above{1, 1, cosine - sine};
  while (below.d + above.d <= highest) {
    approach(below, above, highest);
    if (below.off < uncertain) break;
    if (below.d + above.d > highest) break;
    approach(above, below, highest);
    if (above.off < uncertain) break;
  }
  if (below.off < uncertain || above.off < uncertain) {
    fmt::print(stderr, "find_hard_pairs: 127 bits are too few\n");
    std::exit(1);
  }
  return {below, above};
}

struct Words {
  int fraction_bits;
  int bits;

  /// The greatest magnitude of a word.
  [[nodiscard]] std::uint64_t highest() const { return std::uint64_t{1} << (bits - 1); }
};

class Search {
 public:
  Search(const Words& words, int distance)
      : words_(words),
        limit_(std::ldexp(1.0, -distance)),
        unit_(std::ldexp(1.0, words.fraction_bits - 127)) {
    for (int i = 0; i < block; ++i) offsets_.push_back(direction_of(angle(Decimal100(i))));
    for (const int half_turns : {1, 2}) {
      const Decimal100 ulps = angle_in_ulps(0, -1) * half_turns / 2;
      const Decimal100 distance_of_axis = abs(ulps - floor(ulps) - 0.5);
      keep({half_turns == 1 ? 1 : 0, half_turns == 1 ? 0 : -1,
            static_cast<double>(distance_of_axis)});
    }
  }

  /// Ties from `first`, as many as there are in a block or up to `last`.
  void try_block(std::uint64_t first, std::uint64_t last) {
    const Direction start = direction_of(angle(Decimal100(first) + 0.5));
    const std::uint64_t count = std::min<std::uint64_t>(block, last + 1 - first);
    for (std::uint64_t i = 0; i < count; ++i) try_tie(first + i, turned(start, offsets_[i]));
  }

  /// The last tie below pi or the highest number.
  [[nodiscard]] std::uint64_t last_tie() const {
    const auto last = static_cast<std::uint64_t>(floor(angle_in_ulps(0, -1) - 0.5));
    return std::min(last, words_.highest() - 2);
  }

  static constexpr int block = 4096;

  struct Vector {
    std::int64_t y;
    std::int64_t x;
    double distance;
  };
  [[nodiscard]] const Vector& nearest() const { return nearest_; }

 private:
  [[nodiscard]] Decimal100 angle(const Decimal100& ulps) const {
    return ldexp(ulps, -words_.fraction_bits);
  }

  [[nodiscard]] Decimal100 angle_in_ulps(std::int64_t y, std::int64_t x) const {
    return ldexp(atan2(Decimal100(y), Decimal100(x)), words_.fraction_bits);
  }

  void keep(const Vector& vector) {
    if (vector.distance < nearest_.distance) nearest_ = vector;
  }

  void try_tie(std::uint64_t tie, const Direction& to) {
    const bool is_steep = to.cosine.magnitude < to.sine.magnitude;
    const bool is_left = to.cosine.is_negative;
    const auto [below, above] =
        neighbours_of(std::min(to.cosine.magnitude, to.sine.magnitude),
                      std::max(to.cosine.magnitude, to.sine.magnitude), words_.highest());
    // The angle grows with n/d in two of the four octants.
    const bool grows = is_steep == is_left;
    try_vector(tie + (grows ? 0 : 1), tie, below, is_steep, is_left);
    try_vector(tie + (grows ? 1 : 0), tie, above, is_steep, is_left);
  }

  void try_vector(std::uint64_t result, std::uint64_t tie, const Neighbour& v, bool is_steep,
                  bool is_left) {
    if (v.n == 0) return;
    const auto n = static_cast<double>(v.n);
    const auto d = static_cast<double>(v.d);
    const double distance = static_cast<double>(v.off) / std::sqrt(n * n + d * d) * unit_;
    const auto y = static_cast<std::int64_t>(is_steep ? v.d : v.n);
    const auto width = static_cast<std::int64_t>(is_steep ? v.n : v.d);
    const std::int64_t x = is_left ? -width : width;
    keep({y, x, distance});
    if (distance > limit_ * 1.0001) return;
    const Decimal100 exact = abs(angle_in_ulps(y, x) - (Decimal100(tie) + 0.5));
    if (exact >= limit_) return;
    fmt::print("q{}_{} {} {} {} 2^{:.1f}\n", words_.bits - words_.fraction_bits,
               words_.fraction_bits, y, x, result, static_cast<double>(log2(exact)));
  }

  Words words_;
  double limit_;
  double unit_;  ///< of Neighbour::off, in ulps
  Vector nearest_{0, 1, 0.5};
  std::vector<Direction> offsets_;
};

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::uint64_t> numbers;
  for (const std::string_view arg : std::vector<std::string_view>(argv + 1, argv + argc)) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(arg.data(), arg.data() + arg.size(), number);
    if (error == std::errc() && end == arg.data() + arg.size()) numbers.push_back(number);
  }
  const auto count = static_cast<std::size_t>(argc - 1);
  if (numbers.size() != count || (count != 3 && count != 5) || numbers[0] > 32 || numbers[1] < 2 ||
      numbers[1] > 33 || numbers[2] > 100) {
    fmt::print(stderr,
               "usage: find_hard_pairs FRACTION_BITS WORD_BITS DISTANCE [FIRST LAST]\n"
               "with 0 to 32 fraction bits and words of 2 to 33 bits\n");
    return 2;
  }
  const Words words{static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
  Search search(words, static_cast<int>(numbers[2]));
  const std::uint64_t first = count == 5 ? numbers[3] : 0;
  const std::uint64_t last =
      std::min(count == 5 ? numbers[4] : search.last_tie(), search.last_tie());
  for (std::uint64_t i = first; i <= last; i += Search::block) search.try_block(i, last);
  const auto& [y, x, distance] = search.nearest();
  fmt::print(stderr, "{} ties, the nearest vector y = {}, x = {}, 2^{:.2f} ulps from one\n",
             last + 1 - std::min(first, last + 1), y, x, std::log2(distance));
}
