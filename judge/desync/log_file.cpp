#include "judge/desync/log_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include "fixed/record/hash.hpp"
#include "support/usage_error.hpp"

namespace fixproof::desync {

namespace {

using record::page_type;

/// How many damaged pages at the end count as torn: more than a loss of power leaves.
constexpr word max_torn_pages = 4096;

page_type type_of(word first) { return static_cast<page_type>(first >> 32); }

/// Tells whether the counts of a page are possible, so that code that uses the page need not check
/// them.
bool is_sound(const std::array<word, record::page_words>& page) {
  if ((page[0] & 0xffffffff) != record::magic) return false;
  const word count = page[4] & 0xffffffff;
  switch (type_of(page[0])) {
    case page_type::header:
    case page_type::name:
      return count <= record::page_room * sizeof(word);
    case page_type::records:
      return count <= record::page_room;
    case page_type::blocks:
      return count >= 1 && count <= record::page_entries;
  }
  return false;
}

std::string text_of(const std::array<word, record::page_words>& page) {
  std::string text;
  const word length = page[4] & 0xffffffff;
  for (std::size_t i = 0; i < length; ++i) {
    text += static_cast<char>(page[record::page_header + i / 8] >> (8 * (i % 8)) & 0xff);
  }
  return text;
}

/// Adds to a record what `words` say of it. Returns whether it is complete.
bool add_to(Record& next, record::kind kind, std::span<const word> words) {
  if (kind == record::kind::place) {
    next.file = words[1] >> 32;
    next.line = static_cast<std::uint32_t>(words[1]);
    return false;
  }
  if (kind == record::kind::input) {
    next.input = words[1];
    return false;
  }
  next.words.assign(words.begin(), words.end());
  if (kind == record::kind::mark) next.name = words[1];
  return true;
}

}  // namespace

LogFile::LogFile(const std::string& path) : path_(path) {
  std::error_code error;
  const auto type = std::filesystem::status(path, error).type();
  if (type == std::filesystem::file_type::not_found) fail("there is no such file");
  if (type != std::filesystem::file_type::regular) {
    fail("this is not a regular file; desync searches in a file, and reads no folder or pipe");
  }
  const word bytes = std::filesystem::file_size(path, error);
  file_.open(path, std::ios::binary);
  if (error || !file_) fail("cannot be read; check its permissions");
  pages_ = bytes / record::page_bytes;
  const auto header = pages_ == 0 ? std::nullopt : try_page(0);
  if (!header || type_of((*header)[0]) != page_type::header) {
    fail("is not a log of record::log, or its first page is damaged");
  }
  origin_ = text_of(*header);
  const word whole = pages_;
  while (!try_page(pages_ - 1)) {
    if (whole - --pages_ > max_torn_pages) fail("has more than 4,096 damaged pages at its end");
  }
  torn_bytes_ = bytes - pages_ * record::page_bytes;
  for (word i = pages_; i-- > 1;) {
    const Page& last = page(i);
    if (type_of(last[0]) != page_type::blocks) continue;
    confirmed_ = static_cast<std::int64_t>(last[5]);
    const word count = last[4] & 0xffffffff;
    if (last[2] > ~word{0} - count) fail(fmt::format("page {} has impossible numbers", i));
    blocks_ = last[2] + count;
    const Entry end = entry(blocks_ - 1);
    is_complete_ = end.is_last;
    // Only the last block of a run may have no record.
    if (end.is_last && end.operations == 0 && end.hash == 0) --blocks_;
    break;
  }
}

void LogFile::fail(const std::string& reason) const {
  throw support::UsageError(fmt::format("{}: {}", path_, reason));
}

std::optional<LogFile::Page> LogFile::try_page(word number) {
  std::array<char, record::page_bytes> bytes{};
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(number * record::page_bytes));
  file_.read(bytes.data(), bytes.size());
  ++pages_read_;
  if (file_.gcount() != static_cast<std::streamsize>(bytes.size())) return std::nullopt;
  Page page{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    page[i / 8] |= word{static_cast<unsigned char>(bytes[i])} << (8 * (i % 8));
  }
  const word checksum = page[7];
  page[7] = 0;
  if (record::hash_words(page.data(), page.size()) != checksum) return std::nullopt;
  if (page[1] != number || !is_sound(page)) return std::nullopt;
  return page;
}

const LogFile::Page& LogFile::page(word number) {
  if (page_number_ == number) return page_;
  const auto read = try_page(number);
  if (!read) fail(fmt::format("page {} is damaged", number));
  page_ = *read;
  page_number_ = number;
  return page_;
}

/// Searches for the last page whose first block is at most `block`. Pages of names and of records
/// come before the page of entries and have the same first block.
word LogFile::page_of_block(word block) {
  word low = 1;
  word high = pages_;
  while (high - low > 1) {
    const word middle = low + (high - low) / 2;
    (page(middle)[2] <= block ? low : high) = middle;
  }
  const Page& found = page(low);
  if (type_of(found[0]) != page_type::blocks || block < found[2] ||
      block - found[2] >= (found[4] & 0xffffffff)) {
    fail(fmt::format("page {} has no entry of block {}", low, block));
  }
  return low;
}

Entry LogFile::entry(word block) {
  const bool is_here = page_number_ && type_of(page_[0]) == page_type::blocks &&
                       page_[2] <= block && block - page_[2] < (page_[4] & 0xffffffff);
  const Page& found = is_here ? page_ : page(page_of_block(block));
  Entry entry;
  entry.first_operation = found[3];
  for (word b = found[2];; ++b) {
    const word* words = &found[record::page_header + (b - found[2]) * record::entry_words];
    const word operations = words[3] & record::entry_operations;
    if (b < block) {
      entry.first_operation += operations;
      continue;
    }
    entry.prefix = words[0];
    entry.hash = words[1];
    entry.frame = static_cast<std::int64_t>(words[2]);
    entry.operations = operations;
    entry.begins_frame = (words[3] & record::entry_begins_frame) != 0;
    entry.is_last = (words[3] & record::entry_is_last) != 0;
    entry.name = words[3] >> record::entry_name_shift;
    return entry;
  }
}

/// Returns the first page that may have records of a block, given the page of its entry. A flush
/// during a block puts one page of entries between its records.
word LogFile::first_page_of_records(word block, word end) {
  bool may_pass_entries = page(end)[2] == block;
  word first = end;
  for (; first > 1; --first) {
    const Page& before = page(first - 1);
    if (type_of(before[0]) == page_type::records && before[6] < block) break;
    if (type_of(before[0]) == page_type::blocks && !std::exchange(may_pass_entries, false)) break;
  }
  return first;
}

std::vector<Record> LogFile::records(word block) {
  const word end = page_of_block(block);
  const word first = first_page_of_records(block, end);
  const word start = entry(block).first_operation;
  std::vector<Record> records;
  Record next;
  next.operation = start;
  for (word i = first; i < end; ++i) {
    const Page contents = page(i);
    if (type_of(contents[0]) != page_type::records || contents[6] != block) continue;
    const word used = contents[4] & 0xffffffff;
    for (word at = 0; at < used;) {
      const word* words = &contents[record::page_header + at];
      const word length = record::words_of(*words);
      if (length > record::max_record_words || length > used - at) {
        fail(fmt::format("page {} has a record of an impossible length", i));
      }
      at += length;
      const record::kind kind = record::kind_of(*words);
      if (record::text_of(kind) == nullptr) {
        fail(fmt::format("page {} has a record of the unknown kind {}", i,
                         *words & record::tag_kind));
      }
      if (!add_to(next, kind, {words, length})) continue;
      records.push_back(next);
      if (record::is_operation(kind)) ++next.operation;
      next.input.reset();
      if (records.size() > record::block_records) {
        fail(fmt::format("page {} has more than {} records of block {}", i, record::block_records,
                         block));
      }
    }
  }
  return records;
}

std::string LogFile::name(word number) {
  if (number == 0) return "?";
  // Find the first page that counts this name.
  word low = 0;
  word high = pages_ - 1;
  while (low < high) {
    const word middle = low + (high - low) / 2;
    if (page(middle)[4] >> 32 >= number) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  const Page& found = page(low);
  return type_of(found[0]) == page_type::name && found[6] == number ? text_of(found) : "?";
}

std::string LogFile::name_with_hash(word hash) {
  const word names = page(pages_ - 1)[4] >> 32;
  for (word number = 1; number <= std::min<word>(names, 4096); ++number) {
    std::string text = name(number);
    if (record::hash_text(text.data(), text.size()) == hash) return text;
  }
  return "?";
}

}  // namespace fixproof::desync
