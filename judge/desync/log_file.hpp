/// @file
/// Reads the log of a run. docs/recorder.md documents the format.
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "fixed/record/layout.hpp"

namespace fixproof::desync {

using record::word;

/// The summary of a block.
struct Entry {
  word prefix = 0;  ///< The sum of the hashes of all records up to its end.
  word hash = 0;    ///< The sum of the hashes of its records.
  std::int64_t frame = record::no_frame;
  word operations = 0;
  word first_operation = 0;  ///< The number of operations before this block.
  word name = 0;             ///< The number of the name in force at its start, or 0.
  bool begins_frame = false;
  bool is_last = false;  ///< Whether the run ended in this block.
};

/// A record of a block, with the place and the mark in force there.
struct Record {
  std::vector<word> words;
  word operation = 0;  ///< The number of operations of the run before it.
  word name = 0;       ///< The hash of the mark's name, or 0 if the block has no mark so far.
  word file = 0;       ///< The number of the source's name, or 0 if unknown.
  std::uint32_t line = 0;
  std::optional<word> input;  ///< The bits of the double that it converts.
};

/// A log on disk. It reads pages on demand and keeps only the last one, so the size of the log does
/// not matter. It checks every page before it uses it.
class LogFile {
 public:
  /// @throws support::UsageError with the name of the file if it is not a log
  explicit LogFile(const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  /// The origin of the log: lines `name: value`.
  [[nodiscard]] const std::string& origin() const { return origin_; }
  /// The number of finished blocks that have records.
  [[nodiscard]] word blocks() const { return blocks_; }
  /// Whether the program closed the log. Otherwise the program was killed or still runs.
  [[nodiscard]] bool is_complete() const { return is_complete_; }
  /// The number of bytes at the end that are no page: what a killed program or machine left of the
  /// last pages.
  [[nodiscard]] word torn_bytes() const { return torn_bytes_; }
  /// The last confirmed frame, or no_frame.
  [[nodiscard]] std::int64_t confirmed() const { return confirmed_; }
  /// The number of pages read so far.
  [[nodiscard]] word pages_read() const { return pages_read_; }

  /// Returns the entry of a block below blocks().
  /// @throws support::UsageError if a page is damaged
  Entry entry(word block);
  /// Returns the records of a block, or none if the log does not have them in full.
  /// @throws support::UsageError if a page is damaged
  std::vector<Record> records(word block);
  /// Returns the name with a number from 1, or "?" if the log does not have it.
  std::string name(word number);
  /// Returns the name with a hash, or "?" if the log does not have it.
  std::string name_with_hash(word hash);

 private:
  using Page = std::array<word, record::page_words>;

  [[noreturn]] void fail(const std::string& reason) const;
  /// Reads a page and checks it. Returns nothing if it is damaged.
  std::optional<Page> try_page(word number);
  const Page& page(word number);
  word page_of_block(word block);
  word first_page_of_records(word block, word end);

  std::string path_;
  std::ifstream file_;
  word pages_ = 0;
  word blocks_ = 0;
  word torn_bytes_ = 0;
  word pages_read_ = 0;
  bool is_complete_ = false;
  std::int64_t confirmed_ = record::no_frame;
  std::string origin_;
  Page page_{};
  std::optional<word> page_number_;
};

}  // namespace fixproof::desync
