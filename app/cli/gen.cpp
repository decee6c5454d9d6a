#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <optional>
#include <vector>

#include "app/cli/arguments.hpp"
#include "app/cli/case_options.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/print_error.hpp"
#include "app/cli/selection.hpp"
#include "judge/check/cases.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/output_file.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::cli {

namespace {

struct GenOptions {
  std::string operation;
  check::CaseOptions cases;
  FormatOptions formats;
  std::string file;
  bool comments = false;
};

/// Writes to standard output, or to a file that appears only once it is complete.
class LineOutput {
 public:
  explicit LineOutput(const std::string& path) {
    if (!path.empty()) file_.emplace(path);
  }

  /// @return false if the reader has closed the pipe, which is not an error
  bool write(std::string_view text) {
    if (file_) {
      file_->append(text);
      return true;
    }
    while (!text.empty()) {
      const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
      if (written >= 0) {
        text.remove_prefix(static_cast<std::size_t>(written));
      } else if (errno == EPIPE) {
        return false;
      } else if (errno != EINTR) {
        throw OutputLost();
      }
    }
    return true;
  }

  void finish() {
    if (file_) file_->finish();
  }

 private:
  std::optional<support::OutputFile> file_;
};

int generate(const GenOptions& options) {
  constexpr std::size_t flush_size = 1U << 16U;
  const cases::Operation operation = cases::operation_named(options.operation);
  if (!check::is_judged(operation) && !options.formats.format.empty()) {
    format_operation_named(options.operation);
  }
  const cases::Variant variant = variant_in(operation, options.formats);
  check::GeneratedCases cases(variant, options.cases);
  const std::uint64_t all = *cases.count();
  if (all == 0) {
    throw support::UsageError(
        fmt::format("--shard {}: this part has no cases; use fewer parts", options.cases.shard));
  }
  LineOutput output(options.file);
  std::vector<std::uint32_t> words(cases::words_in(variant));
  const support::Interrupt interrupt;
  support::FrameProgress progress(all, "cases");
  std::string pending;
  if (options.comments) {
    pending = fmt::format("# {}: {} cases\n", options.cases.command_line(variant), all);
  }
  std::string_view stream;
  std::uint64_t done = 0;
  while (!support::Interrupt::flag() && cases.next(words)) {
    if (options.comments && cases.origin() != stream) {
      stream = cases.origin();
      pending += fmt::format("# {}: {} cases\n", stream, cases.count_of(stream));
    }
    cases::append_operands(pending, variant, words);
    pending += '\n';
    ++done;
    if (pending.size() < flush_size) continue;
    if (!output.write(pending)) return 0;
    pending.clear();
    if (!options.file.empty()) progress.show(done);
  }
  if (done < all) {
    print_error(fmt::format("STOPPED after {} of {} cases{}", done, all,
                            options.file.empty() ? "" : "; " + options.file + " is not written"));
    return support::interrupted_status;
  }
  if (output.write(pending)) output.finish();
  return 0;
}

}  // namespace

void add_gen(CLI::App& app, int& status) {
  auto options = std::make_shared<GenOptions>();
  CLI::App* command =
      app.add_subcommand("gen", "write the cases of a verification as input for another program");
  command
      ->add_option("operation", options->operation,
                   "mul, div, sqrt, add, sub, mul_add, lerp, dot, from_binary64, convert, "
                   "from_decimal, to_decimal, cossin, xformvec, concat, decimal, binary64, or a "
                   "function: " +
                       cases::function_names())
      ->required();
  add_format_options(*command, options->formats, ". cossin, xformvec and concat have no other");
  add_case_options(*command, options->cases);
  command->add_option("-o,--output", options->file, "output file; by default standard output")
      ->check(not_empty());
  command->add_flag(
      "--comments", options->comments,
      "also write lines that start with #: this command, and the stream of the cases that "
      "follow");
  command->footer(
      R"(Writes one case per line in the format that `fixproof eval` reads: operands as lower-case hex
digits of two's complement, separated by single spaces: 8 digits, or with --format those of the
integer of 8, 16, 32 or 64 bits that stores a word. The cases are those of `fixproof verify`, stream by stream: boundary words, random
words, constructed ties and their neighbours. The operands of conversions are a double as 16 hex
digits (from_binary64), a word of --format (convert, to_decimal) or a decimal number (from_decimal).
`fixproof check` makes the same cases from the same options and names the stream of a wrong result.
`eval` and `check --from` skip the lines of --comments.

Exit status: 0 done, 2 bad usage, 130 interrupted.

Examples:
  fixproof gen mul | ./mine | fixproof check mul --rounding half-up
  fixproof gen div --level 2 --shard 1/4 -o cases.txt
  fixproof gen mul --format q2_30         # words of eight digits, in units of 2^-30
  fixproof gen convert --format q16_16 --to q8_8
  fixproof gen mul --format q2_16 --to q4_32   # words of 18 bits, products of 36
  fixproof gen dot --terms 8 --format q1_15
  fixproof gen sqrt --cases 1000          # a thousand cases, evenly spread
  fixproof gen div --comments | less      # with the names of the streams)");
  command->callback([options, &status] { status = generate(*options); });
}

}  // namespace fixproof::cli
