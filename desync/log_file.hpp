/// @file
/// Reads the log of a run. docs/recorder.md documents the format.
#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "record/layout.hpp"

namespace fixproof::desync {

using record::word;

/// The summary of a block.
struct Entry {
  word prefix = 0;  ///< The sum of the hashes of all records to its end.
  word hash = 0;    ///< The same of the records of this block.
  std::int64_t frame = record::no_frame;
  word operations = 0;
  word first_operation = 0;  ///< The operations before this block.
  word name = 0;             ///< The number of the name in force where it begins; 0: none.
  bool begins_frame = false;
  bool is_last = false;  ///< The run ended in this block.
};

/// A record of a block, with what is in force there.
struct Record {
  std::vector<word> words;
  word operation = 0;  ///< The operations of the run before it.
  word name = 0;       ///< The hash of the mark's name; 0: none since the block began.
  word file = 0;       ///< The number of the source's name; 0: unknown.
  std::uint32_t line = 0;
  std::optional<word> input;  ///< The bits of the double that it converts.
};

/// A log on disk. It reads the pages that are asked for and keeps only the last one, so the size of
/// a log does not matter. Every page is checked before it is used.
class LogFile {
 public:
  /// @throws support::UsageError naming the file if it is no log
  explicit LogFile(const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  /// What made it: lines `name: value`.
  [[nodiscard]] const std::string& origin() const { return origin_; }
  /// The number of finished blocks.
  [[nodiscard]] word blocks() const { return blocks_; }
  /// Whether the program closed it; otherwise the program was killed, or still runs.
  [[nodiscard]] bool is_complete() const { return is_complete_; }
  /// Bytes at the end that are no page: what a killed program or machine left of the last ones.
  [[nodiscard]] word torn_bytes() const { return torn_bytes_; }
  /// The last frame that is final, or no_frame.
  [[nodiscard]] std::int64_t confirmed() const { return confirmed_; }
  /// The pages read so far.
  [[nodiscard]] word pages_read() const { return pages_read_; }

  /// The entry of a block below blocks().
  /// @throws support::UsageError if a page is damaged
  Entry entry(word block);
  /// The records of a block if the log has them in full, else nothing.
  /// @throws support::UsageError if a page is damaged
  std::vector<Record> records(word block);
  /// The name with a number from 1, or "?" if the log does not have it.
  std::string name(word number);
  /// The name with a hash, or "?".
  std::string name_with_hash(word hash);

 private:
  using Page = std::array<word, record::page_words>;

  [[noreturn]] void fail(const std::string& reason) const;
  /// Reads a page and checks it; nothing if it is damaged.
  std::optional<Page> try_page(word number);
  const Page& page(word number);
  word page_of_block(word block);

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
