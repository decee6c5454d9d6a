#include "xsharp/window/window.hpp"

#include <SDL2/SDL.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace xsharp {
namespace {

/// SDL's driver without a display.
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

TEST_F(AWindow, WithoutADisplayTheCauseIsNamed) {
  ::setenv("SDL_VIDEODRIVER", "no such driver", 1);
  try {
    const Window window("test", 32, 24);
    ADD_FAILURE() << "opened";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("cannot open a window: ")) << error.what();
    EXPECT_NE(std::string(error.what()).find("no such driver"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace xsharp
