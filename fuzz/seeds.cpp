// Writes the initial inputs of every target, from the generators in verify/, in the target's
// format. usage: fuzz_seeds FOLDER SCENES VECTORS; FOLDER gets one folder per target.
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/plan.hpp"
#include "cases/streams.hpp"
#include "cases/words.hpp"
#include "fuzz/step_case.hpp"
#include "fuzz/word_target.hpp"
#include "fuzz/words.hpp"
#include "oracle/decimal.hpp"
#include "support/error_text.hpp"
#include "support/file.hpp"

using namespace fixproof;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t seed = 1994;

class Corpus {
 public:
  Corpus(const fs::path& root, std::string_view target) : folder_(root / target) {
    fs::create_directories(folder_);
  }

  void add(std::string_view bytes) {
    const fs::path path = folder_ / fmt::format("seed-{:04}", files_++);
    std::ofstream file;
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.open(path, std::ios::binary);
    file << bytes;
  }
  void add(std::span<const std::uint8_t> bytes) { add(std::string(bytes.begin(), bytes.end())); }

  void add_file(const fs::path& path, std::string_view before = "") {
    add(std::string(before) + support::read_file(path));
  }

 private:
  fs::path folder_;
  int files_ = 0;
};

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
  for (const char* text :
       {"", "-", "+.5", "5.", "1e5", " 7", "-0", "00032767.99999", "32768", "-32768.00001"}) {
    corpus.add(text);
  }
}

/// Writes a command letter and input lines; see command_lines.cpp.
void write_lines(const fs::path& root, const fs::path& vectors) {
  Corpus corpus(root, "command_lines");
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
  corpus.add("j# a comment\r\n\n00018000 00028000\r\n--\n0003c001\n");
  corpus.add_file(vectors / "8088.json", "m");
  corpus.add_file(vectors / "386.json", "n");
  corpus.add_file(vectors / "386-divide.json.gz", "n");
  corpus.add_file(vectors / "286.MOO", "o");
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
    write_lines(root, argv[3]);
  } catch (const std::exception& error) {
    support::write_error(fmt::format("fuzz_seeds: {}\n", error.what()));
    return 2;
  }
  return 0;
}
