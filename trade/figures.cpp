#include "trade/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/plain_text.hpp"

namespace fixproof::trade {

std::string error_text(double x, bool with_sign) {
  if (std::fabs(x) >= 1000) return fmt::format("{:.2e}", x);
  return with_sign ? fmt::format("{:+.4f}", x) : fmt::format("{:.4f}", x);
}

std::string largest_text(double x) {
  if (x >= 1000) return fmt::format("{:.2e}", x);
  if (x > 0 && x < 1e-5) return fmt::format("{:.0e}", x);
  return fmt::format("{:.5f}", std::floor(x * 1e5) / 1e5);
}

std::string share_text(double x) {
  const double percent = 100 * x;
  return fmt::format("{:.3f} %", x < 1 ? std::min(percent, 99.999) : percent);
}

std::string between(double min, double max, int decimals) {
  const auto text = [decimals](double x) {
    return decimals == 0 ? support::grouped(static_cast<std::uint64_t>(x))
                         : fmt::format("{:.{}f}", x, decimals);
  };
  return min == max ? text(min) : fmt::format("{}-{}", text(min), text(max));
}

}  // namespace fixproof::trade
