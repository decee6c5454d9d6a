/// @file
/// The memory of a captured case, as the model sees it.
#pragma once

#include <cstdint>
#include <optional>

#include "verify/singlestep/read.hpp"
#include "x86model/machine.hpp"

namespace fixproof::singlestep {

/// Reads the bytes that a case lists, and keeps what is written apart from them: an instruction
/// reads before it writes. Offsets of an 8088 wrap around in the segment and in the address space;
/// since the 286 an operand that crosses the end of its segment is a fault.
class CaptureMemory {
 public:
  /// @param data DS, or SS if that is the segment of the instruction's memory operand
  CaptureMemory(const Case& c, x86model::Cpu cpu, Place data) : case_(&c), cpu_(cpu), data_(data) {}

  bool read(std::uint32_t offset, std::uint32_t& value) const {
    return read_word(data_, offset, value);
  }
  bool write(std::uint32_t offset, std::uint32_t value) { return write_word(data_, offset, value); }
  bool read_byte(std::uint32_t offset, std::uint32_t& value) const {
    return read_at(data_, offset, value);
  }
  bool write_byte(std::uint32_t offset, std::uint32_t value) {
    return write_at(data_, offset, value);
  }
  bool write_extra_byte(std::uint32_t offset, std::uint32_t value) {
    return write_at(Place::es, offset, value);
  }
  bool write_extra_word(std::uint32_t offset, std::uint32_t value) {
    return write_word(Place::es, offset, value);
  }
  bool read_code(std::uint32_t offset, std::uint32_t& value) const {
    return read_word(Place::cs, offset, value);
  }
  bool read_stack(std::uint32_t offset, std::uint32_t& value) const {
    return read_word(Place::ss, offset, value);
  }
  bool write_stack(std::uint32_t offset, std::uint32_t value) {
    return write_word(Place::ss, offset, value);
  }

  [[nodiscard]] const Ram& written() const { return written_; }
  /// The first byte that was read, as 0, but that the case does not list.
  [[nodiscard]] std::optional<std::uint32_t> unlisted() const { return unlisted_; }
  /// Whether an operand crossed the end of its segment.
  [[nodiscard]] bool crossed_end() const { return crossed_end_; }

 private:
  /// The address of a byte; nothing if it is beyond the segment's end.
  [[nodiscard]] std::optional<std::uint32_t> address_of(Place segment, std::uint32_t offset) const {
    const std::uint32_t base = case_->initial[segment] << 4U;
    if (cpu_ == x86model::Cpu::i8088) {
      return (base + (offset & 0xFFFFU)) & largest(address_bits(cpu_));
    }
    if (offset <= 0xFFFF) return base + offset;
    crossed_end_ = true;
    return std::nullopt;
  }

  bool read_at(Place segment, std::uint32_t offset, std::uint32_t& value) const {
    const auto address = address_of(segment, offset);
    if (!address) return false;
    const auto found = case_->initial.ram.find(*address);
    const bool listed = found != case_->initial.ram.end();
    if (!listed && !unlisted_) unlisted_ = address;
    value = listed ? found->second : 0;
    return true;
  }
  bool write_at(Place segment, std::uint32_t offset, std::uint32_t value) {
    const auto address = address_of(segment, offset);
    if (address) written_[*address] = static_cast<std::uint8_t>(value);
    return address.has_value();
  }
  bool read_word(Place segment, std::uint32_t offset, std::uint32_t& value) const {
    std::uint32_t high = 0;
    if (!read_at(segment, offset, value) || !read_at(segment, offset + 1, high)) return false;
    value |= high << 8U;
    return true;
  }
  bool write_word(Place segment, std::uint32_t offset, std::uint32_t value) {
    return write_at(segment, offset, value) && write_at(segment, offset + 1, value >> 8U);
  }

  const Case* case_;
  x86model::Cpu cpu_;
  Place data_;
  Ram written_;
  mutable std::optional<std::uint32_t> unlisted_;
  mutable bool crossed_end_ = false;
};

using CaptureMachine = x86model::Machine<16, CaptureMemory>;

}  // namespace fixproof::singlestep
