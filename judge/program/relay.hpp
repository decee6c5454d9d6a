/// @file
/// Gives cases to several processes of a program, and returns their results in the order of the
/// cases.
#pragma once

#include <boost/noncopyable.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "judge/program/child.hpp"

namespace fixproof::program {

/// Appends the next case to a text, as a line; false at the end.
using NextCase = std::function<bool(std::string& text)>;

struct RelayOptions {
  std::string command;
  std::size_t processes = 1;
  std::chrono::milliseconds silence{60'000};  ///< the longest time without reading or writing
};

/// Why there are fewer or more results than cases.
struct Fault {
  enum class Kind : std::uint8_t {
    ends,         ///< it ended, or closed its output, with results missing
    silent,       ///< it neither read nor wrote
    too_many,     ///< it wrote more results than it read cases
    never_ends,   ///< it wrote every result and went on
    interrupted,  ///< Interrupt::flag() was set
  };
  Kind kind;
  std::optional<Child::Ending> ending{};  ///< empty if the program had not ended
  std::string said{};                     ///< the line that is one too many
  std::string error{};                    ///< the first line on standard error
};

/// Every process gets the next block of cases as soon as it has read its last one. What a process
/// writes is kept until its turn comes, so a program may read everything before it writes.
class Relay : private boost::noncopyable {
 public:
  Relay(const RelayOptions& options, NextCase next_case);
  ~Relay();

  /// Returns the result of the next case, a line without its end, up to the next call. Skips lines
  /// that start with #, and blank lines at the end. Empty at the end and after a fault.
  /// @throws std::system_error if no process can be started
  std::optional<std::string_view> next();
  [[nodiscard]] const std::optional<Fault>& fault() const { return fault_; }
  /// The number of cases that the processes were given.
  [[nodiscard]] std::uint64_t given() const { return given_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Share;

  /// Moves the next result of a process to `line_`.
  void take_line(Share& share);
  /// Waits until the processes end after the last result.
  void finish();
  /// Gives blocks to processes that have none to read, then moves bytes in both directions.
  void pump();
  void give();
  void send(Share& share);
  void receive(Share& share);
  void receive_errors(Share& share);
  /// Appends a line to the results of a process, unless it is a comment.
  void add_line(Share& share, std::string_view line);
  [[nodiscard]] bool has_ended(const Share& share) const;
  void fail(Fault::Kind kind, Share& share);

  RelayOptions options_;
  NextCase next_case_;
  bool has_more_ = true;
  std::uint64_t given_ = 0;
  std::uint64_t taken_ = 0;
  std::vector<std::unique_ptr<Share>> shares_;
  std::deque<Share*> owners_;  ///< of the blocks from that of the next result on
  std::string line_;           ///< the result that was returned last
  std::optional<Fault> fault_;
};

}  // namespace fixproof::program
