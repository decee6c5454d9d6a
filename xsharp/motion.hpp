/// @file
/// The rotation and movement of an object from frame to frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "xsharp/arithmetic.hpp"
#include "xsharp/look_at.hpp"
#include "xsharp/rotation.hpp"
#include "xsharp/scene.hpp"

namespace xsharp {

/// How a scene computes rotations.
struct RotationStyle {
  Trigonometry trigonometry = Trigonometry::table;
  Conversion conversion = Conversion::published;
  bool from_scratch = false;
  std::int32_t restore_every = 0;
  RestoredRows restore_rows = RestoredRows::all;
};

/// The position and orientation of an object in the world, and their changes.
template <Scalar N>
class Motion {
 public:
  Motion(const ObjectDescription& object, const RotationStyle& style)
      : style_(style),
        spin_(object.spin),
        drift_(object.drift),
        orbit_(object.orbit),
        to_world_(identity<N>()),
        page_(object.page),
        look_at_page_(object.page) {
    for (std::size_t i = 0; i < 3; ++i)
      place(i) = coordinate<N>(object.position[i], style.conversion);
    if (style.trigonometry == Trigonometry::floating) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        floating_turns_[axis] = turn_about(axis);
      }
    }
    rotation_count_ = spin_.delay.first;
    if (orbit_) drift_.reset();
    if (drift_) {
      for (std::size_t i = 0; i < 3; ++i) {
        step_[i] = coordinate<N>(drift_->step[i], style.conversion);
        // From the end of a page, a step of one page would leave 16.16.
        turn_page(i);
      }
      move_count_ = drift_->delay.first;
    }
    if (orbit_) {
      orbit_angle_ = orbit_->start_tenths;
      orbit_tilt_ = Arithmetic<N>::turn(orbit_->tilt_tenths);
      orbit_radius_ = coordinate<N>(orbit_->radius, style.conversion);
      put_on_orbit();
    }
    if (object.look_at) {
      look_at_.emplace();
      for (std::size_t i = 0; i < 3; ++i) {
        (*look_at_)[i] = coordinate<N>((*object.look_at)[i], style.conversion);
      }
      face_point();
    }
  }

  /// The transform to world space; its translation is the position within the page.
  [[nodiscard]] const Transform<N>& to_world() const { return to_world_; }
  [[nodiscard]] const std::array<std::int32_t, 3>& page() const { return page_; }

  /// Advances one frame: rotates if the delay is over, then moves, then faces its point.
  /// @return whether anything changed
  bool advance() {
    bool changed = false;
    if (spin_.tenths != std::array<std::int32_t, 3>{} && due(rotation_count_, spin_.delay)) {
      rotate();
      changed = true;
    }
    if (drift_ && due(move_count_, drift_->delay)) {
      move();
      changed = true;
    }
    if (orbit_) {
      orbit_angle_ = (orbit_angle_ + orbit_->step_tenths) % 3600;
      put_on_orbit();
      changed = true;
    }
    if (changed && look_at_) face_point();
    return changed;
  }

 private:
  N& place(std::size_t i) { return to_world_.rows[i][3]; }

  static bool due(std::int32_t& count, const Delay& delay) {
    if (--count != 0) return false;
    count = delay.base;
    return true;
  }

  void rotate() {
    ++rotations_;
    if (style_.from_scratch) {
      const auto matrix = rotation_after(spin_.tenths, rotations_);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          to_world_.rows[i][j] = Arithmetic<N>::constant(matrix[i][j], Conversion::nearest);
        }
      }
      return;
    }
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      const auto i = static_cast<std::size_t>(axis);
      if (spin_.tenths[i] == 0) continue;
      // Every rotation calls CosSin, as in chapter 53.
      append_rotation(
          to_world_, axis,
          style_.trigonometry == Trigonometry::table ? turn_about(i) : floating_turns_[i]);
    }
    if (style_.restore_every > 0 && rotations_ % style_.restore_every == 0) {
      restore_orthogonality(to_world_, style_.restore_rows);
    }
  }

  [[nodiscard]] Turn<N> turn_about(std::size_t axis) const {
    return turn<N>(spin_.tenths[axis], style_.trigonometry, style_.conversion);
  }

  void move() {
    for (std::size_t i = 0; i < 3; ++i) {
      place(i) = place(i) + step_[i];
      turn_page(i);
    }
    const double z = page_[2] * static_cast<double>(page_size) + static_cast<double>(place(2));
    if (drift_->stop_z && z > *drift_->stop_z) step_[2] = from_whole<N>(0);
    if (drift_->bounce_z && (z < drift_->bounce_z->least || z > drift_->bounce_z->most)) {
      step_[2] = -step_[2];
    }
  }

  /// Keeps the position within one page to either side.
  void turn_page(std::size_t i) {
    const N page = from_whole<N>(page_size);
    if (place(i) >= page && page_[i] < max_pages) {
      place(i) = place(i) - page;
      ++page_[i];
    } else if (place(i) <= -page && page_[i] > -max_pages) {
      place(i) = place(i) + page;
      --page_[i];
    }
  }

  void put_on_orbit() {
    const Turn<N> around = Arithmetic<N>::turn(orbit_angle_);
    const N across = orbit_radius_ * around.cos;
    const N along = orbit_radius_ * around.sin;
    const std::array<N, 3> offset{across, -(along * orbit_tilt_.sin), along * orbit_tilt_.cos};
    for (std::size_t i = 0; i < 3; ++i) {
      place(i) = coordinate<N>(orbit_->about[i], style_.conversion) + offset[i];
    }
  }

  /// Turns the object toward its point. At the point itself, it keeps its orientation.
  void face_point() {
    Triple toward{};
    for (std::size_t i = 0; i < 3; ++i) {
      // Exact within 2^23 pages. Beyond, double rounds to nearest, alike on every platform.
      const double pages = static_cast<double>(look_at_page_[i]) - page_[i];
      toward[i] =
          pages * page_size + static_cast<double>((*look_at_)[i]) - static_cast<double>(place(i));
    }
    if (toward == Triple{}) return;
    const auto rotation = look_at_rotation<N>(toward);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) to_world_.rows[i][j] = rotation[i][j];
    }
  }

  static constexpr std::int32_t max_pages = 1 << 30;

  RotationStyle style_;
  Spin spin_;
  std::optional<Drift> drift_;
  std::optional<Orbit> orbit_;
  Transform<N> to_world_;
  std::array<std::int32_t, 3> page_;
  std::array<std::int32_t, 3> look_at_page_;
  std::optional<std::array<N, 3>> look_at_{};
  /// Chapter 52 calls cos() and sin() for every rotation, always with these results.
  std::array<Turn<N>, 3> floating_turns_{};
  std::array<N, 3> step_{};
  Turn<N> orbit_tilt_{};
  N orbit_radius_{};
  std::int32_t rotation_count_ = 1;
  std::int32_t move_count_ = 1;
  std::int32_t orbit_angle_ = 0;
  std::int64_t rotations_ = 0;
};

}  // namespace xsharp
