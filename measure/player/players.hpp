/// @file
/// Players of a scene in each arithmetic.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "support/usage_error.hpp"
#include "verify/cases/build.hpp"
#include "xsharp/player.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::player {

/// Returns the build of a choice; empty for double and for the saturating and trapping types.
std::optional<cases::Build> build_of(const xsharp::ArithmeticChoice& choice);
/// @param by "type" or "model"
xsharp::ArithmeticChoice arithmetic_of(const cases::Build& build, std::string by);

/// `type i386, multiply on, divide off`, `type saturating`, `double`.
std::string name_of(const xsharp::ArithmeticChoice& choice);

/// Returns the error for an arithmetic that does not exist. It lists the targets.
support::UsageError no_arithmetic(const xsharp::ArithmeticChoice& choice);

/// @param threads how many threads move, prepare and draw objects; pictures do not depend on it
/// @throws UsageError for an arithmetic that does not exist, and for the model on more
///   than one thread, because it records calls on the caller's thread
std::unique_ptr<xsharp::Player> make_player(const xsharp::Scene& scene,
                                            const xsharp::ArithmeticChoice& choice,
                                            std::size_t threads = 1);

/// Make the player of one party; null if the party does not have the arithmetic. Each has its own
/// file, because it takes long to compile.
std::unique_ptr<xsharp::Player> make_type_player(const xsharp::Scene& scene,
                                                 const xsharp::ArithmeticChoice& choice,
                                                 std::size_t threads);
std::unique_ptr<xsharp::Player> make_model_player(const xsharp::Scene& scene,
                                                  const xsharp::ArithmeticChoice& choice);

}  // namespace fixproof::player
