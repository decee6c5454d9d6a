// Calls routines of the processors of architecture.hpp, by their conventions.
#include <algorithm>

#include "judge/code/caller.hpp"

namespace fixproof::judge {

namespace {

class CallerElsewhere final : public Caller {
 public:
  CallerElsewhere(const Subject& subject, std::unique_ptr<Machine> machine)
      : image_(subject.image),
        a_(*subject.image.architecture),
        convention_(subject.frame.elsewhere.value()),
        variant_(subject.variant),
        operands_(subject.image, subject.frame.signature, subject.variant),
        machine_(std::move(machine)),
        file_(a_),
        stack_pointer_(file_.find(a_.stack_pointer).value()) {}

  Answer answer(std::span<const std::uint32_t> words, std::uint64_t number) override {
    enter(words, number);
    Registers left = entered_;
    Answer answer;
    answer.ending = machine_->call(left);
    if (answer.ending.end != End::returned) return answer;
    answer.broken = broken(left);
    answer.changed = changed(left);
    leave(left, std::span(answer.words).first(words_out(variant_)));
    return answer;
  }

  [[nodiscard]] std::uint8_t* memory() const override { return machine_->memory(); }

 private:
  [[nodiscard]] std::uint8_t* at(std::uint32_t address) const {
    return machine_->memory() + image_.index_of(address);
  }

  static std::uint64_t lowest(std::uint64_t value, int bits) {
    return bits == 64 ? value : value & ((std::uint64_t{1} << bits) - 1);
  }

  /// Returns a word of a number with what the convention has above the number.
  [[nodiscard]] std::uint64_t word_of(std::size_t parameter, std::uint64_t value,
                                      cases::Draw& draw) const {
    const Parameter& p = operands_.parameters()[parameter];
    const bool is_narrow = !p.is_pointer && p.bits < a_.word_bits;
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
      const std::uint64_t word = lowest(word_of(parameter, value, draw), a_.word_bits);
      if (part.is_register) {
        entered_.general.at(part.at) = word;
      } else {
        store(at(stack + static_cast<std::uint32_t>(part.at)), word, a_.word_bits / 8,
              a_.is_big_endian);
      }
      value = a_.word_bits == 64 ? 0 : value >> a_.word_bits;
    }
  }

  void enter(std::span<const std::uint32_t> words, std::uint64_t number) {
    cases::Draw draw(68'000, number);
    for (std::uint64_t& r : std::span(entered_.general).first(file_.names.size())) {
      r = lowest(draw.bits(), a_.word_bits);
    }
    entered_.flags = static_cast<std::uint32_t>(draw.bits());
    operands_.put(machine_->memory(), words, draw);
    // The ABIs want multiples of 8 or 16.
    const std::uint32_t stack = (image_.stack_top - convention_.stack_bytes) / 16 * 16;
    set_register(a_.stack_pointer, stack);
    if (a_.link.empty()) {
      store(at(stack + a_.pushed.above), image_.exit / a_.pushed.unit, a_.pushed.bytes, true);
    } else {
      set_register(a_.link, image_.exit - a_.behind_link);
    }
    if (!a_.callee.empty()) set_register(a_.callee, image_.entry);
    if (!a_.zero.empty()) set_register(a_.zero, 0);
    for (const Symbol& base : image_.bases) set_register(base.name, base.offset);
    for (std::size_t i = 0; i < convention_.in.size(); ++i) {
      put(convention_.in[i], i, words, stack, draw);
    }
  }

  void set_register(std::string_view name, std::uint64_t value) {
    entered_.general.at(file_.find(name).value()) = lowest(value, a_.pointer_bits);
  }

  void leave(const Registers& left, std::span<std::uint32_t> words) const {
    if (operands_.has_results_behind_pointers()) return operands_.take(machine_->memory(), words);
    std::uint64_t value = 0;
    int shift = 0;
    for (const Part& part : convention_.out.front().parts) {
      if (shift < 64) value |= left.general.at(part.at) << shift;
      shift += a_.word_bits;
    }
    operands_.give(value, words);
  }

  [[nodiscard]] RegisterMask broken(const Registers& left) const {
    RegisterMask mask = changed_registers(left) & convention_.kept;
    const auto pushed = static_cast<std::uint64_t>(a_.link.empty() ? a_.pushed.bytes : 0);
    const std::uint64_t popped = entered_.general.at(stack_pointer_) + pushed;
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

  const Image& image_;
  const Architecture& a_;
  const Convention& convention_;
  cases::Variant variant_;
  CallOperands operands_;
  std::unique_ptr<Machine> machine_;
  RegisterFile file_;
  std::size_t stack_pointer_;
  Registers entered_{};
};

}  // namespace

std::unique_ptr<Caller> make_caller_elsewhere(const Subject& subject,
                                              std::unique_ptr<Machine> machine) {
  return std::make_unique<CallerElsewhere>(subject, std::move(machine));
}

}  // namespace fixproof::judge
