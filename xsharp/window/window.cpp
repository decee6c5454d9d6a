#include "xsharp/window/window.hpp"

#include <SDL2/SDL.h>

#include <algorithm>
#include <array>
#include <boost/noncopyable.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>

namespace xsharp {

namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error("cannot " + what + ": " + SDL_GetError());
}

/// Initialises SDL's video for its lifetime; SDL counts references.
class Video : private boost::noncopyable {
 public:
  Video() {
    // Keeps the program's signal handlers.
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) fail("open a window");
    if (is_invisible()) {
      SDL_QuitSubSystem(SDL_INIT_VIDEO);
      throw std::runtime_error("cannot open a window: no display, neither X11 nor Wayland");
    }
  }
  ~Video() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }

 private:
  /// Whether SDL fell back to a driver that draws into memory, without having been told to.
  static bool is_invisible() {
    return SDL_getenv("SDL_VIDEODRIVER") == nullptr &&
           std::string_view(SDL_GetCurrentVideoDriver()) == "offscreen";
  }
};

struct Destroy {
  void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
  void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
  void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};

template <class T>
std::unique_ptr<T, Destroy> made(T* thing, const char* what) {
  if (thing == nullptr) fail(what);
  return std::unique_ptr<T, Destroy>(thing);
}

/// The largest whole factor, at least 1, with which the page fits on the screen.
int initial_factor(std::int32_t width, std::int32_t height) {
  SDL_Rect usable{};
  if (SDL_GetDisplayUsableBounds(0, &usable) != 0) return 1;
  // Leaves a tenth for the window frame.
  return std::max(1, std::min(usable.w * 9 / 10 / width, usable.h * 9 / 10 / height));
}

std::optional<Key> key_of(SDL_Keycode code) {
  switch (code) {
    case SDLK_ESCAPE:
    case SDLK_q:
      return Key::quit;
    case SDLK_SPACE:
      return Key::pause;
    case SDLK_s:
    case SDLK_RIGHT:
      return Key::step;
    case SDLK_1:
    case SDLK_a:
      return Key::ambient;
    case SDLK_2:
      return Key::spot1;
    case SDLK_3:
      return Key::spot2;
    case SDLK_4:
      return Key::spot3;
    case SDLK_r:
      return Key::rounding;
    default:
      return std::nullopt;
  }
}

}  // namespace

class Window::Implementation {
 public:
  Implementation(const std::string& title, std::int32_t width, std::int32_t height)
      : width_(width), height_(height) {
    const int factor = initial_factor(width, height);
    window_ = made(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                    width * factor, height * factor, SDL_WINDOW_RESIZABLE),
                   "open a window");
    renderer_ = made(SDL_CreateRenderer(window_.get(), -1, 0), "draw in a window");
    if (SDL_RenderSetLogicalSize(renderer_.get(), width, height) != 0 ||
        SDL_RenderSetIntegerScale(renderer_.get(), SDL_TRUE) != 0) {
      fail("scale pages");
    }
    texture_ = made(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB888,
                                      SDL_TEXTUREACCESS_STREAMING, width, height),
                    "draw pages of this size");
    if (SDL_SetTextureScaleMode(texture_.get(), SDL_ScaleModeNearest) != 0) fail("scale pages");
  }

  void set_title(const std::string& title) { SDL_SetWindowTitle(window_.get(), title.c_str()); }

  void show(std::span<const std::uint32_t> pixels, std::int32_t width, std::int32_t height) {
    if (width != width_ || height != height_) {
      throw std::invalid_argument("a page of " + std::to_string(width) + " x " +
                                  std::to_string(height) + " pixels for a window of " +
                                  std::to_string(width_) + " x " + std::to_string(height_));
    }
    const int pitch = width * static_cast<int>(sizeof(std::uint32_t));
    if (SDL_UpdateTexture(texture_.get(), nullptr, pixels.data(), pitch) != 0) fail("show a page");
    present();
  }

  std::vector<Key> keys() {
    std::vector<Key> keys;
    SDL_Event event{};
    bool uncovered = false;
    while (SDL_PollEvent(&event) != 0) {
      if (event.type == SDL_QUIT) keys.push_back(Key::quit);
      if (event.type == SDL_WINDOWEVENT) uncovered = true;
      if (event.type != SDL_KEYDOWN) continue;
      const auto key = key_of(event.key.keysym.sym);
      // A held key must not toggle repeatedly.
      if (key && (event.key.repeat == 0 || key == Key::step)) keys.push_back(*key);
    }
    if (uncovered) present();
    return keys;
  }

 private:
  void present() {
    if (SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, SDL_ALPHA_OPAQUE) != 0 ||
        SDL_RenderClear(renderer_.get()) != 0 ||
        SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr) != 0) {
      fail("show a page");
    }
    SDL_RenderPresent(renderer_.get());
  }

  Video video_{};
  std::int32_t width_;
  std::int32_t height_;
  std::unique_ptr<SDL_Window, Destroy> window_;
  std::unique_ptr<SDL_Renderer, Destroy> renderer_;
  std::unique_ptr<SDL_Texture, Destroy> texture_;
};

bool window_available() { return true; }

Window::Window(const std::string& title, std::int32_t width, std::int32_t height)
    : implementation_(std::make_unique<Implementation>(title, width, height)) {}
Window::~Window() = default;

void Window::set_title(const std::string& title) { implementation_->set_title(title); }

void Window::show(const Page<std::uint32_t>& page) {
  implementation_->show(page.pixels(), page.width(), page.height());
}

void Window::show(const Page<std::uint8_t>& page, const Palette& palette) {
  std::array<std::uint32_t, 256> colors{};
  std::transform(palette.begin(), palette.end(), colors.begin(), rgb);
  Page<std::uint32_t> shown(page.width(), page.height());
  std::transform(page.pixels().begin(), page.pixels().end(), shown.pixels().begin(),
                 [&colors](std::uint8_t index) { return colors.at(index); });
  show(shown);
}

std::vector<Key> Window::keys() { return implementation_->keys(); }

}  // namespace xsharp
