#include "app/cli/judge_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/cli/judge_rules.hpp"
#include "app/cli/measure_text.hpp"
#include "judge/check/verdict_text.hpp"
#include "support/plain_text.hpp"
#include "x86model/flags.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

namespace {

std::string machine_text(const judge::Verdict& verdict, const judge::Image& image) {
  std::string text = fmt::format(
      "{} case{} {} in {}", support::grouped(verdict.cases), verdict.cases == 1 ? "" : "s",
      "on " + machine_name(verdict, image), support::duration(verdict.seconds));
  if (verdict.on_both > 0) {
    text += fmt::format(", {} of them also on Unicorn", support::grouped(verdict.on_both));
  }
  if (!verdict.note.empty()) text += fmt::format(" ({})", verdict.note);
  return text + '\n';
}

/// Returns the line of a case without its number, which the smallest case does not have.
std::string smallest_text(const check::JudgedCase& one, const check::Rules& rules) {
  const std::string line = check::text_of(one, rules);
  return line.substr(line.find("): ") + 3);
}

/// What a caller of 64-bit code may not set, because it takes the operands for 32-bit integers.
std::string hint_of_types(const judge::Subject& subject) {
  const judge::Architecture* const architecture = subject.image.architecture;
  const bool is_64 = architecture != nullptr ? architecture->is_64 : subject.image.bits == 64;
  const bool is_named = subject.frame.text.find("->") != std::string::npos;
  if (!is_64 || is_named) return {};
  return "; if it takes types of 64 bits, name them, as in --frame 'long, long -> long'";
}

/// What a caller may not set, because it takes what the routine takes for numbers.
std::string hint_of_pointers(const judge::Subject& subject, const judge::Ending& ending) {
  if (ending.end != judge::End::bad_address || subject.frame.text.find("->") != std::string::npos ||
      subject.image.missing_at(ending.address) != nullptr || is_whole(subject.variant.operation)) {
    return {};
  }
  const auto pointer = [](const cases::Format& format, std::string_view mark) {
    return fmt::format("{}int{}_t{}", format.is_signed ? "" : "u", cases::storage_bits(format),
                       mark);
  };
  const cases::Format operand = cases::operand_format(subject.variant);
  const std::size_t count = cases::operands_of(subject.variant);
  std::string types;
  if (subject.variant.operation == cases::Operation::dot) {
    const std::string array = pointer(operand, fmt::format("[{}]", count / 2));
    types = fmt::format("{0}, {0}, ", array);
  } else {
    for (std::size_t i = 0; i < count; ++i) types += pointer(operand, "*") + ", ";
  }
  return fmt::format("; if it takes pointers, name its types, as in --frame '{}{} ->'", types,
                     pointer(subject.variant.format, "*"));
}

std::string unsteady_text(const judge::Subject& subject, const judge::Verdict& verdict) {
  const std::string& operands = verdict.unsteady->operands;
  if (const auto& state = verdict.state) {
    return fmt::format(
        "STATEFUL: for {} the result depends on earlier calls: {} at {:04x}h reads {:x}h, and {} "
        "at {:04x}h writes it. No rule is tried: the operands alone do not decide the result\n",
        operands, state->reads.text, state->reads.at, state->address, state->writes.text,
        state->writes.at);
  }
  if (verdict.is_steady_on_processor) {
    return fmt::format(
        "UNSTEADY: for {} the result on Unicorn is not that on this processor: the routine reads "
        "what differs between processors, such as a flag that Intel leaves undefined\n",
        operands);
  }
  return fmt::format(
      "UNSTEADY: for {} the result differs from call to call: the routine reads a register, a flag "
      "or memory that its caller does not set{}{}\n",
      operands,
      subject.image.architecture == nullptr ? ", or a flag that Intel leaves undefined" : "",
      hint_of_types(subject));
}

}  // namespace

std::string code_text(const judge::Image& image) {
  return image.architecture != nullptr ? fmt::format("{} code", judge::code_name(image))
                                       : fmt::format("{}-bit code", image.bits);
}

std::string machine_name(const judge::Verdict& verdict, const judge::Image& image) {
  return verdict.machine == judge::On::processor
             ? "this processor"
             : std::string(judge::emulator_of(image.architecture));
}

std::string broken_text(judge::RegisterMask broken, const judge::Image& image) {
  using judge::Call;
  std::string text;
  const auto add = [&text](const std::string& what) {
    text += (text.empty() ? "" : " and ") + what;
  };
  const judge::RegisterMask registers =
      broken & ((judge::RegisterMask{1} << registers_of(image)) - 1);
  if (registers != 0) add("does not keep " + register_names(registers, image));
  if ((broken & Call::sets_direction) != 0) add("leaves the direction flag set");
  if ((broken & Call::fills_x87) != 0) add("leaves values on the x87 stack");
  if ((broken & Call::controls_x87) != 0) add("changes the control word of the x87");
  if ((broken & Call::moves_segments) != 0) add("changes DS or SS");
  return text;
}

std::string register_names(judge::RegisterMask mask, const judge::Image& image) {
  std::string text;
  for (std::size_t r = 0; r < registers_of(image); ++r) {
    if ((mask >> r & 1U) == 0) continue;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", register_name(image, r));
  }
  return text.empty() ? "none" : text;
}

std::string text_of(const judge::Ending& ending, const judge::Image& image) {
  const std::string at = fmt::format("at {:04x}h", ending.at);
  const std::uint32_t linear = image.code_at(ending.at);
  const bool outside = linear < image.first || linear >= image.end;
  switch (ending.end) {
    case judge::End::returned:
      return "returns";
    case judge::End::divide_error:
      return "raises a divide error (#DE) " + at;
    case judge::End::bad_address:
      if (const judge::Symbol* const missing = image.missing_at(ending.address)) {
        const std::string name = support::quoted(missing->name);
        const bool has_library = image.architecture == nullptr || image.architecture->has_library;
        // Compilers call functions of their own library, whose names begin so.
        if (image.container == judge::object_container && missing->name.starts_with("__") &&
            has_library) {
          return fmt::format(
              "uses {}, which the object does not have, {}; Debian's package {} has "
              "it, and judge adds it",
              name, at,
              image.architecture != nullptr ? image.architecture->package
              : image.bits == 64            ? "gcc"
                                            : "gcc-multilib");
        }
        return image.container == judge::linked_container
                   ? fmt::format(
                         "uses {}, which needs another file or the loader of the system, "
                         "{}; link it statically",
                         name, at)
                   : fmt::format("uses {}, which the object does not have, {}; add it with ld -r",
                                 name, at);
      }
      return fmt::format("uses memory at {:x}h, where there is none, {}", ending.address, at);
    case judge::End::interrupt:
      if (ending.number == 13) return "raises a general protection fault (#GP) " + at;
      return fmt::format("calls interrupt {:02x}h {}: routines run without a system", ending.number,
                         at);
    case judge::End::exception:
      return fmt::format("raises exception {} of the processor {}", ending.number, at);
    case judge::End::system_call:
      return fmt::format("makes a system call {}: routines run without a system", at);
    case judge::End::port:
      return "uses an input or output port " + at;
    case judge::End::endless:
      return "does not end";
    case judge::End::bad_instruction:
    case judge::End::halted:
      if (outside) return fmt::format("leaves the code, to {:04x}h", ending.at);
      return ending.end == judge::End::halted ? "halts the processor " + at
                                              : "has an invalid instruction " + at;
    default:
      return "faults";
  }
}

std::string heading_text(const judge::Subject& subject, const std::string& file,
                         const std::string& rules) {
  const judge::Image& image = subject.image;
  return fmt::format("{}: {}, routine at {:04x}h, {}, frame {}\n{}\n", support::printable(file),
                     image.container, image.entry, code_text(image), subject.frame.text, rules);
}

std::string calls_text(const judge::Subject& subject, const judge::Verdict& verdict) {
  const judge::Image& image = subject.image;
  std::string text = machine_text(verdict, image);
  if (verdict.stuck) {
    return text + fmt::format("BROKEN: for {} the routine {}{}\n", verdict.stuck->operands,
                              text_of(verdict.stuck->ending, image),
                              hint_of_pointers(subject, verdict.stuck->ending));
  }
  text += fmt::format("changes registers {}", register_names(verdict.changed, image));
  judge::RegisterMask kept = subject.frame.elsewhere ? subject.frame.elsewhere->kept : 0;
  for (const auto& name : subject.frame.kept) kept |= judge::RegisterMask{1} << name.holder();
  if (kept != 0) text += fmt::format("; must keep {}", register_names(kept, image));
  text += '\n';
  if (verdict.not_preserved) {
    text += fmt::format("BREAKS its convention in {} {}: it {}, first for {}\n",
                        support::grouped(verdict.not_preserved_count),
                        verdict.not_preserved_count == 1 ? "case" : "cases",
                        broken_text(verdict.not_preserved->broken, image),
                        verdict.not_preserved->operands);
  }
  if (verdict.unsteady) text += unsteady_text(subject, verdict);
  if (verdict.first_divide_error) {
    text +=
        fmt::format("{} case{} raise{} a divide error (#DE), first {}\n",
                    support::grouped(verdict.divide_errors), verdict.divide_errors == 1 ? "" : "s",
                    verdict.divide_errors == 1 ? "s" : "", verdict.first_divide_error->operands);
  }
  return text;
}

std::string judgement_text(const check::Judge& judge,
                           const std::optional<check::JudgedCase>& smallest) {
  const std::string_view cases = judge.cases() == 1 ? "case" : "cases";
  std::string text;
  if (judge.wrong() == 0) {
    text = fmt::format("AGREES on {} {}\n", support::grouped(judge.cases()), cases);
  } else {
    text = fmt::format("WRONG in {} of {} {}\n", support::grouped(judge.wrong()),
                       support::grouped(judge.cases()), cases);
    if (smallest) {
      text += fmt::format("  smallest: {}\n", smallest_text(*smallest, judge.rules()));
    }
  }
  return text + '\n' + check::verdict_text(judge);
}

std::string verdict_text(const judge::Subject& subject, const judge::Verdict& verdict) {
  const std::string text = calls_text(subject, verdict);
  if (verdict.stuck || verdict.state) return text;
  return text + judgement_text(*verdict.judge, verdict.smallest);
}

std::string whole_text(const judge::Subject& subject, const judge::WholeVerdict& whole) {
  std::string text = calls_text(subject, whole.verdict);
  if (whole.verdict.stuck || whole.verdict.state) return text;
  const judge::Candidate& best = whole.candidates.front();
  if (best.exceptions == 0) {
    text +=
        fmt::format("AGREES on {} cases: {}\n", support::grouped(whole.verdict.cases), best.name);
    for (const judge::Candidate& other : whole.candidates) {
      if (&other == &best || other.exceptions > 0) continue;
      text += fmt::format("  no case distinguishes this from: {}\n", other.name);
    }
    return text;
  }
  return text + fmt::format("WRONG in {} of {} cases; nearest: {}\n  first: {}\n",
                            support::grouped(best.exceptions),
                            support::grouped(whole.verdict.cases), best.name,
                            best.first_exception->operands);
}

std::string instructions_text(const judge::Inspection& inspection) {
  if (inspection.calls == 0) return {};
  return fmt::format(
      "instructions of a call: {} to {}, on average {:.1f}\n",
      support::grouped(inspection.least_instructions),
      support::grouped(inspection.most_instructions),
      static_cast<double>(inspection.instructions) / static_cast<double>(inspection.calls));
}

std::string inspection_text(const judge::Inspection& inspection, const judge::Image& image) {
  const bool is_x86 = image.architecture == nullptr;
  std::string text = fmt::format("{} calls step by step on {}:", inspection.calls,
                                 judge::emulator_of(image.architecture));
  if (inspection.is_clean()) {
    return text + fmt::format(" {}no foreign memory is used, no instruction is changed\n",
                              is_x86 ? "no undefined flag is read, " : "");
  }
  text += '\n';
  const auto place = [](const judge::Inspection::Finding& f) {
    return fmt::format("{} at {:04x}h", f.line.text, f.line.at);
  };
  if (const auto& f = inspection.undefined_flag) {
    std::string flags;
    constexpr std::array<std::pair<unsigned, std::string_view>, 6> names{{{x86model::CF, "CF"},
                                                                          {x86model::PF, "PF"},
                                                                          {x86model::AF, "AF"},
                                                                          {x86model::ZF, "ZF"},
                                                                          {x86model::SF, "SF"},
                                                                          {x86model::OF, "OF"}}};
    for (const auto& [flag, name] : names) {
      if ((f->flags & flag) != 0) flags += fmt::format("{}{}", flags.empty() ? "" : ", ", name);
    }
    text += fmt::format("  READS AN UNDEFINED FLAG: {} reads {}, for {}\n", place(*f), flags,
                        f->operands);
  }
  if (const auto& f = inspection.foreign_memory) {
    text += fmt::format("  USES FOREIGN MEMORY: {} {} {:x}h, for {}\n", place(*f),
                        f->is_write ? "writes" : "reads", f->address, f->operands);
  }
  if (const auto& f = inspection.changes_own_code) {
    text += fmt::format("  CHANGES ITS OWN CODE: {} writes {:x}h, an instruction, for {}\n",
                        place(*f), f->address, f->operands);
  }
  if (const auto& f = inspection.privileged) {
    text += fmt::format("  USES A PRIVILEGED INSTRUCTION: {}, for {}\n", place(*f), f->operands);
  }
  return text;
}

std::string clocks_text(const judge::RoutineClocks& clocks) {
  std::string text = fmt::format("clocks of {} calls by Intel's tables:\n", clocks.calls);
  if (clocks.calls == 0) return "clocks are not counted: no call returns\n";
  const auto row = [&text](std::string_view name, const judge::Spread& spread) {
    text += fmt::format("  {:<14}{:>9}{:>18}{:>9}\n", name, support::grouped(spread.least()),
                        between(spread.mean_min(), spread.mean_max(), 1),
                        support::grouped(spread.most()));
  };
  text += fmt::format("  {:<14}{:>9}{:>18}{:>9}\n", "", "least", "mean", "most");
  row("instructions", clocks.instructions);
  row("bytes fetched", clocks.code_bytes);
  row("bytes of data", clocks.data_bytes);
  for (const auto& on : clocks.on) {
    if (on.without.empty()) {
      row(x86model::name_of(on.cpu), on.clocks);
      continue;
    }
    const judge::Line& first = on.without.front();
    text += fmt::format("  {:<14}no figure for {} at {:04x}h", x86model::name_of(on.cpu),
                        first.text, first.at);
    for (std::size_t i = 1; i < std::min<std::size_t>(on.without.size(), 3); ++i) {
      text += fmt::format(", {} at {:04x}h", on.without[i].text, on.without[i].at);
    }
    if (on.without.size() > 3) text += fmt::format(" and {} others", on.without.size() - 3);
    text += on.is_too_wide ? "; 32 bits need a 386\n" : "\n";
  }
  return text;
}

std::string proof_text(const judge::RoutineProof& proof, const check::Rules& rules,
                       const std::string& solver) {
  const std::string by =
      fmt::format("{} path{}, {} in {}", proof.paths, proof.paths == 1 ? "" : "s", solver,
                  support::duration(proof.seconds));
  if (proof.standing == proof::Standing::proven) {
    return fmt::format("PROVEN for all operands ({})\n", by);
  }
  if (proof.counterexample) {
    return fmt::format("DISPROVEN ({})\n  {}\n", by, smallest_text(*proof.counterexample, rules));
  }
  return fmt::format("NOT PROVEN, only judged by cases: {}\n", support::printable(proof.why));
}

}  // namespace fixproof::cli
