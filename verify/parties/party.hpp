/// @file
/// The interface of a party, which answers cases of one variant.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "verify/cases/variant.hpp"

namespace fixproof::parties {

enum class Ending : std::uint8_t {
  value,           ///< the result words hold the answer
  divide_error,    ///< #DE
  undefined_flag,  ///< the program read a flag that Intel leaves undefined
  broken,  ///< the program left its memory, did not end or did not preserve its caller's state
};

/// Cases to answer and room for the answers. Words are two's complement bits, zero-extended. The
/// result words of a case that did not end in a value are unspecified.
struct Cases {
  std::span<const std::uint32_t> in;  ///< cases * words_in(variant)
  std::span<std::uint32_t> out;       ///< cases * words_out(variant)
  std::span<Ending> endings;          ///< one per case
};

/// A party cannot answer, for a reason outside the cases, such as lack of memory. That is never a
/// mismatch, and no case that it was asked counts as compared.
class PartyFailure : public std::runtime_error {
 public:
  PartyFailure(std::string_view party, std::string_view reason);
};

class Party : private boost::noncopyable {
 public:
  virtual ~Party() = default;

  /// The party's command-line name: one lower-case word, or the name of library.hpp.
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// Returns what answers under that name, such as the version of a library or the name of a
  /// processor: two parties of one name may answer differently if their identities differ.
  [[nodiscard]] virtual std::string identity() const = 0;
  /// Returns why this party cannot answer anything here, in a clause; empty if it can.
  [[nodiscard]] virtual std::string absence() const { return {}; }
  [[nodiscard]] virtual bool answers(const cases::Variant& variant) const = 0;
  /// Answers every case. Several threads may call it at once.
  /// @throws PartyFailure, whatever the implementation throws
  void answer(const cases::Variant& variant, const Cases& asked) const;

 private:
  /// Implements answer(). A program that faults is an answer, Ending::broken; a party that cannot
  /// run it throws.
  virtual void fill(const cases::Variant& variant, const Cases& asked) const = 0;
};

/// Returns the parties of this build, including the absent ones: model (compiled run), interpreter
/// (the same programs step by step), oracle (big integers), fast (the oracle's answers from
/// built-in integers), type (fixproof::number), batch (fixed/batch/batch.hpp), its paths
/// batch-portable, batch-neon, batch-avx2 and batch-avx512, silicon (the listings as machine code
/// on this processor), and unicorn (the same code on an emulator).
const std::vector<std::unique_ptr<Party>>& parties();

/// Returns the party of that name, or that of a function of a shared library (library.hpp).
/// @throws std::invalid_argument for an absent (with the reason) or unknown party (with the names)
const Party& party_named(std::string_view name);

}  // namespace fixproof::parties
