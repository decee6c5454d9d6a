/// @file
/// Who answers: a party is asked a batch of cases of one variant.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/variant.hpp"

namespace fixproof::parties {

/// How a case ended.
enum class Ending : std::uint8_t {
  value,           ///< the result words hold the answer
  divide_error,    ///< #DE
  undefined_flag,  ///< the program read a flag that Intel leaves undefined
  broken,          ///< the program left its memory or did not end
};

/// Cases to answer and room for the answers. Words are two's complement bits, zero-extended; result
/// words of a case that did not end in a value are unspecified.
struct Batch {
  std::span<const std::uint32_t> in;  ///< cases * words_in(operation)
  std::span<std::uint32_t> out;       ///< cases * words_out(operation)
  std::span<Ending> endings;          ///< one for each case
};

class Party : private boost::noncopyable {
 public:
  virtual ~Party() = default;

  /// One lower-case word, as on the command line.
  [[nodiscard]] virtual std::string_view name() const = 0;
  /// Why this party cannot answer anything here, in a clause; empty where it can.
  [[nodiscard]] virtual std::string absence() const { return {}; }
  /// Whether this party has anything to say about a variant.
  [[nodiscard]] virtual bool answers(const cases::Variant& variant) const = 0;
  /// Answers every case of the batch. Called from several threads at once.
  virtual void answer(const cases::Variant& variant, const Batch& batch) const = 0;
};

/// The parties of this build: model (compiled run), interpreter (the same programs step by step),
/// oracle (big integers), fast (the oracle's answers from built-in integers), type (fixed::number),
/// batch (fixed/batch.hpp) and batch-portable, batch-neon, batch-avx2, batch-avx512 (its paths),
/// silicon (the listings as machine code on this processor), unicorn (the same code on
/// an emulator); the absent ones too.
const std::vector<std::unique_ptr<Party>>& parties();

/// The party of that name; throws std::invalid_argument for an absent one, saying why, and for any
/// other name, naming those there are.
const Party& party_named(std::string_view name);

}  // namespace fixproof::parties
