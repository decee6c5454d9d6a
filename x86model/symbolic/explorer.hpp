/// @file
/// Follows every path through some code, for all operands at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "x86model/symbolic/evaluate.hpp"
#include "x86model/symbolic/state.hpp"

namespace x86model::symbolic {

/// A path in progress.
struct Thread {
  State state{};
  Term condition{};  ///< on the operands that take it
  Term in_table{};   ///< see Path::in_table in run.hpp
  std::size_t position = 0;
  std::size_t steps = 0;                ///< instructions so far, with the one at `position`
  std::map<std::size_t, int> jumps{};   ///< number of jumps by position
  std::vector<std::uint64_t> values{};  ///< of the enumerated operand that take this path
};

/// The paths through code of one kind. A class derived from this one executes an instruction and
/// collects the paths that have ended in `paths_`.
template <class Path>
class Explorer {
 public:
  Explorer(const Explorer&) = delete;
  Explorer& operator=(const Explorer&) = delete;
  Explorer(Explorer&&) = delete;
  Explorer& operator=(Explorer&&) = delete;
  virtual ~Explorer() = default;

  std::vector<Path> all(Thread start) {
    if (enumerated_) {
      start.values.resize(std::size_t{1} << t_.width(*enumerated_));
      std::iota(start.values.begin(), start.values.end(), std::uint64_t{0});
    }
    threads_.push_back(std::move(start));
    while (!threads_.empty()) {
      Thread thread = std::move(threads_.back());
      threads_.pop_back();
      do {
        ++thread.steps;
      } while (step(thread));
    }
    return std::move(paths_);
  }

 protected:
  /// @param max_paths  if there are more, the next thread that would split calls give_up()
  /// @param enumerated an operand of at most 16 bits; if a jump depends only on it, all its values
  ///                   are tried, and paths that no value takes are dropped
  Explorer(Terms& terms, std::size_t max_paths, std::optional<Term> enumerated = {})
      : t_(terms), max_paths_(max_paths), enumerated_(enumerated), evaluation_(terms, concrete) {}

  /// Executes the instruction at the thread's position. @return false if the thread has ended, or
  /// was split
  virtual bool step(Thread& thread) = 0;
  /// Ends a thread because there are too many paths. May throw.
  virtual void give_up(Thread& thread) = 0;

  /// Takes the operands that satisfy a condition from a thread. @return the condition of their path
  Term take_off(Thread& thread, Term condition) {
    const Term taken = t_.both(thread.condition, condition);
    thread.condition = t_.both(thread.condition, t_.negation(condition));
    return taken;
  }

  /// Goes on to `to` or to `next`, or splits the thread if that depends on operands. @return
  /// whether the thread goes on
  bool jump(Thread& thread, Term taken, std::size_t to, std::size_t next) {
    if (t_.is_constant(taken)) {
      thread.position = t_.value(taken) != 0 ? to : next;
      return true;
    }
    if (paths_.size() + threads_.size() > max_paths_) {
      give_up(thread);
      return false;
    }
    Thread other = thread;
    other.condition = take_off(thread, taken);
    other.position = to;
    thread.position = next;
    if (enumerated_ && t_.depends_only_on(*enumerated_, taken)) {
      const std::string& name = t_[*enumerated_].name;
      const auto jumps = [&](std::uint64_t value) {
        evaluation_.set(name, value);
        return evaluation_(taken) != 0;
      };
      std::erase_if(other.values, [&](std::uint64_t value) { return !jumps(value); });
      std::erase_if(thread.values, jumps);
      if (!other.values.empty()) threads_.push_back(std::move(other));
      if (!thread.values.empty()) threads_.push_back(std::move(thread));
      return false;
    }
    if (is_possible(other)) threads_.push_back(std::move(other));
    if (is_possible(thread)) threads_.push_back(std::move(thread));
    return false;
  }

  /// Whether the condition is not known to be false.
  [[nodiscard]] bool is_possible(const Thread& thread) const {
    return !t_.is_constant(thread.condition) || t_.value(thread.condition) != 0;
  }

  // NOLINTBEGIN(*-non-private-member-variables-in-classes)
  Terms& t_;
  std::vector<Path> paths_;
  // NOLINTEND(*-non-private-member-variables-in-classes)

 private:
  std::size_t max_paths_;
  std::optional<Term> enumerated_;
  Evaluation evaluation_;
  std::vector<Thread> threads_;
};

}  // namespace x86model::symbolic
