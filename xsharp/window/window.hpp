/// @file
/// Shows pages in a window and reads its keys.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "xsharp/raster/page.hpp"
#include "xsharp/raster/palette.hpp"

namespace xsharp {

/// The requests that keys stand for.
enum class Key {
  quit,      ///< Escape, q, or the window was closed
  pause,     ///< space
  step,      ///< s or the right arrow; held down it repeats
  ambient,   ///< 1 or a
  spot1,     ///< 2
  spot2,     ///< 3
  spot3,     ///< 4
  rounding,  ///< r
};

/// Whether this build has SDL2. A window may still find no display.
bool window_available();

/// A window for pages of one size, enlarged by the largest whole factor that fits; every pixel of
/// the page is a square of one colour. Use it only from the thread that made it.
class Window : private boost::noncopyable {
 public:
  /// @throws std::runtime_error with the cause: no SDL2 in this build, no display, no memory
  Window(const std::string& title, std::int32_t width, std::int32_t height);
  ~Window();

  /// @throws std::invalid_argument for a page of another size, std::runtime_error with the cause
  void show(const Page<std::uint32_t>& page);
  void show(const Page<std::uint8_t>& page, const Palette& palette);

  void set_title(const std::string& title);

  /// The requests since the last call, in order. Also processes window events, so call it many
  /// times per second, even if nothing new is shown.
  /// @throws std::runtime_error with the cause
  std::vector<Key> keys();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace xsharp
