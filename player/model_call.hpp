/// @file
/// One call of a listing, and a log of the operands of calls.
#pragma once

#include <array>
#include <boost/noncopyable.hpp>
#include <cstdint>
#include <span>
#include <vector>

#include "cases/variant.hpp"
#include "x86model/routine.hpp"

namespace fixproof::player {

/// Runs the routine of a variant of 16.16 on the model.
/// @return false for a divide error
/// @throws std::logic_error if the routine does not end as one of the listings does
bool call_model(const cases::Variant& variant, std::span<const std::uint32_t> in,
                std::span<std::uint32_t> out);

/// The operands of calls, operation by operation, one case after the other.
using OperandLog = std::array<std::vector<std::uint32_t>, x86model::routine_count>;

/// While it lives, the operands of this thread's calls of call_model() are added to a log. The
/// pipeline's numbers are values and know no log: this is the one place where they meet.
class Recording : private boost::noncopyable {
 public:
  explicit Recording(OperandLog& log);
  ~Recording();
};

}  // namespace fixproof::player
