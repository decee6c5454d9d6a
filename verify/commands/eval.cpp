#include <fmt/format.h>

#include <array>
#include <iostream>
#include <memory>

#include "verify/arguments.hpp"
#include "verify/commands/commands.hpp"
#include "verify/commands/lines.hpp"
#include "verify/hex.hpp"
#include "verify/options.hpp"
#include "verify/party.hpp"
#include "verify/usage_error.hpp"

namespace fixproof {

namespace {

struct EvalOptions {
  std::string operation;
  std::string by;
  VariantOptions variant;
};

void append_answer(std::string& output, Ending ending, std::span<const std::uint32_t> words) {
  if (ending == Ending::divide_error) {
    output += "DE";
    return;
  }
  if (ending != Ending::value) throw UsageError("the party gave no answer");
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) output += ' ';
    append_hex(output, words[i], 8);
  }
}

Variant chosen(const EvalOptions& options) {
  const Operation operation = operation_named(options.operation);
  const VariantOptions& v = options.variant;
  if (is_routine(operation)) {
    const Variant variant = v.choose(operation);
    if (v.as_printed && operation == Operation::cossin && variant.target == Target::i8088) {
      throw UsageError(no_printed_shift);
    }
    return variant;
  }
  if (v.repaired) throw UsageError(only_repaired);
  if (!v.targets.empty() || v.mul_round || v.div_round || v.as_printed || v.chapter_52) {
    throw UsageError(fmt::format("{} is no routine: it has neither target, rounding nor chapter",
                                 options.operation));
  }
  return {.operation = operation, .target = Target::standard};
}

int run(const EvalOptions& options) {
  const Variant variant = chosen(options);
  const Operation operation = variant.operation;
  const std::string by = !options.by.empty()     ? options.by
                         : is_routine(operation) ? "model"
                                                 : "type";
  const Party& party = party_named(by);
  if (!party.answers(variant)) {
    throw UsageError(fmt::format("{} does not answer this variant of {}", by, options.operation));
  }
  std::array<std::uint32_t, most_words_in> in{};
  std::array<std::uint32_t, most_words_out> out{};
  const auto taken = std::span(in).first(words_in(operation));
  const auto given = std::span(out).first(words_out(operation));
  answer_lines(std::cin, std::cout, [&](std::string_view line, std::string& output) {
    parse_words(line, variant, taken);
    std::array<Ending, 1> ending{};
    party.answer(variant, {taken, given, ending});
    append_answer(output, ending[0], given);
  });
  return 0;
}

}  // namespace

void add_eval(CLI::App& app, int& status) {
  auto options = std::make_shared<EvalOptions>();
  CLI::App* command =
      app.add_subcommand("eval", "answer one case a line, read from standard input");
  command
      ->add_option("operation", options->operation,
                   "mul, div, cossin, xformvec, concat, sqrt, sin, cos, decimal or binary64")
      ->required();
  command
      ->add_option(
          "--by", options->by,
          "model, interpreter, oracle, fast, type, silicon or unicorn; by default model, or "
          "type for what is no routine")
      ->check(not_empty());
  options->variant.add_to(*command);
  command->footer(
      "Words are 8 lower-case hex digits of two's complement, single spaces between:\n"
      "  mul, div   a b                             -> one word, DE for a divide error\n"
      "  cossin     an angle in tenths, 4 digits    -> cosine and sine\n"
      "  xformvec   12 words by rows, then x y z    -> 3 words\n"
      "  concat     12 words, then 12               -> 12 words\n"
      "  the others a word                          -> one word; sin and cos take radians\n"
      "Blank lines and lines that start with # are passed over.\n\n"
      "Examples:\n"
      "  echo 00018000 00028000 | fixproof eval mul            # 1.5 x 2.5: 0003c000\n"
      "  echo 00010000 0000ffff | fixproof eval div --target i8088   # divisor below 1: DE\n"
      "  echo 00010000 | fixproof eval sin                     # of one radian: 0000d76b\n"
      "  echo 01c2 | fixproof eval cossin --by type            # 45.0 degrees");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace fixproof
