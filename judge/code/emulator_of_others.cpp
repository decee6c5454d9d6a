// Calls routines on the processors of architecture.hpp.
#include <fmt/format.h>
#include <unicorn/unicorn.h>

#include <algorithm>
#include <array>
#include <vector>

#include "judge/code/caller.hpp"
#include "judge/code/unicorn_engine.hpp"

namespace fixproof::judge {

namespace {

/// The places of registers for Unicorn's functions of many registers.
class Batch {
 public:
  explicit Batch(std::vector<int> numbers) : numbers_(std::move(numbers)) {
    for (std::size_t i = 0; i < numbers_.size(); ++i) places_.push_back(&values_.at(i));
  }
  Batch(const Batch&) = delete;

  void read(uc_engine* engine, Registers& registers) {
    values_ = {};
    check(uc_reg_read_batch(engine, numbers_.data(), places_.data(), count()), "registers");
    std::ranges::copy(values_, registers.general.begin());
  }
  void write(uc_engine* engine, const Registers& registers) {
    std::ranges::copy(registers.general, values_.begin());
    check(uc_reg_write_batch(engine, numbers_.data(), places_.data(), count()), "registers");
  }

 private:
  [[nodiscard]] int count() const { return static_cast<int>(numbers_.size()); }

  std::vector<int> numbers_;
  std::array<std::uint64_t, most_registers> values_{};
  std::vector<void*> places_;
};

class CallerElsewhere final : public Caller {
 public:
  CallerElsewhere(const Subject& subject, Trace* trace)
      : image_(subject.image),
        a_(*subject.image.architecture),
        convention_(subject.frame.elsewhere.value()),
        variant_(subject.variant),
        operands_(subject.image, subject.frame.signature, subject.variant),
        trace_(trace),
        memory_(subject.image),
        engine_(static_cast<uc_arch>(a_.emulator), static_cast<uc_mode>(a_.mode)),
        file_(a_),
        batch_(file_.numbers),
        stack_pointer_(file_.find(a_.stack_pointer).value()) {
    if (a_.model >= 0) check(uc_ctl_set_cpu_model(engine_.get(), a_.model), "model");
    check(uc_mem_map_ptr(engine_.get(), image_.base, memory_.size(), UC_PROT_ALL, memory_.bytes()),
          "memory");
    for (const Region& region : image_.regions) map(region);
    for (const Setting& setting : a_.settings) set(setting);
    if (!a_.first_code.code.empty()) run_first(a_.first_code);
    engine_.keep_state();
    add_hooks();
  }

  Answer answer(std::span<const std::uint32_t> words, std::uint64_t number) override {
    enter(words, number);
    batch_.write(engine_.get(), entered_);
    Answer answer;
    answer.ending = run();
    Registers left;
    batch_.read(engine_.get(), left);
    if (answer.ending.end != End::returned) {
      engine_.restore_state();
      return answer;
    }
    answer.broken = broken(left);
    answer.changed = changed(left);
    leave(left, std::span(answer.words).first(words_out(variant_)));
    return answer;
  }

 private:
  void map(const Region& region) {
    const std::uint64_t first = region.address / page_bytes * page_bytes;
    const std::uint64_t end = region.address + region.bytes.size();
    const std::uint64_t pages = (end - first + page_bytes - 1) / page_bytes;
    check(uc_mem_map(engine_.get(), first, pages * page_bytes, UC_PROT_ALL), "memory");
    check(uc_mem_write(engine_.get(), region.address, region.bytes.data(), region.bytes.size()),
          "memory");
  }

  void set(const Setting& setting) {
    if (setting.number < 0) return;
    std::uint64_t value = 0;
    check(uc_reg_read(engine_.get(), setting.number, &value), "registers");
    value |= setting.bits;
    check(uc_reg_write(engine_.get(), setting.number, &value), "registers");
  }

  /// Runs code below the stack, where no call leaves anything that another expects.
  void run_first(const FirstCode& first) {
    const std::uint32_t value = image_.stack_top - 16;
    const std::uint32_t code = value - 16;
    store(at(value), first.value, 8, a_.is_big_endian);
    std::ranges::copy(first.code, at(code));
    std::uint64_t base = value;
    check(uc_reg_write(engine_.get(), file_.numbers[file_.find(first.base).value()], &base),
          "registers");
    check(uc_emu_start(engine_.get(), code, code + first.code.size(), 0, 0), "first code");
  }

  [[nodiscard]] std::uint8_t* at(std::uint32_t address) const {
    return memory_.bytes() + image_.index_of(address);
  }

  [[nodiscard]] std::uint64_t whole(std::uint64_t value) const {
    return a_.is_64 ? value : static_cast<std::uint32_t>(value);
  }

  /// Returns a word of a number with what the convention has above the number.
  [[nodiscard]] std::uint64_t word_of(std::size_t parameter, std::uint64_t value,
                                      cases::Draw& draw) const {
    const Parameter& p = operands_.parameters()[parameter];
    const bool is_narrow = !p.is_pointer && p.bits < a_.word_bits();
    if (is_narrow && a_.above == Above::noise) {
      const std::uint64_t mask = ~std::uint64_t{0} << p.bits;
      return (value & ~mask) | (draw.bits() & mask);
    }
    if (is_narrow && p.bits == 32 && a_.above == Above::extension_of_32) {
      return static_cast<std::uint64_t>(static_cast<std::int32_t>(value));
    }
    return value;
  }

  void put(const Passing& passing, std::size_t parameter, std::span<const std::uint32_t> words,
           std::uint32_t stack, cases::Draw& draw) {
    std::uint64_t value =
        passing.is_pointer ? operands_.place(parameter) : operands_.value(parameter, words);
    for (const Part& part : passing.parts) {
      const std::uint64_t word = whole(word_of(parameter, value, draw));
      if (part.is_register) {
        entered_.general.at(part.at) = word;
      } else {
        store(at(stack + static_cast<std::uint32_t>(part.at)), word, a_.word_bits() / 8,
              a_.is_big_endian);
      }
      value = a_.is_64 ? 0 : value >> 32U;
    }
  }

  void enter(std::span<const std::uint32_t> words, std::uint64_t number) {
    cases::Draw draw(68'000, number);
    for (std::uint64_t& r : std::span(entered_.general).first(file_.names.size())) {
      r = whole(draw.bits());
    }
    operands_.put(memory_.bytes(), words, draw);
    // The ABIs want multiples of 8 or 16.
    const std::uint32_t stack = (image_.stack_top - convention_.stack_bytes) / 16 * 16;
    set_register(a_.stack_pointer, stack);
    if (a_.link.empty()) {
      store(at(stack), image_.exit, 4, a_.is_big_endian);
    } else {
      set_register(a_.link, image_.exit);
    }
    if (!a_.callee.empty()) set_register(a_.callee, image_.entry);
    for (const Symbol& base : image_.bases) set_register(base.name, base.offset);
    for (std::size_t i = 0; i < convention_.in.size(); ++i) {
      put(convention_.in[i], i, words, stack, draw);
    }
  }

  void set_register(std::string_view name, std::uint64_t value) {
    entered_.general.at(file_.find(name).value()) = value;
  }

  void leave(const Registers& left, std::span<std::uint32_t> words) const {
    if (operands_.has_results_behind_pointers()) return operands_.take(memory_.bytes(), words);
    std::uint64_t value = 0;
    int shift = 0;
    for (const Part& part : convention_.out.front().parts) {
      value |= left.general.at(part.at) << shift;
      shift += 32;  // a result of two parts has those of 32 bits
    }
    operands_.give(value, words);
  }

  [[nodiscard]] RegisterMask broken(const Registers& left) const {
    RegisterMask mask = changed_registers(left) & convention_.kept;
    const std::uint64_t popped = entered_.general.at(stack_pointer_) + (a_.link.empty() ? 4 : 0);
    if (left.general.at(stack_pointer_) != popped) mask |= RegisterMask{1} << stack_pointer_;
    return mask;
  }
  [[nodiscard]] RegisterMask changed(const Registers& left) const {
    return changed_registers(left) & ~(RegisterMask{1} << stack_pointer_);
  }
  [[nodiscard]] RegisterMask changed_registers(const Registers& left) const {
    RegisterMask mask = 0;
    for (std::size_t r = 0; r < file_.names.size(); ++r) {
      if (left.general.at(r) != entered_.general.at(r)) mask |= RegisterMask{1} << r;
    }
    return mask;
  }

  Ending run() {
    ending_ = {.end = End::halted};
    blocks_ = 0;
    const uc_err error =
        uc_emu_start(engine_.get(), image_.entry | image_.entry_mode, image_.exit, 0, 0);
    std::uint64_t counter = 0;
    check(uc_reg_read(engine_.get(), a_.program_counter, &counter), "registers");
    const auto place = static_cast<std::uint32_t>(counter);
    if (error == UC_ERR_OK && ending_.end == End::halted && place == image_.exit) return {};
    if (error != UC_ERR_OK && ending_.end == End::halted) {
      const bool is_address = error >= UC_ERR_READ_UNMAPPED && error <= UC_ERR_FETCH_UNMAPPED;
      ending_.end = is_address ? End::bad_address : End::bad_instruction;
    }
    ending_.at = trace_ != nullptr && !trace_->steps.empty() ? trace_->steps.back().at : place;
    return ending_;
  }

  void stop(End end) {
    ending_.end = end;
    uc_emu_stop(engine_.get());
  }

  static CallerElsewhere& self(void* data) { return *static_cast<CallerElsewhere*>(data); }

  [[nodiscard]] End end_after(std::uint32_t exception) const {
    const auto is_one_of = [&](const std::array<int, 2>& numbers) {
      return std::ranges::find(numbers, static_cast<int>(exception)) != numbers.end();
    };
    if (is_one_of(a_.divide_errors)) return End::divide_error;
    return is_one_of(a_.system_calls) ? End::system_call : End::exception;
  }

  void add_hooks() {
    using Code = void(uc_engine*, std::uint64_t, std::uint32_t, void*);
    Code* const at_block = [](uc_engine*, std::uint64_t, std::uint32_t, void* data) {
      if (++self(data).blocks_ > max_blocks) self(data).stop(End::endless);
    };
    engine_.hook(UC_HOOK_BLOCK, at_block, this, 1, 0);
    using Interrupt = void(uc_engine*, std::uint32_t, void*);
    Interrupt* const at_interrupt = [](uc_engine*, std::uint32_t number, void* data) {
      self(data).ending_.number = static_cast<std::uint8_t>(number);
      self(data).stop(self(data).end_after(number));
    };
    engine_.hook(UC_HOOK_INTR, at_interrupt, this, 1, 0);
    using Invalid = bool(uc_engine*, uc_mem_type, std::uint64_t, int, std::int64_t, void*);
    Invalid* const at_invalid = [](uc_engine*, uc_mem_type, std::uint64_t address, int,
                                   std::int64_t, void* data) {
      self(data).ending_.address = address;
      self(data).ending_.end = End::bad_address;
      return false;
    };
    engine_.hook(UC_HOOK_MEM_INVALID, at_invalid, this, 1, 0);
    if (trace_ != nullptr) add_trace_hooks();
  }

  void add_trace_hooks() {
    using Code = void(uc_engine*, std::uint64_t, std::uint32_t, void*);
    Code* const at_step = [](uc_engine*, std::uint64_t address, std::uint32_t size, void* data) {
      CallerElsewhere& e = self(data);
      const auto at = static_cast<std::uint32_t>(address);
      if (at == e.image_.exit) return;
      if (e.trace_->steps.size() >= max_emulated_steps) return e.stop(End::endless);
      Step& step = e.trace_->steps.emplace_back(Step{.at = at, .bytes = size});
      e.batch_.read(e.engine_.get(), step.registers);
    };
    engine_.hook(UC_HOOK_CODE, at_step, this, 1, 0);
    using Memory = void(uc_engine*, uc_mem_type, std::uint64_t, int, std::int64_t, void*);
    Memory* const at_access = [](uc_engine*, uc_mem_type type, std::uint64_t address, int size,
                                 std::int64_t, void* data) {
      CallerElsewhere& e = self(data);
      if (e.trace_->steps.empty()) return;
      e.trace_->accesses.push_back({.step = static_cast<std::uint32_t>(e.trace_->steps.size() - 1),
                                    .address = address,
                                    .bytes = static_cast<std::uint32_t>(size),
                                    .is_write = type == UC_MEM_WRITE ? 1U : 0U});
    };
    engine_.hook(UC_HOOK_MEM_READ | UC_HOOK_MEM_WRITE, at_access, this, 1, 0);
  }

  const Image& image_;
  const Architecture& a_;
  const Convention& convention_;
  cases::Variant variant_;
  CallOperands operands_;
  Trace* trace_;
  MappedMemory memory_;
  Engine engine_;
  RegisterFile file_;
  Batch batch_;
  std::size_t stack_pointer_;
  Registers entered_{};
  Ending ending_{};
  std::uint64_t blocks_ = 0;
};

}  // namespace

std::unique_ptr<Caller> make_caller_elsewhere(const Subject& subject, Trace* trace) {
  return std::make_unique<CallerElsewhere>(subject, trace);
}

}  // namespace fixproof::judge
