/// @file
/// What a program or its environment asks of a log.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace fixproof::record {

/// A range of blocks or frames to record in full, both ends included. It is empty if `last` <
/// `first`.
struct full_range {
  bool is_of_frames = false;  ///< Whether the ends are numbers of frames.
  std::int64_t first = 0;     ///< The first block or frame.
  std::int64_t last = -1;     ///< The last one.

  /// Reads a range of blocks such as "97-98", or of frames such as "frames:12-13". Frames may be
  /// negative: "frames:-2--1". Returns an empty range for anything else.
  [[nodiscard]] static full_range from_text(std::string_view text) noexcept {
    full_range range;
    constexpr std::string_view frames = "frames:";
    if (text.substr(0, frames.size()) == frames) {
      range.is_of_frames = true;
      text.remove_prefix(frames.size());
    }
    const std::size_t dash = text.find('-', 1);  // the first character may be a sign
    std::int64_t first = 0;
    std::int64_t last = 0;
    if (dash == std::string_view::npos || !read(text.substr(0, dash), first) ||
        !read(text.substr(dash + 1), last) || (first < 0 && !range.is_of_frames)) {
      return {};
    }
    range.first = first;
    range.last = last;
    return range;
  }

  /// Returns the range for people: "blocks 97 to 98", "frames 12 to 13" or "nothing".
  [[nodiscard]] std::string to_text() const {
    if (last < first) return "nothing";
    return (is_of_frames ? "frames " : "blocks ") + std::to_string(first) + " to " +
           std::to_string(last);
  }

 private:
  static bool read(std::string_view text, std::int64_t& value) noexcept {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end;
  }
};

/// The options of a log.
struct options {
  /// The name of the program, for the log.
  std::string_view program = "unnamed";
  /// What to record in full. The default is the range in the environment variable
  /// FIXPROOF_RECORD_FULL.
  full_range full = from_environment();

  /// Returns the range in FIXPROOF_RECORD_FULL, or an empty one.
  [[nodiscard]] static full_range from_environment() noexcept {
    const char* const text = std::getenv("FIXPROOF_RECORD_FULL");
    return text == nullptr ? full_range{} : full_range::from_text(text);
  }
};

}  // namespace fixproof::record
