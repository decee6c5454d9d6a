// AVR on simavr: a core without peripherals, whose memory is that of the image.
#include <simavr/sim_avr.h>
#include <simavr/sim_core.h>
#include <simavr/sim_cycle_timers.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "judge/code/avr_access.hpp"
#include "judge/code/machine.hpp"
#include "verify/machine_code/emulator.hpp"

namespace fixproof::judge {

namespace {

/// A call that executes more instructions than this counts as endless.
constexpr std::uint64_t max_instructions = 20'000'000;

/// simavr tells of an instruction that it does not know in its log only.
bool& has_complained() {
  static bool complaint = false;
  return complaint;
}
void note_complaint(avr_t* /*avr*/, int level, const char* /*format*/, va_list /*values*/) {
  if (level <= LOG_ERROR) has_complained() = true;
}

class Simavr final : public Machine {
 public:
  Simavr(const Image& image, Trace* trace)
      : image_(image), a_(*image.architecture), trace_(trace), memory_(memory_of(image)) {
    avr_global_logger_set(note_complaint);
    avr_->mmcu = "judge";
    // simavr would access the memory outside its array if there were addresses without memory.
    avr_->ramend = DataSpace::bytes - 1;
    avr_->ioend = avr::first_memory - 1;
    avr_->vector_size = 4;
    avr_->rampz = avr::rampz;
    if (a_.pushed.bytes == 3) avr_->eind = avr::eind;
    if (avr_init(avr_.get()) != 0) throw machine_code::EmulatorError("simavr: init");
    for (std::uint8_t* const own : {avr_->flash, avr_->data}) {
      std::free(own);  // NOLINT(*-no-malloc,*-owning-memory): simavr's malloc()
    }
    avr_->flash = memory_.get();
    avr_->flashend = a_.data.first - 1;
    avr_->data = memory_.get() + a_.data.first;
    std::fill_n(avr_->data, avr::first_memory, std::uint8_t{0});
    for (std::uint32_t word = 0; word < reaches_.size(); ++word) {
      constexpr std::array<std::uint8_t, avr::registers> any{};
      const avr::Reach reach = avr::reach_of(
          {.word = static_cast<std::uint16_t>(word), .r = any, .return_bytes = a_.pushed.bytes});
      reaches_[word] = reach.kind != avr::Reach::Kind::none;
    }
  }

  [[nodiscard]] std::uint8_t* memory() const override { return avr_->flash; }
  [[nodiscard]] std::uint16_t code_selector() const override { return 0; }

  Ending call(Registers& called) override {
    enter(called);
    Ending ending{.end = End::endless};
    for (std::uint64_t i = 0; i < max_instructions; ++i) {
      ending.at = avr_->pc;
      if (avr_->pc == image_.exit) {
        called = current();
        return {};
      }
      // Most instructions use nothing but registers, whatever is in them.
      if (trace_ != nullptr || is_outside() || reaches_[word_at(avr_->pc)]) {
        const avr::Reach access = next_access();
        if (trace_ != nullptr) {
          if (trace_->steps.size() >= max_emulated_steps) return ending;
          add_to_trace(access);
        }
        if (const End end = end_before(access, ending); end != End::returned) {
          ending.end = end;
          return ending;
        }
      }
      avr_->state = cpu_Running;
      avr_->run_cycle_count = 0;  // one instruction only
      avr_->pc = avr_run_one(avr_.get());
      if (has_complained()) {
        ending.end = End::bad_instruction;
        return ending;
      }
    }
    return ending;
  }

 private:
  void enter(const Registers& called) {
    for (std::size_t i = 0; i < avr::registers; ++i) {
      avr_->data[i] = static_cast<std::uint8_t>(called.general.at(i));
    }
    std::fill(avr_->data + avr::first_port, avr_->data + avr::first_memory, std::uint8_t{0});
    const std::uint64_t stack = called.general.at(avr::registers);
    avr_->data[avr::low_stack_pointer] = static_cast<std::uint8_t>(stack);
    avr_->data[avr::low_stack_pointer + 1] = static_cast<std::uint8_t>(stack >> 8U);
    // All flags but that of interrupts are those of the arithmetic before.
    for (unsigned flag = 0; flag < 8; ++flag) {
      avr_->sreg[flag] = flag == 7 ? 0 : static_cast<std::uint8_t>(called.flags >> flag & 1U);
    }
    avr_->interrupt_state = 0;
    avr_->pc = image_.entry;
    has_complained() = false;
  }

  [[nodiscard]] std::uint16_t stack_pointer() const {
    return static_cast<std::uint16_t>(avr_->data[avr::low_stack_pointer] |
                                      avr_->data[avr::low_stack_pointer + 1] << 8U);
  }

  [[nodiscard]] Registers current() const {
    Registers now;
    std::copy_n(avr_->data, avr::registers, now.general.begin());
    now.general.at(avr::registers) = stack_pointer();
    for (unsigned flag = 0; flag < 8; ++flag) now.flags |= std::uint32_t{avr_->sreg[flag]} << flag;
    return now;
  }

  [[nodiscard]] bool is_outside() const {
    return avr_->pc < image_.first || avr_->pc >= image_.end;
  }

  [[nodiscard]] avr::Reach next_access() const {
    if (is_outside()) return {};
    return avr::reach_of({.word = word_at(avr_->pc),
                          .next = word_at(avr_->pc + 2),
                          .r = {avr_->data, avr::registers},
                          .stack = stack_pointer(),
                          .high_z = avr_->data[avr::rampz],
                          .return_bytes = a_.pushed.bytes});
  }
  [[nodiscard]] std::uint16_t word_at(std::uint32_t at) const {
    return static_cast<std::uint16_t>(avr_->flash[at] | avr_->flash[at + 1] << 8U);
  }

  /// Returns how the next instruction ends the call; End::returned if it does not.
  [[nodiscard]] End end_before(const avr::Reach& access, Ending& ending) const {
    if (is_outside()) {
      ending.address = avr_->pc;
      return image_.missing_at(avr_->pc) != nullptr ? End::bad_address : End::bad_instruction;
    }
    switch (access.kind) {
      case avr::Reach::Kind::halt:
        return End::halted;
      case avr::Reach::Kind::invalid:
        return End::bad_instruction;
      case avr::Reach::Kind::program:
        ending.address = access.address;
        return access.address < image_.first || access.address >= image_.end ? End::bad_address
                                                                             : End::returned;
      case avr::Reach::Kind::data:
        ending.address = a_.data.first + access.address;
        return end_at(access);
      default:
        return End::returned;
    }
  }

  /// The same for an access to the data space.
  static End end_at(const avr::Reach& access) {
    if (access.address + access.bytes > DataSpace::bytes) return End::bad_address;
    if (access.address >= avr::first_memory || access.address < avr::first_port)
      return End::returned;
    // Of the ports, only those of the core are there: RAMPZ and EIND, SP and SREG.
    return access.address >= avr::rampz ? End::returned : End::port;
  }

  void add_to_trace(const avr::Reach& access) const {
    const auto step = static_cast<std::uint32_t>(trace_->steps.size());
    trace_->steps.push_back({.at = avr_->pc, .bytes = 2, .registers = current()});
    const bool is_data = access.kind == avr::Reach::Kind::data;
    // Registers and ports are no memory.
    if (!is_data && access.kind != avr::Reach::Kind::program) return;
    if (is_data && access.address < avr::first_memory) return;
    trace_->accesses.push_back({.step = step,
                                .address = access.address + (is_data ? a_.data.first : 0),
                                .bytes = access.bytes,
                                .is_write = access.is_write ? 1U : 0U});
  }

  struct Free {
    // NOLINTNEXTLINE(*-no-malloc,*-owning-memory): the memory is calloc()'s
    void operator()(std::uint8_t* memory) const { std::free(memory); }
  };
  using Memory = std::unique_ptr<std::uint8_t, Free>;

  /// Copies the code and the data space. What is between them costs nothing, and no call reads it.
  static Memory memory_of(const Image& image) {
    constexpr std::size_t beyond = 4;  // an instruction at the end reads beyond itself
    // NOLINTNEXTLINE(*-no-malloc): pages of calloc() are there once they are used
    Memory memory(static_cast<std::uint8_t*>(std::calloc(image.memory.size() + beyond, 1)));
    if (!memory) throw std::bad_alloc();
    const std::uint32_t data = image.architecture->data.first;
    std::copy(image.memory.begin() + image.first, image.memory.begin() + image.end,
              memory.get() + image.first);
    std::copy(image.memory.begin() + data, image.memory.end(), memory.get() + data);
    return memory;
  }

  struct Terminate {
    void operator()(avr_t* avr) const {
      avr->flash = avr->data = nullptr;
      avr_terminate(avr);
      // avr_terminate() keeps what avr_init() makes for interrupts.
      avr_free_irq(avr->interrupts.irq, AVR_INT_IRQ_COUNT);
      std::free(avr->irq_pool.irq);  // NOLINT(*-no-malloc,*-owning-memory): simavr's realloc()
      delete avr;  // NOLINT(cppcoreguidelines-owning-memory): that of the unique_ptr
    }
  };

  const Image& image_;
  const Architecture& a_;
  Trace* trace_;
  Memory memory_;
  /// Whether the instruction that begins with a word may use memory or may not run.
  std::vector<bool> reaches_ = std::vector<bool>(0x10000);
  std::unique_ptr<avr_t, Terminate> avr_{new avr_t{}};
};

}  // namespace

std::string absence_on_simavr() { return {}; }

std::unique_ptr<Machine> make_simavr(const Image& image, Trace* trace) {
  return std::make_unique<Simavr>(image, trace);
}

}  // namespace fixproof::judge
