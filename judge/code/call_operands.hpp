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
  CallOperands(const Image& image, const cases::Variant& variant);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// Returns a number of a case, extended to 64 bits by its signedness.
  [[nodiscard]] std::uint64_t value(std::size_t parameter,
                                    std::span<const std::uint32_t> words) const;
  /// Returns where the pointer of a parameter points to, as an offset in the data segment.
  [[nodiscard]] std::uint32_t place(std::size_t parameter) const { return places_[parameter]; }
  [[nodiscard]] bool has_results_behind_pointers() const;

  /// Puts operands behind their pointers, and noise where the results will be.
  void put(std::uint8_t* memory, std::span<const std::uint32_t> words, cases::Draw& draw) const;
  /// Reads the results behind pointers.
  void take(const std::uint8_t* memory, std::span<std::uint32_t> words) const;

 private:
  [[nodiscard]] std::size_t index_of(std::size_t parameter, std::size_t number) const;

  const Image& image_;
  std::vector<Parameter> parameters_;
  std::vector<std::size_t> first_words_{};  ///< of each parameter, in the words of a case
  std::vector<std::uint32_t> places_{};
};

/// Returns the parameters of a routine that computes an operation: its operands, then its results
/// behind pointers. A result that is not a parameter is the return value.
std::vector<Parameter> parameters_of(const cases::Variant& variant);
/// Returns the bits of the value that such a routine returns; 0 if its results are parameters.
int bits_of_returned(const cases::Variant& variant);

}  // namespace fixproof::judge
