#include "judge/code/kept_state.hpp"

#include <map>

#include "judge/check/cases.hpp"
#include "judge/code/inspection.hpp"

namespace fixproof::judge {

namespace {

/// The first readers and writers of bytes, as offsets of instructions.
class Uses {
 public:
  explicit Uses(const Image& image)
      : first_of_stack_(image.data_at(image.stack_top - stack_bytes)),
        end_of_operands_(image.data_at(image.data + data_bytes)) {}

  void add(const Trace& trace) {
    std::map<std::uint64_t, std::uint32_t> written;  // in this call
    for (const Access& access : trace.accesses) {
      if (access.step >= trace.steps.size()) continue;
      const std::uint32_t by = trace.steps[access.step].at;
      for (std::uint32_t i = 0; i < access.bytes; ++i) {
        const std::uint64_t address = access.address + i;
        if (address >= first_of_stack_ && address < end_of_operands_) continue;
        if (access.is_write != 0) {
          written.try_emplace(address, by);
        } else if (!written.contains(address)) {
          readers_.try_emplace(address, by);
        }
      }
    }
    writers_.merge(written);
  }

  [[nodiscard]] std::optional<KeptState> kept(Listing& listing) const {
    for (const auto& [address, reader] : readers_) {
      const auto writer = writers_.find(address);
      if (writer == writers_.end()) continue;
      return KeptState{address, listing.at(reader), listing.at(writer->second)};
    }
    return std::nullopt;
  }

 private:
  std::uint32_t first_of_stack_;
  std::uint32_t end_of_operands_;
  std::map<std::uint64_t, std::uint32_t> readers_;
  std::map<std::uint64_t, std::uint32_t> writers_;
};

}  // namespace

std::optional<KeptState> find_kept_state(const Subject& subject,
                                         std::span<const std::uint32_t> words) {
  Uses uses(subject.image);
  Tracer tracer(subject);
  if (const auto call = tracer.call(words)) uses.add(call->trace);
  check::GeneratedCases cases(subject.variant, {.cases = calls_to_inspect});
  std::vector<std::uint32_t> one(words_in(subject.variant));
  while (cases.next(one)) {
    if (const auto call = tracer.call(one)) uses.add(call->trace);
  }
  Listing listing(subject.image);
  return uses.kept(listing);
}

}  // namespace fixproof::judge
