#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "judge/code/machine.hpp"
#include "verify/machine_code/host_segment.hpp"

namespace fixproof::judge {

namespace {

class Processor final : public Machine {
 public:
  explicit Processor(const Image& image)
      : segment_(image.bits, image.memory.size()), entry_(image.entry) {
    std::copy(image.memory.begin(), image.memory.end(), segment_.memory());
    segment_.put_exit(image.exit);
  }

  [[nodiscard]] std::uint8_t* memory() const override { return segment_.memory(); }
  [[nodiscard]] std::uint16_t code_selector() const override { return segment_.code_selector(); }
  Ending call(Registers& registers) override {
    machine_code::HostSegment::Registers host{.flags = registers.flags};
    std::ranges::transform(std::span(registers.general).first(host.general.size()),
                           host.general.begin(),
                           [](std::uint64_t r) { return static_cast<std::uint32_t>(r); });
    const machine_code::CallEnding ending = segment_.call(host, entry_);
    registers = {.flags = host.flags & observed_flags, .x87 = host.x87};
    std::ranges::copy(host.general, registers.general.begin());
    if (ending == machine_code::CallEnding::returned) return {};
    const bool is_divide_error = ending == machine_code::CallEnding::divide_error;
    return {.end = is_divide_error ? End::divide_error : End::fault};
  }

 private:
  machine_code::HostSegment segment_;
  std::uint32_t entry_;
};

}  // namespace

std::string absence_on_processor(const Image& image) {
  if (image.architecture != nullptr) {
    return fmt::format("code for {} runs on {} only", image.architecture->name,
                       emulator_of(image.architecture));
  }
  if (image.bits == 64) return "64-bit code runs on Unicorn only";
  if (image.code_segment != 0 || image.data_segment != 0) {
    return "code with several real-mode segments runs on Unicorn only";
  }
  if (image.base != 0) {
    return fmt::format("code that is linked for {:x}h runs on Unicorn only", image.base);
  }
  return machine_code::HostSegment::absence();
}

std::unique_ptr<Machine> make_processor(const Image& image) {
  return std::make_unique<Processor>(image);
}

}  // namespace fixproof::judge
