/// @file
/// A fast digest of the answers of one chunk. It finds changed answers, but resists no forger.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fixproof::verify {

/// Every step is a bijection of the lane for a given number, and of the number for a given lane, so
/// that a change of one number always changes the digest. Four lanes hide the multiply's latency.
class AnswerDigest {
 public:
  /// Adds small numbers, as many to 64 bits as fit.
  template <class Small>
  void add(std::span<const Small> values) {
    constexpr std::size_t in_one = sizeof(std::uint64_t) / sizeof(Small);
    std::size_t i = 0;
    for (; i + in_one * lanes_.size() <= values.size(); i += in_one * lanes_.size()) {
      for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
        // By value, because memory differs between processors.
        std::uint64_t number = 0;
        for (std::size_t k = 0; k < in_one; ++k) {
          number |= static_cast<std::uint64_t>(values[i + lane * in_one + k])
                    << (8 * sizeof(Small) * k);
        }
        mix(lanes_[lane], number);
      }
    }
    for (; i < values.size(); ++i) {
      mix(lanes_[i % lanes_.size()], static_cast<std::uint64_t>(values[i]));
    }
  }

  [[nodiscard]] std::uint64_t value() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t lane : lanes_) mix(sum, lane);
    return sum;
  }

 private:
  static void mix(std::uint64_t& lane, std::uint64_t number) {
    lane = (lane ^ number) * 0x9E3779B97F4A7C15U;  // odd: 2^64 divided by the golden ratio
    lane ^= lane >> 32U;
  }

  std::array<std::uint64_t, 4> lanes_{1, 2, 3, 4};
};

}  // namespace fixproof::verify
