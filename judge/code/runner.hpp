/// @file
/// Runs a user's routine for many cases, in a process of its own.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/code/caller.hpp"
#include "judge/code/confined.hpp"

namespace fixproof::judge {

/// Answers cases on one machine.
class Runner {
 public:
  using Start = std::function<std::unique_ptr<Server>()>;

  Runner(const Subject& subject, On machine);
  /// Asks servers of another kind: for tests.
  Runner(const Subject& subject, Start start);

  /// Answers the cases in `words`, words_in(variant) words each: at most one answer for each case,
  /// in order. Stops after a case that neither returns nor raises #DE, and only then has fewer
  /// answers. If the process dies at a case, that case gets End::fault, or End::endless if it took
  /// too long.
  /// @throws support::Stopped; std::system_error if the system provides no process
  std::vector<Answer> answers(std::span<const std::uint32_t> words);
  /// Returns why the process last died, or Downfall::none if it never did.
  [[nodiscard]] Downfall downfall() const { return downfall_; }

 private:
  struct Batch {
    Downfall downfall = Downfall::none;
    std::vector<Answer> answers{};
  };
  Batch ask(std::span<const std::uint32_t> words);

  const Subject& subject_;
  Start start_;
  std::unique_ptr<Server> server_;
  Downfall downfall_ = Downfall::none;
};

/// A call, step by step.
struct TracedCall {
  Answer answer;
  Trace trace;
};

/// Reads a reply to a batch of cases. Returns nothing if it is false: if it has another length than
/// some answers, no answer, more than `asked`, or fewer without a call that is stuck; if a stuck
/// call is not the last; or if an ending, or one of so many registers, is none.
std::optional<std::vector<Answer>> read_answers(std::string_view reply, std::size_t asked,
                                                std::size_t registers);

/// Reads a traced call. Returns nothing if it is false: if it has another length than its steps and
/// accesses, an ending or a register that is none, or an access of no step or of too many bytes.
std::optional<TracedCall> read_trace(std::string_view reply, std::size_t registers);

/// Traces calls on an emulator, in a process that calls share while what they wrote can be put
/// back. No call sees what another one left.
class Tracer : private boost::noncopyable {
 public:
  /// @param subject must outlive the tracer
  explicit Tracer(const Subject& subject);

  /// Returns nothing if there is no memory for the emulator, or if the process dies, which only a
  /// defect of the emulator can cause.
  /// @throws support::Stopped; std::system_error if the system provides no process
  std::optional<TracedCall> call(std::span<const std::uint32_t> words);

 private:
  const Subject& subject_;
  Trace trace_;
  std::unique_ptr<Caller> caller_;   ///< a process gets a copy: a fork is faster than an emulator
  std::vector<std::uint8_t> fresh_;  ///< the memory of x86 code before a call
  std::unique_ptr<Confined> child_;  ///< none after a call that cannot be undone
};

}  // namespace fixproof::judge
