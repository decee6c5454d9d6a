#include "judge/program/walk.hpp"

#include "judge/check/case_words.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::program {

Steps::Steps(const cases::Variant& variant, const check::CaseOptions& options, std::uint64_t stride)
    : variant_(variant),
      cases_(std::make_unique<check::GeneratedCases>(variant, options)),
      stride_(stride),
      words_(cases::words_in(variant)) {}

bool Steps::next() {
  for (; to_skip_ > 0; --to_skip_) {
    if (!cases_->next(words_)) return false;
  }
  to_skip_ = stride_ - 1;
  return cases_->next(words_);
}

check::JudgedCase Steps::judged() const {
  check::JudgedCase one = check::case_of(variant_, words_);
  one.origin = cases_->origin();
  return one;
}

NextCase Walk::lines(std::uint64_t first, std::uint64_t end) const {
  // A std::function must be copyable.
  auto steps = std::make_shared<Steps>(variant, cases, stride);
  return [steps, first, end, at = std::uint64_t{0}, variant = variant](std::string& text) mutable {
    for (; at < first; ++at) {
      if (!steps->next()) return false;
    }
    if (at >= end || !steps->next()) return false;
    ++at;
    cases::append_operands(text, variant, steps->words());
    text += '\n';
    return true;
  };
}

}  // namespace fixproof::program
