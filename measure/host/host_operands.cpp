// Operands for which every contender has a result.
#include <array>
#include <cmath>

#include "measure/host/host_contenders.hpp"
#include "verify/cases/draw.hpp"
#include "xsharp/rotation.hpp"

namespace fixproof::measure {

namespace {

/// Keys of the random streams, one for each operation.
enum class HostDraw : std::uint64_t { products = 1, quotients, roots, cosines, vertices, chains };

std::uint32_t as_word(std::int64_t units) { return static_cast<std::uint32_t>(units); }

/// A uniform signed number of `bits` bits.
std::int64_t signed_draw(cases::Draw& draw, unsigned bits) {
  const auto top = static_cast<std::int64_t>(draw.bits());
  return top >> (64 - bits);
}

/// The words that make(draw) returns for draws 0, `step`, ... below `end`.
template <class Make>
std::vector<std::uint32_t> drawn(HostDraw what, std::uint64_t seed, std::size_t end,
                                 std::size_t step, Make make) {
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < end; i += step) {
    cases::Draw draw(cases::mix(seed) + static_cast<std::uint64_t>(what), i);
    for (const std::int64_t units : make(draw)) words.push_back(as_word(units));
  }
  return words;
}

using One = std::array<std::int64_t, 1>;
using Two = std::array<std::int64_t, 2>;

}  // namespace

HostOperands product_operands(std::uint64_t seed, std::size_t blocks) {
  const auto factors = [](cases::Draw& draw) {
    return Two{signed_draw(draw, 24), signed_draw(draw, 24)};
  };
  // A factor from 1 to 2 and its inverse keep the chain in range.
  const auto there_and_back = [](cases::Draw& draw) {
    const double factor = 1 + static_cast<double>(draw.below(1U << 16U)) / 65536;
    return Two{draw.either_sign(std::llround(factor * 65536)),
               draw.either_sign(std::llround(65536 / factor))};
  };
  return {2 * host_block, drawn(HostDraw::products, seed, blocks * host_block, 1, factors),
          0x00645C29, drawn(HostDraw::chains, seed, host_block, 2, there_and_back)};
}

HostOperands quotient_operands(std::uint64_t seed, std::size_t blocks) {
  constexpr std::int64_t one = 65536;
  const auto dividend_and_divisor = [](cases::Draw& draw) {
    Two both{signed_draw(draw, 28), 0};
    while (both[1] > -one && both[1] < one) both[1] = signed_draw(draw, 28);
    return both;
  };
  const auto numerators = [](cases::Draw& draw) {
    const auto numerator = 15'000 * one + static_cast<std::int64_t>(draw.below(15'000 * one));
    return Two{draw.either_sign(numerator), draw.either_sign(numerator)};
  };
  // A longer chain would drift, because dividing by whole parts restores a quotient only nearly.
  return {2 * host_block,
          drawn(HostDraw::quotients, seed, blocks * host_block, 1, dividend_and_divisor),
          0x00969E38, drawn(HostDraw::chains, seed, 256, 2, numerators)};
}

HostOperands root_operands(std::uint64_t seed, std::size_t blocks) {
  const auto uniform = [](int bits) {
    return [bits](cases::Draw& draw) {
      return One{static_cast<std::int64_t>(draw.bits() >> (64 - bits))};
    };
  };
  // One bit less leaves room to add a root.
  return {host_block, drawn(HostDraw::roots, seed, blocks * host_block, 1, uniform(31)), 0x00645C29,
          drawn(HostDraw::chains, seed, host_block, 1, uniform(30))};
}

HostOperands cosine_operands(std::uint64_t seed, std::size_t blocks) {
  const auto angle = [](cases::Draw& draw) {
    return One{static_cast<std::int64_t>(draw.below(3600))};
  };
  return {host_block, drawn(HostDraw::cosines, seed, blocks * host_block, 1, angle), 0, {}};
}

HostOperands vertex_operands(std::uint64_t seed, std::size_t blocks) {
  using N = fixproof::q16_16;
  using xsharp::Axis;
  const auto vertices = [](cases::Draw& draw) {
    std::vector<std::int64_t> all;
    auto transform = xsharp::identity<N>();
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      const auto tenths = static_cast<std::int32_t>(draw.below(3600));
      xsharp::append_rotation(transform, axis, xsharp::Arithmetic<N>::turn(tenths));
    }
    for (auto& row : transform.rows) {
      row[3] = N::from_raw(static_cast<std::int32_t>(signed_draw(draw, 25)));
    }
    for (std::size_t i = 0; i < host_vertices; ++i) {
      for (const auto& row : transform.rows) {
        for (const N x : row) all.push_back(x.raw());
      }
      for (std::size_t k = 0; k < 3; ++k) all.push_back(signed_draw(draw, 24));
    }
    return all;
  };
  return {15 * host_vertices, drawn(HostDraw::vertices, seed, blocks, 1, vertices), 0, {}};
}

}  // namespace fixproof::measure
