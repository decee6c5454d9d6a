// Tests profiles of scenes that are small enough to work out by hand.
#include "measure/trade/profile/profile.hpp"

#include "app/cli/profile_text.hpp"
#include "measure/player/players.hpp"
#include "tests/measure/one_cube.hpp"
#include "tests/support/test.hpp"
#include "x86model/forms.hpp"

namespace fixproof {
namespace {

constexpr std::int64_t one = 65536;

/// One cube at (0, 0, z) that does not move; the projection constant is -320.
xsharp::Scene still_cube(double half_edge, double z) {
  xsharp::Scene scene = one_cube(half_edge, z);
  scene.depth_key = xsharp::DepthKey::none;
  return scene;
}

trade::SceneProfile profile_of(const xsharp::Scene& scene, const std::string& target, bool round,
                               int frames) {
  const xsharp::ArithmeticChoice choice{"model", target, round, round};
  trade::Profiler profiler(scene, choice);
  std::unique_ptr<xsharp::Player> player;
  xsharp::Picture picture;
  for (int frame = 0; frame < frames; ++frame) {
    player::OperandLog log;
    {
      const player::Recording recording(log);
      if (player) {
        player->move();
      } else {
        player = player::make_player(scene, choice);
      }
      player->draw(picture);
    }
    profiler.add(log, *player);
  }
  return profiler.profile();
}

const trade::RoutineProfile& routine(const trade::SceneProfile& profile,
                                     cases::Operation operation) {
  return profile.routines.at(static_cast<std::size_t>(operation));
}

void expect_range(const trade::ValueRange& range, std::int64_t least, std::int64_t greatest,
                  int bits) {
  EXPECT_EQ(range.least(), least);
  EXPECT_EQ(range.greatest(), greatest);
  EXPECT_EQ(range.bits(), bits);
}

// Corners at x, y = -1, 1 and z = -9, -11. The largest quotient is 1/9 = 7281.78 units.
TEST(Profile, OfACubeWorkedByHand) {
  const trade::SceneProfile profile = profile_of(still_cube(1, -10), "i386", true, 3);
  EXPECT_EQ(profile.frames, 3U);

  const trade::RoutineProfile& concat = routine(profile, cases::Operation::concat);
  EXPECT_EQ(concat.calls, 1U);
  expect_range(concat.operands.at(0), 0, one, 18);
  expect_range(concat.operands.at(1), 0, 0, 1);
  expect_range(concat.operands.at(3), -10 * one, 0, 21);
  expect_range(concat.results.at(1), -10 * one, 0, 21);

  const trade::RoutineProfile& xformvec = routine(profile, cases::Operation::xformvec);
  EXPECT_EQ(xformvec.calls, 8U);
  expect_range(xformvec.operands.at(2), -one, one, 18);
  expect_range(xformvec.results.at(0), -11 * one, one, 21);

  const trade::RoutineProfile& div = routine(profile, cases::Operation::div);
  EXPECT_EQ(div.calls, 16U);
  EXPECT_EQ(div.faults, 0U);
  expect_range(div.operands.at(0), -one, one, 18);
  expect_range(div.operands.at(1), -11 * one, -9 * one, 21);
  expect_range(div.results.at(0), -7282, 7282, 14);
  EXPECT_EQ(profile.divides.least_divisor, 9 * one);
  EXPECT_EQ(profile.divides.greatest_quotient, 7282);

  const trade::RoutineProfile& mul = routine(profile, cases::Operation::mul);
  EXPECT_EQ(mul.calls, 16U);
  // Nine instructions from PUSH BP to RET, without a jump.
  EXPECT_EQ(mul.instructions, 16U * 9);
  EXPECT_EQ(std::ranges::count(mul.executed, true), 9);
  EXPECT_EQ(mul.executed.size(), 9U);
  expect_range(mul.operands.at(0), -7282, 7282, 14);
  // The published conversion makes -320 one unit too large.
  expect_range(mul.operands.at(1), -320 * one + 1, -320 * one + 1, 26);
  EXPECT_EQ(mul.results.at(0).greatest(), 7282 * 320);

  // Nothing moves, so the first frame does all the work. Nothing turns, so no sine is looked up.
  EXPECT_EQ(mul.max_in_frame, 16U);
  EXPECT_EQ(mul.least_in_frame, 0U);
  EXPECT_EQ(routine(profile, cases::Operation::cossin).calls, 0U);

  EXPECT_EQ(profile.view.nearest, -9 * one);
  EXPECT_EQ(profile.view.faces, 3U * 6);
  EXPECT_EQ(profile.view.clipped_faces, 0U);
  for (const trade::RoutineProfile& r : profile.routines) EXPECT_EQ(r.wrapped, 0U);
}

// The calls that chapters 53 and 54 describe.
TEST(Profile, CallsOfAFrameAreThoseOfTheText) {
  xsharp::Scene scene = still_cube(1, -10);
  xsharp::ObjectDescription& cube = scene.objects[0];
  cube.spin.tenths = {10, 0, -20};
  cube.mesh = xsharp::with_normals(std::move(cube.mesh));
  cube.shadings.assign(6, {.ambient = true, .diffuse = true});
  for (xsharp::Paint& paint : cube.paints) paint = {false, 0, {255, 255, 255}};
  trade::SceneProfile profile = profile_of(scene, "i386", true, 4);
  // Three moves of two rotations each.
  EXPECT_EQ(routine(profile, cases::Operation::cossin).calls, 3U * 2);
  // Transforms eight corners and six ends of normals, projects only the corners.
  EXPECT_EQ(routine(profile, cases::Operation::xformvec).calls, 4U * (8 + 6));
  EXPECT_EQ(routine(profile, cases::Operation::div).calls, 4U * 8 * 2);
  // Sorting by centres also transforms the centres.
  scene.depth_key = xsharp::DepthKey::center;
  profile = profile_of(scene, "i386", true, 4);
  EXPECT_EQ(routine(profile, cases::Operation::xformvec).calls, 4U * (8 + 6 + 1));
  EXPECT_EQ(routine(profile, cases::Operation::div).calls, 4U * 8 * 2);
}

TEST(Profile, TruncatedQuotientsAreAUnitSmaller) {
  const trade::SceneProfile profile = profile_of(still_cube(1, -10), "i386", false, 1);
  EXPECT_EQ(profile.divides.greatest_quotient, 7281);
}

// Corners at z = 0 and -2: only the far face is unclipped. The others are clipped at z = -1.
TEST(Profile, OfACubeInTheNearPlane) {
  const trade::SceneProfile profile = profile_of(still_cube(1, -1), "i8088", true, 1);
  EXPECT_EQ(profile.view.nearest, -2 * one);
  EXPECT_EQ(profile.view.faces, 6U);
  EXPECT_EQ(profile.view.clipped_faces, 5U);
  EXPECT_EQ(profile.divides.least_divisor, one);
  EXPECT_EQ(profile.divides.greatest_quotient, one);
  EXPECT_EQ(routine(profile, cases::Operation::div).faults, 0U);
}

TEST(Profile, OfACubeOutOfReach) {
  xsharp::Scene scene = still_cube(1, -10);
  scene.objects[0].page = {9, 0, 0};
  const trade::SceneProfile profile = profile_of(scene, "i386", true, 2);
  EXPECT_EQ(profile.view.out_of_reach, 2U);
  EXPECT_EQ(profile.view.faces, 0U);
  EXPECT_FALSE(profile.view.nearest);
  EXPECT_FALSE(profile.divides.least_divisor);
}

TEST(Profile, FormsAreExecutedOrNever) {
  for (const auto target : {x86model::Target::i386, x86model::Target::i8088}) {
    const bool i386 = target == x86model::Target::i386;
    const trade::FormUse forms =
        trade::forms_of(profile_of(still_cube(1, -10), i386 ? "i386" : "i8088", true, 1));
    std::vector<std::string> all;
    std::ranges::merge(forms.executed, forms.never, std::back_inserter(all));
    EXPECT_EQ(all, x86model::form_texts(target));
    // Both targets divide. Only an unrounded build executes IDIV.
    EXPECT_TRUE(std::ranges::binary_search(forms.executed, i386 ? "div r/m32" : "div r/m16"));
    EXPECT_EQ(std::ranges::binary_search(forms.never, "idiv r/m32"), i386);
  }
}

TEST(Profile, SaysWhichRoutinesAreNeverCalled) {
  xsharp::Scene scene = still_cube(1, -10);
  scene.objects[0].spin.tenths = {0, 10, 0};
  const auto says_so = [&scene] {
    return cli::text_of(profile_of(scene, "i386", true, 2)).find("CosSin: never called") !=
           std::string::npos;
  };
  EXPECT_FALSE(says_so());
  scene.trigonometry = xsharp::Trigonometry::floating;
  EXPECT_TRUE(says_so());
}

}  // namespace
}  // namespace fixproof
