// Segments made with modify_ldt(2).
#include "machine_code/processor.hpp"

#if defined(__linux__) && defined(__x86_64__) && !defined(__ILP32__)

#include <asm/ldt.h>
#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaltstack() is POSIX's
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <bitset>
#include <boost/noncopyable.hpp>
#include <cerrno>
#include <mutex>
#include <new>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "machine_code/enter_segment.hpp"
#include "machine_code/faults.hpp"

namespace fixproof::machine_code {

namespace {

std::system_error refused(const char* what) { return {errno, std::generic_category(), what}; }

/// @return false if the system rejects the descriptor
bool write_descriptor(user_desc description) {
  constexpr int write_in_new_format = 0x11;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the C library has no function for it
  return syscall(SYS_modify_ldt, write_in_new_format, &description, sizeof description) == 0;
}

/// The entries of the process's descriptor table, allocated to its threads.
class Entries {
 public:
  unsigned take() {
    const std::lock_guard lock(mutex_);
    for (unsigned i = 0; i < used_.size(); ++i) {
      if (used_[i]) continue;
      used_[i] = true;
      return i;
    }
    throw std::system_error(ENOSPC, std::generic_category(), "descriptors");
  }
  void give_back(unsigned entry) {
    const std::lock_guard lock(mutex_);
    used_[entry] = false;
  }

 private:
  std::mutex mutex_;
  std::bitset<LDT_ENTRIES> used_;
};

Entries& entries() {
  static Entries all;
  return all;
}

class Descriptor : private boost::noncopyable {
 public:
  Descriptor(std::uint32_t base, unsigned contents, std::size_t bytes) : entry_(entries().take()) {
    user_desc d{};
    d.entry_number = entry_;
    d.base_addr = base;
    d.limit = static_cast<unsigned>(bytes - 1);
    d.contents = contents & 3U;
    d.useable = 1;
    if (!write_descriptor(d)) {
      const int reason = errno;
      entries().give_back(entry_);
      throw std::system_error(reason, std::generic_category(), "modify_ldt");
    }
  }
  ~Descriptor() {
    // An entry that cannot be cleared stays allocated.
    user_desc empty{};
    empty.entry_number = entry_;
    empty.read_exec_only = 1;
    empty.seg_not_present = 1;
    if (write_descriptor(empty)) entries().give_back(entry_);
  }

  /// A selector of the local table with user privilege.
  [[nodiscard]] std::uint16_t selector() const {
    return static_cast<std::uint16_t>(entry_ << 3U | 7U);
  }

 private:
  unsigned entry_;
};

/// Memory below 2 GiB: the segment, then a page of landing code and a page for the Landing.
class LowMemory : private boost::noncopyable {
 public:
  LowMemory()
      : first_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_32BIT,
                    -1, 0)) {
    if (first_ == MAP_FAILED) throw refused("mmap");
  }
  ~LowMemory() { munmap(first_, bytes); }

  [[nodiscard]] std::uint8_t* at(std::size_t offset) const {
    return static_cast<std::uint8_t*>(first_) + offset;
  }
  [[nodiscard]] std::uint32_t address_of(std::size_t offset) const {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): what a descriptor holds
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(at(offset)));
  }
  void protect(std::size_t offset, std::size_t size, int rights) const {
    if (mprotect(at(offset), size, rights) != 0) throw refused("mprotect");
  }

  static constexpr std::size_t landing_code = segment_size;
  static constexpr std::size_t landing = landing_code + landing_distance;
  static constexpr std::size_t bytes = landing + page_size;

 private:
  void* first_;
};

constexpr std::size_t code_bytes = segment_size - caller_origin;

void put(std::uint8_t* to, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to[i] = static_cast<std::uint8_t>(value >> (8 * i) & 0xFFU);
}

/// Shadow stacks (arch_prctl(2), Linux 6.6) hold 64-bit return addresses only.
bool has_shadow_stack() {
  constexpr int arch_shstk_status = 0x5005;
  std::uint64_t features = 0;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): as above
  return syscall(SYS_arch_prctl, arch_shstk_status, &features) == 0 && features != 0;
}

}  // namespace

struct Processor::Parts {
  explicit Parts(std::size_t data_bytes)
      : data(memory.address_of(0), MODIFY_LDT_CONTENTS_DATA, data_bytes) {}

  LowMemory memory;
  Landing* landing = new (memory.at(LowMemory::landing)) Landing{};
  Descriptor code{memory.address_of(0), MODIFY_LDT_CONTENTS_CODE, segment_size};
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
  std::copy(fixproof_landing, fixproof_landing_end, memory.at(LowMemory::landing_code));
  memory.protect(LowMemory::landing_code, page_size, PROT_READ | PROT_EXEC);

  // The caller: a near call of the routine, then a far jump with a 32-bit offset.
  std::uint8_t* caller = memory.at(caller_origin);
  constexpr std::uint16_t call_length = 3;
  caller[0] = 0xE8;
  put(caller + 1, code_origin - caller_origin - call_length, 2);
  caller[3] = 0x66;
  caller[4] = 0xEA;
  put(caller + 5, memory.address_of(LowMemory::landing_code), 4);
  put(caller + 9, code_selector_of_64_bits(), 2);
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
                  .reserved = 0,
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
  const int signal = call_segment(call);
  for (std::size_t r = 0; r < x86model::register_count; ++r) {
    m.registers.write(static_cast<Register>(r), Size::dword, call.registers[r]);
  }
  if (signal == 0) return CallEnding::returned;
  return signal == SIGFPE ? CallEnding::divide_error : CallEnding::fault;
}

}  // namespace fixproof::machine_code

#endif
