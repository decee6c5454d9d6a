// Segments made with modify_ldt(2).
#include "verify/machine_code/processor.hpp"

#if defined(__linux__) && defined(__x86_64__) && !defined(__ILP32__)

#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaltstack() is POSIX's
#include <sys/mman.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "verify/machine_code/enter_segment.hpp"
#include "verify/machine_code/faults.hpp"
#include "verify/machine_code/low_memory.hpp"

namespace fixproof::machine_code {

namespace {

constexpr std::size_t code_bytes = segment_size - caller_origin;

}  // namespace

struct Processor::Parts {
  explicit Parts(std::size_t data_bytes)
      : data(memory.address_of(0), SegmentUse::data, data_bytes) {}

  LowMemory memory{segment_size};
  Landing* landing = new (memory.at(memory.landing())) Landing{};
  Descriptor code{memory.address_of(0), SegmentUse::code, segment_size};
  Descriptor data;
  /// The handler's stack; the largest register files of x86-64 take 11 KiB of it.
  std::vector<std::uint8_t> signal_stack = std::vector<std::uint8_t>(0x10000);
};

std::string Processor::absence() {
  static const std::string reason = []() -> std::string {
    if (has_shadow_stack()) return "shadow stacks are switched on";
    try {
      Processor trial;
      return "";
    } catch (const std::system_error& error) {
      return fmt::format("the system does not provide 16-bit segments: {}", error.what());
    }
  }();
  return reason;
}

Processor::Processor(std::size_t data_bytes) : parts_(std::make_unique<Parts>(data_bytes)) {
  catch_segment_faults();
  const LowMemory& memory = parts_->memory;
  memory.put_landing_code();

  // The caller: a near call of the routine, then a far jump with a 32-bit offset.
  std::uint8_t* caller = memory.at(caller_origin);
  constexpr std::uint16_t call_length = 3;
  caller[0] = 0xE8;
  put(caller + 1, code_origin - caller_origin - call_length, 2);
  caller[3] = 0x66;
  put_far_jump(caller + 4, memory.address_of(memory.landing_code()), code_selector_of_64_bits());
  memory.protect(caller_origin, code_bytes, PROT_READ | PROT_EXEC);
}

Processor::~Processor() = default;

std::uint8_t* Processor::memory() const { return parts_->memory.at(0); }

void Processor::load(std::span<const std::uint8_t> code) {
  if (code.size() > segment_size - code_origin) throw std::length_error("code for a segment");
  const LowMemory& memory = parts_->memory;
  memory.protect(caller_origin, code_bytes, PROT_READ | PROT_WRITE);
  std::copy(code.begin(), code.end(), memory.at(code_origin));
  memory.protect(caller_origin, code_bytes, PROT_READ | PROT_EXEC);
}

struct Processor::Calls::Saved {
  stack_t stack;
  sigset_t blocked;
  SegmentCall call;
};

Processor::Calls::Calls(Processor& processor) : saved_(std::make_unique<Saved>()) {
  Parts& parts = *processor.parts_;
  saved_->call = {.registers = {},
                  .flags = 0,
                  .entry = caller_origin,
                  .code_selector = parts.code.selector(),
                  .data_selector = parts.data.selector(),
                  .hides_registers = 0,
                  .landing = parts.landing};
  stack_t stack{};
  stack.ss_sp = parts.signal_stack.data();
  stack.ss_size = parts.signal_stack.size();
  if (sigaltstack(&stack, &saved_->stack) != 0) throw refused("sigaltstack");
  sigset_t blocked;
  sigfillset(&blocked);
  for (const int fault : {SIGFPE, SIGSEGV, SIGBUS, SIGILL, SIGTRAP}) sigdelset(&blocked, fault);
  pthread_sigmask(SIG_BLOCK, &blocked, &saved_->blocked);
}

Processor::Calls::~Calls() {
  pthread_sigmask(SIG_SETMASK, &saved_->blocked, nullptr);
  sigaltstack(&saved_->stack, nullptr);
}

CallEnding Processor::Calls::call(SegmentMachine& m) const {
  using x86model::Register;
  using x86model::Size;
  SegmentCall& call = saved_->call;
  for (std::size_t r = 0; r < x86model::register_count; ++r) {
    call.registers[r] = m.registers.read(static_cast<Register>(r), Size::dword);
  }
  // SP skips the return address of enter(), because CALL pushes its own.
  constexpr auto sp = static_cast<std::size_t>(Register::sp);
  call.registers[sp] = (call.registers[sp] & 0xFFFF0000U) | ((call.registers[sp] + 2) & 0xFFFFU);
  // Bit 1 of the flags is always set. The system requires enabled interrupts.
  call.flags = 0x202U | (m.flags.value & x86model::arithmetic_flags);
  const CallEnding ending = call_segment(call);
  for (std::size_t r = 0; r < x86model::register_count; ++r) {
    m.registers.write(static_cast<Register>(r), Size::dword, call.registers[r]);
  }
  return ending;
}

}  // namespace fixproof::machine_code

#endif
