#include "verify/shrink.hpp"

#include <bit>
#include <tuple>

namespace fixproof::verify {

namespace {

/// A word as sign and magnitude, because that is how people read it.
struct Signed {
  bool negative;
  std::uint32_t magnitude;
};

class Words {
 public:
  explicit Words(int bits) : mask_(~std::uint32_t{0} >> (32 - bits)), sign_(mask_ ^ mask_ >> 1U) {}

  [[nodiscard]] Signed split(std::uint32_t word) const {
    const bool negative = (word & sign_) != 0;
    return {negative, negative ? -word & mask_ : word};
  }
  [[nodiscard]] std::uint32_t join(Signed s) const {
    return (s.negative ? -s.magnitude : s.magnitude) & mask_;
  }
  /// Returns whether `a` is simpler than `b`. The order is strict, so shrinking terminates.
  [[nodiscard]] bool simpler(std::uint32_t a, std::uint32_t b) const {
    const auto rank = [&](std::uint32_t word) {
      const Signed s = split(word);
      return std::tuple(std::popcount(s.magnitude), s.negative, s.magnitude);
    };
    return rank(a) < rank(b);
  }

  /// Replacements to try for a word, the simplest first.
  [[nodiscard]] std::vector<std::uint32_t> simplifications(std::uint32_t word) const {
    const Signed from = split(word);
    std::vector<std::uint32_t> tries{0, from.magnitude & mask_};
    for (const bool negative : {false, true}) {
      for (std::uint32_t bit = 1; bit != 0 && bit <= mask_; bit <<= 1U) {
        tries.push_back(join({negative, bit}));
      }
    }
    for (std::uint32_t bit = sign_; bit != 0; bit >>= 1U) {
      if ((from.magnitude & bit) != 0) {
        tries.push_back(join({from.negative, from.magnitude & ~bit}));
      }
    }
    tries.push_back(join({from.negative, from.magnitude >> 1U}));
    return tries;
  }

 private:
  std::uint32_t mask_;
  std::uint32_t sign_;
};

}  // namespace

std::vector<std::uint32_t> shrink(
    std::vector<std::uint32_t> words, int word_bits,
    const std::function<bool(std::span<const std::uint32_t>)>& fails) {
  const Words format(word_bits);
  const auto simplify = [&](std::uint32_t& word) {
    const std::uint32_t before = word;
    for (const std::uint32_t simple : format.simplifications(before)) {
      if (!format.simpler(simple, before)) continue;
      word = simple;
      if (fails(words)) return true;
    }
    word = before;
    return false;
  };
  for (bool simplified = true; simplified;) {
    simplified = false;
    for (auto& word : words) {
      while (simplify(word)) simplified = true;
    }
  }
  return words;
}

}  // namespace fixproof::verify
