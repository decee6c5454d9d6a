// Finds the vectors whose angle is nearest to a tie, in words of 32 bits:
//
//     find_hard_pairs FRACTION_BITS DISTANCE [FIRST LAST]
//
// Prints what tests/fixed/functions/hard_pairs prints, which is too slow for millions of ties. Of
// the two vectors nearest to each tie, it prints those with y >= 0 within 2^-DISTANCE ulps of the
// tie. Tie k is the angle k + 1/2 ulps. FIRST and LAST select ties. Without them it tries all ties
// from 0 to pi, or to the highest number if that is lower. It writes the number of ties, and the
// distance of the nearest vector, to stderr.
//
// Let S and C be the magnitudes of a tie's sine and cosine. A vector (x, y) in its octant has the
// angle atan(n/d), and |n C - d S| / |(x, y)| is the sine of its distance. The Stern-Brocot tree
// gives the fractions nearest to S/C with d <= 2^31: Euclid's algorithm on S and C - S, in units of
// 2^-127. S and C are off by less than 16 units, which moves n C - d S by less than 2^36 units. The
// program stops with status 1 if an n C - d S is not above 2^40 units, where a fraction would be
// uncertain.
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

constexpr std::uint64_t highest = std::uint64_t{1} << 31;

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

/// Adds `by` to `to` as often as `to` stays on its side of S/C and d is not above 2^31.
void approach(Neighbour& to, const Neighbour& by) {
  const auto most = (highest - to.d) / by.d;
  const Wide quotient = to.off < by.off << 1 ? Wide{to.off < by.off ? 0U : 1U} : to.off / by.off;
  const std::uint64_t steps = quotient < most ? static_cast<std::uint64_t>(quotient) : most;
  to.n += steps * by.n;
  to.d += steps * by.d;
  to.off -= steps * by.off;
}

/// The fractions nearest to sine / cosine. \pre 0 < sine < cosine
Neighbours neighbours_of(Wide sine, Wide cosine) {
  constexpr Wide uncertain = Wide{1} << 40;
  Neighbour below{0, 1, sine};
  Neighbour above{1, 1, cosine - sine};
  while (below.d + above.d <= highest) {
    approach(below, above);
    if (below.off < uncertain) break;
    if (below.d + above.d > highest) break;
    approach(above, below);
    if (above.off < uncertain) break;
  }
  if (below.off < uncertain || above.off < uncertain) {
    fmt::print(stderr, "find_hard_pairs: 127 bits are too few\n");
    std::exit(1);
  }
  return {below, above};
}

class Search {
 public:
  Search(int fraction_bits, int distance)
      : fraction_bits_(fraction_bits), limit_(std::ldexp(1.0, -distance)) {
    for (int i = 0; i < block; ++i) offsets_.push_back(direction_of(angle(Decimal100(i))));
  }

  /// Ties from `first`, as many as there are in a block or up to `last`.
  void try_block(std::uint64_t first, std::uint64_t last) {
    const Direction start = direction_of(angle(Decimal100(first) + 0.5));
    const std::uint64_t count = std::min<std::uint64_t>(block, last + 1 - first);
    for (std::uint64_t i = 0; i < count; ++i) try_tie(first + i, turned(start, offsets_[i]));
  }

  static constexpr int block = 4096;
  [[nodiscard]] double nearest() const { return nearest_; }

 private:
  [[nodiscard]] Decimal100 angle(const Decimal100& ulps) const {
    return ldexp(ulps, -fraction_bits_);
  }

  void try_tie(std::uint64_t tie, const Direction& to) {
    const bool is_steep = to.cosine.magnitude < to.sine.magnitude;
    const bool is_left = to.cosine.is_negative;
    const auto [below, above] = neighbours_of(std::min(to.cosine.magnitude, to.sine.magnitude),
                                              std::max(to.cosine.magnitude, to.sine.magnitude));
    // The angle grows with n/d in two of the four octants.
    const bool grows = is_steep == is_left;
    try_vector(tie + (grows ? 0 : 1), tie, below, is_steep, is_left);
    try_vector(tie + (grows ? 1 : 0), tie, above, is_steep, is_left);
  }

  void try_vector(std::uint64_t result, std::uint64_t tie, const Neighbour& v, bool is_steep,
                  bool is_left) {
    if (v.n == 0) return;
    const double distance = std::ldexp(
        static_cast<double>(v.off) / std::hypot(static_cast<double>(v.n), static_cast<double>(v.d)),
        fraction_bits_ - 127);
    nearest_ = std::min(nearest_, distance);
    if (distance > limit_ * 1.0001) return;
    const auto y = static_cast<std::int64_t>(is_steep ? v.d : v.n);
    const auto width = static_cast<std::int64_t>(is_steep ? v.n : v.d);
    const std::int64_t x = is_left ? -width : width;
    const Decimal100 exact =
        abs(ldexp(atan2(Decimal100(y), Decimal100(x)), fraction_bits_) - (Decimal100(tie) + 0.5));
    if (exact >= limit_) return;
    fmt::print("q{}_{} {} {} {} 2^{:.1f}\n", 32 - fraction_bits_, fraction_bits_, y, x, result,
               static_cast<double>(log2(exact)));
  }

  int fraction_bits_;
  double limit_;
  double nearest_ = 1;
  std::vector<Direction> offsets_;
};

/// The last tie below pi or the highest number.
std::uint64_t last_tie(int fraction_bits) {
  const Decimal100 ulps = ldexp(acos(Decimal100(-1)), fraction_bits);
  const auto last = static_cast<std::uint64_t>(floor(ulps - 0.5));
  return std::min(last, highest - 2);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::uint64_t> numbers;
  for (const std::string_view arg : std::vector<std::string_view>(argv + 1, argv + argc)) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(arg.data(), arg.data() + arg.size(), number);
    if (error == std::errc() && end == arg.data() + arg.size()) numbers.push_back(number);
  }
  const auto count = static_cast<std::size_t>(argc - 1);
  if (numbers.size() != count || (count != 2 && count != 4) || numbers[0] > 31 ||
      numbers[1] > 100) {
    fmt::print(stderr, "usage: find_hard_pairs FRACTION_BITS DISTANCE [FIRST LAST]\n");
    return 2;
  }
  const int fraction_bits = static_cast<int>(numbers[0]);
  const std::uint64_t first = count == 4 ? numbers[2] : 0;
  const std::uint64_t last =
      std::min(count == 4 ? numbers[3] : ~std::uint64_t{0} >> 1, last_tie(fraction_bits));
  Search search(fraction_bits, static_cast<int>(numbers[1]));
  for (std::uint64_t i = first; i <= last; i += Search::block) search.try_block(i, last);
  fmt::print(stderr, "{} ties, the nearest vector 2^{:.2f} ulps from one\n",
             last + 1 - std::min(first, last + 1), std::log2(search.nearest()));
}
