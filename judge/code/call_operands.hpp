/// @file
/// The operands and results of a call: their values, and their places behind pointers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "judge/code/image.hpp"
#include "judge/code/parameter.hpp"
#include "verify/cases/draw.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::judge {

/// The operands and results of one operation as a routine of an image has them.
class CallOperands {
 public:
  /// The signature must have room: see expect_room().
  CallOperands(const Image& image, const Signature& signature, const cases::Variant& variant);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// Returns what a parameter is in a call, extended to 64 bits by the signedness of the parameter.
  [[nodiscard]] std::uint64_t value(std::size_t parameter,
                                    std::span<const std::uint32_t> words) const;
  /// Returns where the pointer of a parameter points to, as an offset in the data segment.
  [[nodiscard]] std::uint32_t place(std::size_t parameter) const { return places_[parameter]; }
  [[nodiscard]] bool has_results_behind_pointers() const;

  /// Puts operands behind their pointers, and noise where the results will be.
  void put(std::uint8_t* memory, std::span<const std::uint32_t> words, cases::Draw& draw) const;
  /// Reads the results behind pointers.
  void take(const std::uint8_t* memory, std::span<std::uint32_t> words) const;

  /// Stores a result as the words of an answer. Only the integer that stores a word counts. If its
  /// upper bits are no copies of the sign, they are kept, so that the answer is no word.
  void give(std::uint64_t result, std::span<std::uint32_t> words) const;

 private:
  [[nodiscard]] std::size_t index_of(std::size_t parameter, std::size_t number) const;
  /// Returns an operand of a case, extended to 64 bits by its format.
  [[nodiscard]] std::uint64_t operand(std::size_t number,
                                      std::span<const std::uint32_t> words) const;

  const Image& image_;
  std::vector<Parameter> parameters_;
  cases::Variant variant_;
  std::vector<std::size_t> first_operands_{};  ///< of each parameter, in those of a case
  std::vector<std::uint32_t> places_{};
};

/// Returns the signature that a routine has unless its caller says otherwise: operands in the
/// integers that store them, then results behind pointers if there are several.
Signature signature_of(const cases::Variant& variant);

/// @throws support::UsageError if there is no room for what the pointers of a signature point to
void expect_room(const Signature& signature);

}  // namespace fixproof::judge
