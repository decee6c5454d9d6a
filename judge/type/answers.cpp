#include "judge/type/answers.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>

#include "support/file.hpp"
#include "support/plain_text.hpp"
#include "support/sha256.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

/// A stop without warning loses at most as many answers.
constexpr std::size_t answers_between_writes = 100;
constexpr std::size_t digits_of_digest = 64;

}  // namespace

Answers::Answers(const std::string& path, const std::string& asked)
    : head_("questions without a counterexample, as SHA-256; asked: " + asked + '\n') {
  if (path.empty()) return;
  if (std::filesystem::exists(path)) {
    std::istringstream text(support::read_file(path));
    std::string line;
    std::getline(text, line);
    if (line + '\n' != head_) {
      throw support::UsageError(fmt::format("{}: its first line is not '{}'; name another file",
                                            support::quoted(path),
                                            head_.substr(0, head_.size() - 1)));
    }
    while (std::getline(text, line)) {
      if (line.size() != digits_of_digest ||
          line.find_first_not_of("0123456789abcdef") != std::string::npos) {
        throw support::UsageError(
            fmt::format("{}: {} is no digest", support::quoted(path), support::quoted(line)));
      }
      proven_.insert(line);
    }
  }
  file_.emplace(path);
}

proof::SolverAnswer Answers::operator()(const std::string& script,
                                        const std::function<proof::SolverAnswer()>& ask) {
  const std::string digest = support::sha256_hex(script);
  {
    const std::lock_guard lock(mutex_);
    if (proven_.contains(digest)) {
      ++remembered_;
      return {.verdict = proof::Satisfiability::unsatisfiable};
    }
  }
  proof::SolverAnswer answer = ask();
  if (answer.verdict == proof::Satisfiability::unsatisfiable) {
    const std::lock_guard lock(mutex_);
    proven_.insert(digest);
    if (++unsaved_ >= answers_between_writes) write();
  }
  return answer;
}

void Answers::save() {
  const std::lock_guard lock(mutex_);
  if (unsaved_ > 0) write();
}

void Answers::write() {
  unsaved_ = 0;
  if (!file_) return;
  std::string text = head_;
  for (const std::string& digest : proven_) text += digest + '\n';
  file_->replace(text);
}

}  // namespace fixproof::judge
