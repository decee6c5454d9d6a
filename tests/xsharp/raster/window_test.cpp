#include "xsharp/window/window.hpp"

#include <SDL2/SDL.h>

#include <filesystem>

#include "tests/support/test.hpp"

namespace xsharp {
namespace {

/// Uses SDL's dummy driver, which needs no display.
class AWindow : public testing::Test {
 protected:
  void SetUp() override { ::setenv("SDL_VIDEODRIVER", "dummy", 1); }
};

void press(SDL_Keycode code, bool again = false) {
  SDL_Event event{};
  event.type = SDL_KEYDOWN;
  event.key.keysym.sym = code;
  event.key.repeat = again ? 1 : 0;
  SDL_PushEvent(&event);
}

TEST_F(AWindow, IsAvailable) { EXPECT_TRUE(window_available()); }

TEST_F(AWindow, ShowsPagesOfItsSize) {
  Window window("test", 32, 24);
  EXPECT_NO_THROW(window.show(Page<std::uint32_t>(32, 24)));
  EXPECT_NO_THROW(window.show(Page<std::uint8_t>(32, 24), palette_of(PaletteKind::vga)));
  EXPECT_THROW(window.show(Page<std::uint32_t>(24, 32)), std::invalid_argument);
  EXPECT_THROW(window.show(Page<std::uint8_t>(1, 1), palette_of(PaletteKind::vga)),
               std::invalid_argument);
}

TEST_F(AWindow, TellsTheKeysThatWerePressed) {
  Window window("test", 32, 24);
  (void)window.keys();
  EXPECT_EQ(window.keys(), std::vector<Key>{});
  for (const SDL_Keycode code : {SDLK_ESCAPE, SDLK_q, SDLK_SPACE, SDLK_s, SDLK_RIGHT, SDLK_1,
                                 SDLK_a, SDLK_2, SDLK_3, SDLK_4, SDLK_r, SDLK_F5, SDLK_z}) {
    press(code);
  }
  EXPECT_EQ(window.keys(),
            (std::vector<Key>{Key::quit, Key::quit, Key::pause, Key::step, Key::step, Key::ambient,
                              Key::ambient, Key::spot1, Key::spot2, Key::spot3, Key::rounding}));
  EXPECT_EQ(window.keys(), std::vector<Key>{});
}

TEST_F(AWindow, OnlyStepRepeatsWhileItIsHeldDown) {
  Window window("test", 32, 24);
  (void)window.keys();
  for (const SDL_Keycode code : {SDLK_SPACE, SDLK_r, SDLK_1, SDLK_s, SDLK_RIGHT}) press(code, true);
  EXPECT_EQ(window.keys(), (std::vector<Key>{Key::step, Key::step}));
}

TEST_F(AWindow, ClosingItIsToQuit) {
  Window window("test", 32, 24);
  (void)window.keys();
  SDL_Event event{};
  event.type = SDL_QUIT;
  SDL_PushEvent(&event);
  EXPECT_EQ(window.keys(), std::vector<Key>{Key::quit});
}

TEST_F(AWindow, CanBeOpenedAgain) {
  { const Window window("test", 320, 240); }
  EXPECT_NO_THROW(Window("test", 1, 1));
}

std::string refusal() {
  try {
    const Window window("test", 32, 24);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "opened";
}

TEST_F(AWindow, TheDriverThatIsMissingIsNamed) {
  ::setenv("SDL_VIDEODRIVER", "nosuch", 1);
  EXPECT_EQ(refusal(), "cannot open a window: nosuch not available");
}

TEST_F(AWindow, WithoutADisplayThereIsNone) {
  if (std::filesystem::exists("/dev/dri")) GTEST_SKIP() << "SDL may take the console";
  for (const char* name : {"SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR"}) {
    ::unsetenv(name);
  }
  EXPECT_EQ(refusal(), "cannot open a window: no display, neither X11 nor Wayland");
}

}  // namespace
}  // namespace xsharp
