#include "measure/player/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <thread>

#include "measure/player/canvas.hpp"
#include "measure/player/players.hpp"
#include "support/interrupt.hpp"
#include "support/usage_error.hpp"

namespace fixproof::player {

namespace {

using xsharp::Key;

class Show {
 public:
  Show(const xsharp::Scene& scene, bool true_color, std::size_t threads)
      : scene_(scene),
        true_color_(true_color),
        threads_(threads),
        window_(title(), scene.width, scene.height),
        canvas_(make_canvas(scene, true_color)),
        player_(make_player(scene, scene.arithmetic, threads)) {}

  void play() {
    using clock = std::chrono::steady_clock;
    const auto frame_time = std::chrono::duration_cast<clock::duration>(
        std::chrono::duration<double>(1 / scene_.frames_per_second));
    auto next = clock::now();
    draw();
    while (!ended_ && !support::Interrupt::flag()) {
      for (const Key key : window_.keys()) press(key);
      if (!paused_ && clock::now() >= next) {
        step();
        // A slow machine delays frames but drops none.
        next = std::max(next + frame_time, clock::now());
      }
      constexpr clock::duration longest = std::chrono::milliseconds(5);
      std::this_thread::sleep_for(
          paused_ ? longest : std::clamp(next - clock::now(), clock::duration(0), longest));
    }
  }

 private:
  [[nodiscard]] std::string title() const {
    return fmt::format("{} - {}", scene_.name, name_of(scene_.arithmetic));
  }

  void press(Key key) {
    switch (key) {
      case Key::quit:
        ended_ = true;
        return;
      case Key::pause:
        paused_ = !paused_;
        return;
      case Key::step:
        paused_ = true;
        step();
        return;
      case Key::rounding:
        switch_rounding();
        break;
      case Key::ambient:
      case Key::spot1:
      case Key::spot2:
      case Key::spot3:
        switch_light(static_cast<std::size_t>(key) - static_cast<std::size_t>(Key::ambient));
        break;
    }
    draw();
  }

  void switch_light(std::size_t light) {
    player_->switch_light(light);
    switched_.push_back(light);
  }

  /// Replays the scene with the other rounding, to show the errors that accumulate.
  void switch_rounding() {
    xsharp::ArithmeticChoice& choice = scene_.arithmetic;
    if (choice.by == "double" || !xsharp::is_listing(choice)) return;
    choice.mul_round = !choice.mul_round;
    player_ = make_player(scene_, choice, threads_);
    canvas_ = make_canvas(scene_, true_color_);
    for (std::uint64_t i = 0; i < moves_ && !support::Interrupt::flag(); ++i) player_->move();
    for (const std::size_t light : switched_) player_->switch_light(light);
    window_.set_title(title());
  }

  void step() {
    player_->move();
    ++moves_;
    draw();
  }

  void draw() {
    player_->draw(picture_);
    canvas_->show(picture_);
    canvas_->show_in(window_);
  }

  xsharp::Scene scene_;
  bool true_color_;
  std::size_t threads_;
  xsharp::Window window_;
  std::unique_ptr<Canvas> canvas_;
  std::unique_ptr<xsharp::Player> player_;
  xsharp::Picture picture_;
  std::vector<std::size_t> switched_;
  std::uint64_t moves_ = 0;
  bool paused_ = false;
  bool ended_ = false;
};

}  // namespace

int show_scene(const xsharp::Scene& scene, bool true_color, std::size_t threads) {
  if (!xsharp::window_available())
    throw support::UsageError("--show needs SDL2; install it and build again, or use --animate");
  const support::Interrupt interrupt;
  Show(scene, true_color, threads).play();
  return support::Interrupt::flag() ? support::interrupted_status : 0;
}

}  // namespace fixproof::player
