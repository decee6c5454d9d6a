#include "verify/machine_code/emulator.hpp"

#include <fmt/format.h>
#include <unicorn/unicorn.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <span>
#include <utility>

#include "judge/code/machine.hpp"
#include "judge/code/unicorn_engine.hpp"

namespace fixproof::judge {

namespace {

using machine_code::EmulatorError;

/// The flags, then the registers in the order of encoding: of 16- and 32-bit code, and of 64-bit.
constexpr std::array narrow_registers{UC_X86_REG_EFLAGS, UC_X86_REG_EAX, UC_X86_REG_ECX,
                                      UC_X86_REG_EDX,    UC_X86_REG_EBX, UC_X86_REG_ESP,
                                      UC_X86_REG_EBP,    UC_X86_REG_ESI, UC_X86_REG_EDI};
constexpr std::array wide_registers{
    UC_X86_REG_EFLAGS, UC_X86_REG_RAX, UC_X86_REG_RCX, UC_X86_REG_RDX, UC_X86_REG_RBX,
    UC_X86_REG_RSP,    UC_X86_REG_RBP, UC_X86_REG_RSI, UC_X86_REG_RDI, UC_X86_REG_R8,
    UC_X86_REG_R9,     UC_X86_REG_R10, UC_X86_REG_R11, UC_X86_REG_R12, UC_X86_REG_R13,
    UC_X86_REG_R14,    UC_X86_REG_R15};

uc_mode mode_of(int bits) { return bits == 16 ? UC_MODE_16 : bits == 32 ? UC_MODE_32 : UC_MODE_64; }

/// A call that executes more basic blocks than this counts as endless; a traced call, more steps.
constexpr std::uint64_t max_blocks = 2'000'000;
constexpr std::size_t max_emulated_steps = 100'000;

class Emulator final : public Machine {
 public:
  Emulator(const Image& image, Trace* trace)
      : image_(image), trace_(trace), memory_(image), engine_(UC_ARCH_X86, mode_of(image.bits)) {
    memory()[image.index_of(image.code_at(image.exit))] = 0x90;  // NOP, for the hook
    check(uc_mem_map_ptr(engine_.get(), image.base, memory_.size(), UC_PROT_ALL, memory()),
          "memory");
    if (image.bits == 16) {
      write(UC_X86_REG_CS, image.code_segment);
      for (const int r : {UC_X86_REG_DS, UC_X86_REG_ES, UC_X86_REG_SS}) {
        write(r, image.data_segment);
      }
    }
    if (image.bits == 64) {
      // What protects the stack of compiled code is at FS:28h: far below what calls use of it.
      write(UC_X86_REG_FS_BASE, image.data_at(image.stack_top - stack_bytes));
    }
    initialize_floating_point();
    engine_.keep_state();
    add_hooks();
  }

  [[nodiscard]] std::uint8_t* memory() const override { return memory_.bytes(); }
  [[nodiscard]] std::uint16_t code_selector() const override { return image_.code_segment; }

  Ending call(Registers& registers) override {
    ending_ = {.end = End::halted};
    blocks_ = 0;
    write_registers(registers);
    const uc_err error =
        uc_emu_start(engine_.get(), image_.code_at(image_.entry), ~std::uint64_t{0}, 0, 0);
    registers = read_registers();
    registers.x87 = {read_word(UC_X86_REG_FPCW), read_word(UC_X86_REG_FPTAG)};
    registers.has_own_segments =
        image_.bits > 16 || (read_word(UC_X86_REG_DS) == image_.data_segment &&
                             read_word(UC_X86_REG_SS) == image_.data_segment);
    std::uint64_t at = 0;
    check(uc_reg_read(engine_.get(),
                      image_.bits == 16   ? UC_X86_REG_IP
                      : image_.bits == 32 ? UC_X86_REG_EIP
                                          : UC_X86_REG_RIP,
                      &at),
          "registers");
    // Every call starts with the same segments and floating point, and without the exception that
    // ended the last one.
    engine_.restore_state();
    if (ending_.end == End::returned) return ending_;
    if (error != UC_ERR_OK && ending_.end == End::halted) {
      ending_.end = is_at_sysenter() ? End::system_call : end_after(error);
    }
    // A trace has the exact place, its last step. Otherwise the place is as exact as Unicorn keeps
    // it.
    ending_.at = trace_ != nullptr && !trace_->steps.empty() ? trace_->steps.back().at
                                                             : static_cast<std::uint32_t>(at);
    return ending_;
  }

 private:
  static End end_after(uc_err error) {
    switch (error) {
      case UC_ERR_INSN_INVALID:
      case UC_ERR_EXCEPTION:
        return End::bad_instruction;
      case UC_ERR_READ_UNMAPPED:
      case UC_ERR_WRITE_UNMAPPED:
      case UC_ERR_FETCH_UNMAPPED:
      case UC_ERR_READ_PROT:
      case UC_ERR_WRITE_PROT:
      case UC_ERR_FETCH_PROT:
        return End::bad_address;
      default:
        throw EmulatorError(fmt::format("Unicorn: run: {}", uc_strerror(error)));
    }
  }

  /// Unicorn reports exceptions as interrupts.
  [[nodiscard]] End end_after_interrupt(std::uint32_t number) const {
    constexpr std::uint32_t invalid_opcode = 6;
    constexpr std::uint32_t general_protection = 13;
    if (number == 0) return End::divide_error;
    if (number == invalid_opcode) return End::bad_instruction;
    if (number == general_protection && is_at_sysenter()) return End::system_call;
    return End::interrupt;
  }

  /// Tells whether the last step of a trace is SYSENTER. In 16-bit code it raises #GP, and in
  /// 64-bit code Unicorn does not know it.
  [[nodiscard]] bool is_at_sysenter() const {
    if (trace_ == nullptr || trace_->steps.empty()) return false;
    const std::uint32_t at = image_.index_of(image_.code_at(trace_->steps.back().at));
    return at <= memory_.size() - 2 && fetch(memory() + at, 2) == 0x340F;
  }

  void write(int number, std::uint64_t value) {
    check(uc_reg_write(engine_.get(), number, &value), "registers");
  }

  std::uint16_t read_word(int number) {
    std::uint16_t value = 0;
    check(uc_reg_read(engine_.get(), number, &value), "registers");
    return value;
  }

  /// Gives x87 and SSE the state of a new process on this processor. Unicorn starts with control
  /// words of 0: single precision, and no exception masked.
  void initialize_floating_point() {
    constexpr machine_code::X87 fresh;
    write(UC_X86_REG_FPCW, fresh.control);
    write(UC_X86_REG_FPSW, 0);
    write(UC_X86_REG_FPTAG, fresh.tags);
    write(UC_X86_REG_MXCSR, 0x1F80);
  }

  /// Values of registers, and where Unicorn finds them.
  struct Values {
    std::array<std::uint64_t, wide_registers.size()> values{};
    std::array<int, wide_registers.size()> numbers{};
    std::array<void*, wide_registers.size()> places{};
    int count = 0;
  };
  void list(Values& to) const {
    const auto known = image_.bits == 64 ? std::span<const uc_x86_reg>(wide_registers)
                                         : std::span<const uc_x86_reg>(narrow_registers);
    std::copy(known.begin(), known.end(), to.numbers.begin());
    std::transform(to.values.begin(), to.values.end(), to.places.begin(),
                   [](std::uint64_t& value) { return &value; });
    to.count = static_cast<int>(known.size());
  }

  Registers read_registers() {
    Values read;
    list(read);
    check(uc_reg_read_batch(engine_.get(), read.numbers.data(), read.places.data(), read.count),
          "registers");
    Registers registers;
    registers.flags = static_cast<std::uint32_t>(read.values.front()) & observed_flags;
    std::copy(read.values.begin() + 1, read.values.end(), registers.general.begin());
    return registers;
  }

  void write_registers(const Registers& registers) {
    Values written;
    list(written);
    written.values.front() = 2U | registers.flags;  // bit 1 is always set
    std::copy_n(registers.general.begin(), register_count, written.values.begin() + 1);
    check(uc_reg_write_batch(engine_.get(), written.numbers.data(), written.places.data(),
                             written.count),
          "registers");
  }

  void stop(End end) {
    ending_.end = end;
    uc_emu_stop(engine_.get());
  }

  static Emulator& self(void* data) { return *static_cast<Emulator*>(data); }

  void add_hooks() {
    using Code = void(uc_engine*, std::uint64_t, std::uint32_t, void*);
    const std::uint64_t exit = image_.code_at(image_.exit);
    Code* const at_exit = [](uc_engine*, std::uint64_t, std::uint32_t, void* data) {
      self(data).stop(End::returned);
    };
    engine_.hook(UC_HOOK_CODE, at_exit, this, exit, exit);
    Code* const at_block = [](uc_engine*, std::uint64_t, std::uint32_t, void* data) {
      if (++self(data).blocks_ > max_blocks) self(data).stop(End::endless);
    };
    engine_.hook(UC_HOOK_BLOCK, at_block, this, 1, 0);
    using Interrupt = void(uc_engine*, std::uint32_t, void*);
    Interrupt* const at_interrupt = [](uc_engine*, std::uint32_t number, void* data) {
      self(data).ending_.number = static_cast<std::uint8_t>(number);
      self(data).stop(self(data).end_after_interrupt(number));
    };
    engine_.hook(UC_HOOK_INTR, at_interrupt, this, 1, 0);
    using Invalid = bool(uc_engine*, uc_mem_type, std::uint64_t, int, std::int64_t, void*);
    Invalid* const at_invalid = [](uc_engine*, uc_mem_type, std::uint64_t address, int,
                                   std::int64_t, void* data) {
      self(data).ending_.address = address;
      return false;
    };
    engine_.hook(UC_HOOK_MEM_INVALID, at_invalid, this, 1, 0);
    using In = std::uint32_t(uc_engine*, std::uint32_t, int, void*);
    In* const at_in = [](uc_engine*, std::uint32_t, int, void* data) {
      self(data).stop(End::port);
      return 0U;
    };
    engine_.hook(UC_HOOK_INSN, at_in, this, 1, 0, UC_X86_INS_IN);
    using Out = void(uc_engine*, std::uint32_t, int, std::uint32_t, void*);
    Out* const at_out = [](uc_engine*, std::uint32_t, int, std::uint32_t, void* data) {
      self(data).stop(End::port);
    };
    engine_.hook(UC_HOOK_INSN, at_out, this, 1, 0, UC_X86_INS_OUT);
    using System = void(uc_engine*, void*);
    System* const at_system = [](uc_engine*, void* data) { self(data).stop(End::system_call); };
    // Without a hook, Unicorn takes SYSCALL for an instruction without effect.
    engine_.hook(UC_HOOK_INSN, at_system, this, 1, 0, UC_X86_INS_SYSCALL);
    engine_.hook(UC_HOOK_INSN, at_system, this, 1, 0, UC_X86_INS_SYSENTER);
    if (trace_ != nullptr) add_trace_hooks();
  }

  void add_trace_hooks() {
    using Code = void(uc_engine*, std::uint64_t, std::uint32_t, void*);
    Code* const at_step = [](uc_engine*, std::uint64_t address, std::uint32_t size, void* data) {
      Emulator& e = self(data);
      const auto at = static_cast<std::uint32_t>(address) - e.image_.code_at(0);
      if (at == e.image_.exit) return;
      if (e.trace_->steps.size() >= max_emulated_steps) return e.stop(End::endless);
      e.trace_->steps.push_back({at, size, e.read_registers()});
    };
    engine_.hook(UC_HOOK_CODE, at_step, this, 1, 0);
    using Memory = void(uc_engine*, uc_mem_type, std::uint64_t, int, std::int64_t, void*);
    Memory* const at_access = [](uc_engine*, uc_mem_type type, std::uint64_t address, int size,
                                 std::int64_t, void* data) {
      Emulator& e = self(data);
      if (e.trace_->steps.empty()) return;
      Access access{.step = static_cast<std::uint32_t>(e.trace_->steps.size() - 1),
                    .address = address,
                    .bytes = static_cast<std::uint32_t>(size),
                    .is_write = type == UC_MEM_WRITE ? 1U : 0U};
      const std::uint64_t at = address - e.image_.base;
      const bool is_known = size <= 4 && at <= e.memory_.size() - 4;
      if (access.is_write == 0 && is_known) {
        access.value = static_cast<std::uint32_t>(fetch(e.memory() + at, size));
      }
      e.trace_->accesses.push_back(access);
    };
    engine_.hook(UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE, at_access, this, 1, 0);
  }

  const Image& image_;
  Trace* trace_;
  MappedMemory memory_;
  Engine engine_;
  Ending ending_;
  std::uint64_t blocks_ = 0;
};

}  // namespace

std::string absence_on_unicorn() { return {}; }

std::unique_ptr<Machine> make_emulator(const Image& image, Trace* trace) {
  return std::make_unique<Emulator>(image, trace);
}

}  // namespace fixproof::judge
