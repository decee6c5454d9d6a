// Target `capture_file`: a file of captured instructions, JSON or MOO, plain or gzip. The first
// byte chooses the processor, the second the kind of damage, the next two its position. A file must
// give cases or raise a UsageError. Compressed, it must give the same cases and verdicts.
// Compressed and damaged, it must give the same or raise a UsageError.
#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fuzz/finding.hpp"
#include "fuzz/memory_file.hpp"
#include "support/usage_error.hpp"
#include "verify/singlestep/judge.hpp"
#include "verify/singlestep/read.hpp"

using namespace fixproof;

namespace {

using x86model::Cpu;

constexpr std::size_t header_size = 4;

/// Everything that a file gives.
struct Reading {
  std::vector<std::string> cases;
  std::string refused;  ///< empty if the file is read to its end

  friend bool operator==(const Reading&, const Reading&) = default;
};

std::string text_of(const singlestep::State& state) {
  std::string text;
  for (const auto& value : state.registers) text += value ? fmt::format(" {:x}", *value) : " -";
  for (const auto& [address, byte] : state.ram) text += fmt::format(" {:x}:{:x}", address, byte);
  return text;
}

std::string text_of(const singlestep::Case& c, Cpu cpu) {
  std::string text = fmt::format("{} {}", c.index, c.name);
  for (const std::uint8_t byte : c.bytes) text += fmt::format(" {:02x}", byte);
  text += text_of(c.initial) + text_of(c.final);
  const auto verdict = singlestep::judge(c, cpu);
  if (const auto* differences = std::get_if<singlestep::Differences>(&verdict)) {
    for (const std::string& one : *differences) text += "; " + one;
    return text;
  }
  return text + fmt::format("; skipped {}", verdict.index());
}

Reading read(std::string_view bytes, Cpu cpu) {
  const fuzz::MemoryFile file(bytes);
  Reading reading;
  try {
    singlestep::read_cases(file.path(), cpu, [&](const singlestep::Case& c) {
      reading.cases.push_back(text_of(c, cpu));
    });
    if (reading.cases.empty()) fuzz::report_finding("read without a case and without a refusal");
  } catch (const support::UsageError& error) {
    reading.refused = error.what();
    if (!reading.refused.starts_with(file.path() + ": ")) {
      fuzz::report_finding("the file is not named: " + reading.refused);
    }
    reading.refused.erase(0, file.path().size());
  } catch (const std::exception& error) {
    fuzz::report_finding(fmt::format("not a UsageError: {}", error.what()));
  }
  return reading;
}

/// One gzip member.
std::string compressed(std::string_view bytes) {
  z_stream stream{};
  constexpr int gzip_only = 16;
  constexpr int usual_memory = 8;
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS + gzip_only, usual_memory,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    fuzz::report_finding("zlib cannot compress");
  }
  std::vector<Bytef> packed(deflateBound(&stream, bytes.size()));
  stream.next_in = reinterpret_cast<const Bytef*>(  // NOLINT(*-reinterpret-cast): zlib's bytes
      bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = packed.data();
  stream.avail_out = static_cast<uInt>(packed.size());
  const int status = deflate(&stream, Z_FINISH);
  std::string text(packed.data(), stream.next_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) fuzz::report_finding("zlib does not finish");
  return text;
}

std::string damaged(std::string bytes, char kind, std::size_t at) {
  if (kind == 'c') {
    bytes.resize(at % bytes.size());
  } else {
    at %= bytes.size() * 8;
    bytes[at / 8] = static_cast<char>(bytes[at / 8] ^ (1 << at % 8));
  }
  return bytes;
}

[[noreturn]] void report(const std::string& what, const Reading& plain, const Reading& other) {
  fuzz::report_finding(
      fmt::format("{}\n  plain: {} cases, refused: '{}'\n  other: {} cases, refused: '{}'", what,
                  plain.cases.size(), plain.refused, other.cases.size(), other.refused));
}

void check(std::string_view content, Cpu cpu, char damage, std::size_t at) {
  const Reading plain = read(content, cpu);
  // Such data can only be read: compressed once more it would be another file.
  if (content.starts_with("\x1f\x8b")) return;
  const std::string packed = compressed(content);
  if (const Reading other = read(packed, cpu); other != plain) {
    report("compressed, it is read otherwise", plain, other);
  }
  const std::size_t cut = at % (content.size() + 1);
  const std::string first_member = compressed(content.substr(0, cut));
  const std::string members = first_member + compressed(content.substr(cut));
  if (const Reading other = read(members, cpu); other != plain) {
    report(fmt::format("in two members, cut at {}, it is read otherwise", cut), plain, other);
  }
  if (damage != 'c' && damage != 'f') return;
  const auto judge = [&](const std::string& whole) {
    const std::string bytes = damaged(whole, damage, at);
    const Reading other = read(bytes, cpu);
    // Without its second member, the file is sound and ends early.
    if (bytes == first_member) return;
    if (other.refused.empty() && other != plain) {
      report(fmt::format("damaged ({} at {}), it gives other cases", damage, at), plain, other);
    }
  };
  judge(packed);
  judge(members);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < header_size) return 0;
  constexpr std::array cpus{Cpu::i8088, Cpu::i386, Cpu::i286};
  // Letters number the processors, from `m`.
  const Cpu cpu = cpus[(data[0] - std::size_t{'m'}) % cpus.size()];
  const std::size_t at = std::size_t{data[2]} << 8U | data[3];
  const std::string content(data + header_size, data + size);
  check(content, cpu, static_cast<char>(data[1]), at);
  return 0;
}
