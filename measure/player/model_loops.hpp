/// @file
/// The inner loops of the listings, run instruction by instruction on the model.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "x86model/loop.hpp"
#include "xsharp/raster/span_loops.hpp"

namespace fixproof::player {

/// Runs a listing of x86model/loops/ for each call. Rows begin at an even address.
///
///   gouraud   by words, an odd last pixel by bytes
///   depth     the depth test with SHLD
///   texture   unrolled: a bitmap of 256 rows fills its segment, which leaves no room for IncJ
///
/// gouraud_wide has no listing and uses xsharp::PlainLoops.
class ModelLoops final : public xsharp::SpanLoops {
 public:
  /// @param counting the loop counting of Gouraud shading. The depth test has no unrolled form and
  ///   counts by LOOP in its place.
  explicit ModelLoops(x86model::Counting counting = x86model::Counting::loop,
                      x86model::Target target = x86model::Target::i386);

  void gouraud(std::span<std::uint8_t> out, std::uint16_t start, std::uint16_t step) const override;
  void gouraud_wide(std::span<std::uint8_t> out, std::uint32_t start,
                    std::uint32_t step) const override;
  /// Runs on the 386 for every target, because the listing has no 8088 form.
  void depth(std::span<std::uint8_t> out, std::span<std::int16_t> buffer, std::uint8_t pixel,
             std::uint32_t start, std::uint32_t step) const override;
  void texture(std::span<std::uint8_t> out, std::span<const std::uint8_t> bitmap, std::uint32_t u,
               std::uint32_t du, std::uint32_t v, std::uint32_t dv) const override;

 private:
  struct Ready {
    explicit Ready(const x86model::LoopForm& f) : form(f), code(x86model::code_of(f)) {}
    x86model::LoopForm form;
    std::vector<x86model::Instruction> code;
  };

  Ready bytes_;
  Ready words_;
  Ready depth_;
  Ready texture_;
};

}  // namespace fixproof::player
