// Target `report_file`: reads the input as a report of `verify --report`. The reader must throw the
// documented std::runtime_error, or the writer must reproduce the input byte for byte. The target
// then seals the text, as it is and in the writer's layout, so that changed counts reach the checks
// behind the digest. A report that is read must not merge with itself, and its two halves must add
// up to it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fuzz/finding.hpp"
#include "support/json.hpp"
#include "support/sha256.hpp"
#include "verify/merge.hpp"
#include "verify/report_json.hpp"

using namespace fixproof;

namespace {

/// Computes the digest independently, so that the target notices if reader and writer both omit it.
std::string seal(std::string_view content) {
  return fmt::format(" \"digest\": \"{}\"\n}}\n", support::sha256_hex(content));
}

std::optional<verify::Report> read(const std::string& text) {
  try {
    return verify::from_json(text);
  } catch (const std::runtime_error& error) {
    const std::string_view said = error.what();
    if (said.empty()) fuzz::report_finding("refused without a reason");
  } catch (const std::exception& error) {
    fuzz::report_finding(fmt::format("not a std::runtime_error: {}", error.what()));
  }
  return std::nullopt;
}

std::string content_of(const std::string& text) {
  return text.substr(0, text.rfind(" \"digest\""));
}

void check_written(const verify::Report& report, const std::string& text) {
  const std::string written = verify::to_json(report);
  if (written != text) fuzz::report_finding("written otherwise than it was read:\n" + written);
  const std::string content = content_of(text);
  if (content + seal(content) != text) fuzz::report_finding("read with a wrong digest");
}

/// Shard `index` of two: the chunks that it has, and the mismatches in them.
verify::Report half(const verify::Report& whole, std::uint64_t index) {
  verify::Report part(whole.plan, cases::Shard{index, 2}, whole.max_shown);
  for (std::uint64_t number = 0; number < whole.done.size(); ++number) {
    if (!whole.done[number] || !part.shard.has(number)) continue;
    const cases::Chunk chunk = whole.plan.chunk(number);
    verify::Findings found;
    found.cases = chunk.cases;
    found.faults = whole.chunks[number].faults;
    found.mismatches = whole.chunks[number].mismatches;
    for (const verify::Mismatch& m : whole.findings[chunk.job->row].shown) {
      if (m.chunk == number) found.shown.push_back(m);
    }
    if (found.shown.size() > found.mismatches) {
      fuzz::report_finding(fmt::format("chunk {} shows more mismatches than it counts", number));
    }
    part.add(number, {found, whole.chunks[number].answers});
  }
  part.seconds = index == 1 ? whole.seconds : 0;
  part.makers = whole.makers;
  return part;
}

void check_merge(const verify::Report& report) {
  if (report.chunks_done() > 0) {
    const std::array twice{verify::NamedReport{"a", report}, verify::NamedReport{"b", report}};
    bool refused = false;
    try {
      verify::merged(twice, true);
    } catch (const std::runtime_error&) {
      refused = true;
    }
    if (!refused) fuzz::report_finding("a report is merged with itself");
  }
  if (report.shard != cases::Shard{}) return;
  const std::array halves{verify::NamedReport{"a", half(report, 1)},
                          verify::NamedReport{"b", half(report, 2)}};
  try {
    const verify::Report sum = verify::merged(halves, true);
    // The halves must add up to the report, byte for byte.
    if (verify::to_json(sum) != verify::to_json(report)) {
      fuzz::report_finding("its halves give another report:\n" + verify::to_json(sum));
    }
  } catch (const std::runtime_error& error) {
    fuzz::report_finding(fmt::format("its halves are refused: {}", error.what()));
  }
}

void check(const std::string& text) {
  const auto report = read(text);
  if (!report) return;
  check_written(*report, text);
  check_merge(*report);
}

/// The text in the layout of the writer, without its digest; nothing if it is not an object.
std::optional<std::string> laid_out(const std::string& text) {
  // The writer's own type keeps the order of the keys.
  support::Json json = support::Json::parse(text, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  json.erase("digest");
  try {
    std::string laid = json.dump(1);
    constexpr std::string_view end = "\n}";
    if (!laid.ends_with(end)) return std::nullopt;
    laid.replace(laid.size() - end.size(), std::string::npos, ",\n");
    return laid;
  } catch (const support::Json::exception&) {
    return std::nullopt;  // Not UTF-8.
  }
}

/// Returns whether the text nests so deeply that laying it out, which is recursive, could overflow
/// the stack. from_json() already refuses more than 16 levels.
bool is_deep(std::string_view text) {
  constexpr int deepest = 200;
  int depth = 0;
  return std::any_of(text.begin(), text.end(), [&](char c) {
    depth += (c == '[' || c == '{') ? 1 : (c == ']' || c == '}') ? -1 : 0;
    return depth > deepest;
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  check(text);
  const std::string content = content_of(text);
  check(content + seal(content));
  if (is_deep(text)) return 0;
  if (const auto laid = laid_out(text)) check(*laid + seal(*laid));
  return 0;
}
