#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <stdexcept>

#include "oracle/exact.hpp"

namespace oracle {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

constexpr std::size_t kTurn = 3600;  // in tenths of a degree
constexpr std::size_t kThreeQuarters = 2700;

/// cos(step / steps_per_degree degrees), rounded to nearest. By Niven's theorem the cosine of a
/// rational number of degrees is 0, +-1/2, +-1 or irrational: the former are whole ulps, and the
/// latter never a tie, so 50 digits suffice for the rounding.
Word nearest_cosine(std::size_t step, int steps_per_degree, const Format& format) {
  static const Real pi = acos(Real(-1));
  const Real cosine = cos(pi * step / (Real(180) * steps_per_degree));
  const Real scaled = cosine * Real(one(format));
  return static_cast<Word>(wrap(Integer(floor(scaled + Real(0.5))), format));
}

std::array<Word, kTurn> cosines_of_a_turn() {
  std::array<Word, kTurn> cosines{};
  for (std::size_t tenths = 0; tenths < kTurn; ++tenths) {
    cosines[tenths] = nearest_cosine(tenths, 10, 16);
  }
  return cosines;
}

}  // namespace

CosSin cos_sin(std::int16_t angle_tenths) {
  static const std::array<Word, kTurn> cosines = cosines_of_a_turn();
  const int remainder = angle_tenths % static_cast<int>(kTurn);
  const std::size_t angle = (static_cast<std::size_t>(remainder + static_cast<int>(kTurn))) % kTurn;
  // sin(x) = cos(x + 270 degrees)
  return {cosines[angle], cosines[(angle + kThreeQuarters) % kTurn]};
}

std::vector<Word> cosine_table(int steps_per_degree, const Format& format) {
  if (steps_per_degree < 1) throw std::invalid_argument("steps_per_degree must be positive");
  const std::size_t steps = 90 * static_cast<std::size_t>(steps_per_degree);
  std::vector<Word> table;
  for (std::size_t step = 0; step <= steps; ++step) {
    table.push_back(nearest_cosine(step, steps_per_degree, format));
  }
  return table;
}

}  // namespace oracle
