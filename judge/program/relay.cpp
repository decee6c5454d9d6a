#include "judge/program/relay.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <thread>

#include "support/interrupt.hpp"
#include "support/read_line.hpp"

namespace fixproof::program {

namespace {

/// Small, so that slow programs share the last cases too.
constexpr std::uint64_t cases_of_block = 256;
/// The time in which an ended program's last words arrive, and a program without output ends.
constexpr std::chrono::milliseconds grace{1000};
/// How soon an interrupt, or the end of a process, is seen at the latest.
constexpr int poll_milliseconds = 50;
/// The same once no pipe can tell.
constexpr int short_poll_milliseconds = 1;
/// Of what a program says on standard error, so much of the beginning is kept, and of the end.
constexpr std::size_t most_of_errors = 4096;

/// Returns the line that says what is wrong: the first one, but of a traceback of Python the last.
std::string telling_line(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  if (text.find("Traceback (most recent call last):") == std::string_view::npos) {
    return std::string(text.substr(0, text.find('\n')));
  }
  text = text.substr(0, text.find_last_not_of(blank) + 1);
  return std::string(text.substr(text.find_last_of('\n') + 1));
}

}  // namespace

struct Relay::Share {
  explicit Share(const std::string& command) : child(command) {}

  Child child;
  std::string to_send;
  std::size_t sent = 0;
  std::uint64_t cases = 0;    ///< that it was given
  std::uint64_t results = 0;  ///< that it has written
  std::string part;           ///< the start of a line
  std::uint64_t blank = 0;    ///< blank lines, which are errors if a result follows
  std::string lines;          ///< whole results, separated by LF
  std::size_t read = 0;       ///< how much of `lines` was returned
  std::string extra;          ///< the first line that is one too many
  std::string error;
  Clock::time_point last_active = Clock::now();
  std::optional<Child::Ending> ending;
  Clock::time_point ended_at;

  [[nodiscard]] bool has_result() const { return read < lines.size(); }
};

Relay::Relay(const RelayOptions& options, NextCase next_case)
    : options_(options), next_case_(std::move(next_case)) {}

Relay::~Relay() = default;

std::optional<std::string_view> Relay::next() {
  if (shares_.empty()) {
    for (std::size_t i = 0; i < std::max<std::size_t>(options_.processes, 1); ++i) {
      shares_.push_back(std::make_unique<Share>(options_.command));
    }
  }
  for (;;) {
    if (taken_ < given_ && owners_.front()->has_result()) {
      take_line(*owners_.front());
      if (++taken_ % cases_of_block == 0) owners_.pop_front();
      return line_;
    }
    if (fault_) return std::nullopt;
    if (taken_ < given_) {
      if (has_ended(*owners_.front())) fail(Fault::Kind::ends, *owners_.front());
    } else if (!has_more_) {
      finish();
      return std::nullopt;
    } else if (std::ranges::all_of(shares_, [&](const auto& s) { return has_ended(*s); })) {
      fail(Fault::Kind::ends, *shares_.front());
    }
    if (!fault_) pump();
  }
}

void Relay::take_line(Share& share) {
  const std::size_t end = share.lines.find('\n', share.read);
  line_.assign(share.lines, share.read, end - share.read);
  share.read = end + 1;
  // What was returned is dropped in large pieces.
  constexpr std::size_t piece = 1U << 16U;
  if (share.read > piece && share.read > share.lines.size() / 2) {
    share.lines.erase(0, share.read);
    share.read = 0;
  }
}

void Relay::finish() {
  const auto goes_on = [this](const auto& s) { return !has_ended(*s) || !s->child.ending(); };
  while (!fault_ && std::ranges::any_of(shares_, goes_on)) pump();
}

bool Relay::has_ended(const Share& share) const {
  if (!share.child.out.is_open()) return true;
  // A process that the program left behind may keep the pipe open. All that the program itself
  // wrote has been read.
  return share.ending && (share.results == share.cases ||
                          Clock::now() - std::max(share.last_active, share.ended_at) > grace);
}

void Relay::fail(Fault::Kind kind, Share& share) {
  fault_ = Fault{.kind = kind, .said = share.extra};
  if (kind == Fault::Kind::ends) {
    // Its output may end a moment before it does.
    const auto latest = Clock::now() + grace;
    while (!share.child.ending() && Clock::now() < latest) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    fault_->ending = share.child.ending();
    receive_errors(share);
  }
  fault_->error = telling_line(share.error);
}

void Relay::give() {
  for (const auto& share : shares_) {
    if (share->sent < share->to_send.size() || !share->child.in.is_open()) continue;
    share->to_send.clear();
    share->sent = 0;
    std::uint64_t count = 0;
    while (has_more_ && count < cases_of_block) {
      has_more_ = next_case_(share->to_send);
      if (has_more_) ++count;
    }
    if (count == 0) {
      share->child.in = support::Descriptor();
      continue;
    }
    given_ += count;
    share->cases += count;
    owners_.push_back(share.get());
  }
}

void Relay::send(Share& share) {
  while (share.sent < share.to_send.size()) {
    const ssize_t written = ::write(share.child.in.number(), share.to_send.data() + share.sent,
                                    share.to_send.size() - share.sent);
    if (written > 0) {
      share.sent += static_cast<std::size_t>(written);
      share.last_active = Clock::now();
    } else if (errno == EINTR) {
      continue;
    } else {
      // It may have closed its input and write on.
      if (errno != EAGAIN) share.child.in = support::Descriptor();
      return;
    }
  }
}

void Relay::add_line(Share& share, std::string_view line) {
  if (line.starts_with('#')) return;
  if (support::is_blank_or_comment(line)) {
    ++share.blank;
    return;
  }
  if (share.results + share.blank >= share.cases) {
    if (share.extra.empty()) share.extra = line;
    fail(Fault::Kind::too_many, share);
    return;
  }
  share.results += share.blank + 1;
  share.lines.append(share.blank, '\n');
  share.blank = 0;
  share.lines.append(line);
  share.lines += '\n';
}

void Relay::receive(Share& share) {
  std::array<char, 1U << 16U> buffer;
  while (share.child.out.is_open() && !fault_) {
    const ssize_t got = ::read(share.child.out.number(), buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) return;
    if (got <= 0) {
      share.child.out = support::Descriptor();
      if (!share.part.empty()) add_line(share, share.part);
      return;
    }
    share.last_active = Clock::now();
    std::string_view rest(buffer.data(), static_cast<std::size_t>(got));
    for (std::size_t end = 0; !fault_ && (end = rest.find('\n')) != std::string_view::npos;) {
      share.part.append(rest.substr(0, end));
      rest.remove_prefix(end + 1);
      if (share.part.ends_with('\r')) share.part.pop_back();
      add_line(share, share.part);
      share.part.clear();
    }
    share.part.append(rest);
    if (share.part.size() > support::longest_line) {
      // It is no result whatever follows, so nothing more is read.
      share.child.out = support::Descriptor();
      add_line(share, share.part);
    }
  }
}

void Relay::receive_errors(Share& share) {
  std::array<char, 4096> buffer;
  while (share.child.err.is_open()) {
    const ssize_t got = ::read(share.child.err.number(), buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) return;
    if (got <= 0) {
      share.child.err = support::Descriptor();
    } else {
      share.error.append(buffer.data(), static_cast<std::size_t>(got));
      if (share.error.size() > 2 * most_of_errors) {
        share.error.erase(most_of_errors, share.error.size() - 2 * most_of_errors);
      }
    }
  }
}

void Relay::pump() {
  give();
  std::vector<pollfd> waits;
  for (const auto& share : shares_) {
    const bool sends = share->sent < share->to_send.size();
    waits.push_back({sends ? share->child.in.number() : -1, POLLOUT, 0});
    waits.push_back({share->child.out.number(), POLLIN, 0});
    waits.push_back({share->child.err.number(), POLLIN, 0});
  }
  const bool can_tell = std::ranges::all_of(
      shares_, [](const auto& share) { return share->child.out.is_open() || share->ending; });
  const int milliseconds = can_tell ? poll_milliseconds : short_poll_milliseconds;
  if (::poll(waits.data(), waits.size(), milliseconds) < 0 && errno != EINTR) {
    throw std::system_error(errno, std::generic_category(), "cannot wait for the program");
  }
  const auto now = Clock::now();
  for (const auto& share : shares_) {
    if (!share->ending && (share->ending = share->child.ending())) share->ended_at = now;
    if (share->child.in.is_open()) send(*share);
    receive_errors(*share);
    receive(*share);
    if (fault_) return;
    if (support::Interrupt::flag()) {
      fail(Fault::Kind::interrupted, *share);
      return;
    }
    const bool owes = share->results < share->cases;
    const bool is_over = share->ending && has_ended(*share);
    if (!is_over && now - share->last_active > options_.silence) {
      fail(owes ? Fault::Kind::silent : Fault::Kind::never_ends, *share);
      return;
    }
  }
}

}  // namespace fixproof::program
