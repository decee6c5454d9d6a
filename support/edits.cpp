#include "support/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace fixproof::support {

std::size_t edits_between(std::string_view a, std::string_view b) {
  using Row = std::vector<std::size_t>;
  std::array<Row, 3> rows{Row(b.size() + 1), Row(b.size() + 1), Row(b.size() + 1)};
  auto& [two_before, before, now] = rows;
  std::iota(now.begin(), now.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(two_before, before);
    std::swap(before, now);
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({changed, before[j] + 1, now[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        now[j] = std::min(now[j], two_before[j - 2] + 1);
      }
    }
  }
  return now.back();
}

std::string suggestion(std::string_view given, const std::vector<std::string>& names) {
  constexpr std::size_t longest = 40;  // of a name; anything may be on a command line
  constexpr std::size_t most = 2;
  std::string_view nearest;
  std::size_t least = most + 1;
  for (const std::string& name : names) {
    if (given.size() > longest) break;
    const std::size_t distance = edits_between(given, name);
    if (distance < least && 2 * distance < name.size()) {
      least = distance;
      nearest = name;
    }
  }
  // Who writes --round may mean --rounding, if that is the only name that goes on so.
  constexpr std::size_t shortest_beginning = 4;
  if (nearest.empty() && given.size() >= shortest_beginning) {
    for (const std::string& name : names) {
      if (!name.starts_with(given)) continue;
      if (!nearest.empty()) return "";
      nearest = name;
    }
  }
  return nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest);
}

}  // namespace fixproof::support
