#include "judge/code/unicorn_machine.hpp"

namespace fixproof::judge {

namespace {

/// A call that executes more basic blocks than this counts as endless.
constexpr std::uint64_t max_blocks = 2'000'000;

}  // namespace

UnicornMachine::UnicornMachine(const Image& image, Trace* trace, uc_arch processor, uc_mode mode,
                               int model)
    : image_(image), trace_(trace), memory_(image), engine_(processor, mode) {
  if (model >= 0) check(uc_ctl_set_cpu_model(engine(), model), "model");
  check(uc_mem_map_ptr(engine(), image.base, memory_.size(), UC_PROT_ALL, memory()), "memory");
}

std::uint64_t UnicornMachine::read(int number) const {
  std::uint64_t value = 0;
  check(uc_reg_read(engine(), number, &value), "registers");
  return value;
}

void UnicornMachine::write(int number, std::uint64_t value) const {
  check(uc_reg_write(engine(), number, &value), "registers");
}

uc_err UnicornMachine::run(std::uint64_t from, std::uint64_t until) {
  ending_ = {.end = End::halted};
  blocks_ = 0;
  return uc_emu_start(engine(), from, until, 0, 0);
}

void UnicornMachine::stop(End end) {
  ending_.end = end;
  uc_emu_stop(engine());
}

std::uint32_t UnicornMachine::last_place(std::uint32_t otherwise) const {
  return trace_ != nullptr && !trace_->steps.empty() ? trace_->steps.back().at : otherwise;
}

void UnicornMachine::add_hooks() {
  using Code = void(uc_engine*, std::uint64_t, std::uint32_t, void*);
  Code* const at_block = [](uc_engine*, std::uint64_t, std::uint32_t, void* data) {
    if (++self(data).blocks_ > max_blocks) self(data).stop(End::endless);
  };
  engine_.hook(UC_HOOK_BLOCK, at_block, this, 1, 0);
  using Interrupt = void(uc_engine*, std::uint32_t, void*);
  Interrupt* const at_interrupt = [](uc_engine*, std::uint32_t number, void* data) {
    self(data).ending_.number = static_cast<std::uint8_t>(number);
    self(data).stop(self(data).end_after_exception(number));
  };
  engine_.hook(UC_HOOK_INTR, at_interrupt, this, 1, 0);
  using Invalid = bool(uc_engine*, uc_mem_type, std::uint64_t, int, std::int64_t, void*);
  Invalid* const at_invalid = [](uc_engine*, uc_mem_type, std::uint64_t address, int, std::int64_t,
                                 void* data) {
    self(data).ending_.address = address;
    self(data).ending_.end = End::bad_address;
    return false;
  };
  engine_.hook(UC_HOOK_MEM_INVALID, at_invalid, this, 1, 0);
  if (trace_ != nullptr) add_trace_hooks();
}

void UnicornMachine::add_trace_hooks() {
  using Code = void(uc_engine*, std::uint64_t, std::uint32_t, void*);
  Code* const at_step = [](uc_engine*, std::uint64_t address, std::uint32_t size, void* data) {
    UnicornMachine& m = self(data);
    const auto at = static_cast<std::uint32_t>(address) - m.image_.code_at(0);
    if (at == m.image_.exit) return;
    if (m.trace_->steps.size() >= max_emulated_steps) return m.stop(End::endless);
    m.trace_->steps.push_back({at, size, m.current()});
  };
  engine_.hook(UC_HOOK_CODE, at_step, this, 1, 0);
  using Memory = void(uc_engine*, uc_mem_type, std::uint64_t, int, std::int64_t, void*);
  Memory* const at_access = [](uc_engine*, uc_mem_type type, std::uint64_t address, int size,
                               std::int64_t,
                               void* data) { self(data).note_access(type, address, size); };
  engine_.hook(UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE, at_access, this, 1, 0);
}

void UnicornMachine::note_access(uc_mem_type type, std::uint64_t address, int size) {
  if (trace_->steps.empty()) return;
  Access access{.step = static_cast<std::uint32_t>(trace_->steps.size() - 1),
                .address = address,
                .bytes = static_cast<std::uint32_t>(size),
                .is_write = type == UC_MEM_WRITE ? 1U : 0U};
  const std::uint64_t at = address - image_.base;
  if (access.is_write == 0 && size <= 4 && at <= memory_.size() - 4) {
    access.value = static_cast<std::uint32_t>(fetch(memory() + at, size, image_.is_big_endian()));
  }
  trace_->accesses.push_back(access);
}

}  // namespace fixproof::judge
