#include <fmt/format.h>

#include <array>
#include <iostream>
#include <memory>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/lines.hpp"
#include "app/cli/options.hpp"
#include "app/cli/selection.hpp"
#include "app/cli/words.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/words.hpp"
#include "verify/parties/party.hpp"

namespace fixproof::cli {

namespace {

struct EvalOptions {
  std::string operation;
  std::string by;
  std::string format;
  VariantOptions variant;
};

void append_answer(std::string& output, parties::Ending ending,
                   std::span<const std::uint32_t> words, int word_bits) {
  if (ending == parties::Ending::divide_error) {
    output += "DE";
    return;
  }
  if (ending != parties::Ending::value)
    throw support::UsageError("the party gave no answer; choose another with --by");
  cases::append_words(output, words, word_bits);
}

cases::Variant chosen(const EvalOptions& options) {
  const VariantOptions& v = options.variant;
  if (!options.format.empty()) {
    if (!v.targets.empty() || v.mul_round || v.div_round || v.as_printed || v.chapter_52 ||
        v.repaired) {
      throw support::UsageError(
          "--format: other formats have no target, rounding or chapter; leave these options out");
    }
    const cases::Operation operation = format_operation_named(options.operation);
    const cases::Format format = cases::format_named(options.format);
    cases::check_format(operation, format);
    return {.operation = operation, .build = {.target = cases::Target::standard}, .format = format};
  }
  const cases::Operation operation = answered_operation_named(options.operation);
  if (cases::is_routine(operation)) {
    const cases::Variant variant = v.choose(operation);
    if (v.has_printed_shift(variant)) throw support::UsageError(no_printed_shift);
    return variant;
  }
  if (v.repaired) throw support::UsageError(only_repaired);
  if (!v.targets.empty() || v.mul_round || v.div_round || v.as_printed || v.chapter_52) {
    throw support::UsageError(fmt::format(
        "{} is not a routine: it has no target, rounding or chapter; leave these options out",
        options.operation));
  }
  return {.operation = operation, .build = {.target = cases::Target::standard}};
}

int run(const EvalOptions& options) {
  const cases::Variant variant = chosen(options);
  const cases::Operation operation = variant.operation;
  const bool by_model = cases::is_routine(operation) && options.format.empty();
  const bool by_type = parties::party_named("type").answers(variant);
  const std::string by = !options.by.empty() ? options.by
                         : by_model          ? "model"
                         : by_type           ? "type"
                                             : "oracle";
  const parties::Party& party = parties::party_named(by);
  if (!party.answers(variant)) {
    throw support::UsageError(
        fmt::format("{} does not answer this variant of {}; choose another party with --by", by,
                    options.operation));
  }
  std::array<std::uint32_t, cases::max_words_in> in{};
  std::array<std::uint32_t, cases::max_words_out> out{};
  const auto taken = std::span(in).first(cases::words_in(variant));
  const auto given = std::span(out).first(cases::words_out(variant));
  answer_lines(std::cin, std::cout, [&](std::string_view line, std::string& output) {
    read_words(line, variant, taken);
    std::array<parties::Ending, 1> ending{};
    party.answer(variant, {taken, given, ending});
    append_answer(output, ending[0], given, variant.format.word_bits);
  });
  return 0;
}

}  // namespace

void add_eval(CLI::App& app, int& status) {
  auto options = std::make_shared<EvalOptions>();
  CLI::App* command =
      app.add_subcommand("eval", "compute the result of each line of operands on standard input");
  command
      ->add_option("operation", options->operation,
                   "mul, div, cossin, xformvec, concat, sqrt, add, sub, decimal, binary64, or a "
                   "function: " +
                       cases::function_names())
      ->required();
  command
      ->add_option(
          "--by", options->by,
          "party that answers: model, interpreter, oracle, fast, type, silicon, unicorn, or "
          "FILE:FUNCTION of a shared library; by default model for routines, type for other "
          "operations")
      ->check(not_empty());
  command
      ->add_option(
          "--format", options->format,
          "format of the words, such as q2_30 or u8_8. add, sub, mul, div, mul_div, sqrt, "
          "decimal and binary64 round half up and wrap. fmod and remainder (signed formats) "
          "are exact. Other functions round to nearest, in at most 32 bits. type answers in "
          "named formats, oracle in others")
      ->check(not_empty());
  options->variant.add_to(*command);
  command->footer(
      R"(Operands are numbers such as 1.5, -2e3 or 0x18000, or words of 8 hex digits of two's complement
(docs/formats.md has the rule). Spaces, tabs or commas separate them. Results are words:
  mul, div   a b                             -> one word, DE for a divide error
  add, sub   a b                             -> one word
  pow, hypot, atan2   a b                    -> one word; atan2 takes y x
  fmod, remainder   a b                      -> one word, DE for a zero divisor
  mul_div    a b c                           -> the word of a x b / c, DE for a zero divisor
  hypot3     a b c                           -> one word
  cossin     an angle in tenths, or 4 digits -> cosine and sine
  xformvec   12 words, row-major, then x y z -> 3 words
  concat     12 words, then 12               -> 12 words
  others     one word                        -> one word; sin and cos take radians
With --format, words have a hex digit for every four bits of the format.
Blank lines and lines that start with # are skipped.

Examples:
  echo 1.5 2.5 | fixproof eval mul                      # 0003c000
  echo 00018000 00028000 | fixproof eval mul            # the same
  echo 00010000 0000ffff | fixproof eval div --target i8088   # divisor below 1: DE
  echo 00010000 | fixproof eval sin                     # sine of one radian: 0000d76b
  echo 01c2 | fixproof eval cossin --by type            # 45.0 degrees
  echo 00030000 00050000 00040000 | fixproof eval mul_div   # 3 x 5 / 4: 0003c000
  echo 60000000 20000000 | fixproof eval mul --format q2_30   # 1.5 x 0.5: 30000000)");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace fixproof::cli
