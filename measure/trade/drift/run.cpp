#include "measure/trade/drift/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/noncopyable.hpp>
#include <memory>
#include <utility>

#include "measure/host/provenance.hpp"
#include "measure/trade/drift/sources.hpp"
#include "support/thread_pool.hpp"
#include "verify/parties/with_number.hpp"
#include "xsharp/motion.hpp"
#include "xsharp/view.hpp"

namespace fixproof::trade {

namespace {

using xsharp::ObjectDescription;
using xsharp::RotationStyle;

/// The workers wait for each other after so many frames, and an interrupt takes effect.
constexpr std::uint64_t frames_at_a_time = 256;

class Motions : private boost::noncopyable {
 public:
  Motions() = default;
  virtual ~Motions() = default;
  virtual void advance() = 0;
  [[nodiscard]] virtual Placement placement(std::size_t object) const = 0;
};

template <class N>
class MotionsOf final : public Motions {
 public:
  MotionsOf(const xsharp::Scene& scene, const RotationStyle& style) {
    for (const ObjectDescription& object : scene.objects) motions_.emplace_back(object, style);
  }
  void advance() override {
    for (auto& motion : motions_) motion.advance();
  }
  [[nodiscard]] Placement placement(std::size_t object) const override {
    Placement p;
    const auto& motion = motions_[object];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        p.at(i).at(j) = static_cast<double>(motion.to_world().rows[i][j]);
      }
      p.at(i)[3] += static_cast<double>(motion.page()[i]) * xsharp::page_size;
    }
    return p;
  }

 private:
  std::vector<xsharp::Motion<N>> motions_;
};

template <class Number, fixproof::rounding rounding>
std::unique_ptr<Motions> motions_with(const xsharp::Scene& scene, const RotationStyle& style,
                                      Without without) {
  switch (without) {
    case Without::nothing:
    case Without::offset:
      break;
    case Without::step:
      return std::make_unique<MotionsOf<Partly<ExactSteps<rounding>>>>(scene, style);
    case Without::products:
      return std::make_unique<MotionsOf<Partly<ExactProducts>>>(scene, style);
    case Without::all:
      return std::make_unique<MotionsOf<double>>(scene, style);
  }
  return std::make_unique<MotionsOf<Number>>(scene, style);
}

std::unique_ptr<Motions> motions_of(const xsharp::Scene& scene, const DriftCase& c) {
  const auto conversion =
      c.without == Without::offset ? xsharp::Conversion::nearest : scene.conversion;
  const RotationStyle style{scene.trigonometry, conversion, c.from_scratch, c.restore_every,
                            c.restore_rows};
  return parties::with_build(c.build, [&]<cases::Build build>() {
    // No divide runs, so the divide rounding can be the multiply's.
    constexpr cases::Build same{build.target, build.mul_round, build.mul_round};
    constexpr fixproof::policy rules = parties::policy_of(same);
    return motions_with<parties::NumberOf<same>, rules.multiply>(scene, style, c.without);
  });
}

/// The placement in view space, where errors are measured in pixels.
Placement seen(const Placement& to_world, const xsharp::Camera& camera,
               const std::array<std::array<double, 3>, 3>& turn) {
  Placement from_camera = to_world;
  for (std::size_t i = 0; i < 3; ++i) {
    from_camera.at(i)[3] -=
        camera.page.at(i) * static_cast<double>(xsharp::page_size) + camera.position.at(i);
  }
  Placement view{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 3; ++k)
        view.at(i).at(j) += turn.at(i).at(k) * from_camera.at(k).at(j);
    }
  }
  return view;
}

/// @param point the point of the time series that contains the frame
void note(DriftResult& result, const Distortion& d, std::uint64_t frame, std::size_t point) {
  result.worst.add(d);
  if (result.series.size() <= point) result.series.resize(point + 1);
  result.series[point].add(d);
  if (!result.pixel && d.pixels >= Thresholds::pixels) result.pixel = frame;
  if (!result.some && d.length >= Thresholds::some) result.some = frame;
  if (!result.much && d.length >= Thresholds::much) result.much = frame;
}

/// The multiply of a build: `386 on`, `8088 off`.
std::string multiply_name(const cases::Build& build) {
  return fmt::format("{} {}", build.target == cases::Target::i386 ? "386" : "8088",
                     build.mul_round ? "on" : "off");
}

std::string name_of(Without without) {
  static constexpr std::array names{"nothing", "offset", "step", "products", "all"};
  return names.at(static_cast<std::size_t>(without));
}

}  // namespace

std::string name_of(const DriftCase& c) {
  std::string name = multiply_name(c.build);
  if (c.without != Without::nothing) name += ", without " + name_of(c.without);
  if (c.restore_every > 0) {
    const bool one = c.restore_rows == xsharp::RestoredRows::one;
    name += fmt::format(", {} every {}", one ? "one row" : "restored", c.restore_every);
  }
  if (c.from_scratch) name += ", from scratch";
  return name;
}

std::vector<DriftResult> run_drift(const xsharp::Scene& scene, const std::vector<DriftCase>& cases,
                                   std::uint64_t& frames, const std::atomic<bool>& stop,
                                   const std::function<void(std::uint64_t)>& frames_done) {
  std::vector<std::unique_ptr<Motions>> runs;
  std::vector<DriftResult> results;
  for (const DriftCase& c : cases) {
    runs.push_back(motions_of(scene, c));
    results.emplace_back().of = c;
  }
  const RotationStyle exact{scene.trigonometry, scene.conversion, true, 0};
  // Each worker has some of the cases, and the exact motions that they are compared with.
  const auto pool = support::workers_for(runs.size());
  std::vector<std::unique_ptr<MotionsOf<double>>> references;
  while (references.size() < pool->workers()) {
    references.push_back(std::make_unique<MotionsOf<double>>(scene, exact));
  }

  const auto turn = xsharp::turn_to_view(scene.camera);
  const std::uint64_t point_frames = frames_a_point(frames);
  std::uint64_t done = 0;
  while (done < frames && !stop) {
    const std::uint64_t end = std::min(frames, done + frames_at_a_time);
    pool->run([&](std::size_t worker) {
      MotionsOf<double>& reference = *references[worker];
      const auto part = pool->part(runs.size(), worker);
      for (std::uint64_t frame = done; frame < end; ++frame) {
        if (frame > 0) {
          reference.advance();
          for (std::size_t i = part.first; i < part.end; ++i) runs[i]->advance();
        }
        for (std::size_t object = 0; object < scene.objects.size(); ++object) {
          const Placement should_be = seen(reference.placement(object), scene.camera, turn);
          for (std::size_t i = part.first; i < part.end; ++i) {
            note(results[i],
                 distortion(seen(runs[i]->placement(object), scene.camera, turn), should_be,
                            scene.objects[object].mesh, scene),
                 frame, frame / point_frames);
          }
        }
      }
    });
    done = end;
    frames_done(done);
  }
  frames = done;
  return results;
}

static void to_json(support::Json& json, const DriftResult& r) {
  support::Json length = support::Json::array();
  support::Json pixels = support::Json::array();
  for (const Distortion& d : r.series) {
    length.push_back(d.length);
    pixels.push_back(d.pixels);
  }
  const auto rows = static_cast<std::size_t>(r.of.restore_rows);
  json = {{"name", name_of(r.of)},
          {"multiply", multiply_name(r.of.build)},
          {"without", name_of(r.of.without)},
          {"restore_every", r.of.restore_every},
          {"restore_rows", xsharp::restored_rows_words.at(rows)},
          {"from_scratch", r.of.from_scratch},
          {"worst",
           {{"skew", r.worst.skew},
            {"length", r.worst.length},
            {"volume", r.worst.volume},
            {"pixels", r.worst.pixels}}},
          {"first", {{"pixel", r.pixel}, {"some", r.some}, {"much", r.much}}},
          {"series", {{"length", std::move(length)}, {"pixels", std::move(pixels)}}}};
}

void to_json(support::Json& json, const DriftFigures& figures) {
  json = {
      {"made", measure::made_by_json("drift")},
      {"scene", figures.scene},
      {"frames", figures.frames},
      {"frames_a_second", figures.rate},
      {"frames_a_point", frames_a_point(figures.frames)},
      {"thresholds",
       {{"pixels", Thresholds::pixels}, {"some", Thresholds::some}, {"much", Thresholds::much}}},
      {"cases", figures.results}};
}

}  // namespace fixproof::trade
