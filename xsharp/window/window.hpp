/// @file
/// Pages in a window, and the keys pressed in it.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "xsharp/raster/page.hpp"
#include "xsharp/raster/palette.hpp"

namespace xsharp {

/// What can be asked for in a window.
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

/// Whether this build has windows: whether SDL2 was there. A window may still find no display.
bool window_available();

/// A window for pages of one size, enlarged by the largest whole factor that fits; every pixel of
/// the page is a square of one colour. To be used from one thread, the one that made it.
class Window : private boost::noncopyable {
 public:
  /// @throws std::runtime_error naming the cause: no SDL2 in this build, no display, no memory
  Window(const std::string& title, std::int32_t width, std::int32_t height);
  ~Window();

  /// @throws std::invalid_argument for a page of another size, std::runtime_error naming the cause
  void show(const Page<std::uint32_t>& page);
  void show(const Page<std::uint8_t>& page, const Palette& palette);

  void set_title(const std::string& title);

  /// What was asked for since the last call, in order. Also keeps the window alive: to be called
  /// many times a second, even while nothing new is shown.
  /// @throws std::runtime_error naming the cause
  std::vector<Key> keys();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace xsharp
