#include <fmt/format.h>

#include <array>
#include <iostream>
#include <memory>

#include "app/cli/arguments.hpp"
#include "app/cli/case_options.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/lines.hpp"
#include "app/cli/options.hpp"
#include "app/cli/selection.hpp"
#include "app/cli/words.hpp"
#include "judge/check/operands.hpp"
#include "judge/check/rules.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/words.hpp"
#include "verify/parties/party.hpp"

namespace fixproof::cli {

namespace {

struct EvalOptions {
  std::string operation;
  std::string by;
  FormatOptions formats;
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

cases::Variant chosen(const EvalOptions& options, cases::Operation operation) {
  const VariantOptions& v = options.variant;
  const bool has_routine_option = !v.targets.empty() || v.mul_round || v.div_round ||
                                  v.as_printed || v.chapter_52 || v.repaired;
  if (!options.formats.format.empty() || !options.formats.to.empty()) {
    if (has_routine_option) {
      throw support::UsageError(
          "--format: other formats have no target, rounding or chapter; leave these options out");
    }
    if (!check::is_judged(operation)) format_operation_named(options.operation);
  }
  const cases::Variant in_format = variant_in(operation, options.formats);
  if (!options.formats.format.empty() || !options.formats.to.empty()) return in_format;
  if (cases::is_routine(operation)) {
    const cases::Variant variant = v.choose(operation);
    if (v.has_printed_shift(variant)) throw support::UsageError(no_printed_shift);
    return variant;
  }
  if (v.repaired) throw support::UsageError(only_repaired);
  if (has_routine_option) {
    throw support::UsageError(fmt::format(
        "{} is not a routine: it has no target, rounding or chapter; leave these options out",
        options.operation));
  }
  return in_format;
}

/// The word of a function outside its domain: the end of the range nearest to a pole, or 0.
check::NoResult outside_domain(cases::Operation operation) {
  using enum cases::Operation;
  switch (operation) {
    case log2:
    case log:
    case log10:
    case log1p:
      return check::NoResult::minimum;
    case rsqrt:
    case reciprocal:
    case tan_of_degrees:
    case tan_of_turns:
      return check::NoResult::maximum;
    default:
      return check::NoResult::zero;
  }
}

/// Answers what no party does: sums, formats that the type lacks, and results of another format.
void answer_exactly(const cases::Variant& variant) {
  check::Rules rules{.variant = variant};
  if (cases::is_function(variant.operation)) {
    rules.overflow = check::Overflow::saturate;
    rules.no_result = outside_domain(variant.operation);
  } else if (variant.operation == cases::Operation::sqrt) {
    rules.no_result = check::NoResult::zero;
  }
  std::vector<std::uint32_t> words(cases::words_in(variant));
  answer_lines(std::cin, std::cout, [&](std::string_view line, std::string& output) {
    read_words(line, variant, words);
    std::string plain;
    cases::append_operands(plain, variant, words);
    const check::ValuedCase operands = check::parse_valued(plain, variant);
    const bool is_pole =
        variant.operation == cases::Operation::pow && !operands.value && operands.words[0] == 0;
    const check::Said said =
        is_pole ? cases::highest(variant.format) : check::expected_of(rules, operands).said;
    output += said ? check::hex_text(*said, variant.format) : "DE";
  });
}

int run(const EvalOptions& options) {
  const cases::Operation operation = evaluated_operation_named(options.operation);
  const cases::Variant variant = chosen(options, operation);
  const bool has_party =
      !variant.from && cases::is_of_type(variant.format) && !cases::is_sum(operation);
  if (!has_party) {
    if (!check::is_judged(operation)) {
      throw support::UsageError(
          fmt::format("{} has formats of 8, 16, 32 or 64 bits such as q16_16, which {} is not",
                      options.operation, cases::name_of(variant.format)));
    }
    if (!options.by.empty() && options.by != "oracle") {
      throw support::UsageError(fmt::format(
          "--by {}: only the oracle answers sums, results of another format and formats such as "
          "q2_16; leave --by out",
          options.by));
    }
    answer_exactly(variant);
    return 0;
  }
  const bool by_model =
      cases::is_routine(operation) && options.formats.format.empty() && options.formats.to.empty();
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
      ->add_option(
          "operation", options->operation,
          "mul, div, cossin, xformvec, concat, sqrt, add, sub, mul_add, lerp, dot, decimal, "
          "binary64, or a function: " +
              cases::function_names())
      ->required();
  command
      ->add_option(
          "--by", options->by,
          "party that answers: model, interpreter, oracle, fast, type, silicon, unicorn, or "
          "FILE:FUNCTION of a shared library; by default model for routines, type for other "
          "operations")
      ->check(not_empty());
  add_format_options(
      *command, options->formats,
      ". Results round half up and wrap, fmod and remainder (signed formats) are exact, and "
      "functions round to nearest and saturate. type answers in named formats, "
      "oracle in others");
  options->variant.add_to(*command);
  command->footer(
      R"(Operands are numbers such as 1.5, -2e3 or 0x18000, or words of 8 hex digits of two's complement
(docs/formats.md has the rule). Spaces, tabs or commas separate them. Results are words:
  mul, div   a b                             -> one word, DE for a divide error
  add, sub   a b                             -> one word
  pow, hypot, atan2   a b                    -> one word; atan2 and its relatives take y x
  fmod, remainder   a b                      -> one word, DE for a zero divisor
  mul_div    a b c                           -> the word of a x b / c, DE for a zero divisor
  hypot3     a b c                           -> one word
  mul_add    a b c                           -> the word of a x b + c, rounded once
  lerp       a b t                           -> the word of a + (b - a) x t
  dot        a1 a2 ... b1 b2 ...             -> the word of a1 x b1 + a2 x b2 + ..., see --terms
  cossin     an angle in tenths, or 4 digits -> cosine and sine
  xformvec   12 words, row-major, then x y z -> 3 words
  concat     12 words, then 12               -> 12 words
  others     one word                        -> one word; sin and cos take radians
With --format, words have the hex digits of the integer of 8, 16, 32 or 64 bits that stores them.
Blank lines and lines that start with # are skipped.

Examples:
  echo 1.5 2.5 | fixproof eval mul                      # 0003c000
  echo 00018000 00028000 | fixproof eval mul            # the same
  echo 00010000 0000ffff | fixproof eval div --target i8088   # divisor below 1: DE
  echo 00010000 | fixproof eval sin                     # sine of one radian: 0000d76b
  echo 01c2 | fixproof eval cossin --by type            # 45.0 degrees
  echo 00030000 00050000 00040000 | fixproof eval mul_div   # 3 x 5 / 4: 0003c000
  echo 60000000 20000000 | fixproof eval mul --format q2_30   # 1.5 x 0.5: 30000000
  echo 80000000 80000000 | fixproof eval hypot --format q1_31 --to q2_30   # 1.41421356: 5a82799a)");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace fixproof::cli
