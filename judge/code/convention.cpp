#include "judge/code/convention.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "judge/code/frame.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

std::uint64_t mask_of(const std::vector<std::size_t>& registers) {
  std::uint64_t mask = 0;
  for (const std::size_t r : registers) mask |= std::uint64_t{1} << r;
  return mask;
}

int bits_of(const Parameter& p, const Architecture& architecture) {
  return p.is_pointer ? architecture.pointer_bits : p.bits;
}

/// Gives out registers, then bytes on the stack.
class Places {
 public:
  /// @param registers their names
  Places(const Architecture& architecture, std::string_view registers)
      : architecture_(architecture),
        registers_(RegisterFile(architecture).all(registers)),
        stack_(architecture.first_on_stack) {}

  Passing next(const Parameter& p) {
    const int word = architecture_.word_bits;
    const auto words = static_cast<std::size_t>((bits_of(p, architecture_) + word - 1) / word);
    const bool is_pair = words == 2 && architecture_.has_even_pairs;
    if (is_pair || architecture_.has_falling_numbers) {
      used_ += (used_ + words) % 2;
      // Such a number is not divided between registers and the stack.
      if (used_ + words > registers_.size()) used_ = registers_.size();
    }
    const bool is_in_registers = used_ < registers_.size();
    Passing passing{.parts = {}, .is_pointer = p.is_pointer};
    for (std::size_t i = 0; i < words; ++i) passing.parts.push_back(next_part(is_pair && i == 0));
    // The parts are in the order of memory or of registers so far.
    if (architecture_.is_big_endian || (architecture_.has_falling_numbers && is_in_registers)) {
      std::ranges::reverse(passing.parts);
    }
    return passing;
  }
  [[nodiscard]] std::uint32_t stack() const { return stack_; }

 private:
  Part next_part(bool is_aligned) {
    if (used_ < registers_.size()) return {true, registers_[used_++]};
    const auto bytes = static_cast<std::uint32_t>(architecture_.word_bits / 8);
    if (is_aligned) stack_ += (stack_ - architecture_.first_on_stack) % (2 * bytes);
    const Part part{false, stack_};
    stack_ += bytes;
    return part;
  }

  const Architecture& architecture_;
  std::vector<std::size_t> registers_;
  std::size_t used_ = 0;
  std::uint32_t stack_;
};

/// Finds the registers that a user named.
class Named {
 public:
  explicit Named(const Architecture& architecture)
      : architecture_(architecture), file_(architecture) {}

  [[nodiscard]] std::size_t number_of(std::string_view name) const {
    const auto found = file_.find(name);
    if (found && name != architecture_.stack_pointer) return *found;
    throw UsageError(fmt::format(
        "--frame: {} is not a register for operands on {}; choose one of {}, or {}",
        support::quoted(name), architecture_.name, fmt::join(file_.names, ", "), types_instead));
  }

  /// @param taken the registers of the places before it, and after it those of this place, too
  [[nodiscard]] Passing passing(const PlaceText& text, const Parameter& p,
                                std::uint64_t& taken) const {
    Passing passing{.parts = {}, .is_pointer = text.is_pointer};
    for (const std::string_view name : text.parts) {
      const std::size_t number = number_of(name);
      if ((taken >> number & 1U) != 0) {
        throw UsageError(fmt::format("--frame: {} is named twice; choose another register", name));
      }
      taken |= std::uint64_t{1} << number;
      passing.parts.push_back({true, number});
    }
    std::ranges::reverse(passing.parts);
    if (text.is_pointer != p.is_pointer) {
      throw UsageError("--frame: write the registers of pointers, and no others, like [r0]");
    }
    const auto bits = static_cast<int>(passing.parts.size()) * architecture_.word_bits;
    if (bits < bits_of(p, architecture_)) {
      throw UsageError(
          fmt::format("--frame: a place has {} bits, and a {} has {}; write several registers like "
                      "{}:{}, the highest first",
                      bits, p.is_pointer ? "pointer" : "number", bits_of(p, architecture_),
                      file_.names[1], file_.names[0]));
    }
    return passing;
  }

  [[nodiscard]] std::uint64_t mask(const std::vector<std::string_view>& names) const {
    std::vector<std::size_t> numbers;
    for (const std::string_view name : names) numbers.push_back(number_of(name));
    return mask_of(numbers);
  }

 private:
  const Architecture& architecture_;
  RegisterFile file_;
};

}  // namespace

Convention convention_of_c(const Architecture& architecture, std::span<const Parameter> parameters,
                           int result_bits) {
  const RegisterFile file(architecture);
  Convention convention{.kept = mask_of(file.all(architecture.kept))};
  Places places(architecture, architecture.arguments);
  for (const Parameter& p : parameters) convention.in.push_back(places.next(p));
  convention.stack_bytes = places.stack();
  if (result_bits == 0) return convention;
  Passing out = Places(architecture, architecture.results).next({.bits = result_bits});
  if (!std::ranges::all_of(out.parts, &Part::is_register)) {
    throw UsageError(
        fmt::format("--frame c: {} returns no number of {} bits", architecture.name, result_bits));
  }
  convention.out.push_back(std::move(out));
  return convention;
}

Convention convention_of_registers(const Architecture& architecture, const FrameText& text,
                                   std::span<const Parameter> parameters, int result_bits) {
  const Named named(architecture);
  Convention convention{.kept = named.mask(text.kept), .stack_bytes = architecture.first_on_stack};
  const std::size_t results = result_bits > 0 ? 1 : 0;
  if (text.in.size() != parameters.size() || text.out.size() != results) {
    throw UsageError(fmt::format("--frame: name {} place{} before -> and {} after it",
                                 parameters.size(), parameters.size() == 1 ? "" : "s",
                                 results == 0 ? "none" : "one"));
  }
  std::uint64_t taken = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    convention.in.push_back(named.passing(text.in[i], parameters[i], taken));
  }
  std::uint64_t taken_by_results = 0;
  for (const PlaceText& place : text.out) {
    convention.out.push_back(named.passing(place, {.bits = result_bits}, taken_by_results));
  }
  return convention;
}

}  // namespace fixproof::judge
