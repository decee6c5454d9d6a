/// @file
/// Comparison of stepped surfaces with exact ones.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "support/output_file.hpp"
#include "xsharp/picture.hpp"
#include "xsharp/raster/exact_filler.hpp"
#include "xsharp/raster/page.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::player {

/// Draws every picture twice from the same corners, in the scene's arithmetic and exactly, and
/// counts the pixels that differ.
class BesideExact {
 public:
  /// @param file the name of a PNG of the last picture: stepped, exact, and the differences
  /// @throws UsageError if the scene interpolates nothing or does not step
  /// @throws std::runtime_error naming the file, if it cannot be written or another run writes it
  BesideExact(const xsharp::Scene& scene, const std::string& file);

  void show(const xsharp::Picture& picture);
  /// Writes the file, if there are pictures.
  void finish();
  /// `3 of 230,400 pixels differ, …`; empty without pictures.
  [[nodiscard]] std::string differences() const;

 private:
  [[nodiscard]] std::string png() const;

  xsharp::PaletteKind palette_;
  support::OutputFile file_;
  std::unique_ptr<xsharp::SurfaceFiller> stepper_;
  xsharp::ExactFiller exact_filler_;
  std::uint8_t background_;
  xsharp::Page<std::uint8_t> stepped_;
  xsharp::Page<std::uint8_t> exact_;
  std::uint64_t pictures_ = 0;
  std::uint64_t differing_ = 0;
  int max_difference_ = 0;
};

}  // namespace fixproof::player
