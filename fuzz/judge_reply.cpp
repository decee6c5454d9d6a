// Target `judge_reply`: what a process that runs a user's routine sends back. The first byte
// chooses what is read: `a` replies to batches of cases, `t` a traced call, `m` a message in
// pieces. Any bytes must be refused, or give at most one answer for each case, and only the
// last may be stuck, or a trace whose accesses belong to its steps, or the message that was sent.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/finding.hpp"
#include "judge/code/message.hpp"
#include "tests/judge/code/replies.hpp"

using namespace fixproof;

namespace {

void expect(bool holds, const char* what) {
  if (!holds) fuzz::report_finding(what);
}

/// Reads an input from its front.
class Input {
 public:
  explicit Input(std::string_view bytes) : bytes_(bytes) {}

  std::string_view take(std::size_t count) {
    const std::string_view first = bytes_.substr(0, count);
    bytes_.remove_prefix(first.size());
    return first;
  }
  std::size_t number(std::size_t bytes) {
    std::size_t value = 0;
    for (const char c : take(bytes)) value = value << 8U | static_cast<unsigned char>(c);
    return value;
  }
  [[nodiscard]] bool is_empty() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

/// Each reply: why there is none, the steps that it claims, its length and its bytes.
void read_batches(Input input) {
  const std::size_t cases = input.number(2) + 1;
  const auto act = [&input](std::size_t) -> replies::Fake::Said {
    constexpr std::size_t downfalls = static_cast<std::size_t>(judge::Downfall::false_reply) + 1;
    const auto downfall = static_cast<judge::Downfall>(input.number(1) % downfalls);
    const std::uint64_t steps = input.number(8);
    return {downfall, std::string(input.take(input.number(3))), steps};
  };
  const judge::Subject subject = replies::subject();
  judge::Runner runner(subject, [&] { return std::make_unique<replies::Fake>(act); });
  const std::vector<std::uint32_t> words(cases * words_in(subject.variant), 1);
  const auto answers = runner.answers(words);
  expect(!answers.empty() && answers.size() <= cases, "another number of answers than cases");
  expect(std::all_of(answers.begin(), answers.end() - 1, judge::ended_well),
         "answers after a stuck call");
  expect(answers.size() == cases || !judge::ended_well(answers.back()), "answers are missing");
  for (const judge::Answer& answer : answers) {
    expect(answer.ending.end <= judge::End::fault, "an ending that is none");
  }
}

void read_trace(std::string_view reply) {
  const auto call = judge::read_trace(reply, judge::register_count);
  if (!call) return;
  const auto& [steps, accesses] = call->trace;
  expect(
      steps.size() * sizeof(judge::Step) + accesses.size() * sizeof(judge::Access) < reply.size(),
      "more than was sent");
  for (const judge::Step& step : steps) {
    expect(step.bytes <= 15 && step.registers.has_own_segments, "an instruction that is none");
  }
  for (const judge::Access& access : accesses) {
    expect(access.step < steps.size() && access.bytes <= 64, "an access of no step");
  }
}

void read_message(Input input) {
  const std::size_t longest = input.number(1);
  judge::IncomingMessage message(longest);
  std::string sent;
  while (message.state() == judge::IncomingMessage::State::incomplete && !input.is_empty()) {
    const std::string_view piece = input.take(input.number(1) + 1);
    message.add(piece);
    sent += piece;
  }
  if (message.state() != judge::IncomingMessage::State::whole) return;
  const std::string got = message.take();
  expect(got.size() <= longest && judge::length_of(got) + got == sent, "another message");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(data, data + size);
  if (bytes.empty()) return 0;
  const std::string_view rest = std::string_view(bytes).substr(1);
  if (bytes[0] == 'a') read_batches(Input(rest));
  if (bytes[0] == 't') read_trace(rest);
  if (bytes[0] == 'm') read_message(Input(rest));
  return 0;
}
