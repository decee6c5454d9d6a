/// @file
/// What the listings would cost on the processors of their time.
#pragma once

#include "verify/scenes/model_call.hpp"
#include "x86model/clocks.hpp"
#include "xsharp/scene.hpp"

namespace fixproof {

/// The clocks of the calls in a log: of the listings alone, not of the C around them. Two numbers
/// where the tables give a range.
/// @param choice the arithmetic that made the calls, of the model
/// @throws std::invalid_argument where `cpu` cannot run the listings
x86model::Range clocks_of(const OperandLog& log, const xsharp::ArithmeticChoice& choice,
                          x86model::Cpu cpu);

}  // namespace fixproof
