#include "judge/code/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;
using x86model::Register;
using x86model::Size;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  if (trimmed(text).empty()) return parts;
  for (std::size_t at = 0; at != std::string_view::npos;) {
    at = text.find(separator);
    parts.push_back(trimmed(text.substr(0, at)));
    if (at != std::string_view::npos) text.remove_prefix(at + 1);
  }
  return parts;
}

int bits_of(const Place& place) {
  return std::accumulate(place.parts.begin(), place.parts.end(), 0,
                         [](int sum, const RegisterName& r) { return sum + bits_of(r); });
}

RegisterName register_for_operand(std::string_view text, int code_bits) {
  const auto found = register_named(text);
  const bool exists = found && (code_bits == 64 || found->is_legacy());
  if (exists && found->holder() != static_cast<std::size_t>(Register::sp)) return *found;
  throw UsageError(
      fmt::format("--frame: {} is not a register for operands; choose one such as eax, bx or dl",
                  support::quoted(text)));
}

Place place_named(std::string_view text, int code_bits) {
  Place place;
  if (text.starts_with('[') && text.ends_with(']')) {
    place.is_pointer = true;
    text = trimmed(text.substr(1, text.size() - 2));
  }
  for (const std::string_view part : split(text, ':')) {
    place.parts.push_back(register_for_operand(part, code_bits));
  }
  if (place.parts.empty() || place.parts.size() > 2 ||
      (place.is_pointer && place.parts.size() > 1)) {
    throw UsageError(fmt::format(
        "--frame: {} is not a place; write a register, a pair like dx:ax or a pointer like [si]",
        support::quoted(text)));
  }
  return place;
}

/// @throws support::UsageError if two operands or two results share a register
void expect_registers_of_their_own(const std::vector<Place>& places) {
  std::uint32_t taken = 0;  // two bits for each register: its two lower bytes
  for (const Place& place : places) {
    for (const RegisterName& part : place.parts) {
      const unsigned bits_taken = part.size != Size::byte ? 3U : part.is_high_byte() ? 2U : 1U;
      const std::uint32_t bytes = bits_taken << 2 * part.holder();
      if ((taken & bytes) != 0) {
        throw UsageError(
            fmt::format("--frame: {} is named twice; choose another register", name_of(part)));
      }
      taken |= bytes;
    }
  }
}

Frame frame_of_registers(std::string_view text, std::size_t arrow, int bits) {
  Frame frame{.text = std::string(text), .on_stack = false};
  std::string_view results = text.substr(arrow + 2);
  constexpr std::string_view word = "keeps ";
  if (const std::size_t keeps = results.find(word); keeps != std::string_view::npos) {
    for (const auto part : split(results.substr(keeps + word.size()), ',')) {
      frame.kept.push_back(register_for_operand(part, bits));
    }
    results = results.substr(0, keeps);
  }
  for (const auto part : split(text.substr(0, arrow), ',')) {
    frame.in.push_back(place_named(part, bits));
  }
  for (const auto part : split(results, ',')) frame.out.push_back(place_named(part, bits));
  expect_registers_of_their_own(frame.in);
  expect_registers_of_their_own(frame.out);
  return frame;
}

/// Returns the registers that C and Pascal compilers expect a call to preserve.
std::vector<RegisterName> kept_by_convention(int bits) {
  if (bits == 16) {
    return {{Register::bp, Size::word}, {Register::si, Size::word}, {Register::di, Size::word}};
  }
  return {{Register::bp, Size::dword},
          {Register::si, Size::dword},
          {Register::di, Size::dword},
          {Register::bx, Size::dword}};
}

}  // namespace

std::vector<Parameter> parameters_of(const cases::Variant& v) {
  using cases::Operation;
  const int bits = v.format.word_bits;
  if (v.operation == Operation::cossin) {
    const Parameter result{.bits = bits, .is_pointer = true, .is_result = true};
    return {{.bits = cases::operand_bits(v)}, result, result};
  }
  if (v.operation == Operation::xformvec) {
    const auto array = [bits](std::size_t numbers, bool is_result) {
      return Parameter{
          .bits = bits, .numbers = numbers, .is_pointer = true, .is_result = is_result};
    };
    return {array(12, false), array(3, false), array(3, true)};
  }
  return std::vector<Parameter>(cases::words_in(v.operation),
                                {.bits = bits, .is_signed = v.format.is_signed});
}

namespace {

/// The conventions of 64-bit code.
Frame frame_of_64_bits(std::string_view text, const cases::Variant& variant) {
  const bool is_windows = text == "ms";
  if (!is_windows && text != "c" && text != "sysv") {
    throw UsageError(
        fmt::format("--frame {}: choose sysv or ms for 64-bit code, or name registers, such as "
                    "'edi, esi -> eax'",
                    support::quoted(text)));
  }
  const auto parameters = parameters_of(variant);
  const bool returns = std::none_of(parameters.begin(), parameters.end(),
                                    [](const Parameter& p) { return p.is_result; });
  return convention_of_64_bits(is_windows, parameters, returns ? variant.format.word_bits : 0);
}

}  // namespace

Frame convention_of_64_bits(bool is_windows, std::span<const Parameter> parameters,
                            int result_bits) {
  constexpr std::array<unsigned, 4> system_v{7, 6, 2, 1};  // RDI, RSI, RDX, RCX
  constexpr std::array<unsigned, 4> windows{1, 2, 8, 9};   // RCX, RDX, R8, R9
  Frame frame{.text = is_windows ? "ms" : "sysv", .on_stack = false};
  const auto numbers = is_windows ? windows : system_v;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& p = parameters[i];
    const int bits = p.is_pointer || p.bits > 32 ? 64 : 32;
    frame.in.push_back({{whole_register(numbers.at(i), bits)}, p.is_pointer});
  }
  if (result_bits > 0) frame.out.push_back({{whole_register(0, result_bits > 32 ? 64 : 32)}});
  std::vector<unsigned> kept{3, 5, 12, 13, 14, 15};  // RBX, RBP, R12 to R15
  if (is_windows) kept.insert(kept.end(), {6, 7});
  for (const unsigned number : kept) frame.kept.push_back(whole_register(number, 64));
  return frame;
}

Frame frame_named(std::string_view text, int bits, const cases::Variant& variant) {
  const std::size_t arrow = text.find("->");
  if (arrow != std::string_view::npos) return frame_of_registers(text, arrow, bits);
  if (bits == 64) return frame_of_64_bits(text, variant);
  Frame frame{.text = std::string(text)};
  frame.kept = kept_by_convention(bits);
  frame.is_far = text == "c-far" || text == "pascal-far";
  frame.first_is_top = !text.starts_with("pascal");
  frame.callee_pops = text == "stdcall" || !frame.first_is_top;
  constexpr std::array<std::string_view, 5> names{"c", "c-far", "pascal", "pascal-far", "stdcall"};
  if (std::find(names.begin(), names.end(), text) == names.end()) {
    throw UsageError(fmt::format(
        "--frame {}: choose c, c-far, pascal, pascal-far or stdcall, or name registers, such as "
        "'eax, ebx -> eax'",
        support::quoted(text)));
  }
  if (frame.is_far && bits == 32) {
    throw UsageError(fmt::format("--frame {}: 32-bit code has near calls", text));
  }
  return frame;
}

namespace {

void expect_place(const Place& place, const Parameter& parameter, bool may_be_value,
                  const Frame& frame, const cases::Variant& v, int bits) {
  if (place.is_pointer) {
    if (bits_of(place) >= bits) return;
    throw UsageError(
        fmt::format("--frame '{}': a pointer of {}-bit code has {} bits", frame.text, bits, bits));
  }
  if (!may_be_value) {
    throw UsageError(fmt::format("--frame '{}': write the registers of {}'s pointers like [si]",
                                 frame.text, cases::name_of(v.operation)));
  }
  if (bits_of(place) < parameter.bits) {
    throw UsageError(fmt::format(
        "--frame '{}': a place has {} bits, and a number of {} has {}; write a pair like dx:ax",
        frame.text, bits_of(place), cases::name_of(v.format), parameter.bits));
  }
}

}  // namespace

void expect_fit(const Frame& frame, const cases::Variant& v, int bits) {
  const auto parameters = parameters_of(v);
  const std::string_view name = cases::name_of(v.operation);
  const bool returns = std::none_of(parameters.begin(), parameters.end(),
                                    [](const Parameter& p) { return p.is_result; });
  if (frame.on_stack) {
    if (returns && v.format.word_bits > 2 * bits) {
      throw UsageError(fmt::format("--frame {}: {}-bit code returns no number of {} bits",
                                   frame.text, bits, v.format.word_bits));
    }
    return;
  }
  // In a frame of registers, the results behind pointers are either all parameters or all returned.
  const auto operands = static_cast<std::size_t>(std::count_if(
      parameters.begin(), parameters.end(), [](const Parameter& p) { return !p.is_result; }));
  const std::size_t results = returns ? 1 : parameters.size() - operands;
  const bool by_pointer = !returns && frame.in.size() == parameters.size() && frame.out.empty();
  if (!by_pointer && (frame.in.size() != operands || frame.out.size() != results)) {
    throw UsageError(fmt::format("--frame '{}': {} takes {} operand{} and gives {} result{}",
                                 frame.text, name, operands, operands == 1 ? "" : "s", results,
                                 results == 1 ? "" : "s"));
  }
  const auto expect = [&](const Place& place, const Parameter& parameter, bool may_be_value) {
    expect_place(place, parameter, may_be_value, frame, v, bits);
  };
  for (std::size_t i = 0; i < frame.in.size(); ++i) {
    const Parameter& p = parameters[i];
    expect(frame.in[i], p, p.numbers == 1 && !p.is_result);
  }
  for (std::size_t i = 0; i < frame.out.size(); ++i) {
    const Parameter result =
        returns ? Parameter{.bits = v.format.word_bits} : parameters[operands + i];
    if (frame.out[i].is_pointer) {
      throw UsageError(
          fmt::format("--frame '{}': the pointer to a result is an operand", frame.text));
    }
    expect(frame.out[i], result, result.numbers == 1);
  }
}

}  // namespace fixproof::judge
