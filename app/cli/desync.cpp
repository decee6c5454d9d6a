#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>

#include "app/cli/commands.hpp"
#include "app/cli/json/desync_json.hpp"
#include "app/cli/json/result_file.hpp"
#include "judge/desync/compare.hpp"
#include "judge/desync/log_file.hpp"
#include "judge/desync/values.hpp"
#include "support/file.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

using desync::Comparison;
using desync::LogFile;
using desync::Side;
using desync::Verdict;

struct DesyncOptions {
  std::string a;
  std::string b;
  bool rollback = false;
  ResultFile result;
};

std::string frame_text(std::int64_t frame) {
  return frame == record::no_frame ? "before the first frame" : fmt::format("frame {}", frame);
}

/// Returns "1 block" or "2 blocks".
std::string count_of(desync::word number, const char* noun) {
  return fmt::format("{} {}{}", support::grouped(number), noun, number == 1 ? "" : "s");
}

void print_log(const char* side, const LogFile& log) {
  std::string made;
  for (const char c : log.origin()) made += c == '\n' ? "; " : std::string(1, c);
  if (made.ends_with("; ")) made.resize(made.size() - 2);
  std::cout << fmt::format("{}: {}\n   {}\n", side, support::printable(log.path()),
                           support::printable(made));
  if (!log.is_complete()) {
    std::cout << fmt::format(
        "   not closed: the program was killed, it still runs, or a child process went on for "
        "it{}\n",
        log.torn_bytes() == 0
            ? ""
            : fmt::format("; {} at the end", count_of(log.torn_bytes(), "torn byte")));
  }
}

void print_side(const char* name, LogFile& log, const Side& side) {
  if (!side.index) {
    std::cout << fmt::format("{} {:>14}  the frame ends here\n", name, "");
    return;
  }
  for (const ShownRecord& record : records_around(log, side)) {
    std::string source;
    if (!record.input.empty()) source = " from the double " + record.input;
    if (!record.place.empty()) source += "  " + record.place;
    std::cout << fmt::format("{}{} {:>14}  {}{}\n", name, record.differs ? '>' : ' ',
                             support::grouped(record.operation), support::printable(record.text),
                             support::printable(source));
  }
}

const char* explanation(Verdict verdict) {
  switch (verdict) {
    case Verdict::input:
      return "The numbers that enter differ: check how the programs compute or read them, in "
             "which\n"
             "order, and which options they are compiled with.";
    case Verdict::evaluation:
      return "The two values were computed in another order, as by unspecified evaluation of "
             "arguments.\n"
             "C++ leaves this order to the compiler: compute each value in a statement of its own.";
    case Verdict::swapped:
      return "The operands are swapped: both sides have the same ones, in different places. Either "
             "the\n"
             "sources differ, or the compilers choose different operands to compute first, and "
             "each\n"
             "takes the next value of one source, such as a random generator. The logs cannot "
             "tell.";
    case Verdict::moved:
      return "The same values are in another order: both sides computed them in one order, and "
             "use\n"
             "them in different places. The compilers may choose different arguments to compute "
             "first,\n"
             "and each takes the next value of one source. Or the values stand in memory in "
             "another\n"
             "order. The logs cannot tell.";
    case Verdict::integer:
      return "An operand differs that is an integer. Integers are not recorded: check how the\n"
             "programs compute it.";
    case Verdict::operands:
      return "The operands differ, although every recorded operation before this one is equal. "
             "The\n"
             "logs cannot tell why. The value may come from memory that was loaded or copied, from "
             "an\n"
             "uninitialised variable, from a constant, or from a choice between two values.";
    case Verdict::accumulator:
      return "The sums in the accumulators differ, although every recorded operation before this "
             "one\n"
             "is equal. The logs cannot tell why. An accumulator may be copied or uninitialised, "
             "or\n"
             "another one may have got the terms.";
    case Verdict::arithmetic:
      return "The results differ for the same operands: the arithmetic is not the same.";
    case Verdict::order:
      return "The order differs: both sides apply the same two operations to a value, in a\n"
             "different order.";
    case Verdict::type:
      return "The number types differ: the programs are compiled with different formats or rules, "
             "or\n"
             "they take different branches from here. The logs cannot tell.";
    case Verdict::path:
      return "The operations differ. The programs may take different branches from here, because\n"
             "something differs that is not recorded. A compiler may compute a constant that the "
             "other\n"
             "program computes, or choose another argument to compute first. The logs cannot tell.";
    default:
      return "";
  }
}

/// Says which operations computed the two values.
std::string origin_text(const desync::Origin& origin) {
  const auto line = [](const desync::Value& value, desync::word in_a, desync::word in_b) {
    return fmt::format("{} is the result of operation {} of A and of operation {} of B.\n",
                       desync::text_of(value), support::grouped(in_a), support::grouped(in_b));
  };
  return line(origin.of_a, origin.of_a_in_a, origin.of_a_in_b) +
         line(origin.of_b, origin.of_b_in_a, origin.of_b_in_b);
}

void print_hint(const Comparison& found, bool rollback) {
  std::cout << fmt::format(
      "To see the operation, run both programs again with FIXPROOF_RECORD_FULL={} in their\n"
      "environment, and compare the new logs.\n",
      range_to_record(found, rollback));
}

int print(const Comparison& found, LogFile& a, LogFile& b, bool rollback) {
  const auto closing = fmt::format("{}, {} read\n", count_of(found.steps, "step"),
                                   count_of(a.pages_read() + b.pages_read(), "page"));
  if (found.verdict == Verdict::equal || found.verdict == Verdict::ended) {
    std::cout << fmt::format("No difference in {}, {}. {}", count_of(found.operations, "operation"),
                             count_of(found.blocks, rollback ? "common frame" : "common block"),
                             closing);
    if (found.verdict == Verdict::ended && !rollback && !found.a.index && !found.b.index) {
      std::cout << fmt::format(
          "{} ends in block {}, which is not compared. To compare it, record it in full with\n"
          "FIXPROOF_RECORD_FULL={}-{}.\n",
          found.a.entry.operations < found.b.entry.operations ? "A" : "B", found.a.block,
          found.a.block, found.a.block + 1);
    }
    if (!rollback && a.blocks() != b.blocks()) {
      std::cout << fmt::format(
          "{} continues for {}.\n", a.blocks() > b.blocks() ? "A" : "B",
          count_of(std::max(a.blocks(), b.blocks()) - found.blocks, "more block"));
    }
    return 0;
  }
  const desync::Entry& entry = found.a.entry;
  const std::string mark = mark_of(a, found.a);
  std::cout << fmt::format(
      "First difference: block {} ({}{}), {}", found.a.block, frame_text(entry.frame),
      mark.empty() ? "" : ", after the mark " + support::quoted(mark), closing);
  if (found.verdict == Verdict::block) {
    std::cout << fmt::format(
        "It is one of the operations {} to {} of A.\n", support::grouped(entry.first_operation),
        support::grouped(entry.first_operation + std::max<desync::word>(entry.operations, 1) - 1));
    if (entry.frame != found.b.entry.frame && !rollback) {
      std::cout << fmt::format(
          "B is {}{} there. If the programs simulate frames again, compare with --rollback.\n",
          found.b.entry.frame == record::no_frame ? "" : "in ", frame_text(found.b.entry.frame));
    }
    print_hint(found, rollback);
    return 1;
  }
  print_side("A", a, found.a);
  print_side("B", b, found.b);
  std::cout << explanation(found.verdict) << '\n';
  if (found.origin) std::cout << origin_text(*found.origin);
  return 1;
}

}  // namespace

void add_desync(CLI::App& app, int& status) {
  auto options = std::make_shared<DesyncOptions>();
  CLI::App* command =
      app.add_subcommand("desync", "find the first operation in which two recorded runs differ");
  command->add_option("a", options->a, "the log of one run, written by record::log")->required();
  command->add_option("b", options->b, "the log of the other run")->required();
  command->add_flag(
      "--rollback", options->rollback,
      "compare the last simulation of every frame instead of the runs from their beginning");
  options->result.add_to(*command);
  command->footer(
      R"(A program that computes with fixproof::recorded<q16_16> writes such a log (docs/recorder.md).
The first comparison names a block of up to 1,024 records. Run both programs again with the range
that it prints. The second comparison then shows the operation.
Exit status: 0 if there is no difference, 1 if there is one, 2 if a log cannot be read or nothing
was compared.

Examples:
  fixproof desync mine.log theirs.log           # names the block
  FIXPROOF_RECORD_FULL=97655-97656 ./game       # on both machines
  fixproof desync mine.log theirs.log           # shows the operation)");
  command->callback([options, &status] {
    if (support::same_file(options->a, options->b)) {
      throw support::UsageError(fmt::format(
          "{} and {} are the same file; give the logs of two runs", options->a, options->b));
    }
    options->result.open({options->a, options->b}, "the logs");
    LogFile a(options->a);
    LogFile b(options->b);
    print_log("A", a);
    print_log("B", b);
    const Comparison found = options->rollback ? compare_last_frames(a, b) : compare(a, b);
    if (found.blocks == 0) {
      throw support::UsageError(
          fmt::format("{} and {} have no {} in common, so nothing was compared", options->a,
                      options->b, options->rollback ? "frame" : "block"));
    }
    status = options->result.write(print(found, a, b, options->rollback), [&] {
      return desync_json(found, a, b, options->rollback, explanation(found.verdict));
    });
  });
}

}  // namespace fixproof::cli
