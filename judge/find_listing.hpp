/// @file
/// Finds a listing in a user's code and compares the two instruction by instruction.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/canonical.hpp"

namespace fixproof::judge {

/// A routine of a user's code beside a listing.
struct ListingComparison {
  /// One instruction of both; empty where it is only in the other.
  struct Difference {
    std::size_t number = 0;  ///< of the listing's instruction, from 1
    std::uint32_t at = 0;    ///< offset of the code's instruction, or of what stands in its place
    std::string listed{};
    std::string found{};
  };
  std::uint32_t start = 0;
  std::uint32_t end = 0;
  std::size_t instructions = 0;  ///< of the listing
  std::string text{};            ///< canonical, of the code
  std::size_t differences = 0;
  std::optional<Difference> first{};

  [[nodiscard]] bool is_equal() const { return differences == 0; }
};

/// Compares the routine at `start` of the code with the listing at `listed_at`, which ends with its
/// first RET. Beyond the canonical text it compares the routines that both call, and whether all
/// reads of a table find it at one place.
ListingComparison compare_listing(Code& listing, std::uint32_t listed_at, Code& code,
                                  std::uint32_t start);

/// A part of the code, from `first` to before `end`.
struct Range {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

/// Finds every place in the range where the code is a listing's first routine.
/// @throws proof::Stopped
std::vector<ListingComparison> find_listing(Code& listing, Code& code, Range range);

/// Finds the place with the fewest differences. At least half of the listing's instructions must be
/// there.
/// @param taken parts of the code that are something else
/// @throws proof::Stopped
std::optional<ListingComparison> find_nearest(Code& listing, Code& code, Range range,
                                              const std::vector<Range>& taken);

/// Returns the table that a listing assembled for offset 0 reads, which is the rest of it from the
/// first place that it reads; empty if it reads none.
std::string table_of(Code& listing);

}  // namespace fixproof::judge
