#include "judge/code/call.hpp"

#include <algorithm>

namespace fixproof::judge {

namespace {

using x86model::Register;

constexpr std::size_t sp_number = static_cast<std::size_t>(Register::sp);

/// Returns a number of a case, extended to 64 bits by its signedness.
std::uint64_t number_at(std::span<const std::uint32_t> words, std::size_t index,
                        const Parameter& p) {
  if (p.bits > 32) return words[index] | std::uint64_t{words[index + 1]} << 32U;
  std::uint64_t value = words[index];
  const std::uint64_t sign = std::uint64_t{1} << (p.bits - 1);
  if (p.is_signed && (value & sign) != 0) value |= ~std::uint64_t{0} << p.bits;
  return value;
}

/// Returns where the results are that are in registers.
std::vector<Place> places_of_results(const Frame& frame, int result_bits, int code_bits) {
  if (!frame.on_stack) return frame.out;
  const RegisterName ax = whole_register(0, code_bits);
  if (result_bits <= code_bits) return {{{ax}}};
  return {{{{Register::dx, ax.size}, ax}}};
}

}  // namespace

void store(std::uint8_t* to, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to[i] = static_cast<std::uint8_t>(value >> (8 * i) & 0xFFU);
}

std::uint32_t fetch(const std::uint8_t* from, int bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < bytes; ++i) value |= std::uint32_t{from[i]} << (8 * i);
  return value;
}

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
      parameters_(parameters_of(variant)),
      results_(places_of_results(frame, variant.format.word_bits, image.bits)),
      code_selector_(code_selector),
      slot_(image.bits / 8) {
  std::size_t word = 0;
  std::uint32_t data = image.data;
  std::uint32_t bytes = 0;
  for (const Parameter& p : parameters_) {
    first_word_.push_back(word);
    data_offsets_.push_back(data);
    if (!p.is_result) word += p.numbers * static_cast<std::size_t>((p.bits + 31) / 32);
    data += static_cast<std::uint32_t>(p.numbers) * static_cast<std::uint32_t>(p.bits) / 8;
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
  const Parameter& p = parameters_[index];
  if (p.is_pointer) {
    if (frame_.is_far) push(memory, image_.data_segment, slot_);
    return push(memory, data_offsets_[index], slot_);
  }
  const std::uint64_t value = number_at(words, first_word_[index], p);
  for (int slot = slots_of(p) - 1; slot >= 0; --slot) {
    push(memory, value >> (8 * slot_ * slot), slot_);
  }
}

void Call::put_operands(std::uint8_t* memory, std::span<const std::uint32_t> words,
                        cases::Draw& draw) const {
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Parameter& p = parameters_[i];
    if (!p.is_pointer) continue;
    for (std::size_t n = 0; n < p.numbers; ++n) {
      const std::uint32_t value =
          p.is_result ? static_cast<std::uint32_t>(draw.bits()) : words[first_word_[i] + n];
      const auto at = data_offsets_[i] + static_cast<std::uint32_t>(n) * 4;
      store(memory + image_.index_of(image_.data_at(at)), value, 4);
    }
  }
}

void Call::load_registers(Registers& registers, std::span<const std::uint32_t> words) const {
  for (std::size_t i = 0; i < frame_.in.size(); ++i) {
    const Place& place = frame_.in[i];
    std::uint64_t value =
        place.is_pointer ? data_offsets_[i] : number_at(words, first_word_[i], parameters_[i]);
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
  put_operands(memory, words, draw);
  top_ = bottom_;
  if (frame_.on_stack) {
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      push_parameter(memory, frame_.first_is_top ? parameters_.size() - 1 - i : i, words);
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
  const bool is_behind_pointers =
      frame_.out.empty() && std::ranges::any_of(parameters_, &Parameter::is_result);
  if (is_behind_pointers) return take_results(memory, words);
  std::size_t word = 0;
  for (const Place& place : results_) {
    std::uint64_t value = 0;
    for (const RegisterName& part : place.parts) {
      const int bits = bits_of(part);
      value = (bits == 64 ? 0 : value << bits) | registers.read(part);
    }
    const int bits = variant_.format.word_bits;
    if (bits < 64) value &= (std::uint64_t{1} << bits) - 1;
    words[word++] = static_cast<std::uint32_t>(value);
    if (bits > 32) words[word++] = static_cast<std::uint32_t>(value >> 32U);
  }
}

void Call::take_results(const std::uint8_t* memory, std::span<std::uint32_t> words) const {
  std::size_t word = 0;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    if (!parameters_[i].is_result) continue;
    for (std::size_t n = 0; n < parameters_[i].numbers; ++n) {
      const auto at = data_offsets_[i] + static_cast<std::uint32_t>(n) * 4;
      words[word++] = fetch(memory + image_.index_of(image_.data_at(at)), 4);
    }
  }
}

unsigned Call::broken(const Registers& left) const {
  unsigned mask = 0;
  for (const RegisterName& name : frame_.kept) {
    if (left.read(name) != entered_.read(name)) mask |= 1U << name.holder();
  }
  if (left.read(whole_register(sp_number, image_.bits)) != popped_) mask |= 1U << sp_number;
  constexpr machine_code::X87 fresh;
  if ((left.flags & direction_flag) != 0) mask |= sets_direction;
  if (left.x87.tags != fresh.tags) mask |= fills_x87;
  if (left.x87.control != fresh.control) mask |= controls_x87;
  if (!left.has_own_segments) mask |= moves_segments;
  return mask;
}

unsigned Call::changed(const Registers& left) const {
  unsigned mask = 0;
  for (std::size_t r = 0; r < left.general.size(); ++r) {
    if (left.general.at(r) != entered_.general.at(r)) mask |= 1U << r;
  }
  return mask & ~(1U << sp_number);
}

}  // namespace fixproof::judge
