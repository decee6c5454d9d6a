/// \file
/// A log, and what the program says about its run: frames and marks.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <unordered_map>

#include "record/hash.hpp"
#include "record/layout.hpp"
#include "record/origin.hpp"
#include "record/pages.hpp"

namespace fixproof::record {

/// A range of blocks or frames, both ends included, to record in full. Empty: `last` < `first`.
struct full_range {
  bool is_of_frames = false;
  std::int64_t first = 0;
  std::int64_t last = -1;

  /// Reads "97-98" (blocks) or "frames:12-13". Anything else is an empty range.
  [[nodiscard]] static full_range from_text(std::string_view text) noexcept {
    full_range range;
    constexpr std::string_view frames = "frames:";
    if (text.substr(0, frames.size()) == frames) {
      range.is_of_frames = true;
      text.remove_prefix(frames.size());
    }
    const std::size_t dash = text.find('-');
    std::int64_t first = 0;
    std::int64_t last = 0;
    if (dash == std::string_view::npos || !read(text.substr(0, dash), first) ||
        !read(text.substr(dash + 1), last)) {
      return {};
    }
    range.first = first;
    range.last = last;
    return range;
  }

 private:
  static bool read(std::string_view digits, std::int64_t& value) noexcept {
    if (digits.empty() || digits.size() > 18) return false;
    for (const char c : digits) {
      if (c < '0' || c > '9') return false;
      value = value * 10 + (c - '0');
    }
    return true;
  }
};

/// What a log is opened with.
struct options {
  /// Named in the log.
  std::string_view program = "unnamed";
  /// What to record in full; by default what the environment variable FIXPROOF_RECORD_FULL says.
  full_range full = from_environment();

  /// The range in FIXPROOF_RECORD_FULL, or an empty one.
  [[nodiscard]] static full_range from_environment() noexcept {
    const char* const text = std::getenv("FIXPROOF_RECORD_FULL");
    return text == nullptr ? full_range{} : full_range::from_text(text);
  }
};

/// How far a run is: equal on two machines whose operations so far are equal.
struct position {
  std::uint64_t records = 0;  ///< Operations, frames and marks.
  std::uint64_t hash = 0;     ///< The sum of their hashes.

  friend bool operator==(const position&, const position&) = default;
};

/// A place in a source.
struct place {
  const char* file;
  unsigned line;
};
/// No place: that of the record before counts.
inline constexpr place nowhere{"", 0};

class log;

namespace detail {

// What the operations of a thread work on. Not members of one class: g++ would load and store them
// together in a vector register, which is several times slower.

/// The hash of the block so far.
inline constinit thread_local word current_hash = 0;
/// The records until room() must be called. Without a log so many that it never is.
inline constinit thread_local word current_left = 0;
/// The log of this thread. A log is of one thread: the order of operations between threads differs
/// from run to run.
inline constinit thread_local log* current_log = nullptr;

/// Takes a record at which `current_left` would become 0. \return what it becomes instead
word taken(const word* words, std::size_t count, place from) noexcept;
/// The same for two words, which then need not be in memory before.
word taken(word first, word second, place from) noexcept;

/// Puts a record into the hash of the block.
template <std::size_t Count>
inline void put(const std::array<word, Count>& words, place from) noexcept {
  static_assert(Count % 2 == 0 && Count <= max_record_words);
  // A sum, which does not depend on the order: compilers choose which operand of an operator they
  // compute first.
  word hash = current_hash + hash_words(words.data(), Count);
  word left = current_left - 1;
  if (left == 0) [[unlikely]] {
    current_hash = hash;
    if constexpr (Count == 2) {
      left = taken(words[0], words[1], from);
    } else {
      left = taken(words.data(), Count, from);
    }
    hash = current_hash;
  }
  current_hash = hash;
  current_left = left;
}

}  // namespace detail

/// Records the operations of this thread from its construction to its destruction.
///
/// It keeps a hash of each block of 1,024 records and of all blocks so far, and appends them to the
/// file in pages with checksums. It takes 3 KiB of memory, and up to 2 MiB for the names of marks
/// and sources, however long the run is. If the file cannot be opened or written, good() is false
/// and the program goes on as without a log.
class log {
 public:
  /// Replaces the file. A second log of the same thread takes over until it is destroyed.
  explicit log(const std::string& path, const options& how = {})
      : file_(path.c_str()),
        full_(how.full),
        outer_(detail::current_log),
        outer_hash_(detail::current_hash),
        outer_left_(detail::current_left) {
    page_[0] = first_word(page_type::header);
    page_[4] = put_text(page_, origin(how.program));
    append(page_);
    detail::current_log = this;
    begin_block();
  }
  /// Writes what is left and marks the last block as one that the end of the run cut.
  ~log() {
    end_block(entry_is_last);
    flush();
    detail::current_log = outer_;
    detail::current_hash = outer_hash_;
    detail::current_left = outer_left_;
  }
  log(const log&) = delete;
  log(log&&) = delete;
  log& operator=(const log&) = delete;
  log& operator=(log&&) = delete;

  /// Whether everything so far could be written.
  [[nodiscard]] bool good() const noexcept { return file_.good(); }

  /// Begins a frame; see record::frame().
  void frame(std::int64_t number) noexcept {
    end_block(0);
    frame_ = number;
    begins_frame_ = true;
    begin_block();
    put_remark(kind::frame, static_cast<word>(number));
  }

  /// Names what follows; see record::mark().
  void mark(std::string_view name) noexcept {
    const word number = number_of(name);
    put_remark(kind::mark, hash_text(name.data(), name.size()));
    if (number != 0) name_ = number;
  }

  /// Says that no frame up to this one will be simulated again.
  void confirm(std::int64_t number) noexcept { confirmed_ = number; }

  /// In a block that is recorded in full, writes the double that the next record converts. It is
  /// not part of a hash: what rounding hides is no difference of the numbers.
  void input(double x) noexcept {
    if (!is_recorded_) return;
    const std::array<word, 2> words{static_cast<word>(kind::input), std::bit_cast<word>(x)};
    put_words(words.data(), words.size());
  }

  /// Writes the finished blocks to the file.
  void flush() noexcept {
    if (entries_ == 0) return;
    page_[0] = first_word(page_type::blocks);
    append(page_);
    page_first_ = block_;
    page_operation_ = operation_;
    entries_ = 0;
  }

  /// How far this run is.
  [[nodiscard]] position where() const noexcept {
    return {total_ + records_ + (granted_ - detail::current_left), prefix_ + detail::current_hash};
  }

 private:
  friend word detail::taken(const word*, std::size_t, place) noexcept;

  static constexpr std::size_t max_names = 4096;
  static constexpr std::size_t max_name_length = 255;

  static constexpr word first_word(page_type type) noexcept {
    return word{static_cast<std::uint32_t>(type)} << 32 | magic;
  }

  /// Appends a page with what all pages share, and empties it.
  void append(std::array<word, page_words>& page) noexcept {
    page[2] = page_first_;
    if (page[0] == first_word(page_type::blocks)) {
      page[3] = page_operation_;
      page[4] = entries_;
    }
    page[4] |= names_.size() << 32;
    page[5] = static_cast<word>(confirmed_);
    file_.append(page);
    page = {};
  }

  /// The number of a name, from 1; 0 if there are too many.
  word number_of(std::string_view name) noexcept {
    name = name.substr(0, max_name_length);
    try {
      const auto found = names_.find(std::string(name));
      if (found != names_.end()) return found->second;
      if (names_.size() == max_names) return 0;
      const word number = names_.size() + 1;
      names_.emplace(name, number);
      std::array<word, page_words> page{};
      page[0] = first_word(page_type::name);
      page[3] = hash_text(name.data(), name.size());
      page[4] = put_text(page, name);
      page[6] = number;
      append(page);
      return number;
    } catch (...) {  // no memory
      return 0;
    }
  }

  void put_remark(kind k, word value) noexcept {
    ++remarks_;
    detail::put(std::array<word, 2>{static_cast<word>(k), value}, nowhere);
  }

  [[nodiscard]] bool is_full() const noexcept {
    const auto at = full_.is_of_frames ? frame_ : static_cast<std::int64_t>(block_);
    return full_.first <= at && at <= full_.last;
  }

  void begin_block() noexcept {
    is_recorded_ = is_full();
    records_ = 0;
    remarks_ = 0;
    block_name_ = name_;
    place_ = 0;
    detail::current_hash = 0;
    // In a block that is recorded in full every record is taken, with its place.
    granted_ = is_recorded_ ? 1 : block_records;
    detail::current_left = granted_;
  }

  /// Summarises the block, unless it is empty.
  void end_block(word flags) noexcept {
    records_ += granted_ - detail::current_left;
    if (records_ == 0) return;
    if (used_ != 0) write_records();
    prefix_ += detail::current_hash;
    total_ += records_;
    const std::size_t at = page_header + entries_ * entry_words;
    page_[at] = prefix_;
    page_[at + 1] = detail::current_hash;
    page_[at + 2] = static_cast<word>(frame_);
    page_[at + 3] = (records_ - remarks_) | flags | (begins_frame_ ? entry_begins_frame : 0) |
                    block_name_ << entry_name_shift;
    begins_frame_ = false;
    ++block_;
    operation_ += records_ - remarks_;
    if (++entries_ == page_entries) flush();
  }

  word take(const word* words, std::size_t count, place from) noexcept {
    detail::current_left = 0;
    if (is_recorded_) {
      put_place(from);
      put_words(words, count);
    }
    if (records_ + granted_ == block_records) {
      end_block(0);
      begin_block();
    } else {
      records_ += granted_;
      detail::current_left = granted_;
    }
    return detail::current_left;
  }

  /// Writes a record of the place if it is another one than before.
  void put_place(place from) noexcept {
    if (from.line == 0) return;
    const word here = number_of(from.file) << 32 | from.line;
    if (here == place_) return;
    place_ = here;
    const std::array<word, 2> words{static_cast<word>(kind::place), here};
    put_words(words.data(), words.size());
  }
  void put_words(const word* words, std::size_t count) noexcept {
    if (used_ + count > page_room) write_records();
    for (std::size_t i = 0; i < count; ++i) record_page_[page_header + used_++] = words[i];
  }
  void write_records() noexcept {
    record_page_[0] = first_word(page_type::records);
    record_page_[4] = used_;
    record_page_[6] = block_;
    append(record_page_);
    used_ = 0;
  }

  page_file file_;
  full_range full_;
  log* outer_;
  word outer_hash_;
  word outer_left_;

  std::array<word, page_words> page_{};  ///< The entries of finished blocks.
  word entries_ = 0;
  word page_first_ = 0;
  word page_operation_ = 0;
  std::array<word, page_words> record_page_{};  ///< Records of a block in full.
  std::size_t used_ = 0;
  word place_ = 0;

  word block_ = 0;      ///< Finished blocks,
  word operation_ = 0;  ///< the operations in them,
  word total_ = 0;      ///< and their records.
  word prefix_ = 0;
  bool is_recorded_ = false;
  bool begins_frame_ = false;
  word granted_ = 0;  ///< What current_left was when `records_` and `remarks_` were counted.
  word records_ = 0;
  word remarks_ = 0;
  std::int64_t frame_ = no_frame;
  std::int64_t confirmed_ = no_frame;
  word name_ = 0;
  word block_name_ = 0;
  std::unordered_map<std::string, word> names_;
};

namespace detail {

#if defined(__GNUC__)
__attribute__((noinline, cold))
#endif
inline word
taken(const word* words, std::size_t count, place from) noexcept {
  return current_log == nullptr ? 0 : current_log->take(words, count, from);
}
#if defined(__GNUC__)
__attribute__((noinline, cold))
#endif
inline word
taken(word first, word second, place from) noexcept {
  const std::array<word, 2> words{first, second};
  return taken(words.data(), words.size(), from);
}

}  // namespace detail

/// Says that the frame `number` begins. Frames may repeat, where a program goes back and simulates
/// again. Without a log it does nothing, as the other functions.
inline void frame(std::int64_t number) noexcept {
  if (log* const owner = detail::current_log) owner->frame(number);
}

/// Names what follows, until the next mark: "collide", "player 3". Of the text 255 bytes count, and
/// 4,096 names.
inline void mark(std::string_view name) noexcept {
  if (log* const owner = detail::current_log) owner->mark(name);
}

/// Says that no frame up to `number` will be simulated again.
inline void confirm(std::int64_t number) noexcept {
  if (log* const owner = detail::current_log) owner->confirm(number);
}

/// Writes the finished blocks to the file, so that they are not lost if the program is killed.
inline void flush() noexcept {
  if (log* const owner = detail::current_log) owner->flush();
}

/// How far the run is, for machines to compare while they run. Both are 0 without a log.
inline position where() noexcept {
  const log* const owner = detail::current_log;
  return owner == nullptr ? position{} : owner->where();
}

}  // namespace fixproof::record
