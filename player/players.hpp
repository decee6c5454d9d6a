/// @file
/// A scene under the arithmetic that is chosen.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "support/usage_error.hpp"
#include "xsharp/player.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::player {

/// Every arithmetic that a scene can be drawn with: the type under its presets, the model under the
/// builds of the listings, both for the 8088 with the printed ConcatXforms and the repaired one,
/// double.
std::vector<xsharp::ArithmeticChoice> all_arithmetics();

/// `type i386, multiply on, divide off`, `type saturating`, `double`.
std::string name_of(const xsharp::ArithmeticChoice& choice);

/// That there is none of this choice, and which there are.
support::UsageError no_arithmetic(const xsharp::ArithmeticChoice& choice);

/// @param threads that move, prepare and draw objects; the pictures do not depend on how many
/// @throws UsageError for a choice that all_arithmetics() does not have, and for the model on more
///         than one thread: its calls are recorded on that of the caller
std::unique_ptr<xsharp::Player> make_player(const xsharp::Scene& scene,
                                            const xsharp::ArithmeticChoice& choice,
                                            std::size_t threads = 1);

/// The players of one party, which have a file each: they take long to compile. Null if there is
/// none.
std::unique_ptr<xsharp::Player> make_type_player(const xsharp::Scene& scene,
                                                 const xsharp::ArithmeticChoice& choice,
                                                 std::size_t threads);
std::unique_ptr<xsharp::Player> make_model_player(const xsharp::Scene& scene,
                                                  const xsharp::ArithmeticChoice& choice);

}  // namespace fixproof::player
