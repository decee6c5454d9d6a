#include "verify/proof/solver.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "verify/hex.hpp"
#include "verify/usage_error.hpp"

namespace fixproof {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Files without a name: whatever ends this program, nothing stays behind.
File nameless_file() {
  File file(std::tmpfile(), std::fclose);
  if (!file) {
    throw std::runtime_error(
        fmt::format("no temporary file: {}", std::generic_category().message(errno)));
  }
  return file;
}

std::string contents(std::FILE* file) {
  std::string text;
  std::array<char, 4096> buffer{};
  std::rewind(file);
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), file)) {
    text.append(buffer.data(), got);
  }
  return text;
}

/// What a program prints, given that input. @throws std::system_error where it cannot be started
std::string output_of(std::vector<std::string> arguments, const std::string& input) {
  const File in = nameless_file();
  const File out = nameless_file();
  if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() ||
      std::fflush(in.get()) != 0) {
    throw std::runtime_error("cannot write a temporary file");
  }
  std::rewind(in.get());
  std::vector<char*> words;
  for (std::string& word : arguments) words.push_back(word.data());
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), STDERR_FILENO);
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, words.front(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), arguments.front());
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127) {
    throw std::system_error(ENOENT, std::generic_category(), arguments.front());
  }
  if (WIFSIGNALED(status)) {
    throw std::runtime_error(
        fmt::format("{} was ended by signal {}", arguments.front(), WTERMSIG(status)));
  }
  return contents(out.get());
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

Solver::Solver(const std::string& name) : name_(name) {
  if (name != "z3" && name != "cvc5") {
    throw UsageError(fmt::format("unknown solver '{}'; there are z3, cvc5", name));
  }
  try {
    version_ = first_line(output_of({name, "--version"}, ""));
  } catch (const std::system_error& error) {
    throw UsageError(fmt::format("{} cannot be run: {}; Debian's package {} has it", name,
                                 error.code().message(), name));
  }
}

SolverAnswer Solver::ask(const std::string& script, int most_seconds) const {
  std::vector<std::string> command{name_};
  if (name_ == "z3") {
    command.insert(command.end(), {"-smt2", "-in", fmt::format("-T:{}", most_seconds)});
  } else {
    command.insert(command.end(), {"--lang=smt2", fmt::format("--tlimit={}", 1000 * most_seconds)});
  }
  const auto begin = std::chrono::steady_clock::now();
  SolverAnswer answer;
  answer.text = output_of(command, script);
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::string said = first_line(answer.text);
  if (said == "unsat") {
    answer.verdict = Verdict::unsatisfiable;
  } else if (said == "sat") {
    answer.verdict = Verdict::satisfiable;
  } else if (said != "unknown" && said.find("timeout") == std::string::npos) {
    throw std::runtime_error(fmt::format("{} says: {}", name_, quoted(said)));
  }
  return answer;
}

}  // namespace fixproof
