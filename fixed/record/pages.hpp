/// @file
/// Writes the pages of a log.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fixed/record/file.hpp"
#include "fixed/record/hash.hpp"
#include "fixed/record/layout.hpp"

namespace fixproof::record {

/// Appends pages to a file. After an error it writes nothing more, so a log has no gaps.
class page_file {
 public:
  /// Opens the file to write it anew.
  explicit page_file(const char* path) noexcept : file_(path) {}

  /// Returns why nothing more is written, or an empty text.
  [[nodiscard]] const char* problem() const noexcept { return file_.problem(); }

  /// Appends a page. Sets its second word to the number of the page, and its eighth to the
  /// checksum.
  void append(std::array<word, page_words>& page) noexcept {
    page[1] = pages_++;
    page[7] = 0;
    page[7] = hash_words(page.data(), page.size());
    std::array<unsigned char, page_bytes> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = static_cast<unsigned char>(page[i / 8] >> (8 * (i % 8)) & 0xff);
    }
    file_.write(bytes.data(), bytes.size());
  }

 private:
  sole_file file_;
  word pages_ = 0;
};

/// Puts a text into the contents of a page, eight characters to a word, the first one lowest. Cuts
/// off what does not fit. Returns the length.
inline std::size_t put_text(std::array<word, page_words>& page, std::string_view text) noexcept {
  const std::size_t room = page_room * sizeof(word);
  const std::size_t length = text.size() < room ? text.size() : room;
  for (std::size_t i = 0; i < length; ++i) {
    page[page_header + i / 8] |= word{static_cast<unsigned char>(text[i])} << (8 * (i % 8));
  }
  return length;
}

}  // namespace fixproof::record
