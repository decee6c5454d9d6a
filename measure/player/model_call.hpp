/// @file
/// One call of a listing, and a log of the operands of calls.
#pragma once

#include <array>
#include <boost/noncopyable.hpp>
#include <cstdint>
#include <span>
#include <vector>

#include "verify/cases/variant.hpp"
#include "x86model/routine.hpp"

namespace fixproof::player {

/// Runs the routine of a 16.16 variant on the model.
/// @return false for a divide error
/// @throws std::logic_error if the routine ends in a way that no listing does
bool call_model(const cases::Variant& variant, std::span<const std::uint32_t> in,
                std::span<std::uint32_t> out);

/// During its lifetime, the build of the listings that this thread's ModelNumbers call. It is
/// thread-local because the pipeline's numbers are plain values, and a number that had its build as
/// a template argument would instantiate the pipeline once for each.
class InBuild : private boost::noncopyable {
 public:
  explicit InBuild(const cases::Build& build);
  ~InBuild();
  /// @throws std::logic_error if there is none on this thread
  static const cases::Build& current();

 private:
  cases::Build build_;
  const InBuild* outer_;
};

/// The operands of calls, one list per operation, one case after the other.
using OperandLog = std::array<std::vector<std::uint32_t>, x86model::routine_count>;

/// During its lifetime, adds the operands of this thread's calls of call_model() to a log. The log
/// is thread-local because the pipeline's numbers are plain values without access to a log.
class Recording : private boost::noncopyable {
 public:
  explicit Recording(OperandLog& log);
  ~Recording();
};

}  // namespace fixproof::player
