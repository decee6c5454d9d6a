// Target `matrix`: 24 words, two transforms and their product under every build with a
// ConcatXforms. The first 15 words are also a transform and a point for every XformVec.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/finding.hpp"
#include "fuzz/panel.hpp"
#include "fuzz/word_target.hpp"
#include "fuzz/words.hpp"

using namespace fixproof;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto& variants = fuzz::parties_by_variant(fuzz::WordTarget::matrix);
  std::array<std::uint32_t, cases::max_words_in> words{};
  fuzz::read_words({data, size}, words);
  fuzz::report_if_any(fuzz::disagreement(variants, words));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t room, unsigned seed) {
  return fuzz::mutate_input(fuzz::WordTarget::matrix, {data, room}, size, seed);
}
