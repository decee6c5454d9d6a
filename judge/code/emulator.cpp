#include <fmt/format.h>
#include <unicorn/unicorn.h>

#include <algorithm>
#include <array>
#include <span>

#include "judge/code/unicorn_machine.hpp"

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

class Emulator final : public UnicornMachine {
 public:
  Emulator(const Image& image, Trace* trace)
      : UnicornMachine(image, trace, UC_ARCH_X86, mode_of(image.bits)) {
    memory()[image.index_of(image.code_at(image.exit))] = 0x90;  // NOP, for the hook
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
    owner().keep_state();
    add_hooks();
    add_hooks_of_x86();
  }

  [[nodiscard]] std::uint16_t code_selector() const override { return image().code_segment; }

  Ending call(Registers& registers) override {
    write_registers(registers);
    const uc_err error = run(image().code_at(image().entry), ~std::uint64_t{0});
    registers = current();
    registers.x87 = {read_word(UC_X86_REG_FPCW), read_word(UC_X86_REG_FPTAG)};
    registers.has_own_segments =
        image().bits > 16 || (read_word(UC_X86_REG_DS) == image().data_segment &&
                              read_word(UC_X86_REG_SS) == image().data_segment);
    const auto at = static_cast<std::uint32_t>(read(image().bits == 16   ? UC_X86_REG_IP
                                                    : image().bits == 32 ? UC_X86_REG_EIP
                                                                         : UC_X86_REG_RIP));
    // Every call starts with the same segments and floating point, and without the exception that
    // ended the last one.
    owner().restore_state();
    if (ending().end == End::returned) return ending();
    if (error != UC_ERR_OK && ending().end == End::halted) {
      ending().end = is_at_sysenter() ? End::system_call : end_after(error);
    }
    // A trace has the exact place, its last step. Otherwise the place is as exact as Unicorn keeps
    // it.
    ending().at = last_place(at);
    return ending();
  }

 protected:
  [[nodiscard]] Registers current() override {
    Values values;
    list(values);
    check(uc_reg_read_batch(engine(), values.numbers.data(), values.places.data(), values.count),
          "registers");
    Registers registers;
    registers.flags = static_cast<std::uint32_t>(values.values.front()) & observed_flags;
    std::copy(values.values.begin() + 1, values.values.end(), registers.general.begin());
    return registers;
  }

  /// Unicorn reports exceptions as interrupts.
  [[nodiscard]] End end_after_exception(std::uint32_t number) override {
    constexpr std::uint32_t invalid_opcode = 6;
    constexpr std::uint32_t general_protection = 13;
    if (number == 0) return End::divide_error;
    if (number == invalid_opcode) return End::bad_instruction;
    if (number == general_protection && is_at_sysenter()) return End::system_call;
    return End::interrupt;
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

  /// Tells whether the last step of a trace is SYSENTER. In 16-bit code it raises #GP, and in
  /// 64-bit code Unicorn does not know it.
  [[nodiscard]] bool is_at_sysenter() const {
    if (trace() == nullptr || trace()->steps.empty()) return false;
    const std::uint32_t at = image().index_of(image().code_at(trace()->steps.back().at));
    return at <= bytes_of_memory() - 2 && fetch(memory() + at, 2) == 0x340F;
  }

  [[nodiscard]] std::uint16_t read_word(int number) const {
    return static_cast<std::uint16_t>(read(number));
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
    const auto known = image().bits == 64 ? std::span<const uc_x86_reg>(wide_registers)
                                          : std::span<const uc_x86_reg>(narrow_registers);
    std::copy(known.begin(), known.end(), to.numbers.begin());
    std::transform(to.values.begin(), to.values.end(), to.places.begin(),
                   [](std::uint64_t& value) { return &value; });
    to.count = static_cast<int>(known.size());
  }

  void write_registers(const Registers& registers) {
    Values written;
    list(written);
    written.values.front() = 2U | registers.flags;  // bit 1 is always set
    std::copy_n(registers.general.begin(), register_count, written.values.begin() + 1);
    check(
        uc_reg_write_batch(engine(), written.numbers.data(), written.places.data(), written.count),
        "registers");
  }

  void add_hooks_of_x86() {
    using Code = void(uc_engine*, std::uint64_t, std::uint32_t, void*);
    const std::uint64_t exit = image().code_at(image().exit);
    Code* const at_exit = [](uc_engine*, std::uint64_t, std::uint32_t, void* data) {
      self<Emulator>(data).stop(End::returned);
    };
    owner().hook(UC_HOOK_CODE, at_exit, as_data(), exit, exit);
    using In = std::uint32_t(uc_engine*, std::uint32_t, int, void*);
    In* const at_in = [](uc_engine*, std::uint32_t, int, void* data) {
      self<Emulator>(data).stop(End::port);
      return 0U;
    };
    owner().hook(UC_HOOK_INSN, at_in, as_data(), 1, 0, UC_X86_INS_IN);
    using Out = void(uc_engine*, std::uint32_t, int, std::uint32_t, void*);
    Out* const at_out = [](uc_engine*, std::uint32_t, int, std::uint32_t, void* data) {
      self<Emulator>(data).stop(End::port);
    };
    owner().hook(UC_HOOK_INSN, at_out, as_data(), 1, 0, UC_X86_INS_OUT);
    using System = void(uc_engine*, void*);
    System* const at_system = [](uc_engine*, void* data) {
      self<Emulator>(data).stop(End::system_call);
    };
    // Without a hook, Unicorn takes SYSCALL for an instruction without effect.
    owner().hook(UC_HOOK_INSN, at_system, as_data(), 1, 0, UC_X86_INS_SYSCALL);
    owner().hook(UC_HOOK_INSN, at_system, as_data(), 1, 0, UC_X86_INS_SYSENTER);
  }
};

}  // namespace

std::string absence_on_unicorn() { return {}; }

std::string absence_on_emulator(const Architecture* architecture) {
  return architecture != nullptr && architecture->is_on_simavr ? absence_on_simavr() : "";
}

std::unique_ptr<Machine> make_emulator(const Image& image, Trace* trace) {
  if (image.architecture != nullptr) {
    return image.architecture->is_on_simavr ? make_simavr(image, trace)
                                            : make_unicorn_elsewhere(image, trace);
  }
  return std::make_unique<Emulator>(image, trace);
}

}  // namespace fixproof::judge
