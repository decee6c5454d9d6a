#include "judge/code/call.hpp"

#include <algorithm>

namespace fixproof::judge {

namespace {

using x86model::Register;

constexpr std::size_t sp_number = static_cast<std::size_t>(Register::sp);

/// Returns where the results are that are in registers.
std::vector<Place> places_of_results(const Frame& frame, int result_bits, int code_bits) {
  if (!frame.on_stack) return frame.out;
  const RegisterName ax = whole_register(0, code_bits);
  if (result_bits <= code_bits) return {{{ax}}};
  return {{{{Register::dx, ax.size}, ax}}};
}

}  // namespace

std::uint64_t Registers::read(const RegisterName& name) const {
  return general.at(name.holder()) >> name.shift() & ~std::uint64_t{0} >> (64 - bits_of(name));
}

void Registers::write(const RegisterName& name, std::uint64_t value) {
  const std::uint64_t part = ~std::uint64_t{0} >> (64 - bits_of(name)) << name.shift();
  std::uint64_t& whole = general.at(name.holder());
  whole = (whole & ~part) | (value << name.shift() & part);
}

Call::Call(const Image& image, const Frame& frame, const cases::Variant& variant,
           std::uint16_t code_selector)
    : image_(image),
      frame_(frame),
      variant_(variant),
      operands_(image, frame.signature, variant),
      results_(places_of_results(frame, frame.signature.result_bits, image.bits)),
      code_selector_(code_selector),
      slot_(image.bits / 8) {
  std::uint32_t bytes = 0;
  for (const Parameter& p : operands_.parameters()) {
    if (frame.on_stack) bytes += static_cast<std::uint32_t>(slots_of(p) * slot_);
  }
  // The System V ABIs want the stack pointer to be a multiple of 16 before a call; compilers rely
  // on it for vectors. Windows leaves the callee 32 bytes above its return address.
  bottom_ = image.stack_top;
  if (image.bits >= 32) bottom_ -= (image.stack_top - bytes) % 16;
  if (image.bits == 64) bottom_ -= bytes_of_home;
}

int Call::slots_of(const Parameter& p) const {
  if (p.is_pointer) return frame_.is_far ? 2 : 1;
  return std::max(p.bits / (8 * slot_), 1);
}

void Call::push(std::uint8_t* memory, std::uint64_t value, int bytes) {
  top_ -= static_cast<std::uint32_t>(bytes);
  store(memory + image_.index_of(image_.data_at(top_)), value, bytes);
}

void Call::push_parameter(std::uint8_t* memory, std::size_t index,
                          std::span<const std::uint32_t> words) {
  const Parameter& p = operands_.parameters()[index];
  if (p.is_pointer) {
    if (frame_.is_far) push(memory, image_.data_segment, slot_);
    return push(memory, operands_.place(index), slot_);
  }
  const std::uint64_t value = operands_.value(index, words);
  for (int slot = slots_of(p) - 1; slot >= 0; --slot) {
    push(memory, value >> (8 * slot_ * slot), slot_);
  }
}

void Call::load_registers(Registers& registers, std::span<const std::uint32_t> words) const {
  for (std::size_t i = 0; i < frame_.in.size(); ++i) {
    const Place& place = frame_.in[i];
    std::uint64_t value = place.is_pointer ? operands_.place(i) : operands_.value(i, words);
    for (std::size_t part = place.parts.size(); part-- > 0;) {
      const int bits = bits_of(place.parts[part]);
      registers.write(place.parts[part], value);
      value = bits == 64 ? 0 : value >> bits;
    }
  }
}

void Call::enter(std::uint8_t* memory, Registers& registers, std::span<const std::uint32_t> words,
                 std::uint64_t number) {
  cases::Draw draw(386, number);
  for (std::uint64_t& r :
       std::span(registers.general).first(image_.bits == 64 ? register_count : 8)) {
    r = draw.bits();
    if (image_.bits < 64) r = static_cast<std::uint32_t>(r);
  }
  registers.flags = static_cast<std::uint32_t>(draw.bits()) & x86model::arithmetic_flags;
  operands_.put(memory, words, draw);
  top_ = bottom_;
  if (frame_.on_stack) {
    const std::size_t parameters = operands_.parameters().size();
    for (std::size_t i = 0; i < parameters; ++i) {
      push_parameter(memory, frame_.first_is_top ? parameters - 1 - i : i, words);
    }
  }
  popped_ = frame_.callee_pops ? bottom_ : top_;
  if (frame_.is_far) push(memory, code_selector_, slot_);
  push(memory, image_.exit, slot_);
  load_registers(registers, words);
  if (image_.bits == 32) registers.general[sp_number] = 0;
  registers.write(whole_register(sp_number, image_.bits), top_);
  entered_ = registers;
}

void Call::leave(const std::uint8_t* memory, const Registers& registers,
                 std::span<std::uint32_t> words) const {
  if (frame_.out.empty() && operands_.has_results_behind_pointers()) {
    return operands_.take(memory, words);
  }
  const std::size_t each = cases::words_per_number(variant_.format);
  std::size_t word = 0;
  for (const Place& place : results_) {
    std::uint64_t value = 0;
    for (const RegisterName& part : place.parts) {
      const int bits = bits_of(part);
      value = (bits == 64 ? 0 : value << bits) | registers.read(part);
    }
    operands_.give(value, words.subspan(word, each));
    word += each;
  }
}

RegisterMask Call::broken(const Registers& left) const {
  RegisterMask mask = 0;
  for (const RegisterName& name : frame_.kept) {
    if (left.read(name) != entered_.read(name)) mask |= RegisterMask{1} << name.holder();
  }
  if (left.read(whole_register(sp_number, image_.bits)) != popped_)
    mask |= RegisterMask{1} << sp_number;
  constexpr machine_code::X87 fresh;
  if ((left.flags & direction_flag) != 0) mask |= sets_direction;
  if (left.x87.tags != fresh.tags) mask |= fills_x87;
  if (left.x87.control != fresh.control) mask |= controls_x87;
  if (!left.has_own_segments) mask |= moves_segments;
  return mask;
}

RegisterMask Call::changed(const Registers& left) const {
  RegisterMask mask = 0;
  for (std::size_t r = 0; r < left.general.size(); ++r) {
    if (left.general.at(r) != entered_.general.at(r)) mask |= RegisterMask{1} << r;
  }
  return mask & ~(RegisterMask{1} << sp_number);
}

}  // namespace fixproof::judge
