/// @file
/// Finds a listing in a user's code and compares the two instruction by instruction.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/code/canonical.hpp"

namespace fixproof::judge {

/// What a comparison of a routine of a user's code with a listing finds.
struct ListingComparison {
  /// An instruction of each. A text is empty if its side has none in this place.
  struct Difference {
    std::size_t number = 0;  ///< of the instruction in the listing, from 1
    std::uint32_t at = 0;    ///< offset of the instruction in the code, or of the next one there
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
/// first RET. Beyond the canonical text, it compares the routines that both call, and checks that
/// all reads of a table agree on its place.
ListingComparison compare_listing(Code& listing, std::uint32_t listed_at, Code& code,
                                  std::uint32_t start);

/// A part of the code, from `first` up to but not including `end`.
struct CodeRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

/// Finds every place in the range where the code is the first routine of a listing.
/// @throws support::Stopped if the user interrupts the search
std::vector<ListingComparison> find_listing(Code& listing, Code& code, CodeRange range);

/// Finds the place with the fewest differences. Three of the first six instructions must be those
/// of the listing, and at most half of the listing's instructions may differ.
/// @param taken parts of the code that are other listings
/// @throws support::Stopped if the user interrupts the search
std::optional<ListingComparison> find_nearest(Code& listing, Code& code, CodeRange range,
                                              const std::vector<CodeRange>& taken);

/// Returns the table that a listing reads: its bytes from the lowest address that it reads to its
/// end, or nothing if it reads no table. The listing must be assembled for offset 0.
std::string table_of(Code& listing);

}  // namespace fixproof::judge
