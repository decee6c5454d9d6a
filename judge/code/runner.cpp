#include "judge/code/runner.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <set>
#include <type_traits>
#include <utility>

#include "judge/code/ndisasm.hpp"
#include "verify/machine_code/emulator.hpp"

namespace fixproof::judge {

namespace {

using std::chrono::milliseconds;

/// A call that takes longer counts as endless. Most take microseconds, but a busy machine may not
/// run the process for a second. Unicorn has its own limit, too.
constexpr milliseconds time_of_case{3000};
/// A process that claims a step every now and then must end, too.
constexpr milliseconds time_of_batch{60'000};
constexpr std::size_t cases_in_flight = 4096;
/// A traced call has at most 100,000 steps.
constexpr std::size_t longest_trace = std::size_t{1} << 26U;

/// Unicorn maps 1 GiB for translated code. The rest is for replies.
constexpr std::size_t memory_for_code = std::size_t{1} << 26U;
constexpr std::size_t memory_for_unicorn = std::size_t{3} << 29U;

/// @param bytes of whole values
template <class T>
void read_as(std::string_view bytes, std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  values.resize(bytes.size() / sizeof(T));
  // Even for no bytes, memcpy must not get a null pointer.
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
}

/// Reads a value from the beginning of `bytes`, and removes it there.
template <class T>
bool read_first(std::string_view& bytes, T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (bytes.size() < sizeof value) return false;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return true;
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

/// Serves batches: a request has the words of the cases, and the reply has their answers.
Confined::Serve serve_batches(const Subject& subject, On on, Confined::Steps& steps) {
  const std::shared_ptr<Caller> caller = make_caller(subject, on, nullptr);
  return [caller, &subject, &steps, number = std::uint64_t{0}, room = std::vector<std::uint32_t>(),
          answers = std::vector<Answer>()](std::string_view request) mutable {
    read_as(request, room);
    const std::span<const std::uint32_t> words = room;
    const std::size_t in = words_in(subject.variant);
    answers.clear();
    for (std::size_t at = 0; at + in <= words.size(); at += in) {
      answers.push_back(caller->answer(words.subspan(at, in), number++));
      ++steps;
      if (!ended_well(answers.back())) break;
    }
    std::string reply;
    append(reply, answers.data(), answers.size());
    return reply;
  };
}

/// Whether this process may have as much memory as Unicorn takes, which ends a process that may
/// not.
bool has_room_for_unicorn() {
  void* const room = mmap(nullptr, memory_for_unicorn, PROT_READ | PROT_WRITE,
                          MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) return false;
  munmap(room, memory_for_unicorn);
  return true;
}

/// Returns where an access is in Image::memory; nothing if it is not all there.
std::optional<std::size_t> index_of(const Image& image, const Access& access) {
  const std::uint64_t at = access.address - image.base;
  const std::size_t size = image.memory.size();
  if (access.bytes == 0 || at >= size || access.bytes > size - at) return std::nullopt;
  return at;
}

/// Whether what a call wrote can be put back for the next one. Of other processors, a trace lacks
/// some writes, such as those of MVC on s390x, and calls leave registers behind. Unicorn keeps a
/// translation of code, by pages: no page with code may have changed, and a call that does not
/// return may have more of it than its steps.
bool can_be_undone(const Image& image, const TracedCall& call) {
  if (image.architecture != nullptr || call.answer.ending.end != End::returned) return false;
  constexpr std::uint64_t page = 0x1000;
  std::set<std::uint64_t> pages;
  for (const Step& step : call.trace.steps) {
    const std::uint64_t at = image.index_of(image.code_at(step.at));
    if (at >= image.memory.size()) return false;
    pages.insert({at / page, (at + step.bytes) / page});
  }
  return std::ranges::all_of(call.trace.accesses, [&](const Access& access) {
    const auto at = index_of(image, access);
    return access.is_write == 0 ||
           (at && !pages.contains(*at / page) && !pages.contains((*at + access.bytes - 1) / page));
  });
}

/// Serves calls: a request has the words of one, and the reply has the answer, the number of steps,
/// the steps and the accesses. Each call finds the memory that the first one found.
/// @param fresh that memory
Confined::Serve serve_traces(const Image& image, Caller& caller, Trace& trace,
                             const std::vector<std::uint8_t>& fresh) {
  return [&, room = std::vector<std::uint32_t>()](std::string_view request) mutable {
    for (const Access& access : trace.accesses) {
      const auto at = index_of(image, access);
      if (access.is_write != 0 && at) {
        std::copy_n(fresh.data() + *at, access.bytes, caller.memory() + *at);
      }
    }
    trace.steps.clear();
    trace.accesses.clear();
    read_as(request, room);
    const Answer answer = caller.answer(room, 0);
    std::string reply;
    append(reply, &answer, 1);
    const auto steps = static_cast<std::uint32_t>(trace.steps.size());
    append(reply, &steps, 1);
    append(reply, trace.steps.data(), trace.steps.size());
    append(reply, trace.accesses.data(), trace.accesses.size());
    return reply;
  };
}

}  // namespace

namespace {

bool is_possible(const Answer& answer, std::size_t register_count) {
  const RegisterMask registers = (RegisterMask{1} << register_count) - 1;
  const RegisterMask broken = registers | Call::sets_direction | Call::fills_x87 |
                              Call::controls_x87 | Call::moves_segments;
  return answer.ending.end <= End::fault && (answer.broken & ~broken) == 0 &&
         (answer.changed & ~registers) == 0;
}

}  // namespace

std::optional<std::vector<Answer>> read_answers(std::string_view reply, std::size_t asked,
                                                std::size_t registers) {
  const std::size_t count = reply.size() / sizeof(Answer);
  if (count == 0 || count > asked || reply.size() % sizeof(Answer) != 0) return std::nullopt;
  std::vector<Answer> answers;
  read_as(reply, answers);
  for (const Answer& answer : answers) {
    const bool is_last = &answer == &answers.back();
    if (!is_possible(answer, registers) || (!is_last && !ended_well(answer))) return std::nullopt;
  }
  if (count < asked && ended_well(answers.back())) return std::nullopt;
  return answers;
}

std::optional<TracedCall> read_trace(std::string_view reply, std::size_t registers) {
  TracedCall call;
  std::uint32_t steps = 0;
  if (!read_first(reply, call.answer) || !is_possible(call.answer, registers) ||
      !read_first(reply, steps) || reply.size() / sizeof(Step) < steps) {
    return std::nullopt;
  }
  const std::size_t bytes_of_steps = steps * sizeof(Step);
  if ((reply.size() - bytes_of_steps) % sizeof(Access) != 0) return std::nullopt;
  read_as(reply.substr(0, bytes_of_steps), call.trace.steps);
  for (Step& step : call.trace.steps) {
    step.registers.has_own_segments = true;  // only after a call; and a false byte is no bool
    // Unicorn gives an instruction that it does not know a length of billions.
    step.bytes = std::min(step.bytes, longest_instruction);
  }
  read_as(reply.substr(bytes_of_steps), call.trace.accesses);
  for (const Access& access : call.trace.accesses) {
    constexpr std::uint32_t widest_access = 64;
    if (access.step >= steps || access.bytes > widest_access) return std::nullopt;
  }
  return call;
}

Runner::Runner(const Subject& subject, Start start) : subject_(subject), start_(std::move(start)) {}

Runner::Runner(const Subject& subject, On machine)
    : Runner(subject, [&subject, machine]() -> std::unique_ptr<Server> {
        const auto prepare = [&subject, machine](Confined::Steps& steps) {
          return serve_batches(subject, machine, steps);
        };
        const bool is_native = machine == On::processor;
        return std::make_unique<Confined>(prepare, is_native ? memory_for_code : memory_for_unicorn,
                                          is_native ? Calls::fewest : Calls::emulator);
      }) {}

Runner::Batch Runner::ask(std::span<const std::uint32_t> words) {
  if (!server_ || !server_->is_alive()) server_ = start_();
  const std::size_t cases = words.size() / words_in(subject_.variant);
  const Reply reply = server_->ask(bytes_of(words), {.step = time_of_case,
                                                     .whole = time_of_batch,
                                                     .steps = cases,
                                                     .bytes = cases * sizeof(Answer)});
  downfall_ = reply.downfall != Downfall::none ? reply.downfall : downfall_;
  if (reply.downfall != Downfall::none) return {reply.downfall};
  if (auto answers = read_answers(reply.bytes, cases, registers_of(subject_.image)))
    return {.answers = std::move(*answers)};
  server_.reset();
  downfall_ = Downfall::false_reply;
  return {downfall_};
}

std::vector<Answer> Runner::answers(std::span<const std::uint32_t> words) {
  const std::size_t in = words_in(subject_.variant);
  std::vector<Answer> all;
  for (std::size_t at = 0; at < words.size();) {
    const auto some = words.subspan(at, std::min(cases_in_flight * in, words.size() - at));
    Batch batch = ask(some);
    if (batch.downfall != Downfall::none) {
      Answer dead;
      dead.ending.end = batch.downfall == Downfall::out_of_time ? End::endless : End::fault;
      // The answers before that case died with the process: ask again.
      const std::size_t before =
          std::min<std::size_t>(server_ ? server_->steps() : 0, some.size() / in - 1);
      if (before > 0) batch = ask(some.first(before * in));
      if (batch.answers.empty() || ended_well(batch.answers.back())) batch.answers.push_back(dead);
    }
    all.insert(all.end(), batch.answers.begin(), batch.answers.end());
    if (!ended_well(all.back())) break;
    at += some.size();
  }
  return all;
}

Tracer::Tracer(const Subject& subject) : subject_(subject) {
  if (!has_room_for_unicorn()) return;
  try {
    caller_ = make_caller(subject, On::unicorn, &trace_);
    if (subject.image.architecture != nullptr) return;
    fresh_.assign(caller_->memory(), caller_->memory() + subject.image.memory.size());
  } catch (const machine_code::EmulatorError&) {
    caller_.reset();
  } catch (const std::bad_alloc&) {
    caller_.reset();
  }
}

std::optional<TracedCall> Tracer::call(std::span<const std::uint32_t> words) {
  if (!caller_) return std::nullopt;
  const Image& image = subject_.image;
  if (!child_) {
    child_ = std::make_unique<Confined>(
        [&](Confined::Steps&) { return serve_traces(image, *caller_, trace_, fresh_); },
        memory_for_unicorn, Calls::emulator);
  }
  const Reply reply = child_->ask(
      bytes_of(words),
      {.step = 5 * time_of_case, .whole = 5 * time_of_case, .steps = 0, .bytes = longest_trace});
  auto call = read_trace(reply.bytes, registers_of(image));
  if (!call || !can_be_undone(image, *call)) child_.reset();
  return call;
}

}  // namespace fixproof::judge
