// Target `agreement`: a byte that chooses the variant, then its operands. Compares every fast
// party, including the host processor if it can run, and the type's other operations on the first
// words.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/finding.hpp"
#include "fuzz/panel.hpp"
#include "fuzz/type_rules.hpp"
#include "fuzz/word_target.hpp"
#include "fuzz/words.hpp"

using namespace fixproof;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto& variants = fuzz::parties_by_variant(fuzz::WordTarget::agreement);
  if (size == 0) return 0;
  std::array<std::uint32_t, cases::max_words_in> words{};
  fuzz::read_words(std::span(data, size).subspan(1), words);
  fuzz::report_if_any(fuzz::disagreement(variants[data[0] % variants.size()], words));
  fuzz::report_if_any(fuzz::type_difference(std::span(words).first<3>()));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t room, unsigned seed) {
  return fuzz::mutate_input(fuzz::WordTarget::agreement, {data, room}, size, seed);
}
