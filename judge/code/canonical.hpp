/// @file
/// Machine code as canonical text, which does not depend on NOPs, addresses or the choice of
/// encodings. Routines with equal texts are otherwise the same, except that they may call other
/// routines and read other entries of a table. docs/originals.md defines the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fixproof::judge {

/// An instruction of 16-bit code.
struct CanonicalLine {
  std::uint32_t at = 0;     ///< offset of its first byte
  std::uint32_t bytes = 0;  ///< 0 if the code ends before the instruction
  std::string text{};       ///< without the target of a relative jump, LOOP or CALL
  /// The offset to which a relative jump, LOOP or CALL leads. It may be negative or past the code.
  std::optional<std::int64_t> target{};
  /// The displacement for which the text has TAB.
  std::optional<std::uint16_t> table{};
};

/// Machine code that is disassembled on demand, from any offset. Needs ndisasm on the PATH.
class Code {
 public:
  explicit Code(std::string bytes) : bytes_(std::move(bytes)) {}

  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(bytes_.size()); }
  /// Returns the instruction that starts at an offset, even inside another instruction.
  /// @throws support::UsageError if ndisasm cannot be run
  const CanonicalLine& at(std::uint32_t offset);

 private:
  void disassemble(std::uint32_t first, std::vector<CanonicalLine>& lines) const;

  std::string bytes_;
  std::map<std::uint32_t, std::vector<CanonicalLine>> pieces_;  ///< by number
};

/// Consecutive instructions, without the NOPs.
class CanonicalRoutine {
 public:
  /// Takes at most `most` instructions from `start` on, and stops at the end of the code.
  /// @param until_return whether to stop after the first RET
  CanonicalRoutine(Code& code, std::uint32_t start, bool until_return,
                   std::size_t most = std::numeric_limits<std::size_t>::max());

  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  [[nodiscard]] const CanonicalLine& line(std::size_t number) const { return *lines_[number]; }
  /// Keeps only the first `count` instructions.
  void resize(std::size_t count);
  /// Returns the offset after the last instruction, or the start if there are none.
  [[nodiscard]] std::uint32_t end() const;

  /// Returns the number of the instruction to which a jump leads, or nothing if it leads outside.
  [[nodiscard]] std::optional<std::size_t> target_of(std::size_t number) const;
  /// Returns the text of one instruction, with the number of its target or `ext`.
  [[nodiscard]] std::string text_of(std::size_t number) const;
  /// Returns the whole text. A digest is its SHA-256.
  [[nodiscard]] std::string text() const;

 private:
  std::uint32_t start_;
  std::vector<const CanonicalLine*> lines_;
  std::map<std::int64_t, std::size_t> numbers_;  ///< by offset; a NOP has the number of the next
};

}  // namespace fixproof::judge
