#include "app/cli/measure_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measure/host/provenance.hpp"
#include "support/build_info/build_info.hpp"
#include "support/plain_text.hpp"

namespace fixproof::cli {

std::string text_of(const measure::Claim& claim) {
  std::string text = fmt::format("\n{} ({})\n=> {}\n({})\n", claim.text, claim.place,
                                 name_of(verdict_on(claim)), claim.means);
  for (const measure::ClaimFigure& f : claim.figures) {
    text += fmt::format("  {:<45}{:>15} {:<16} {}\n", support::printable(f.where),
                        between(f.measured.min, f.measured.max, 2), claim.unit, name_of(f.verdict));
  }
  return text;
}

std::string made_by(std::uint64_t seed) {
  return fmt::format("seed {}, {}", seed, support::compiler_name());
}

std::string missing_libraries() {
  std::string text;
  for (const auto& [built_in, library] : {std::pair{measure::has_libfixmath(), "libfixmath"},
                                          std::pair{measure::has_freetype(), "FreeType"}}) {
    if (built_in) continue;
    text += fmt::format("{} is left out, because it was not found when this program was built.\n",
                        library);
  }
  return text;
}

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

std::string columns_of(const measure::Times& times) {
  return fmt::format("{:>9.3f}{:>9.3f}{:>7.1f} %", times.min, times.median, 100 * times.spread);
}

}  // namespace fixproof::cli
