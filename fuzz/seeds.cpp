// Writes the initial inputs of every target, from the generators in verify/, in the target's
// format. usage: fuzz_seeds FOLDER SCENES VECTORS; FOLDER gets one folder per target.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/corpus.hpp"
#include "fuzz/log_seeds.hpp"
#include "fuzz/reply_seeds.hpp"
#include "fuzz/step_case.hpp"
#include "fuzz/word_target.hpp"
#include "fuzz/words.hpp"
#include "oracle/decimal.hpp"
#include "support/error_text.hpp"
#include "verify/cases/draw.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"
#include "verify/cases/words.hpp"
#include "verify/maker.hpp"
#include "verify/report_json.hpp"

using namespace fixproof;
using fuzz::Corpus;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t seed = 1994;

/// Calls `each(words)` for evenly spread cases of every stream of the variant.
template <class Each>
void some_cases(const cases::Variant& variant, std::uint64_t of_each_stream, Each each) {
  const cases::Plan plan(1, seed, {{variant, {"a", "b"}}});
  std::vector<std::uint32_t> words(cases::words_in(variant.operation));
  for (const cases::Job& job : plan.jobs()) {
    const std::uint64_t cases = std::min(of_each_stream, job.cases);
    for (std::uint64_t i = 0; i < cases; ++i) {
      cases::make_cases(job.stream, variant, seed, job.cases / cases * i, words);
      each(std::span<const std::uint32_t>(words));
    }
  }
}

void write_words_of(const fs::path& root, std::string_view name, fuzz::WordTarget target) {
  Corpus corpus(root, name);
  const auto& variants = fuzz::parties_by_variant(target);
  const bool chosen = target == fuzz::WordTarget::agreement;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    // All variants of an operation share cases; without a choice byte each input goes to all.
    if (!chosen && i > 0 && variants[i].variant.operation == variants[i - 1].variant.operation)
      continue;
    some_cases(variants[i].variant, chosen || target == fuzz::WordTarget::matrix ? 4 : 16,
               [&](std::span<const std::uint32_t> words) {
                 std::vector<std::uint8_t> bytes(fuzz::input_size(target));
                 if (chosen) bytes[0] = static_cast<std::uint8_t>(i);
                 fuzz::write_words(words, std::span(bytes).subspan(chosen ? 1 : 0));
                 corpus.add(bytes);
               });
  }
}

void write_steps(const fs::path& root) {
  Corpus corpus(root, "step");
  for (std::uint32_t i = 0; i < 32; ++i) {
    fuzz::StepCase step;
    if (i % 2 == 1) step.cpu = x86model::Target::i8088;
    fuzz::mutate_step_case(step, i);
    std::array<std::uint8_t, fuzz::step_input_size> bytes{};
    fuzz::write_step_case(step, bytes);
    corpus.add(bytes);
  }
}

void write_decimals(const fs::path& root) {
  Corpus corpus(root, "decimal_text");
  some_cases({.operation = cases::Operation::decimal, .build = {.target = cases::Target::standard}},
             40, [&](std::span<const std::uint32_t> words) {
               const std::string text = oracle::to_decimal(words[0], 16);
               corpus.add(text);
               // Half an ulp above the word, exactly and slightly more.
               const std::string whole = text.find('.') == std::string::npos ? text + ".0" : text;
               corpus.add(whole + "00000762939453125");
               corpus.add(whole + "000007629394531250000000001");
             });
  for (const char* text : {"", "-", "+.5", "5.", "1e5", "25E-2", "3.5e+", "1e-99999999999", " 7",
                           "-0", "00032767.99999", "32768", "-32768.00001"}) {
    corpus.add(text);
  }
}

/// Writes choices of judged_results().
void write_choices(const fs::path& root) {
  Corpus corpus(root, "judged_results");
  cases::Draw draw(1, 0);
  for (int i = 0; i < 200; ++i) {
    std::string bytes;
    for (int byte = 0; byte < 48; ++byte) bytes += static_cast<char>(draw.bits() & 0xffU);
    corpus.add(bytes);
  }
}

/// Writes a command letter and input lines; see input_lines.cpp.
void write_lines(const fs::path& root) {
  Corpus corpus(root, "input_lines");
  const std::array<cases::Operation, 8> evaluated{
      cases::Operation::mul,      cases::Operation::mul,   cases::Operation::div,
      cases::Operation::div,      cases::Operation::div,   cases::Operation::cossin,
      cases::Operation::xformvec, cases::Operation::concat};
  char letter = 'a';
  for (const cases::Operation operation : evaluated) {
    const cases::Variant variant{.operation = operation};
    some_cases(variant, 4, [&](std::span<const std::uint32_t> words) {
      corpus.add(letter + cases::hex_words(words, cases::operand_bits(variant)) + "\n");
    });
    ++letter;
  }
  for (std::uint32_t i = 0; i < 100; ++i) {
    fuzz::StepCase step;
    if (i % 2 == 1) step.cpu = x86model::Target::i8088;
    fuzz::mutate_step_case(step, i);
    const std::string command = step.replay(step.decoded()->instruction);
    const auto begin = command.find('\'') + 1;
    corpus.add(letter + command.substr(begin, command.find('\'', begin) - begin) + "\n");
  }
  ++letter;
  corpus.add("j00018000 00028000\n00000001 00008000\n--\n0003c000\n00000001\n");
  corpus.add("k00030000 00020000\n00010000 00000000\n--\n00018000\nDE\n");
  corpus.add("l00020000\nffff0000\n--\n00016a0a\nDE\n");
  corpus.add("m7fffffff 00000001\n--\n80000000\n");
  corpus.add("n00000000 00000001\n--\nffffffff\n");
  corpus.add("o400921fb54442d18\nfff0000000000000\n--\n0003243f\nDE\n");
  corpus.add("p00000180\n--\n0002\n");
  corpus.add("q-.5\n1e-3\n--\ne000000000000000\n0010624dd2f1a9fc\n");
  corpus.add("rffff0000\n--\n-1.0\n");
  corpus.add("j# a comment\r\n\n00018000 00028000\r\n--\n0003c001\n");
}

void write_files(const fs::path& root, const fs::path& scenes) {
  Corpus in_json(root, "scene_file");
  Corpus in_obj(root, "obj_file");
  for (const auto& entry : fs::directory_iterator(scenes)) {
    if (entry.path().extension() == ".json") in_json.add_file(entry.path());
    if (entry.path().extension() == ".obj") in_obj.add_file(entry.path());
  }
  in_json.add(
      R"({"objects": [{"shape": {"cube": {"half_edge": 20}}, "paint": 4, "position": [0, 0, -100]}]})");
  in_obj.add("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  in_obj.add(
      "# comment\r\nv 0 0 0 1\nv 1e0 0 0\nv 0 1.5 -0\nvt 0 0\nvn 0 0 1\nf -3/1/1 2//1 3/1\n");
}

/// Writes the functions and types of spans.cpp, with a layout of random bytes.
void write_spans(const fs::path& root) {
  Corpus corpus(root, "spans");
  constexpr std::uint8_t functions = 12;
  constexpr std::uint8_t types = 4;
  constexpr std::size_t size = 64;
  std::uint64_t state = seed;
  for (std::uint8_t function = 0; function < functions; ++function) {
    for (std::uint8_t type = 0; type < types; ++type) {
      std::array<std::uint8_t, size> bytes{type, function};
      for (std::size_t i = 2; i < bytes.size(); ++i) {
        state = cases::mix(state);
        bytes[i] = static_cast<std::uint8_t>(state);
      }
      corpus.add(bytes);
    }
  }
}

/// Writes at least one line for each command; see command_line.cpp.
void write_command_lines(const fs::path& root) {
  Corpus corpus(root, "command_line");
  for (const char* line : {"",
                           "--help",
                           "--version",
                           "verify --help",
                           "verify mul --level 1 --report r.json",
                           "verify div --by type --against oracle --max-reports 3 --threads 2",
                           "verify mul --case 00018000 --case 00028000",
                           "verify --level 2 --resume r.json --shard 1/9",
                           "merge file --report sum.json",
                           "gen div --level 1 --cases 20 --comments -o cases",
                           "gen mul --level 2",
                           "check mul --rounding half-up --from file",
                           "check sqrt file --show 2",
                           "eval mul --by oracle",
                           "eval xformvec --target i8088",
                           "step --cpu 8088",
                           "step --singlestep file --cpu 386",
                           "trace div 00018000 00028000 --target i386",
                           "trace texture --loop unrolled",
                           "list",
                           "list div --target i8088",
                           "prove mul",
                           "prove div --solver both --write queries",
                           "mutate sqrt --verbose",
                           "dos mul -o mul.com",
                           "render scene.json --frames 2 --out frames",
                           "render scene.json --frames 2 --digests d",
                           "render scene.json --animate a.png --size 64x48 --true-color",
                           "drift scene.json --frames 9 --json d.json",
                           "measure --accuracy",
                           "measure --clocks",
                           "measure --host --rounds 1",
                           "measure --stepping scene.json --json m.json",
                           "profile scene.json --frames 2 --target i8088 --json p.json",
                           "advise scene.json --budget 40 --minutes 1",
                           "report --quick --out page"}) {
    std::string arguments(line);
    std::replace(arguments.begin(), arguments.end(), ' ', '\n');
    corpus.add(arguments + "\n--\n00018000 00028000\n--\n00018000 00028000\n0003c000\n");
  }
}

/// A complete report without mismatches.
std::string complete_report(const cases::Variant& variant) {
  verify::Report report(cases::Plan(1, seed, {{variant, {"model", "oracle"}}}), {1, 1}, 3);
  verify::Maker maker = verify::this_build();
  maker.parties = {{"model", "a"}, {"oracle", "b"}};
  report.add(maker);
  for (std::uint64_t number = 0; number < report.done.size(); ++number) {
    const std::uint64_t cases = report.plan.chunk(number).cases;
    report.add(number, {{.cases = cases, .faults = 0, .mismatches = 0, .shown = {}}, number});
  }
  return verify::to_json(report);
}

/// A complete report, and unfinished ones without chunks and with mismatches.
void write_reports(const fs::path& root) {
  Corpus corpus(root, "report_file");
  const cases::Variant mul{.operation = cases::Operation::mul};
  const cases::Variant half{.operation = cases::Operation::div, .format = cases::q8_8};
  corpus.add(complete_report({.operation = cases::Operation::cossin}));
  for (const int level : {1, 3}) {
    for (const cases::Shard shard : {cases::Shard{1, 1}, cases::Shard{2, 5}}) {
      verify::Report report(
          cases::Plan(level, seed, {{level == 3 ? half : mul, {"model", "oracle"}}}), shard, 3);
      corpus.add(verify::to_json(report));
      verify::Maker maker = verify::this_build();
      maker.parties = {{"model", "a"}, {"oracle", "b"}};
      report.add(maker);
      for (std::uint64_t number = 0; number < std::min<std::uint64_t>(report.done.size(), 20);
           ++number) {
        if (!shard.has(number) || number % 7 == 6) continue;
        const cases::Chunk chunk = report.plan.chunk(number);
        verify::Findings found{
            .cases = chunk.cases, .faults = number, .mismatches = 0, .shown = {}};
        // Two at most, of the three that each row keeps.
        if (number == 1 || number == 2) {
          found.mismatches = 1;
          found.shown.push_back(
              {number, chunk.first, {1, 2}, {1, 0}, {{"model", "1"}, {"oracle", "2"}}});
        }
        report.add(number, {found, number});
      }
      corpus.add(verify::to_json(report));
    }
  }
}

/// A letter for the processor, a damage and its place before each file; see capture_file.cpp.
void write_captures(const fs::path& root, const fs::path& vectors) {
  Corpus corpus(root, "capture_file");
  for (const char* damage : {"n00", "f 5", "f19", "c 1", "c@!"}) {
    for (const auto& [letter, name] : {std::pair{'m', "8088.json"},
                                       {'n', "386.json"},
                                       {'n', "386-divide.json.gz"},
                                       {'o', "286.MOO"}}) {
      // The target does not damage what is compressed already.
      if (name == std::string_view("386-divide.json.gz") && damage[0] != 'n') continue;
      corpus.add_file(vectors / name, std::string(1, letter) + damage);
    }
  }
}

/// Machine code after a letter for the container and the place; see code_file.cpp. Objects are
/// among the regressions.
void write_code(const fs::path& root) {
  Corpus corpus(root, "code_file");
  // IMUL BX, RET
  constexpr std::string_view code = "\xF7\xEB\xC3";
  for (const char* line : {"f", "f1", "f0x0..3", "f2h", "F", "c", "c101h", "c$name", "f0:0"}) {
    corpus.add(fmt::format("{}\n{}", line, code));
  }
  const auto word = [](unsigned value) {
    return std::string{static_cast<char>(value & 0xFFU), static_cast<char>(value >> 8U)};
  };
  std::string exe = "MZ" + word(64 + 19) + word(1) + word(2) + word(4) + word(0x200) +
                    word(0xFFFF) + word(2) + word(0x1000) + word(0) + word(0) + word(0) +
                    word(0x1C) + word(0) + word(1) + word(0) + word(0) + word(1);
  exe.resize(64);
  exe += std::string(16, '\x90') + std::string(code);
  for (const char* line : {"e", "e0", "e1:0", "e1:0..3", "e7:0", "F"}) {
    corpus.add(fmt::format("{}\n{}", line, exe));
  }
}

/// Right and wrong answers to the questions of solver_answer.cpp.
void write_solver_answers(const fs::path& root) {
  Corpus corpus(root, "solver_answer");
  for (const char* said :
       {"unsat\n", "sat\n", "unknown\n", "timeout\n", "(error \"line 1\")\n", ""}) {
    corpus.add(said);
  }
  const auto model = [&](const std::string& a, const std::string& b, const std::string& more = "") {
    corpus.add("((define-fun a () (_ BitVec 32) " + a + ")\n (define-fun b () (_ BitVec 32) " + b +
               ")" + more + ")\n");
  };
  model("#x00000001", "#x0000f423");
  model("#x00000002", "#x8000f423");
  model("(_ bv2147483647 32)", "(_ bv1 32)");
  model("#x7fffffff", "(bvlshr twice #x00000001)");
  model("#x00000003", "#x00000004",
        " (define-fun n () Int 4) (define-fun f ((x!0 (_ BitVec 32))) (_ BitVec 32)"
        " (ite (= x!0 #x00000003) #x00000004 #x00000003))");
  model("((_ extract 31 0) ((_ sign_extend 32) #x7ffffffe))",
        "(let ((c #b1)) (concat #x0000000 #b00 c c))",
        " (define-fun twice () (_ BitVec 32) #x00000001)");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    support::write_error("usage: fuzz_seeds FOLDER SCENES VECTORS\n");
    return 2;
  }
  try {
    const fs::path root = argv[1];
    using enum fuzz::WordTarget;
    write_words_of(root, "divide", divide);
    write_words_of(root, "multiply", multiply);
    write_words_of(root, "matrix", matrix);
    write_words_of(root, "agreement", agreement);
    write_steps(root);
    write_decimals(root);
    write_files(root, argv[2]);
    write_choices(root);
    write_lines(root);
    write_spans(root);
    write_command_lines(root);
    write_reports(root);
    write_captures(root, argv[3]);
    write_solver_answers(root);
    write_code(root);
    fuzz::write_logs(root);
    fuzz::write_replies(root);
  } catch (const std::exception& error) {
    support::write_error(fmt::format("fuzz_seeds: {}\n", error.what()));
    return 2;
  }
  return 0;
}
