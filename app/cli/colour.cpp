#include "app/cli/colour.hpp"

#include <unistd.h>

#include <array>
#include <cctype>
#include <cstdlib>
#include <iostream>

namespace fixproof::cli {

namespace {

constexpr std::string_view green = "\x1b[32m";
constexpr std::string_view red = "\x1b[31m";
constexpr std::string_view yellow = "\x1b[33m";
constexpr std::string_view plain = "\x1b[0m";

struct Verdict {
  std::string_view text;
  std::string_view colour;
  bool ends_line = false;  ///< it is a verdict only at the end of a line
};

/// A longer text comes before one that it contains.
constexpr std::array verdicts{Verdict{"NOT PROVEN", yellow},
                              Verdict{"NOT FOUND", red},
                              Verdict{"NOT COMPARED", yellow},
                              Verdict{"READS AN UNDEFINED FLAG", red},
                              Verdict{"USES FOREIGN MEMORY", red},
                              Verdict{"CHANGES ITS OWN CODE", red},
                              Verdict{"USES A PRIVILEGED INSTRUCTION", red},
                              Verdict{"AGREES", green},
                              Verdict{"PROVEN", green},
                              Verdict{"WRONG", red},
                              Verdict{"BROKEN", red},
                              Verdict{"BREAKS", red},
                              Verdict{"UNSTEADY", red},
                              Verdict{"STATEFUL", red},
                              Verdict{"DIFFER", red},
                              Verdict{"DIFFERS", red},
                              Verdict{"DISPROVEN", red},
                              Verdict{"GAP", red},
                              Verdict{"DISPUTED", yellow},
                              Verdict{"STOPPED", yellow},
                              Verdict{"INCOMPLETE", yellow},
                              Verdict{"First difference", red},
                              Verdict{"No difference", green},
                              Verdict{"All parties agree on every case", green},
                              Verdict{"all parties agree on every case", green},
                              Verdict{"equal", green, true}};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Returns the verdict that begins there as whole words, or null.
const Verdict* verdict_at(std::string_view line, std::size_t at) {
  if (at > 0 && is_letter(line[at - 1])) return nullptr;
  const std::string_view rest = line.substr(at);
  for (const Verdict& verdict : verdicts) {
    if (!rest.starts_with(verdict.text)) continue;
    const std::size_t end = verdict.text.size();
    if (end == rest.size() || (!verdict.ends_line && !is_letter(rest[end]))) return &verdict;
  }
  return nullptr;
}

}  // namespace

bool wants_colour() {
  const auto is_set = [](const char* name) {
    const char* const value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  if (is_set("NO_COLOR")) return false;
  if (is_set("CLICOLOR_FORCE")) return std::string_view(std::getenv("CLICOLOR_FORCE")) != "0";
  const char* const terminal = std::getenv("TERM");
  return ::isatty(STDOUT_FILENO) == 1 && terminal != nullptr &&
         std::string_view(terminal) != "dumb";
}

std::string coloured(std::string_view line) {
  std::string text;
  for (std::size_t at = 0; at < line.size();) {
    const Verdict* const verdict = verdict_at(line, at);
    if (verdict == nullptr) {
      text += line[at++];
      continue;
    }
    text.append(verdict->colour).append(verdict->text).append(plain);
    at += verdict->text.size();
  }
  return text;
}

/// Keeps a line until it ends, or until what is there must be seen.
class ColouredOutput::Buffer : public std::streambuf {
 public:
  explicit Buffer(std::streambuf* target) : target_(target) {}

  [[nodiscard]] std::streambuf* target() const { return target_; }

 protected:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char one = traits_type::to_char_type(c);
    return xsputn(&one, 1) == 1 ? c : traits_type::eof();
  }

  std::streamsize xsputn(const char* text, std::streamsize size) override {
    for (std::streamsize i = 0; i < size; ++i) {
      if (text[i] != '\n') {
        line_ += text[i];
        continue;
      }
      if (!pass_on() || traits_type::eq_int_type(target_->sputc('\n'), traits_type::eof()))
        return i;
    }
    return size;
  }

  int sync() override { return pass_on() ? target_->pubsync() : -1; }

 private:
  bool pass_on() {
    const std::string text = coloured(line_);
    line_.clear();
    const auto size = static_cast<std::streamsize>(text.size());
    return target_->sputn(text.data(), size) == size;
  }

  std::streambuf* target_;
  std::string line_;
};

ColouredOutput::ColouredOutput() : buffer_(std::make_unique<Buffer>(std::cout.rdbuf())) {
  std::cout.rdbuf(buffer_.get());
}

ColouredOutput::~ColouredOutput() {
  buffer_->pubsync();
  // With `-` for a file, the text goes to standard error.
  if (std::cout.rdbuf() == buffer_.get()) {
    const auto state = std::cout.rdstate();
    std::cout.rdbuf(buffer_->target());  // this clears the state
    std::cout.clear(state);
  }
}

}  // namespace fixproof::cli
