#include "judge/code/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "judge/code/c_types.hpp"
#include "judge/code/call_operands.hpp"
#include "support/plain_text.hpp"
#include "support/split.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::split;
using support::trimmed;
using support::UsageError;
using x86model::Register;
using x86model::Size;

int bits_of(const Place& place) {
  return std::accumulate(place.parts.begin(), place.parts.end(), 0,
                         [](int sum, const RegisterName& r) { return sum + bits_of(r); });
}

RegisterName register_for_operand(std::string_view text, int code_bits) {
  const auto found = register_named(text);
  const bool exists = found && (code_bits == 64 || found->is_legacy());
  if (exists && found->holder() != static_cast<std::size_t>(Register::sp)) return *found;
  throw UsageError(
      fmt::format("--frame: {} is not a register for operands; choose one such as eax, bx or dl, "
                  "or {}",
                  support::quoted(text), types_instead));
}

Place place_named(const PlaceText& text, int code_bits) {
  Place place{.parts = {}, .is_pointer = text.is_pointer};
  for (const std::string_view part : text.parts) {
    place.parts.push_back(register_for_operand(part, code_bits));
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

Frame frame_of_registers(std::string_view text, int bits) {
  Frame frame{.text = std::string(text), .on_stack = false};
  const FrameText parts = frame_text(text).value();
  for (const auto part : parts.kept) frame.kept.push_back(register_for_operand(part, bits));
  for (const PlaceText& part : parts.in) frame.in.push_back(place_named(part, bits));
  for (const PlaceText& part : parts.out) frame.out.push_back(place_named(part, bits));
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

PlaceText place_text(std::string_view text, std::size_t most_parts, std::size_t of_pointer) {
  PlaceText place;
  std::string_view inner = text;
  if (text.starts_with('[') && text.ends_with(']')) {
    place.is_pointer = true;
    inner = trimmed(text.substr(1, text.size() - 2));
  }
  // `std::int32_t` is a type, and no registers.
  const bool is_qualified = inner.find("::") != std::string_view::npos;
  place.parts = is_qualified ? std::vector{inner} : split(inner, ':');
  if (place.parts.empty() || place.parts.size() > (place.is_pointer ? of_pointer : most_parts)) {
    throw UsageError(fmt::format(
        "--frame: {} is not a place; write a register, a pair like dx:ax or a pointer like [si]",
        support::quoted(inner)));
  }
  return place;
}

}  // namespace

std::optional<FrameText> frame_text(std::string_view text, std::size_t most_parts,
                                    std::size_t of_pointer) {
  const std::size_t arrow = text.find("->");
  if (arrow == std::string_view::npos) return std::nullopt;
  FrameText parts;
  std::string_view results = text.substr(arrow + 2);
  constexpr std::string_view word = "keeps ";
  if (const std::size_t keeps = results.find(word); keeps != std::string_view::npos) {
    parts.kept = split(results.substr(keeps + word.size()), ',');
    results = results.substr(0, keeps);
  }
  const auto add = [&](std::string_view places, std::vector<PlaceText>& to) {
    for (const auto part : split(places, ',')) {
      to.push_back(place_text(part, most_parts, of_pointer));
    }
  };
  add(text.substr(0, arrow), parts.in);
  add(results, parts.out);
  return parts;
}

Frame convention_of_64_bits(bool is_windows, const Signature& signature) {
  constexpr std::array<unsigned, 6> system_v{7, 6, 2, 1, 8, 9};  // RDI, RSI, RDX, RCX, R8, R9
  constexpr std::array<unsigned, 4> windows{1, 2, 8, 9};         // RCX, RDX, R8, R9
  Frame frame{.text = is_windows ? "ms" : "sysv", .on_stack = false, .signature = signature};
  const std::span<const unsigned> numbers =
      is_windows ? std::span<const unsigned>(windows) : std::span<const unsigned>(system_v);
  if (signature.operands.size() > numbers.size()) {
    throw UsageError(fmt::format("--frame {}: there are registers for {} parameters, not for {}",
                                 frame.text, numbers.size(), signature.operands.size()));
  }
  for (std::size_t i = 0; i < signature.operands.size(); ++i) {
    const Parameter& p = signature.operands[i];
    const int bits = p.is_pointer || p.bits > 32 ? 64 : 32;
    frame.in.push_back({{whole_register(numbers[i], bits)}, p.is_pointer});
  }
  const int result_bits = signature.result_bits;
  if (result_bits > 0) frame.out.push_back({{whole_register(0, result_bits > 32 ? 64 : 32)}});
  std::vector<unsigned> kept{3, 5, 12, 13, 14, 15};  // RBX, RBP, R12 to R15
  if (is_windows) kept.insert(kept.end(), {6, 7});
  for (const unsigned number : kept) frame.kept.push_back(whole_register(number, 64));
  return frame;
}

namespace {

/// Returns a frame with the arrow that a user forgot, for a message.
std::string with_arrow(std::string_view text) {
  for (const std::string_view other : {"=>", "\u2192"}) {
    if (const std::size_t at = text.find(other); at != std::string_view::npos) {
      return fmt::format("{}->{}", text.substr(0, at), text.substr(at + other.size()));
    }
  }
  const std::size_t open = text.find('(');
  const std::size_t close = text.rfind(')');
  if (open != std::string_view::npos && close != std::string_view::npos && open < close) {
    // A prototype: the type of the result, then perhaps the name of the function.
    std::string_view result = trimmed(text.substr(0, open));
    if (const std::size_t name = result.rfind(' '); name != std::string_view::npos) {
      result = trimmed(result.substr(0, name));
    }
    const std::string_view in = trimmed(text.substr(open + 1, close - open - 1));
    return result == "void" ? fmt::format("{} ->", in) : fmt::format("{} -> {}", in, result);
  }
  if (text.ends_with('*') || text.ends_with(']')) return fmt::format("{} ->", text);
  return fmt::format("{} -> {}", text, trimmed(text.substr(0, text.find(','))));
}

/// Names the mistake if a frame without an arrow has places.
void expect_no_places(std::string_view text) {
  if (text.find_first_of(",(* ") == std::string_view::npos) return;
  throw UsageError(fmt::format("--frame {}: there is no -> between operands and result; write '{}'",
                               support::quoted(text), support::printable(with_arrow(text))));
}

/// Returns a convention of x86 by its name.
Frame convention_named(std::string_view text, int bits, const Signature& signature) {
  expect_no_places(text);
  if (bits == 64) {
    const bool is_windows = text == "ms";
    if (is_windows || text == "c" || text == "sysv") {
      return convention_of_64_bits(is_windows, signature);
    }
    throw UsageError(
        fmt::format("--frame {}: choose sysv or ms for 64-bit code, or name registers, such as "
                    "'edi, esi -> eax'",
                    support::quoted(text)));
  }
  Frame frame{.text = std::string(text), .signature = signature};
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

}  // namespace

Frame frame_named(std::string_view text, int bits, const cases::Variant& variant) {
  const auto parts = frame_text(text);
  if (!parts) return convention_named(text, bits, signature_of(variant));
  const auto in_c = signature_in_c(*parts, variant, bits);
  Frame frame = in_c ? convention_named("c", bits, *in_c) : frame_of_registers(text, bits);
  if (!in_c) frame.signature = signature_of(variant);
  frame.text = text;
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
  expect_room(frame.signature);
  if (frame.elsewhere) return;
  const auto& parameters = frame.signature.operands;
  const int result_bits = frame.signature.result_bits;
  const std::string_view name = cases::name_of(v.operation);
  const bool returns = result_bits > 0;
  if (frame.on_stack) {
    if (result_bits > 2 * bits) {
      throw UsageError(fmt::format("--frame {}: {}-bit code returns no number of {} bits",
                                   frame.text, bits, result_bits));
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
    const Parameter result = returns ? Parameter{.bits = result_bits} : parameters[operands + i];
    if (frame.out[i].is_pointer) {
      throw UsageError(
          fmt::format("--frame '{}': the pointer to a result is an operand", frame.text));
    }
    expect(frame.out[i], result, result.numbers == 1);
  }
}

Frame frame_for(const Image& image, std::string_view text, const cases::Variant& variant) {
  if (image.architecture == nullptr) return frame_named(text, image.bits, variant);
  const Architecture& architecture = *image.architecture;
  const auto words = [&](int bits) { return static_cast<std::size_t>(bits / image.bits); };
  const auto parts =
      frame_text(text, std::max<std::size_t>(2, words(64)), words(architecture.pointer_bits));
  const auto in_c =
      parts ? signature_in_c(*parts, variant, architecture.pointer_bits) : std::nullopt;
  Frame frame{.text = std::string(text),
              .on_stack = false,
              .signature = in_c.value_or(signature_of(variant))};
  const auto& [parameters, result_bits] = frame.signature;
  if (in_c || text == "c") {
    frame.elsewhere = convention_of_c(architecture, parameters, result_bits);
  } else if (parts) {
    frame.elsewhere = convention_of_registers(architecture, *parts, parameters, result_bits);
  } else {
    expect_no_places(text);
    throw UsageError(
        fmt::format("--frame {}: choose c for {}, or name registers, the operands first, then -> "
                    "and the result",
                    support::quoted(text), architecture.name));
  }
  return frame;
}

}  // namespace fixproof::judge
