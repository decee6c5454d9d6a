#include "verify/machine_code/host_segment.hpp"

#if defined(__linux__) && defined(__x86_64__) && !defined(__ILP32__)

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigfillset() is POSIX's
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <new>

#include "verify/machine_code/enter_segment.hpp"
#include "verify/machine_code/faults.hpp"
#include "verify/machine_code/handler_stack.hpp"
#include "verify/machine_code/low_memory.hpp"
#include "verify/machine_code/processor.hpp"
#include "x86model/flags.hpp"

namespace fixproof::machine_code {

namespace {

/// A stack for the handlers of faults, and a mask without all other signals.
class FaultsOnly : private boost::noncopyable {
 public:
  FaultsOnly() {
    sigset_t blocked;
    sigfillset(&blocked);
    for (const int fault : {SIGFPE, SIGSEGV, SIGBUS, SIGILL, SIGTRAP}) sigdelset(&blocked, fault);
    pthread_sigmask(SIG_BLOCK, &blocked, &blocked_);
  }
  ~FaultsOnly() { pthread_sigmask(SIG_SETMASK, &blocked_, nullptr); }

 private:
  HandlerStack stack_;
  sigset_t blocked_{};
};

/// Returns the state of the x87, then gives x87 and SSE that of a new process.
X87 renew_floating_point() {
  constexpr std::uint32_t sse_control = 0x1F80;
  std::array<std::uint16_t, 14> environment{};  // each of its words has 32 bits
  asm volatile("fnstenv %0\n\tfninit\n\tldmxcsr %1" : "=m"(environment) : "m"(sse_control));
  return {.control = environment[0], .tags = environment[4]};
}

}  // namespace

struct HostSegment::Parts {
  Parts(int width, std::size_t bytes)
      : bits(width),
        memory(bytes),
        code(memory.address_of(0), SegmentUse::code, bytes, width),
        data(memory.address_of(0), SegmentUse::data, bytes, width),
        exit(memory.address_of(memory.exit_jump()), SegmentUse::unreadable_code,
             LowMemory::exit_jump_bytes, 32) {}

  int bits;
  LowMemory memory;
  Landing* landing = new (memory.at(memory.landing())) Landing{};
  Descriptor code;
  Descriptor data;
  Descriptor exit;  ///< with the jump to the landing code
  FaultsOnly faults_only;
};

std::string HostSegment::absence() { return Processor::absence(); }

HostSegment::HostSegment(int bits, std::size_t bytes)
    : parts_(std::make_unique<Parts>(bits, bytes)) {
  catch_segment_faults();
  parts_->memory.put_landing_code();
  parts_->memory.protect(0, bytes, PROT_READ | PROT_WRITE | PROT_EXEC);
}

HostSegment::~HostSegment() = default;

std::uint8_t* HostSegment::memory() const { return parts_->memory.at(0); }

std::uint16_t HostSegment::code_selector() const { return parts_->code.selector(); }

void HostSegment::put_exit(std::uint32_t offset) const {
  put_far_jump(memory() + offset, 0, parts_->exit.selector(), parts_->bits);
}

CallEnding HostSegment::call(Registers& registers, std::uint32_t entry) const {
  SegmentCall call{.registers = {},
                   // Bit 1 of the flags is always set. The system requires enabled interrupts.
                   .flags = 0x202U | (registers.flags & x86model::arithmetic_flags),
                   .entry = entry,
                   .code_selector = parts_->code.selector(),
                   .data_selector = parts_->data.selector(),
                   .hides_registers = __builtin_cpu_supports("avx") != 0 ? 2U : 1U,
                   .landing = parts_->landing};
  std::copy(registers.general.begin(), registers.general.end(), std::begin(call.registers));
  renew_floating_point();  // this process may have raised flags of SSE
  const CallEnding ending = call_segment(call);
  std::copy(std::begin(call.registers), std::end(call.registers), registers.general.begin());
  registers.flags = call.flags;
  registers.x87 = renew_floating_point();
  return ending;
}

}  // namespace fixproof::machine_code

#else

#include <stdexcept>

namespace fixproof::machine_code {

struct HostSegment::Parts {};

std::string HostSegment::absence() { return "this needs Linux on an x86-64 processor"; }

// Callers check absence() first.
HostSegment::HostSegment(int /*bits*/, std::size_t /*bytes*/) { throw std::logic_error(absence()); }
HostSegment::~HostSegment() = default;
// NOLINTBEGIN(readability-convert-member-functions-to-static): the other segment has a state
std::uint8_t* HostSegment::memory() const { return nullptr; }
std::uint16_t HostSegment::code_selector() const { return 0; }
void HostSegment::put_exit(std::uint32_t /*offset*/) const {}
CallEnding HostSegment::call(Registers& /*registers*/, std::uint32_t /*entry*/) const {
  return CallEnding::fault;
}
// NOLINTEND(readability-convert-member-functions-to-static)

}  // namespace fixproof::machine_code

#endif
