/// @file
/// The characters that no message may contain, because a terminal obeys them.
#pragma once

#include <string_view>

namespace fixproof::fuzz {

/// Returns whether `text`, in UTF-8, contains a control character other than a newline, or one that
/// changes the direction of writing: C0, DEL, C1 (U+0080 to U+009F), U+200E, U+200F, U+202A to
/// U+202E, U+2066 to U+2069.
inline bool has_control_character(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto at = [&](std::size_t k) {
      return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0U;
    };
    if ((at(0) < ' ' && at(0) != '\n') || at(0) == 0x7F) return true;
    if (at(0) == 0xC2 && at(1) >= 0x80 && at(1) <= 0x9F) return true;
    if (at(0) != 0xE2) continue;
    if (at(1) == 0x80 && (at(2) == 0x8E || at(2) == 0x8F || (at(2) >= 0xAA && at(2) <= 0xAE))) {
      return true;
    }
    if (at(1) == 0x81 && at(2) >= 0xA6 && at(2) <= 0xA9) return true;
  }
  return false;
}

}  // namespace fixproof::fuzz
