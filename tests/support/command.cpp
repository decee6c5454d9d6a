#include "tests/support/command.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <thread>

#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace command {

namespace {

void check(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

struct Pipe {
  int read;
  int write;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  check(pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno, "pipe");
  return {.read = ends[0], .write = ends[1]};
}

std::string read_all(int from) {
  std::string text;
  std::array<char, 65536> part{};
  for (;;) {
    const ssize_t count = read(from, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

Process::Process(std::vector<std::string> arguments, Output output) {
  // A program that stops reading must not end the test.
  (void)std::signal(SIGPIPE, SIG_IGN);
  const Pipe in = make_pipe();
  const Pipe out = make_pipe();
  const Pipe err = make_pipe();
  posix_spawn_file_actions_t actions;
  check(posix_spawn_file_actions_init(&actions), "file actions");
  check(posix_spawn_file_actions_adddup2(&actions, in.read, STDIN_FILENO), "stdin");
  check(output == Output::full_device
            ? posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/full", O_WRONLY, 0)
            : posix_spawn_file_actions_adddup2(&actions, out.write, STDOUT_FILENO),
        "stdout");
  check(posix_spawn_file_actions_adddup2(&actions, err.write, STDERR_FILENO), "stderr");
  if (output == Output::reader_gone) close(out.read);

  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (std::string& word : arguments) words.push_back(word.data());
  words.push_back(nullptr);
  const int error = posix_spawnp(&id_, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(in.read);
  close(out.write);
  close(err.write);
  input_ = in.write;
  output_ = output == Output::reader_gone ? -1 : out.read;
  errors_ = err.read;
  check(error, words[0]);
}

Process::~Process() {
  if (input_ >= 0) close(input_);
  if (output_ >= 0) close(output_);
  if (errors_ >= 0) close(errors_);
  if (id_ > 0) waitpid(id_, nullptr, 0);
}

void Process::write(std::string_view text) const {
  while (!text.empty()) {
    const ssize_t count = ::write(input_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

std::string Process::read_line() const {
  constexpr int patience = 30'000;  // milliseconds
  std::string line;
  char c = 0;
  pollfd waits{.fd = output_, .events = POLLIN, .revents = 0};
  while (poll(&waits, 1, patience) == 1 && read(output_, &c, 1) == 1 && c != '\n') line += c;
  return line;
}

Run Process::finish(std::string_view rest) {
  // Writes in a thread, so that neither side can block the other.
  std::thread input([&] {
    write(rest);
    close(input_);
    input_ = -1;
  });
  Run result{};
  std::thread errors([&] { result.err = read_all(errors_); });
  if (output_ >= 0) result.out = read_all(output_);
  errors.join();
  input.join();
  int status = 0;
  waitpid(id_, &status, 0);
  id_ = 0;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return result;
}

Run run(std::vector<std::string> arguments, std::string_view input, Output output) {
  return Process(std::move(arguments), output).finish(input);
}

std::vector<std::string> command(std::string_view arguments) {
  std::vector<std::string> words{paths::command()};
  for (const std::string& word : split(arguments, ' ')) {
    if (!word.empty()) words.push_back(word);
  }
  return words;
}

Run fixproof(std::string_view arguments, std::string_view input, Output output) {
  return run(command(arguments), input, output);
}

std::string output_of(std::string_view arguments, std::string_view input) {
  Run result = fixproof(arguments, input);
  EXPECT_EQ(result.status, 0) << arguments;
  EXPECT_EQ(result.err, "") << arguments;
  return std::move(result.out);
}

void expect_contains(std::string_view text, std::string_view part) {
  EXPECT_NE(text.find(part), std::string_view::npos) << '"' << part << "\" in:\n" << text;
}

void expect_usage_error(const Run& run, std::string_view part) {
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(run.err.starts_with("fixproof: ")) << run.err;
  EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
  expect_contains(run.err, part);
}

void expect_refused(std::string_view arguments, std::string_view part, std::string_view input) {
  SCOPED_TRACE(arguments);
  const Run refused = fixproof(arguments, input);
  EXPECT_EQ(refused.out, "");
  expect_usage_error(refused, part);
}

void expect_output_needed(std::string_view arguments, std::string_view input) {
  for (const Output output : {Output::full_device, Output::reader_gone}) {
    const Run refused = fixproof(arguments, input, output);
    const bool is_full = output == Output::full_device;
    EXPECT_EQ(refused.status, is_full ? 2 : 141) << arguments;
    EXPECT_EQ(refused.err, is_full ? "fixproof: cannot write standard output\n" : "") << arguments;
  }
}

bool has(std::string_view program) {
  return run({"sh", "-c", fmt::format("command -v {}", program)}).status == 0;
}

std::string assemble(std::string_view source) {
  const ScratchFolder folder;
  const auto nasm = run({"nasm", "-w+all", "-f", "bin", "-o", folder.path("code"),
                         folder.write("source.asm", source)});
  EXPECT_EQ(nasm.status, 0) << nasm.err;
  EXPECT_EQ(nasm.err, "");
  return folder.read("code");
}

std::string hex(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) text += fmt::format("{:02x} ", static_cast<unsigned char>(byte));
  return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t at = text.find(separator); at != std::string_view::npos;
       at = text.find(separator)) {
    parts.emplace_back(text.substr(0, at));
    text.remove_prefix(at + 1);
  }
  parts.emplace_back(text);
  return parts;
}

}  // namespace command
