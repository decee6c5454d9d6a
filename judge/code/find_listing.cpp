#include "judge/code/find_listing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "support/interrupt.hpp"

namespace fixproof::judge {

namespace {

/// How many instructions the code may have more or less than the listing up to any point.
constexpr std::size_t slack = 12;

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// An instruction of the listing and the one in its place; `none` where there is no such one.
struct Pair {
  std::size_t listed = none;
  std::size_t found = none;
};

/// The alignment with the fewest instructions that are replaced, left out or added. What follows
/// the code's last one is not compared. Jumps are equal here wherever they lead.
class Alignment {
 public:
  Alignment(const CanonicalRoutine& listed, const CanonicalRoutine& found)
      : listed_(listed), found_(found), columns_(found.size() + 1) {
    costs_.assign((listed.size() + 1) * columns_, far);
    // Code that ends early lacks as many.
    const std::size_t band = slack + listed.size() - std::min(listed.size(), found.size());
    for (std::size_t i = 0; i <= listed.size(); ++i) {
      for (std::size_t j = i < band ? 0 : i - band; j < std::min(columns_, i + band + 1); ++j) {
        cost(i, j) = least(i, j);
      }
    }
  }

  [[nodiscard]] std::vector<Pair> pairs() {
    std::size_t i = listed_.size();
    std::size_t j = 0;
    for (std::size_t k = 0; k < columns_; ++k) {
      if (cost(i, k) <= cost(i, j)) j = k;
    }
    std::vector<Pair> pairs;
    while (i > 0 || j > 0) {
      if (i > 0 && j > 0 && cost(i, j) == replaced(i, j)) {
        pairs.push_back({--i, --j});
      } else if (i > 0 && cost(i, j) == cost(i - 1, j) + 1) {
        pairs.push_back({--i, none});
      } else {
        pairs.push_back({none, --j});
      }
    }
    std::ranges::reverse(pairs);
    return pairs;
  }

 private:
  static constexpr std::size_t far = none / 2;

  std::size_t& cost(std::size_t i, std::size_t j) { return costs_[i * columns_ + j]; }

  std::size_t replaced(std::size_t i, std::size_t j) {
    const bool same = listed_.line(i - 1).text == found_.line(j - 1).text;
    return cost(i - 1, j - 1) + (same ? 0 : 1);
  }

  std::size_t least(std::size_t i, std::size_t j) {
    if (i == 0 && j == 0) return 0;
    std::size_t best = far;
    if (i > 0 && j > 0) best = replaced(i, j);
    if (i > 0) best = std::min(best, cost(i - 1, j) + 1);
    if (j > 0) best = std::min(best, cost(i, j - 1) + 1);
    return best;
  }

  const CanonicalRoutine& listed_;
  const CanonicalRoutine& found_;
  std::size_t columns_;
  std::vector<std::size_t> costs_;
};

class Comparer {
 public:
  Comparer(Code& listing, std::uint32_t listed_at, Code& code, std::uint32_t start)
      : listing_(listing),
        code_(code),
        listed_(listing, listed_at, true),
        found_(code, start, false, listed_.size() + slack) {
    pairs_ = Alignment(listed_, found_).pairs();
    const auto count = std::ranges::count_if(pairs_, [](Pair p) { return p.found != none; });
    found_.resize(static_cast<std::size_t>(count));
    result_.start = start;
    result_.end = found_.end();
    result_.instructions = listed_.size();
    result_.text = found_.text();
    for (std::size_t i = 0; i < pairs_.size(); ++i) compare(i);
    if (2 * result_.differences > listed_.size()) compare_in_order();
  }

  [[nodiscard]] const ListingComparison& result() const { return result_; }

 private:
  void compare(std::size_t index) {
    const Pair pair = pairs_[index];
    if (pair.listed == none || pair.found == none) return differ(index, "");
    const CanonicalLine& listed = listed_.line(pair.listed);
    const CanonicalLine& found = found_.line(pair.found);
    if (listed.text != found.text) return differ(index, "");
    if (listed.target) compare_targets(index, *listed.target, *found.target);
    if (listed.table) {
      const auto distance = static_cast<std::uint16_t>(*found.table - *listed.table);
      if (!distance_) distance_ = distance;
      if (distance != *distance_) {
        differ(index, fmt::format(", {:x}h from the place of the first read's table",
                                  static_cast<std::uint16_t>(distance - *distance_)));
      }
    }
  }

  void compare_targets(std::size_t index, std::int64_t listed, std::int64_t found) {
    const auto listed_number = listed_.target_of(pairs_[index].listed);
    const auto found_number = found_.target_of(pairs_[index].found);
    if (listed_number.has_value() != found_number.has_value()) return differ(index, "");
    if (listed_number) {
      if (in_listing(*found_number) != *listed_number) differ(index, "");
      return;
    }
    const auto target = static_cast<std::uint32_t>(listed);
    if (listed < 0 || target >= listing_.size()) return;
    const bool inside = found >= 0 && found < code_.size();
    if (inside &&
        compare_listing(listing_, target, code_, static_cast<std::uint32_t>(found)).is_equal()) {
      return;
    }
    differ(index, inside ? fmt::format(", to {:x}h, another routine", found)
                         : ", to a place outside the file");
  }

  /// Of code that has little in common with the listing, the first difference is where the two
  /// part.
  void compare_in_order() {
    std::size_t i = 0;
    while (i < listed_.size() && i < found_.size() && listed_.text_of(i) == found_.text_of(i)) ++i;
    const bool has_one = i < found_.size();
    result_.first = {.number = i + 1,
                     .at = has_one ? found_.line(i).at : found_.end(),
                     .listed = i < listed_.size() ? listed_.text_of(i) : "",
                     .found = has_one ? found_.text_of(i) : ""};
  }

  /// Returns the place in the listing of an instruction of the code, or of the next one there.
  [[nodiscard]] std::size_t in_listing(std::size_t found) const {
    for (const Pair pair : pairs_) {
      if (pair.found != none && pair.found >= found && pair.listed != none) return pair.listed;
    }
    return none;
  }

  void differ(std::size_t index, const std::string& remark) {
    if (result_.differences++ > 0) return;
    const Pair pair = pairs_[index];
    ListingComparison::Difference difference{.number = listed_.size() + 1, .at = found_.end()};
    for (std::size_t i = pairs_.size(); i-- > index;) {
      if (pairs_[i].listed != none) difference.number = pairs_[i].listed + 1;
      if (pairs_[i].found != none) difference.at = found_.line(pairs_[i].found).at;
    }
    if (pair.listed != none) difference.listed = listed_.text_of(pair.listed);
    if (pair.found != none) difference.found = found_.text_of(pair.found) + remark;
    result_.first = difference;
  }

  Code& listing_;
  Code& code_;
  CanonicalRoutine listed_;
  CanonicalRoutine found_;
  std::vector<Pair> pairs_;
  std::optional<std::uint16_t> distance_;
  ListingComparison result_;
};

/// The first instructions of a routine that tell whether it may be a listing.
constexpr std::size_t looked_at = 6;

/// Tells whether three of the first instructions are the same, in order.
bool begins_alike(const CanonicalRoutine& listed, const CanonicalRoutine& found) {
  constexpr std::size_t enough = 3;
  std::size_t same = 0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < std::min(looked_at, listed.size()); ++i) {
    for (std::size_t j = next; j < std::min(looked_at, found.size()); ++j) {
      if (listed.line(i).text != found.line(j).text) continue;
      next = j + 1;
      ++same;
      break;
    }
  }
  return same >= enough;
}

/// A file that begins like a listing at every third byte takes minutes.
void stop_if_interrupted() {
  if (support::Interrupt::flag()) throw support::Stopped();
}

}  // namespace

ListingComparison compare_listing(Code& listing, std::uint32_t listed_at, Code& code,
                                  std::uint32_t start) {
  return Comparer(listing, listed_at, code, start).result();
}

std::vector<ListingComparison> find_listing(Code& listing, Code& code, CodeRange range) {
  const CanonicalRoutine listed(listing, 0, true);
  std::vector<ListingComparison> equal;
  for (std::uint32_t at = range.first; at < range.end; ++at) {
    stop_if_interrupted();
    if (code.at(at).text != listed.line(0).text) continue;
    if (CanonicalRoutine(code, at, false, listed.size()).text() != listed.text()) continue;
    ListingComparison one = compare_listing(listing, 0, code, at);
    if (one.is_equal() && one.end <= range.end) equal.push_back(std::move(one));
  }
  return equal;
}

std::optional<ListingComparison> find_nearest(Code& listing, Code& code, CodeRange range,
                                              const std::vector<CodeRange>& taken) {
  const CanonicalRoutine listed(listing, 0, true);
  std::optional<ListingComparison> nearest;
  for (std::uint32_t at = range.first; at < range.end; ++at) {
    stop_if_interrupted();
    const std::string& text = code.at(at).text;
    // No listing starts so. A jump or a RET is the end of what stands before the routine.
    if (text.empty() || text == "nop" || text == "ret" || text == "retf" || text == "jmp") continue;
    if (!begins_alike(listed, CanonicalRoutine(code, at, false, looked_at))) continue;
    ListingComparison one = compare_listing(listing, 0, code, at);
    const bool is_taken = std::ranges::any_of(
        taken, [&](CodeRange other) { return one.start < other.end && other.first < one.end; });
    if (is_taken || one.end > range.end || 2 * one.differences > listed.size()) continue;
    if (!nearest || one.differences < nearest->differences) nearest = std::move(one);
  }
  return nearest;
}

std::string table_of(Code& listing) {
  const CanonicalRoutine listed(listing, 0, true);
  std::optional<std::uint16_t> first;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const auto& table = listed.line(i).table;
    if (table && (!first || *table < *first)) first = table;
  }
  return first && *first < listing.size() ? listing.bytes().substr(*first) : "";
}

}  // namespace fixproof::judge
