#include "judge/code/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "judge/check/cases.hpp"
#include "judge/code/answering.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/words.hpp"
#include "x86model/flags.hpp"
#include "x86model/text.hpp"

namespace fixproof::judge {

namespace {

bool is_own(const Image& image, std::uint64_t address, std::uint32_t bytes) {
  const auto inside = [&](std::uint64_t first, std::uint64_t end) {
    return address >= first && address <= end && bytes <= end - address;
  };
  const bool is_far = std::ranges::any_of(image.regions, [&](const Region& region) {
    return inside(region.address, region.address + region.bytes.size());
  });
  return is_far || inside(image.first, std::max(image.end, image.reserved)) ||
         inside(image.data_at(image.stack_top - stack_bytes),
                image.data_at(image.data + data_bytes));
}

class Inspector {
 public:
  explicit Inspector(const Subject& subject)
      : subject_(subject), tracer_(subject), listing_(subject.image) {}

  void look_at(std::span<const std::uint32_t> words) {
    const auto call = tracer_.call(words);
    if (!call) return;
    ++inspection_.calls;
    operands_ = text_of_operands(subject_.variant, words);
    // What flags an instruction reads is known of x86 only.
    if (subject_.image.architecture == nullptr) look_at_instructions(call->trace);
    const std::uint64_t steps = call->trace.steps.size();
    inspection_.instructions += steps;
    inspection_.least_instructions = std::min(inspection_.least_instructions, steps);
    inspection_.most_instructions = std::max(inspection_.most_instructions, steps);
    look_at_memory(call->trace);
  }

  [[nodiscard]] const Inspection& inspection() const { return inspection_; }

 private:
  void look_at_instructions(const Trace& trace) {
    // A caller leaves unknown flags.
    unsigned undefined = x86model::arithmetic_flags;
    for (const Step& step : trace.steps) {
      const Decoded& instruction = instruction_at(step.at);
      const x86model::FlagUse& effects = instruction.flags;
      if ((effects.reads & undefined) != 0 && !inspection_.undefined_flag) {
        inspection_.undefined_flag = {.operands = operands_,
                                      .line = listing_.at(step.at),
                                      .flags = effects.reads & undefined};
      }
      undefined = (undefined & ~unsigned{effects.sets}) | effects.leaves_undefined;
      // Code of DOS may use them.
      const bool is_program = subject_.image.bits == 64;
      if (is_program && instruction.is_privileged && !inspection_.privileged) {
        inspection_.privileged = {.operands = operands_, .line = listing_.at(step.at)};
      }
    }
  }

  const Decoded& instruction_at(std::uint32_t offset) {
    const auto known = instructions_.find(offset);
    if (known != instructions_.end()) return known->second;
    return instructions_.emplace(offset, listing_.decoded_at(offset)).first->second;
  }

  void look_at_memory(const Trace& trace) {
    const Image& image = subject_.image;
    std::map<std::uint32_t, std::uint32_t> code;  // the size of each instruction, by its address
    for (const Step& step : trace.steps) code[image.code_at(step.at)] = step.bytes;
    for (const Access& access : trace.accesses) {
      if (access.step >= trace.steps.size()) continue;
      const auto finding = [&] {
        return Inspection::Finding{.operands = operands_,
                                   .line = listing_.at(trace.steps[access.step].at),
                                   .address = access.address,
                                   .is_write = access.is_write != 0};
      };
      if (!inspection_.foreign_memory && !is_own(image, access.address, access.bytes)) {
        inspection_.foreign_memory = finding();
      }
      if (access.is_write == 0 || inspection_.changes_own_code) continue;
      const bool is_code = std::ranges::any_of(code, [&](const auto& instruction) {
        const auto [at, bytes] = instruction;
        return access.address < at + bytes && access.address + access.bytes > at;
      });
      if (is_code) inspection_.changes_own_code = finding();
    }
  }

  const Subject& subject_;
  Tracer tracer_;
  Listing listing_;
  std::map<std::uint32_t, Decoded> instructions_;  // by offset
  Inspection inspection_;
  std::string operands_;
};

std::string changes_text(const Registers& before, const Registers& after, const Image& image) {
  const int bits = image.bits;
  std::string text;
  for (std::size_t r = 0; r < registers_of(image); ++r) {
    if (before.general.at(r) == after.general.at(r)) continue;
    if (image.architecture != nullptr) {
      text += fmt::format(" {}={:0{}x}", register_name(image, r), after.general.at(r), bits / 4);
      continue;
    }
    // In 16-bit code, the upper half is shown only if it changes.
    const bool high = (before.general.at(r) >> 16U) != (after.general.at(r) >> 16U);
    const RegisterName name = whole_register(r, bits == 16 && high ? 32 : bits);
    text += fmt::format(" {}={:0{}x}", name_of(name), after.read(name), bits_of(name) / 4);
  }
  if (before.flags != after.flags) text += fmt::format(" fl={:04x}", after.flags);
  return text;
}

}  // namespace

Inspection inspect(const Subject& subject) {
  Inspector inspector(subject);
  check::GeneratedCases cases(subject.variant, {.cases = calls_to_inspect});
  std::vector<std::uint32_t> words(words_in(subject.variant));
  while (cases.next(words)) inspector.look_at(words);
  return inspector.inspection();
}

TraceText trace_text(const Subject& subject, std::span<const std::uint32_t> words) {
  const auto call = Tracer(subject).call(words);
  if (!call) throw support::UsageError("Unicorn ends while it runs this call");
  Listing listing(subject.image);
  std::string text;
  const auto& steps = call->trace.steps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string changes =
        i + 1 < steps.size()
            ? changes_text(steps[i].registers, steps[i + 1].registers, subject.image)
            : "";
    const std::string line =
        fmt::format("{:04x}  {:<30}{}", steps[i].at, listing.at(steps[i].at).text, changes);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  if (call->answer.ending.end == End::returned) {
    const auto results = std::span(call->answer.words).first(words_out(subject.variant));
    text +=
        fmt::format("returns {}\n", cases::hex_words(results, subject.variant.format.word_bits));
  }
  return {text, call->answer.ending};
}

}  // namespace fixproof::judge
