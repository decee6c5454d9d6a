#include "judge/runner.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace fixproof::judge {

namespace {

using std::chrono::milliseconds;

/// A call that takes longer counts as endless. Most take microseconds, but a busy machine may not
/// run the process for a second. Unicorn has its own limit, too.
constexpr milliseconds time_of_case{3000};
constexpr std::size_t cases_of_batch = 4096;

/// Unicorn maps 1 GiB for translated code. The rest is for replies.
constexpr std::size_t memory_for_code = std::size_t{1} << 26U;
constexpr std::size_t memory_for_unicorn = std::size_t{3} << 29U;

template <class T>
std::span<const T> read_as(std::string_view bytes, std::vector<T>& room) {
  static_assert(std::is_trivially_copyable_v<T>);
  room.resize(bytes.size() / sizeof(T));
  // Even for no bytes, memcpy must not get a null pointer.
  if (!room.empty()) std::memcpy(room.data(), bytes.data(), room.size() * sizeof(T));
  return room;
}

template <class T>
void append(std::string& to, const T* first, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the bytes of values
  to.append(reinterpret_cast<const char*>(first), count * sizeof(T));
}

std::string bytes_of(std::span<const std::uint32_t> words) {
  std::string bytes;
  append(bytes, words.data(), words.size());
  return bytes;
}

Answer answer_of(Machine& machine, Call& call, const cases::Variant& variant,
                 std::span<const std::uint32_t> words, std::uint64_t number) {
  Registers registers;
  call.enter(machine.memory(), registers, words, number);
  Answer answer;
  answer.ending = machine.call(registers);
  if (answer.ending.end != End::returned) return answer;
  answer.broken = static_cast<std::uint16_t>(call.broken(registers));
  answer.changed = static_cast<std::uint16_t>(call.changed(registers));
  call.leave(machine.memory(), registers, std::span(answer.words).first(words_out(variant)));
  return answer;
}

/// Serves batches: a request has the words of the cases, and the reply has their answers.
Confined::Serve serve_batches(const Subject& subject, On on, Confined::Steps& steps) {
  std::shared_ptr<Machine> machine =
      on == On::processor ? make_processor(subject.image) : make_emulator(subject.image, nullptr);
  const auto call = std::make_shared<Call>(subject.image, subject.frame, subject.variant,
                                           machine->code_selector());
  return [machine, call, &subject, &steps, number = std::uint64_t{0},
          room = std::vector<std::uint32_t>(),
          answers = std::vector<Answer>()](std::string_view request) mutable {
    const auto words = read_as(request, room);
    const std::size_t in = words_in(subject.variant);
    answers.clear();
    for (std::size_t at = 0; at + in <= words.size(); at += in) {
      answers.push_back(
          answer_of(*machine, *call, subject.variant, words.subspan(at, in), number++));
      ++steps;
      if (!ended_well(answers.back())) break;
    }
    std::string reply;
    append(reply, answers.data(), answers.size());
    return reply;
  };
}

/// Serves one call: the request has its words, and the reply has the answer, the number of steps,
/// the steps and the accesses.
Confined::Serve serve_trace(const Subject& subject) {
  const auto trace = std::make_shared<Trace>();
  const std::shared_ptr<Machine> machine = make_emulator(subject.image, trace.get());
  return [trace, machine, &subject,
          room = std::vector<std::uint32_t>()](std::string_view request) mutable {
    Call call(subject.image, subject.frame, subject.variant, machine->code_selector());
    const Answer answer = answer_of(*machine, call, subject.variant, read_as(request, room), 0);
    std::string reply;
    append(reply, &answer, 1);
    const auto steps = static_cast<std::uint32_t>(trace->steps.size());
    append(reply, &steps, 1);
    append(reply, trace->steps.data(), trace->steps.size());
    append(reply, trace->accesses.data(), trace->accesses.size());
    return reply;
  };
}

}  // namespace

bool ended_well(const Answer& answer) {
  return answer.ending.end == End::returned || answer.ending.end == End::divide_error;
}

Runner::Runner(const Subject& subject, On machine) : subject_(subject), machine_(machine) {}

Reply Runner::ask(std::span<const std::uint32_t> words) {
  if (!child_ || !child_->is_alive()) {
    child_ = std::make_unique<Confined>(
        [this](Confined::Steps& steps) { return serve_batches(subject_, machine_, steps); },
        machine_ == On::processor ? memory_for_code : memory_for_unicorn);
  }
  Reply reply = child_->ask(bytes_of(words), time_of_case);
  if (reply.downfall == Downfall::none &&
      (reply.bytes.empty() || reply.bytes.size() % sizeof(Answer) != 0)) {
    child_.reset();
    reply.downfall = Downfall::crashed;
  }
  if (reply.downfall != Downfall::none) downfall_ = reply.downfall;
  return reply;
}

std::vector<Answer> Runner::answers(std::span<const std::uint32_t> words) {
  const std::size_t in = words_in(subject_.variant);
  std::vector<Answer> all;
  std::vector<Answer> room;
  for (std::size_t at = 0; at < words.size();) {
    const auto some = words.subspan(at, std::min(cases_of_batch * in, words.size() - at));
    Reply reply = ask(some);
    std::optional<Answer> dead;
    if (reply.downfall != Downfall::none) {
      dead.emplace();
      dead->ending.end = reply.downfall == Downfall::out_of_time ? End::endless : End::fault;
      // The answers before that case died with the process: ask again.
      const std::size_t before =
          std::min<std::size_t>(child_ ? child_->steps() : 0, some.size() / in - 1);
      if (before > 0) reply = ask(some.first(before * in));
    }
    const auto answers = read_as(reply.bytes, room);
    all.insert(all.end(), answers.begin(), answers.end());
    if (dead) all.push_back(*dead);
    if (all.empty() || !ended_well(all.back())) break;
    at += some.size();
  }
  return all;
}

std::optional<TracedCall> traced(const Subject& subject, std::span<const std::uint32_t> words) {
  Confined child([&subject](Confined::Steps&) { return serve_trace(subject); }, memory_for_unicorn);
  const Reply reply = child.ask(bytes_of(words), 5 * time_of_case);
  std::string_view bytes = reply.bytes;
  TracedCall call;
  std::uint32_t steps = 0;
  if (bytes.size() < sizeof call.answer + sizeof steps) return std::nullopt;
  std::memcpy(&call.answer, bytes.data(), sizeof call.answer);
  bytes.remove_prefix(sizeof call.answer);
  std::memcpy(&steps, bytes.data(), sizeof steps);
  bytes.remove_prefix(sizeof steps);
  if (bytes.size() < steps * sizeof(Step)) return std::nullopt;
  read_as(bytes.substr(0, steps * sizeof(Step)), call.trace.steps);
  read_as(bytes.substr(steps * sizeof(Step)), call.trace.accesses);
  return call;
}

}  // namespace fixproof::judge
