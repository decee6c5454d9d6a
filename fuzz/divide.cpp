// Target `divide`: two words, n / d under every build of FIXED.ASM and under the type's standard
// rules, also at half width; then the type under other policies. The oracle judges.
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
  static const auto& variants = fuzz::parties_by_variant(fuzz::WordTarget::divide);
  std::array<std::uint32_t, 2> words{};
  fuzz::read_words({data, size}, words);
  fuzz::report_if_any(fuzz::disagreement(variants, words));
  fuzz::report_if_any(fuzz::quotient_difference(words[0], words[1]));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t room, unsigned seed) {
  return fuzz::mutate_input(fuzz::WordTarget::divide, {data, room}, size, seed);
}
