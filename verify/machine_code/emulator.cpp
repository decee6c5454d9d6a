#include "verify/machine_code/emulator.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unicorn/unicorn.h>

#include <algorithm>
#include <array>
#include <boost/noncopyable.hpp>
#include <cerrno>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace fixproof::machine_code {

namespace {

using x86model::Register;
using x86model::Size;

/// In the order of x86model::Register, then the flags.
constexpr std::array register_numbers{UC_X86_REG_EAX, UC_X86_REG_ECX, UC_X86_REG_EDX,
                                      UC_X86_REG_EBX, UC_X86_REG_ESP, UC_X86_REG_EBP,
                                      UC_X86_REG_ESI, UC_X86_REG_EDI, UC_X86_REG_EFLAGS};

void check(uc_err error, const char* what) {
  if (error == UC_ERR_OK) return;
  throw EmulatorError(fmt::format("Unicorn: {}: {}", what, uc_strerror(error)));
}

/// Tells whether the emulated program caused the error. Every other error is a failure of Unicorn.
bool is_fault(uc_err error) {
  switch (error) {
    case UC_ERR_READ_UNMAPPED:
    case UC_ERR_WRITE_UNMAPPED:
    case UC_ERR_FETCH_UNMAPPED:
    case UC_ERR_INSN_INVALID:
    case UC_ERR_WRITE_PROT:
    case UC_ERR_READ_PROT:
    case UC_ERR_FETCH_PROT:
    case UC_ERR_READ_UNALIGNED:
    case UC_ERR_WRITE_UNALIGNED:
    case UC_ERR_FETCH_UNALIGNED:
    case UC_ERR_EXCEPTION:
      return true;
    default:
      return false;
  }
}

/// An emulator maps this much memory for the code that it translates: 1 GiB on 64-bit hosts, 32 MiB
/// on others.
constexpr std::size_t translation_bytes = std::size_t{1} << (sizeof(void*) == 8 ? 30U : 25U);
/// For everything else. Its other allocations take less than 1 MiB; it does not check them.
constexpr std::size_t spare_bytes = std::size_t{1} << 25U;

/// Tries whether the memory of an emulator can be had. If Unicorn cannot map it, it ends the
/// process with exit(1) or a segmentation fault.
void expect_memory() {
  constexpr std::size_t bytes = translation_bytes + spare_bytes;
  void* const trial =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (trial == MAP_FAILED) {
    throw EmulatorError(fmt::format("Unicorn needs {} MiB of address space for each thread: {}",
                                    bytes >> 20U, std::generic_category().message(errno)));
  }
  munmap(trial, bytes);
}

struct alignas(page_size) Segment {
  std::array<std::uint8_t, segment_size> bytes{};
};

/// The caller: CALL NEAR to the routine, a NOP for the return hook, and a jump back.
constexpr std::array<std::uint8_t, 6> caller{
    0xE8,
    static_cast<std::uint8_t>((code_origin - caller_origin - 3) & 0xFF),
    static_cast<std::uint8_t>((code_origin - caller_origin - 3) >> 8),
    0x90,
    0xEB,
    0xFA};
constexpr std::uint16_t after_call = caller_origin + 3;

/// An address outside the segment, so that only a hook ends a run.
constexpr std::uint64_t nowhere = 0xFFFFFFFF;

}  // namespace

struct Emulator::Parts : private boost::noncopyable {
  std::unique_ptr<Segment> segment = std::make_unique<Segment>();
  SegmentMachine machine{segment->bytes.data()};
  uc_engine* engine = nullptr;
  /// The state before the first run.
  uc_context* fresh = nullptr;
  uc_hook at_return = 0;
  uc_hook at_interrupt = 0;
  const Calls* calls = nullptr;
  std::size_t call = 0;
  bool interrupted = false;
  std::uint32_t interrupt = 0;
  /// The exception of a hook, kept because it must not pass through Unicorn.
  std::exception_ptr thrown;

  Parts() = default;
  ~Parts() {
    if (fresh != nullptr) uc_context_free(fresh);
    if (engine != nullptr) uc_close(engine);
  }

  void read_registers() {
    std::array<std::uint32_t, register_numbers.size()> values{};
    transfer(values, [this](int* numbers, void** places, int count) {
      return uc_reg_read_batch(engine, numbers, places, count);
    });
    for (std::size_t r = 0; r < x86model::register_count; ++r) {
      machine.registers.write(static_cast<Register>(r), Size::dword, values[r]);
    }
    machine.flags = {static_cast<std::uint16_t>(values.back() & x86model::arithmetic_flags), 0};
  }

  void write_registers() {
    std::array<std::uint32_t, register_numbers.size()> values{};
    for (std::size_t r = 0; r < x86model::register_count; ++r) {
      values[r] = machine.registers.read(static_cast<Register>(r), Size::dword);
    }
    // Bit 1 of the flags is always set.
    values.back() = 2U | (machine.flags.value & x86model::arithmetic_flags);
    transfer(values, [this](int* numbers, void** places, int count) {
      return uc_reg_write_batch(engine, numbers, places, count);
    });
  }

  /// SP skips the return address of calls->enter(), because CALL pushes its own.
  void enter() {
    calls->enter(call, machine);
    auto& registers = machine.registers;
    registers.write(Register::sp, Size::word, registers.read(Register::sp, Size::word) + 2);
    write_registers();
  }

  void leave(CallEnding ending) {
    read_registers();
    calls->leave(call++, machine, ending);
  }

  /// Runs until a hook stops it. @return false if a fault stopped it
  bool start(std::uint16_t from) {
    interrupted = false;
    const uc_err error = uc_emu_start(engine, from, nowhere, 0, 0);
    if (thrown) std::rethrow_exception(std::exchange(thrown, nullptr));
    if (!is_fault(error)) check(error, "run");
    return error == UC_ERR_OK;
  }

  /// Returns the fault that ended a run. Unicorn keeps an exception pending, so the next one would
  /// be a double fault; restoring the fresh context clears it.
  [[nodiscard]] CallEnding fault() const {
    check(uc_context_restore(engine, fresh), "context");
    return interrupted && interrupt == 0 ? CallEnding::divide_error : CallEnding::fault;
  }

 private:
  template <class Values, class Transfer>
  static void transfer(Values& values, Transfer&& with) {
    std::array<int, register_numbers.size()> numbers{};
    std::array<void*, register_numbers.size()> places{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      numbers[i] = register_numbers[i];
      places[i] = &values[i];
    }
    check(with(numbers.data(), places.data(), static_cast<int>(values.size())), "registers");
  }
};

namespace {

/// Unicorn takes hooks as void*, and only a reinterpret_cast converts a function pointer.
template <class Function>
void* hook_of(Function* function) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): see above
  return reinterpret_cast<void*>(function);
}

}  // namespace

std::string Emulator::absence() { return {}; }

std::string Emulator::version() {
  const unsigned version = uc_version(nullptr, nullptr);
  return fmt::format("{}.{}.{}", version >> 24, version >> 16 & 0xFF, version >> 8 & 0xFF);
}

Emulator::Emulator(std::span<const std::uint8_t> code) : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  auto& bytes = p.segment->bytes;
  if (code.size() > segment_size - code_origin) throw std::length_error("code for a segment");
  std::copy(caller.begin(), caller.end(), bytes.begin() + caller_origin);
  std::copy(code.begin(), code.end(), bytes.begin() + code_origin);
  // One at a time: no other emulator takes the memory between the trial and its use.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  expect_memory();
  check(uc_open(UC_ARCH_X86, UC_MODE_16, &p.engine), "open");
  check(uc_mem_map_ptr(p.engine, 0, segment_size, UC_PROT_ALL, bytes.data()), "memory");

  check(uc_context_alloc(p.engine, &p.fresh), "context");
  check(uc_context_save(p.engine, p.fresh), "context");

  const auto on_return = [](uc_engine* engine, std::uint64_t, std::uint32_t, void* data) {
    auto& parts = *static_cast<Parts*>(data);
    try {
      parts.leave(CallEnding::returned);
      if (parts.call < parts.calls->count) return parts.enter();
    } catch (...) {
      parts.thrown = std::current_exception();
    }
    uc_emu_stop(engine);
  };
  const auto on_interrupt = [](uc_engine* engine, std::uint32_t number, void* data) {
    auto& parts = *static_cast<Parts*>(data);
    parts.interrupted = true;
    parts.interrupt = number;
    uc_emu_stop(engine);
  };
  // NOLINTBEGIN(cppcoreguidelines-pro-type-vararg): the only function there is
  check(uc_hook_add(p.engine, &p.at_return, UC_HOOK_CODE,
                    hook_of<void(uc_engine*, std::uint64_t, std::uint32_t, void*)>(on_return), &p,
                    after_call, after_call),
        "hook");
  check(uc_hook_add(p.engine, &p.at_interrupt, UC_HOOK_INTR,
                    hook_of<void(uc_engine*, std::uint32_t, void*)>(on_interrupt), &p, 1, 0),
        "hook");
  // NOLINTEND(cppcoreguidelines-pro-type-vararg)
}

Emulator::~Emulator() = default;

std::uint8_t* Emulator::memory() const { return parts_->segment->bytes.data(); }

void Emulator::run(const Calls& calls) {
  Parts& p = *parts_;
  p.calls = &calls;
  p.call = 0;
  while (p.call < calls.count) {
    p.enter();
    const bool stopped = p.start(caller_origin);
    if (!stopped || p.interrupted) p.leave(p.fault());
  }
  p.calls = nullptr;
}

CallEnding Emulator::trace(SegmentMachine& m, const Step& step, std::size_t limit) {
  Parts& p = *parts_;
  p.machine.registers = m.registers;
  p.machine.flags = m.flags;
  p.machine.memory.write(m.registers.read(Register::sp, Size::word), after_call);
  std::uint64_t next = code_origin;
  for (std::size_t steps = 0; steps < limit; ++steps) {
    step(p.machine, static_cast<std::uint16_t>(next));
    p.write_registers();
    p.interrupted = false;
    // One instruction at a time: Unicorn ignores flags written within a block of translated code.
    const uc_err error = uc_emu_start(p.engine, next, nowhere, 0, 1);
    if (!is_fault(error)) check(error, "run");
    p.read_registers();
    m.registers = p.machine.registers;
    m.flags = p.machine.flags;
    if (error != UC_ERR_OK || p.interrupted) return p.fault();
    check(uc_reg_read(p.engine, UC_X86_REG_IP, &next), "registers");
    if (next == after_call) {
      step(p.machine, after_call);
      return CallEnding::returned;
    }
  }
  return CallEnding::fault;
}

}  // namespace fixproof::machine_code
