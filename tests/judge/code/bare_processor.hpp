/// @file
/// Runs pieces of 64-bit code on this processor.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "judge/code/call.hpp"
#include "tests/judge/code/user_forms.hpp"

namespace bare_processor {

/// The registers that pieces may use, in the numbers of encoding: RAX, RCX, RDX, RBX, RSI and R8.
inline constexpr std::array<std::size_t, 6> used_registers{0, 1, 2, 3, 6, 8};

/// Returns why no 64-bit code can run here, or an empty text.
std::string absence();

/// Tells whether this processor has a feature.
bool has(user_forms::Feature feature);

/// Pieces of code that one call of NASM assembles.
class Pieces : private boost::noncopyable {
 public:
  /// @param bits of the code; call() runs 64 only
  explicit Pieces(const std::vector<user_forms::Form>& forms, int bits = 64);
  ~Pieces();

  /// Returns the bytes of a piece.
  [[nodiscard]] std::string code(std::size_t index) const;
  /// Runs a piece from the used registers and the flags. @return whether it raised #DE
  [[nodiscard]] bool call(std::size_t index, fixproof::judge::Registers& registers) const;

 private:
  struct Memory;

  std::string bytes_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace bare_processor
