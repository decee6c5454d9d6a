#include "judge/code/caller.hpp"

namespace fixproof::judge {

namespace {

class X86Caller final : public Caller {
 public:
  X86Caller(const Subject& subject, std::unique_ptr<Machine> machine)
      : variant_(subject.variant),
        machine_(std::move(machine)),
        call_(subject.image, subject.frame, subject.variant, machine_->code_selector()) {}

  Answer answer(std::span<const std::uint32_t> words, std::uint64_t number) override {
    Registers registers;
    call_.enter(machine_->memory(), registers, words, number);
    Answer answer;
    answer.ending = machine_->call(registers);
    if (answer.ending.end != End::returned) return answer;
    answer.broken = call_.broken(registers);
    answer.changed = call_.changed(registers);
    call_.leave(machine_->memory(), registers, std::span(answer.words).first(words_out(variant_)));
    return answer;
  }

  [[nodiscard]] std::uint8_t* memory() const override { return machine_->memory(); }

 private:
  cases::Variant variant_;
  std::unique_ptr<Machine> machine_;
  Call call_;
};

}  // namespace

std::unique_ptr<Caller> make_caller(const Subject& subject, On machine, Trace* trace) {
  if (subject.image.architecture != nullptr) {
    return make_caller_elsewhere(subject, make_emulator(subject.image, trace));
  }
  return std::make_unique<X86Caller>(subject, machine == On::processor
                                                  ? make_processor(subject.image)
                                                  : make_emulator(subject.image, trace));
}

bool ended_well(const Answer& answer) {
  return answer.ending.end == End::returned || answer.ending.end == End::divide_error;
}

std::size_t registers_of(const Image& image) {
  if (image.architecture != nullptr) return RegisterFile(*image.architecture).names.size();
  return image.bits == 64 ? register_count : x86model::register_count;
}

std::string register_name(const Image& image, std::size_t number) {
  if (image.architecture != nullptr) return RegisterFile(*image.architecture).names[number];
  return name_of(whole_register(number, image.bits));
}

}  // namespace fixproof::judge
