#include "support/edits.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace fixproof::support {

std::size_t edits_between(std::string_view a, std::string_view b) {
  // above[i] is the number of edits from the characters of `a` so far to the first i + 1 of `b`.
  std::vector<std::size_t> above(b.size());
  std::iota(above.begin(), above.end(), std::size_t{1});
  std::size_t edits = b.size();
  for (std::size_t row = 0; row < a.size(); ++row) {
    std::size_t diagonal = row;
    edits = row + 1;
    for (std::size_t i = 0; i < b.size(); ++i) {
      const std::size_t replaced = diagonal + (a[row] == b[i] ? 0 : 1);
      diagonal = above[i];
      edits = std::min({replaced, diagonal + 1, edits + 1});
      above[i] = edits;
    }
  }
  return edits;
}

}  // namespace fixproof::support
