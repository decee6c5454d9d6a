// Target `recorder_log`: two logs of record::log. The first byte says whether the target corrects
// the checksums of the pages, so that damage to what is in them is seen; the second one is the
// number of pages of the first log. A log must be read or refused by name. It must not differ from
// itself, and two logs must have the same first difference whichever comes first.
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "fixed/record/hash.hpp"
#include "fixed/record/layout.hpp"
#include "fuzz/finding.hpp"
#include "fuzz/memory_file.hpp"
#include "judge/desync/compare.hpp"
#include "judge/desync/log_file.hpp"
#include "judge/desync/values.hpp"
#include "support/usage_error.hpp"

using namespace fixproof;

namespace {

using desync::Comparison;
using desync::LogFile;
using desync::Verdict;
using record::word;

/// Writes the right checksum into every whole page.
void seal(std::string& bytes) {
  constexpr std::size_t hash_at = 7;
  for (std::size_t start = 0; start + record::page_bytes <= bytes.size();
       start += record::page_bytes) {
    std::array<word, record::page_words> page{};
    for (std::size_t i = 0; i < record::page_bytes; ++i) {
      const word byte = static_cast<unsigned char>(bytes[start + i]);
      page[i / sizeof(word)] |= byte << (8 * (i % sizeof(word)));
    }
    page[hash_at] = 0;
    const word hash = record::hash_words(page.data(), page.size());
    for (std::size_t i = 0; i < sizeof(word); ++i) {
      bytes[start + hash_at * sizeof(word) + i] = static_cast<char>(hash >> (8 * i) & 0xff);
    }
  }
}

/// Reads everything that `fixproof desync` may print about a side. Reads a name once for a sequence
/// of records, because that takes longer than all else.
void read_side(LogFile& log, const desync::Side& side) {
  word file = 0;
  word mark = 0;
  for (const desync::Record& record : side.records) {
    (void)desync::text_of(desync::operation_of(record.words));
    if (std::exchange(file, record.file) != record.file) (void)log.name(file);
    if (std::exchange(mark, record.name) != record.name) (void)log.name_with_hash(mark);
  }
}

/// What a comparison says; nothing if a log is refused.
std::optional<Comparison> compare(const fuzz::MemoryFile& a, const fuzz::MemoryFile& b,
                                  bool last_frames) {
  try {
    LogFile first(a.path());
    LogFile second(b.path());
    Comparison found =
        last_frames ? desync::compare_last_frames(first, second) : desync::compare(first, second);
    read_side(first, found.a);
    read_side(second, found.b);
    return found;
  } catch (const support::UsageError& error) {
    const std::string_view said = error.what();
    if (!said.starts_with(a.path() + ": ") && !said.starts_with(b.path() + ": ")) {
      fuzz::report_finding(fmt::format("the log is not named: {}", said));
    }
  } catch (const std::exception& error) {
    fuzz::report_finding(fmt::format("not a UsageError: {}", error.what()));
  }
  return std::nullopt;
}

void check(const std::string& a_bytes, const std::string& b_bytes) {
  const fuzz::MemoryFile a(a_bytes);
  const fuzz::MemoryFile b(b_bytes);
  for (const bool last_frames : {false, true}) {
    const auto itself = compare(a, a, last_frames);
    if (itself && itself->verdict != Verdict::equal && itself->verdict != Verdict::ended) {
      fuzz::report_finding(
          fmt::format("a log differs from itself: verdict {}", static_cast<int>(itself->verdict)));
    }
    const auto one = compare(a, b, last_frames);
    const auto other = compare(b, a, last_frames);
    if (one.has_value() != other.has_value()) {
      fuzz::report_finding("logs are refused in one order and not in the other");
    }
    if (one && (one->verdict != other->verdict || one->a.block != other->b.block ||
                one->b.block != other->a.block)) {
      fuzz::report_finding(
          fmt::format("verdict {} in blocks {} and {}; in the other order {} in {} and {}",
                      static_cast<int>(one->verdict), one->a.block, one->b.block,
                      static_cast<int>(other->verdict), other->a.block, other->b.block));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t before_logs = 2;
  if (size < before_logs) return 0;
  std::string a(data + before_logs, data + size);
  const std::size_t first_size = std::size_t{data[1]} * record::page_bytes;
  std::string b = first_size < a.size() ? a.substr(first_size) : "";
  a.resize(a.size() - b.size());
  if (data[0] == 's') {
    seal(a);
    seal(b);
  }
  check(a, b);
  return 0;
}
