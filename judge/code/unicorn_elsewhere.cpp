// The processors of architecture.hpp that Unicorn runs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "judge/code/unicorn_machine.hpp"
#include "verify/cases/draw.hpp"

namespace fixproof::judge {

namespace {

/// The places of registers for Unicorn's functions of many registers.
class Batch {
 public:
  explicit Batch(std::vector<int> numbers)
      : numbers_(std::move(numbers)), values_(numbers_.size()) {
    for (std::uint64_t& value : values_) places_.push_back(&value);
  }
  Batch(const Batch&) = delete;

  [[nodiscard]] std::vector<std::uint64_t>& values() { return values_; }
  void read(uc_engine* engine) {
    std::ranges::fill(values_, 0);
    check(uc_reg_read_batch(engine, numbers_.data(), places_.data(), count()), "registers");
  }
  void write(uc_engine* engine) {
    check(uc_reg_write_batch(engine, numbers_.data(), places_.data(), count()), "registers");
  }

 private:
  [[nodiscard]] int count() const { return static_cast<int>(numbers_.size()); }

  std::vector<int> numbers_;
  std::vector<std::uint64_t> values_;
  std::vector<void*> places_{};
};

/// Registers that calls find as they happen to be.
class Noise {
 public:
  explicit Noise(const Architecture& architecture) : batch_(numbers_of(architecture)) {
    for (const Scratch& scratch : architecture.scratch) {
      bits_.insert(bits_.end(), static_cast<std::size_t>(scratch.count), scratch.bits);
    }
  }

  /// Keeps the bits that stay as they are.
  void keep(uc_engine* engine) {
    batch_.read(engine);
    kept_ = batch_.values();
  }
  void write(uc_engine* engine, std::uint64_t number) {
    if (bits_.empty()) return;
    cases::Draw draw(68'020, number);
    for (std::size_t i = 0; i < bits_.size(); ++i) {
      batch_.values()[i] = (kept_[i] & ~bits_[i]) | (draw.bits() & bits_[i]);
    }
    batch_.write(engine);
  }

 private:
  static std::vector<int> numbers_of(const Architecture& architecture) {
    std::vector<int> numbers;
    for (const Scratch& scratch : architecture.scratch) {
      for (int i = 0; i < scratch.count; ++i) numbers.push_back(scratch.first + i);
    }
    return numbers;
  }

  std::vector<std::uint64_t> bits_{};
  std::vector<std::uint64_t> kept_{};
  Batch batch_;
};

class UnicornElsewhere final : public UnicornMachine {
 public:
  UnicornElsewhere(const Image& image, Trace* trace)
      : UnicornMachine(image, trace, static_cast<uc_arch>(image.architecture->emulator),
                       static_cast<uc_mode>(image.architecture->mode), image.architecture->model),
        a_(*image.architecture),
        batch_(RegisterFile(a_).numbers),
        noise_(a_) {
    for (const Region& region : image.regions) map(region);
    for (const Setting& setting : a_.settings) {
      if (setting.number >= 0) write(setting.number, read(setting.number) | setting.bits);
    }
    if (!a_.first_code.code.empty()) run_first(a_.first_code);
    owner().keep_state();
    noise_.keep(engine());
    add_hooks();
  }

  [[nodiscard]] std::uint16_t code_selector() const override { return 0; }

  Ending call(Registers& registers) override {
    noise_.write(engine(), registers.flags);
    std::copy_n(registers.general.begin(), batch_.values().size(), batch_.values().begin());
    batch_.write(engine());
    const uc_err error = run(image().entry | image().entry_mode, image().exit);
    registers = current();
    const auto place = static_cast<std::uint32_t>(read(a_.program_counter));
    if (error == UC_ERR_OK && ending().end == End::halted && place == image().exit + a_.beyond_stop)
      return {};
    if (error != UC_ERR_OK && ending().end == End::halted) {
      const bool is_address = error >= UC_ERR_READ_UNMAPPED && error <= UC_ERR_FETCH_UNMAPPED;
      ending().end = is_address ? End::bad_address : End::bad_instruction;
    }
    ending().at = last_place(place);
    owner().restore_state();
    return ending();
  }

 protected:
  [[nodiscard]] Registers current() override {
    Registers registers;
    batch_.read(engine());
    std::ranges::copy(batch_.values(), registers.general.begin());
    return registers;
  }

  [[nodiscard]] End end_after_exception(std::uint32_t number) override {
    const auto is_one_of = [number](const auto& numbers) {
      return std::ranges::find(numbers, static_cast<int>(number)) != numbers.end();
    };
    if (is_one_of(a_.divide_errors)) return is_divide() ? End::divide_error : End::bad_instruction;
    if (is_one_of(a_.bad_instructions)) return End::bad_instruction;
    return is_one_of(a_.system_calls) ? End::system_call : End::exception;
  }

 private:
  /// Runs code below the stack, where no call leaves anything that another expects.
  void run_first(const FirstCode& first) {
    const std::uint32_t value = image().stack_top - 16;
    const std::uint32_t code = value - 16;
    const auto at = [&](std::uint32_t address) { return memory() + image().index_of(address); };
    store(at(value), first.value, 8, a_.is_big_endian);
    std::ranges::copy(first.code, at(code));
    const RegisterFile file(a_);
    write(file.numbers[file.find(first.base).value()], value);
    check(uc_emu_start(engine(), code, code + first.code.size(), 0, 0), "first code");
  }

  void map(const Region& region) const {
    const std::uint64_t first = region.address / page_bytes * page_bytes;
    const std::uint64_t end = region.address + region.bytes.size();
    const std::uint64_t pages = (end - first + page_bytes - 1) / page_bytes;
    check(uc_mem_map(engine(), first, pages * page_bytes, UC_PROT_ALL), "memory");
    check(uc_mem_write(engine(), region.address, region.bytes.data(), region.bytes.size()),
          "memory");
  }

  /// Tells whether the instruction that raised an exception divides, as far as its number leaves
  /// that open.
  [[nodiscard]] bool is_divide() const {
    if (a_.divides.front().mask == 0) return true;
    const std::uint64_t at = image().index_of(static_cast<std::uint32_t>(read(a_.program_counter)));
    if (at > bytes_of_memory() - 8) return false;
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < 8; ++i) bytes |= std::uint64_t{memory()[at + i]} << (8 * i);
    return std::ranges::any_of(
        a_.divides, [&](const Pattern& p) { return p.mask != 0 && (bytes & p.mask) == p.bits; });
  }

  const Architecture& a_;
  Batch batch_;
  Noise noise_;
};

}  // namespace

std::unique_ptr<Machine> make_unicorn_elsewhere(const Image& image, Trace* trace) {
  return std::make_unique<UnicornElsewhere>(image, trace);
}

}  // namespace fixproof::judge
