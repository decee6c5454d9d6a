/// @file
/// Runs the real command, its streams joined to the test by pipes.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace command {

/// What a run left behind.
struct Run {
  std::string out;
  std::string err;
  int status;  ///< exit status; minus the signal's number where one ended it
};

/// Where standard output leads.
enum class Output { pipe, full_device, reader_gone };

/// A program that runs while the test writes to it and reads from it.
class Process {
 public:
  /// Starts `arguments[0]`, looked up as the shell does.
  explicit Process(std::vector<std::string> arguments, Output output = Output::pipe);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  Process(Process&&) = delete;
  Process& operator=(Process&&) = delete;
  ~Process();

  /// Writes all of `text`, or as much as the program takes before it goes away.
  void write(std::string_view text) const;
  /// The next line of its standard output without the newline; waits for it, though not for ever.
  [[nodiscard]] std::string read_line() const;
  /// Gives it the rest of its input, reads what it still says, and waits for its end.
  Run finish(std::string_view rest = {});

 private:
  int input_ = -1;
  int output_ = -1;
  int errors_ = -1;
  pid_t id_ = 0;
};

/// One run of any program with all of `input`.
Run run(std::vector<std::string> arguments, std::string_view input = {},
        Output output = Output::pipe);

/// One run of `fixproof`, its arguments separated by spaces.
Run fixproof(std::string_view arguments, std::string_view input = {}, Output output = Output::pipe);

/// The words of a command line of `fixproof`, the program first.
std::vector<std::string> command(std::string_view arguments);

/// Expects status 2 and one line on stderr that contains `part`.
void expect_usage_error(const Run& run, std::string_view part);

/// Whether the shell finds this program.
bool has(std::string_view program);

/// Assembles with nasm and returns the machine code; any warning fails the test.
std::string assemble(std::string_view source);

/// Two hexadecimal digits and a space for each byte.
std::string hex(std::string_view bytes);

/// `count` times `c`.
std::string repeated(std::size_t count, char c);

std::vector<std::string> split(std::string_view text, char separator);

}  // namespace command
