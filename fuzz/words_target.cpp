// The targets with word inputs; FIXPROOF_TARGET is one of them.
// `multiply` and `divide`: two words, under every build of FIXED.ASM and under the type's standard
// rules, also at half width; `divide` then takes the type under other policies, and the oracle
// judges. `matrix`: 24 words, two transforms and their product under every build with a
// ConcatXforms; the first 15 are also a transform and a point for every XformVec. `agreement`: a
// byte that chooses the variant, then its operands, for every fast party, including the host
// processor if it can run; the first words are operands of the type's other operations.
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
using enum fuzz::WordTarget;

constexpr fuzz::WordTarget target = FIXPROOF_TARGET;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto& variants = fuzz::parties_by_variant(target);
  std::array<std::uint32_t, cases::max_words_in> words{};
  if constexpr (target == agreement) {
    if (size == 0) return 0;
    fuzz::read_words(std::span(data, size).subspan(1), words);
    fuzz::report_if_any(fuzz::disagreement(variants[data[0] % variants.size()], words));
    fuzz::report_if_any(fuzz::type_difference(std::span(words).first<3>()));
  } else {
    const auto used = std::span(words).first(fuzz::input_size(target) / fuzz::bytes_of_word);
    fuzz::read_words({data, size}, used);
    fuzz::report_if_any(fuzz::disagreement(variants, used));
    if (target == divide) fuzz::report_if_any(fuzz::quotient_difference(words[0], words[1]));
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t room, unsigned seed) {
  return fuzz::mutate_input(target, {data, room}, size, seed);
}
