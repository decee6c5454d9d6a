/// @file
/// Runs the command and connects its streams to the test by pipes.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace command {

struct Run {
  std::string out;
  std::string err;
  int status;  ///< exit status, or minus the number of the signal that ended it
};

enum class Output { pipe, full_device, reader_gone };

/// A program that runs while the test writes to it and reads from it.
class Process {
 public:
  /// Starts `arguments[0]`, found on the PATH.
  explicit Process(std::vector<std::string> arguments, Output output = Output::pipe);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  Process(Process&&) = delete;
  Process& operator=(Process&&) = delete;
  ~Process();

  /// Writes `text` until all of it is written or the program exits.
  void write(std::string_view text) const;
  /// Waits for the next line of its standard output and returns it without the newline. The wait
  /// has a time limit.
  [[nodiscard]] std::string read_line() const;
  /// Writes `rest`, closes its input, reads the remaining output and waits for its end.
  Run finish(std::string_view rest = {});

 private:
  int input_ = -1;
  int output_ = -1;
  int errors_ = -1;
  pid_t id_ = 0;
};

/// Runs any program with `input` on standard input.
Run run(std::vector<std::string> arguments, std::string_view input = {},
        Output output = Output::pipe);

Run fixproof(std::string_view arguments, std::string_view input = {}, Output output = Output::pipe);

std::vector<std::string> command(std::string_view arguments);

/// Expects status 0 and nothing on stderr, and returns the output.
std::string output_of(std::string_view arguments, std::string_view input = {});

void expect_contains(std::string_view text, std::string_view part);

/// Expects status 2 and one line on stderr that contains `part`.
void expect_usage_error(const Run& run, std::string_view part);

/// Expects the same, and no output.
void expect_refused(std::string_view arguments, std::string_view part, std::string_view input = {});

/// Expects status 2 if standard output is full, and 141 and no message if it is a pipe without a
/// reader.
void expect_output_needed(std::string_view arguments, std::string_view input = {});

bool has(std::string_view program);

/// Assembles with nasm and returns the machine code. Any warning fails the test.
std::string assemble(std::string_view source);

/// Formats each byte as two hex digits and a space.
std::string hex(std::string_view bytes);

std::vector<std::string> split(std::string_view text, char separator);

}  // namespace command
