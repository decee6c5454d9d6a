#include "app/cli/lines.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "app/cli/print_error.hpp"
#include "support/read_line.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

void write(std::ostream& out, std::string& pending) {
  out.write(pending.data(), static_cast<std::streamsize>(pending.size()));
  out.flush();
  pending.clear();
  if (!out) throw OutputLost();
}

}  // namespace

void answer_lines(std::istream& in, std::ostream& out,
                  const std::function<void(std::string_view, std::string&)>& answer) {
  constexpr std::size_t flush_size = 1U << 16U;
  std::string line;
  std::string pending;
  for (std::uint64_t number = 1;; ++number) {
    try {
      if (!support::read_line(in, line)) break;
      if (support::is_blank_or_comment(line)) continue;
      answer(line, pending);
    } catch (const support::UsageError& error) {
      write(out, pending);
      throw support::UsageError(fmt::format("line {}: {}", number, error.what()));
    } catch (...) {
      write(out, pending);
      throw;
    }
    pending += '\n';
    if (pending.size() > flush_size || in.rdbuf()->in_avail() <= 0) write(out, pending);
  }
  write(out, pending);
}

}  // namespace fixproof::cli
