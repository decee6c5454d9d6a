#include "app/cli/judge_listing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <utility>

#include "app/cli/arguments.hpp"
#include "app/cli/json/judge_json.hpp"
#include "app/cli/program.hpp"
#include "judge/code/assemble.hpp"
#include "judge/code/find_listing.hpp"
#include "judge/code/load.hpp"
#include "support/plain_text.hpp"
#include "support/sha256.hpp"
#include "support/usage_error.hpp"
#include "x86model/originals.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

namespace {

using judge::ListingComparison;
using machine_code::ProgramKey;

judge::Code code_of(const ProgramKey& key) {
  std::string bytes = judge::assembled(x86model::nasm_source(key.routine, key.target, key.build));
  if (bytes.empty()) throw support::UsageError("nasm does not assemble the listing");
  return judge::Code(std::move(bytes));
}

/// The listings that the options name, in the order of FIXED.ASM for `all`.
std::vector<ProgramKey> keys_of(const ListingOptions& options) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const std::string& name : options.routines) {
    if (name != "all") {
      add(name);
      continue;
    }
    add("mul");
    add("div");
    // Chapter 52 has the others in C.
    if (options.variant.chapter_52.value_or(false)) continue;
    for (const char* other : {"cossin", "xformvec", "concat"}) add(other);
  }
  std::vector<ProgramKey> keys;
  for (const std::string& name : names) {
    ProgramOptions program;
    program.operation = name;
    program.variant = options.variant;
    keys.push_back(program.choose());
  }
  return keys;
}

std::string offset_text(std::uint32_t offset) { return fmt::format("{0:x}h ({0})", offset); }

/// Where in a file the listings are looked for.
class Search {
 public:
  Search(judge::Code& code, const std::string& at) : code_(code), range_{0, code.size()} {
    if (at.empty()) return;
    const judge::Location location = judge::location_named(at);
    if (location.segment) {
      throw support::UsageError(
          "--at: with --against-listing it is an offset in the file, without a segment");
    }
    range_ = {location.offset, location.end.value_or(code.size())};
    is_exact_ = !location.end;
    has_range_ = !is_exact_;
    if (range_.first >= code.size() || range_.end > code.size()) {
      throw support::UsageError(fmt::format("--at: the file ends at {}", offset_text(code.size())));
    }
  }

  /// Returns the places of an equal routine.
  std::vector<ListingComparison> equal(judge::Code& listing) {
    if (!is_exact_) return judge::find_listing(listing, code_, range_);
    ListingComparison one = judge::compare_listing(listing, 0, code_, range_.first);
    if (!one.is_equal()) return {};
    return {std::move(one)};
  }

  /// Returns the nearest routine, if none is equal.
  std::optional<ListingComparison> nearest(judge::Code& listing,
                                           const std::vector<judge::CodeRange>& taken) {
    if (!is_exact_) return judge::find_nearest(listing, code_, range_, taken);
    return judge::compare_listing(listing, 0, code_, range_.first);
  }

  [[nodiscard]] std::string text() const {
    if (is_exact_) return fmt::format("the routine at {}", offset_text(range_.first));
    return fmt::format("bytes {} to {}", offset_text(range_.first), offset_text(range_.end));
  }
  /// Tells whether these bytes of the file are in the range.
  [[nodiscard]] bool contains(std::size_t at, std::size_t bytes) const {
    return range_.first <= at && at <= range_.end && bytes <= range_.end - at;
  }
  /// Returns how many of the bytes are known, if a range was given.
  [[nodiscard]] std::string share_text(std::uint64_t bytes) const {
    if (!has_range_) return {};
    return fmt::format(", {} of {} bytes", support::grouped(bytes),
                       support::grouped(range_.end - range_.first));
  }

 private:
  judge::Code& code_;
  judge::CodeRange range_;
  bool is_exact_ = false;
  bool has_range_ = false;
};

std::string digest_text(const ProgramKey& key, const ListingComparison& found) {
  const std::string digest = support::sha256_hex(found.text);
  const x86model::Source source = x86model::source_of(key.routine, key.target, key.build);
  const char* whose = source.digest.sha256 != digest ? "which is not recorded"
                      : source.is_original           ? "the author's"
                                                     : "ours";
  return fmt::format("  digest {}, {}\n", digest, whose);
}

std::string difference_text(const ListingComparison& found) {
  const ListingComparison::Difference& first = *found.first;
  const auto or_nothing = [](const std::string& text) {
    return text.empty() ? std::string("nothing") : text;
  };
  return fmt::format("  instruction {}\n    listing  {}\n    file     {}, at {}\n", first.number,
                     or_nothing(first.listed), or_nothing(first.found), offset_text(first.at));
}

/// Names another build of the routine, if that is in the file.
std::string other_build_text(const ProgramKey& wanted, Search& search) {
  for (const ProgramKey& key : machine_code::all_programs()) {
    if (key.routine != wanted.routine) continue;
    judge::Code listing = code_of(key);
    const auto found = search.equal(listing);
    if (found.empty()) continue;
    return fmt::format("  but {} is there, at {}\n", machine_code::name_of(key),
                       offset_text(found.front().start));
  }
  return {};
}

/// What became of one listing.
struct Sought {
  ProgramKey key;
  judge::Code listing;
  std::vector<ListingComparison> places;  ///< equal to it
  std::string table;
  std::size_t table_at = std::string::npos;

  [[nodiscard]] bool is_confirmed() const {
    return !places.empty() && (table.empty() || table_at != std::string::npos);
  }
};

Sought seek(const ProgramKey& key, judge::Code& code, Search& search) {
  Sought sought{key, code_of(key), {}, {}};
  sought.places = search.equal(sought.listing);
  sought.table = judge::table_of(sought.listing);
  if (!sought.table.empty()) sought.table_at = code.bytes().find(sought.table);
  return sought;
}

std::string confirmed_text(const Sought& sought) {
  const ListingComparison& one = sought.places.front();
  std::string places;
  for (const ListingComparison& place : sought.places) {
    places += (places.empty() ? "" : ", ") + offset_text(place.start);
  }
  std::string text =
      fmt::format("confirmed at {}: {} instructions in {} bytes\n{}", places, one.instructions,
                  support::grouped(one.end - one.start), digest_text(sought.key, one));
  if (sought.table.empty()) return text;
  const std::string table =
      fmt::format("  its table of {} bytes is ", support::grouped(sought.table.size()));
  if (!sought.is_confirmed()) return text + table + "NOT in the file\n";
  return text +
         fmt::format("{}at {}\n", table, offset_text(static_cast<std::uint32_t>(sought.table_at)));
}

/// @param taken the places of the listings that are confirmed
std::string missing_text(Sought& sought, Search& search,
                         const std::vector<judge::CodeRange>& taken) {
  const std::string other = other_build_text(sought.key, search);
  const auto nearest = search.nearest(sought.listing, taken);
  if (!nearest) return "NOT FOUND\n" + other;
  return fmt::format("DIFFERS at {} in {} of {} instructions, first in\n{}{}",
                     offset_text(nearest->start), nearest->differences, nearest->instructions,
                     difference_text(*nearest), other);
}

}  // namespace

void ListingOptions::add_to(CLI::App& command) {
  CLI::Option* const against =
      command
          .add_option("--against-listing", routines,
                      "only compare the code with a listing, instruction by instruction: mul, div, "
                      "cossin, xformvec, concat, several with commas, or all")
          ->delimiter(',')
          ->check(one_of({"mul", "div", "cossin", "xformvec", "concat", "all"}));
  variant.add_to(command);
  for (const char* name : {"--target", "--round", "--mul-round", "--div-round", "--as-printed",
                           "--chapter", "--repaired"}) {
    command.get_option(name)->needs(against);
  }
}

int judge_against_listings(const std::string& file, const std::string& at,
                           const ListingOptions& options, ResultFile& result) {
  const std::vector<ProgramKey> keys = keys_of(options);
  judge::Code code(judge::bytes_of(file));
  Search search(code, at);
  std::cout << fmt::format("{}: {}, as 16-bit code\n", support::printable(file), search.text());
  std::vector<Sought> all;
  std::vector<judge::CodeRange> taken;
  std::uint64_t bytes = 0;
  std::size_t confirmed = 0;
  for (const ProgramKey& key : keys) {
    const Sought& one = all.emplace_back(seek(key, code, search));
    if (one.is_confirmed()) {
      ++confirmed;
      if (search.contains(one.table_at, one.table.size())) bytes += one.table.size();
    }
    for (const ListingComparison& place : one.places) {
      taken.push_back({place.start, place.end});
      bytes += place.end - place.start;
    }
  }
  std::vector<ListingResult> listings;
  for (Sought& one : all) {
    ListingResult& listing = listings.emplace_back(
        ListingResult{machine_code::name_of(one.key), one.is_confirmed(), {}, {}});
    for (const ListingComparison& place : one.places) listing.places.push_back(place.start);
    listing.text = one.places.empty() ? missing_text(one, search, taken) : confirmed_text(one);
    std::cout << listing.name << ": " << listing.text;
  }
  std::cout << fmt::format("{} of {} listing{} confirmed{}\n", confirmed, keys.size(),
                           keys.size() == 1 ? "" : "s", search.share_text(bytes));
  return result.write(confirmed == keys.size() ? 0 : 1,
                      [&] { return listings_json(file, listings); });
}

}  // namespace fixproof::cli
