// Operands for which every contender has a result.
#include <cmath>

#include "cases/draw.hpp"
#include "measure/host/host_contenders.hpp"
#include "xsharp/rotation.hpp"

namespace fixproof::measure {

namespace {

/// Keys of the random streams, one for each operation.
enum class HostDraw : std::uint64_t { products = 1, quotients, roots, cosines, vertices, chains };

cases::Draw host_draw(HostDraw what, std::uint64_t seed, std::uint64_t i) {
  return {cases::mix(seed) + static_cast<std::uint64_t>(what), i};
}

std::uint32_t as_word(std::int64_t units) { return static_cast<std::uint32_t>(units); }

/// A uniform signed number of `bits` bits.
std::int64_t signed_draw(cases::Draw& draw, unsigned bits) {
  const auto top = static_cast<std::int64_t>(draw.bits());
  return top >> (64 - bits);
}

}  // namespace

HostOperands product_operands(std::uint64_t seed, std::size_t blocks) {
  HostOperands o{2 * host_block, {}, 0x00645C29, {}};
  for (std::size_t i = 0; i < blocks * host_block; ++i) {
    cases::Draw draw = host_draw(HostDraw::products, seed, i);
    o.words.push_back(as_word(signed_draw(draw, 24)));
    o.words.push_back(as_word(signed_draw(draw, 24)));
  }
  for (std::size_t i = 0; i < host_block; i += 2) {
    cases::Draw draw = host_draw(HostDraw::chains, seed, i);
    // A factor from 1 to 2 and its inverse keep the chain in range.
    const double factor = 1 + static_cast<double>(draw.below(1U << 16U)) / 65536;
    const std::int64_t back = std::llround(65536 / factor);
    o.taken.push_back(as_word(draw.either_sign(std::llround(factor * 65536))));
    o.taken.push_back(as_word(draw.either_sign(back)));
  }
  return o;
}

HostOperands quotient_operands(std::uint64_t seed, std::size_t blocks) {
  constexpr std::int64_t one = 65536;
  HostOperands o{2 * host_block, {}, 0x00969E38, {}};
  for (std::size_t i = 0; i < blocks * host_block; ++i) {
    cases::Draw draw = host_draw(HostDraw::quotients, seed, i);
    o.words.push_back(as_word(signed_draw(draw, 28)));
    std::int64_t divisor = 0;
    while (divisor > -one && divisor < one) divisor = signed_draw(draw, 28);
    o.words.push_back(as_word(divisor));
  }
  // A longer chain would drift, because dividing by whole parts restores a quotient only nearly.
  for (std::size_t i = 0; i < 256; i += 2) {
    cases::Draw draw = host_draw(HostDraw::chains, seed, i);
    const std::int64_t numerator =
        15'000 * one + static_cast<std::int64_t>(draw.below(15'000 * one));
    o.taken.push_back(as_word(draw.either_sign(numerator)));
    o.taken.push_back(as_word(draw.either_sign(numerator)));
  }
  return o;
}

HostOperands root_operands(std::uint64_t seed, std::size_t blocks) {
  HostOperands o{host_block, {}, 0x00645C29, {}};
  for (std::size_t i = 0; i < blocks * host_block; ++i) {
    cases::Draw draw = host_draw(HostDraw::roots, seed, i);
    o.words.push_back(static_cast<std::uint32_t>(draw.bits() >> 33U));
  }
  for (std::size_t i = 0; i < host_block; ++i) {
    cases::Draw draw = host_draw(HostDraw::chains, seed, i);
    // One bit less leaves room to add a root.
    o.taken.push_back(static_cast<std::uint32_t>(draw.bits() >> 34U));
  }
  return o;
}

HostOperands cosine_operands(std::uint64_t seed, std::size_t blocks) {
  HostOperands o{host_block, {}, 0, {}};
  for (std::size_t i = 0; i < blocks * host_block; ++i) {
    cases::Draw draw = host_draw(HostDraw::cosines, seed, i);
    o.words.push_back(static_cast<std::uint32_t>(draw.below(3600)));
  }
  return o;
}

HostOperands vertex_operands(std::uint64_t seed, std::size_t blocks) {
  using N = fixed::q16_16;
  using xsharp::Axis;
  HostOperands o{15 * host_vertices, {}, 0, {}};
  for (std::size_t block = 0; block < blocks; ++block) {
    cases::Draw turns = host_draw(HostDraw::vertices, seed, block);
    auto transform = xsharp::identity<N>();
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      const auto tenths = static_cast<std::int32_t>(turns.below(3600));
      xsharp::append_rotation(transform, axis, xsharp::Arithmetic<N>::turn(tenths));
    }
    for (auto& row : transform.rows) {
      row[3] = N::from_raw(static_cast<std::int32_t>(signed_draw(turns, 25)));
    }
    for (std::size_t i = 0; i < host_vertices; ++i) {
      for (const auto& row : transform.rows) {
        for (const N x : row) o.words.push_back(as_word(x.raw()));
      }
      for (std::size_t k = 0; k < 3; ++k) o.words.push_back(as_word(signed_draw(turns, 24)));
    }
  }
  return o;
}

}  // namespace fixproof::measure
