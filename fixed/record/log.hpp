/// @file
/// A log of a run, and what the program reports about the run, such as frames and marks.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

#include "fixed/detail/inlining.hpp"
#include "fixed/record/hash.hpp"
#include "fixed/record/layout.hpp"
#include "fixed/record/options.hpp"
#include "fixed/record/origin.hpp"
#include "fixed/record/pages.hpp"

/// What a program reports about a run with recorded numbers, and the log that keeps it.
namespace fixproof::record {

/// How far a run has come. Two machines whose operations so far are equal have the same position.
struct position {
  std::uint64_t records = 0;  ///< Operations, frames and marks.
  std::uint64_t hash = 0;     ///< The sum of their hashes.

  /// Whether both members are equal.
  friend bool operator==(const position&, const position&) = default;
};

/// A place in a source.
struct place {
  const char* file;  ///< The name of the file.
  unsigned line;     ///< The line, from 1 on.
};
/// No place. The place of the record before remains in force.
inline constexpr place nowhere{"", 0};

// A program and its shared libraries share these and the state of a thread, also under
// -fvisibility=hidden: a log has the operations of all of them.
#if defined(__ELF__)
#pragma GCC visibility push(default)
#endif
class log;

namespace detail {

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): each thread has its own
// The state that each operation of a thread updates. They are not members of one class, because g++
// would load and store them together in a vector register, which is several times slower.

/// The hash of the block so far.
inline constinit thread_local word current_hash = 0;
/// The number of records until taken() must be called. Without a log it starts at 0 and wraps
/// around, so that taken() is never called.
inline constinit thread_local word current_left = 0;
/// The log of this thread. Each log belongs to one thread, because the order of operations in
/// different threads differs from run to run.
inline constinit thread_local log* current_log = nullptr;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)
#if defined(__ELF__)
#pragma GCC visibility pop
#endif

/// Takes a record at which `current_left` would become 0. Returns what it becomes instead.
word taken(const word* words, std::size_t count, place from) noexcept;
/// The same for a record of two words, which the caller then need not put into memory.
word taken(word first, word second, place from) noexcept;
/// Writes the double that the next record converts, if the block is recorded in full. No hash
/// covers the double, because a difference that rounding hides is no difference of the numbers.
void put_input(double x) noexcept;

/// Adds a record to the hash of the block.
template <std::size_t Count>
FIXED_INLINE inline void put(const std::array<word, Count>& words, place from) noexcept {
  static_assert(Count % 2 == 0 && Count <= max_record_words);
  // A sum does not depend on the order, and compilers choose which operand of an operator they
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
/// The log keeps a hash of each block of 1,024 records and of all blocks so far, and appends them
/// to the file in pages with checksums. It takes 3 KiB of memory, and up to 2 MiB for the names of
/// marks and sources, however long the run is. If the file cannot be opened or written, or another
/// log writes it, good() returns false, and the program continues as without a log. So does a child
/// process that inherits the log from fork().
class log {
 public:
  /// Opens a log and replaces the file at `path`. Until it is destroyed, an older log of this
  /// thread gets no records.
  explicit log(const std::string& path, const options& how = {})
      : file_(path.c_str()), full_(how.full), older_(detail::current_log) {
    page_[0] = first_word(page_type::header);
    page_[4] = put_text(page_, origin(how.program) + "recorded in full: " + full_.to_text() + '\n');
    append(page_);
    make_current(this);
    begin_block();
  }
  /// Writes the rest and marks the last block as one that ends with the run. Logs may be destroyed
  /// in any order. In another thread, the destructor writes only finished blocks, and the thread
  /// that opened the log must have ended.
  ~log() {
    log** holder = &detail::current_log;
    while (*holder != nullptr && *holder != this) holder = &(*holder)->older_;
    if (*holder == nullptr) {
      flush();
      return;
    }
    log* const current = detail::current_log;
    make_current(this);
    end_block(entry_is_last);
    flush();
    make_current(current == this ? older_ : current);
    *holder = older_;
  }
  log(const log&) = delete;
  log(log&&) = delete;
  log& operator=(const log&) = delete;
  log& operator=(log&&) = delete;

  /// Tells whether everything so far was written.
  [[nodiscard]] bool good() const noexcept { return *problem() == '\0'; }
  /// Returns why nothing more is written, such as "the file cannot be written", or an empty text.
  [[nodiscard]] const char* problem() const noexcept { return file_.problem(); }

 private:
  friend void frame(std::int64_t number) noexcept;
  friend void mark(std::string_view name) noexcept;
  friend void confirm(std::int64_t number) noexcept;
  friend void flush() noexcept;
  friend position where() noexcept;
  friend void detail::put_input(double x) noexcept;
  friend word detail::taken(const word* words, std::size_t count, place from) noexcept;

  void frame(std::int64_t number) noexcept {
    if (has_records()) end_block(0);
    frame_ = number;
    begins_frame_ = true;
    begin_block();
    put_remark(kind::frame, static_cast<word>(number));
  }

  void mark(std::string_view name) noexcept {
    name = name.substr(0, max_name_length);
    name_ = number_of(name);  // before the record, because that may begin the next block
    put_remark(kind::mark, hash_text(name.data(), name.size()));
  }

  void confirm(std::int64_t number) noexcept { confirmed_ = number; }

  void input(double x) noexcept {
    if (!is_recorded_) return;
    const std::array<word, 2> words{static_cast<word>(kind::input), std::bit_cast<word>(x)};
    put_words(words.data(), words.size());
  }

  void flush() noexcept {
    if (entries_ == 0) return;
    page_[0] = first_word(page_type::blocks);
    append(page_);
    page_first_ = block_;
    page_operation_ = operation_;
    entries_ = 0;
  }

  [[nodiscard]] position where() const noexcept {
    return {total_ + records_ + (granted_ - detail::current_left), prefix_ + detail::current_hash};
  }

  static constexpr std::size_t max_names = 4096;
  static constexpr std::size_t max_name_length = 255;

  static constexpr word first_word(page_type type) noexcept {
    return word{static_cast<std::uint32_t>(type)} << 32 | magic;
  }

  /// Gives the state of this thread to `next`, which may be null, and keeps it for the log that had
  /// it.
  static void make_current(log* next) noexcept {
    if (log* const before = detail::current_log) {
      before->hash_ = detail::current_hash;
      before->left_ = detail::current_left;
    }
    detail::current_log = next;
    detail::current_hash = next == nullptr ? 0 : next->hash_;
    detail::current_left = next == nullptr ? 0 : next->left_;
  }

  /// Fills in what all pages have, appends the page, and clears it.
  void append(std::array<word, page_words>& page) noexcept {
    page[2] = page_first_;
    if (page[0] == first_word(page_type::blocks)) {
      page[3] = page_operation_;
      page[4] = entries_;
    }
    page[4] |= names_.size() << 32;
    page[5] = static_cast<word>(written_confirmed_);
    file_.append(page);
    page = {};
  }

  /// Returns the number of a name, from 1, or 0 if there are too many names or no memory.
  word number_of(std::string_view name) noexcept {
    name = name.substr(0, max_name_length);
#if defined(__cpp_exceptions)
    try {
      return find_or_write(name);
    } catch (...) {  // no memory
      return 0;
    }
#else
    return find_or_write(name);
#endif
  }
  word find_or_write(std::string_view name) {
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
    // In a block that is recorded in full, take() gets every record, with its place.
    granted_ = is_recorded_ ? 1 : block_records;
    detail::current_left = granted_;
  }

  [[nodiscard]] bool has_records() const noexcept {
    return records_ + (granted_ - detail::current_left) != 0;
  }

  /// Writes the entry of the block. Only the last block of a run may be empty.
  void end_block(word flags) noexcept {
    records_ += granted_ - detail::current_left;
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
    // The records before confirm() are in finished blocks now.
    written_confirmed_ = confirmed_;
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

  /// Writes a record of the place if the place has changed.
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
  log* older_;  ///< The next older log of this thread, or null.
  /// What `current_hash` and `current_left` become when this log is current again.
  word hash_ = 0;
  word left_ = 0;

  std::array<word, page_words> page_{};  ///< The entries of finished blocks.
  word entries_ = 0;
  word page_first_ = 0;
  word page_operation_ = 0;
  std::array<word, page_words> record_page_{};  ///< Records of a block that is recorded in full.
  std::size_t used_ = 0;
  word place_ = 0;

  word block_ = 0;      ///< The number of finished blocks.
  word operation_ = 0;  ///< The number of operations in them.
  word total_ = 0;      ///< The number of records in them.
  word prefix_ = 0;
  bool is_recorded_ = false;
  bool begins_frame_ = false;
  word granted_ = 0;  ///< What current_left was when `records_` was last updated.
  word records_ = 0;
  word remarks_ = 0;
  std::int64_t frame_ = no_frame;
  std::int64_t confirmed_ = no_frame;
  std::int64_t written_confirmed_ = no_frame;  ///< What was confirmed when the last block ended.
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

inline void put_input(double x) noexcept {
  if (log* const owner = current_log) owner->input(x);
}

}  // namespace detail

/// Says that the frame `number` begins. Frames may repeat if a program goes back and simulates them
/// again. Like the functions below, it does nothing without a log.
inline void frame(std::int64_t number) noexcept {
  if (log* const owner = detail::current_log) owner->frame(number);
}

/// Names what follows until the next mark, such as "collide" or "player 3". A log keeps the first
/// 255 bytes of a name, and 4,096 names.
inline void mark(std::string_view name) noexcept {
  if (log* const owner = detail::current_log) owner->mark(name);
}

/// Says that frames up to `number` are final: the program will not simulate them again.
inline void confirm(std::int64_t number) noexcept {
  if (log* const owner = detail::current_log) owner->confirm(number);
}

/// Writes the finished blocks to the file, so that they survive if the program is killed.
inline void flush() noexcept {
  if (log* const owner = detail::current_log) owner->flush();
}

/// Returns how far the run has come, for machines to compare while they run. Both members are 0
/// without a log.
inline position where() noexcept {
  const log* const owner = detail::current_log;
  return owner == nullptr ? position{} : owner->where();
}

}  // namespace fixproof::record
