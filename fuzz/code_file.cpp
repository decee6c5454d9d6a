// Target `code_file`: a file of machine code for `judge`. The first letter chooses how the name and
// --bits tell the container, the rest of the first line is --at, or --symbol after a `$`. The file
// must be refused with a message that names it, or give an image that fits its memory, has the
// bytes of the file except where relocations are, and in which a call can be set up.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/control_characters.hpp"
#include "fuzz/finding.hpp"
#include "judge/code/call.hpp"
#include "judge/code/listing.hpp"
#include "judge/code/load.hpp"
#include "support/usage_error.hpp"

using namespace fixproof;

namespace {

std::optional<judge::Image> image_of(const std::string& name, const std::string& bytes,
                                     const judge::LoadOptions& options) {
  constexpr std::size_t longest_message = 2000;
  try {
    return judge::load_bytes(name, bytes, options);
  } catch (const support::UsageError& error) {
    const std::string_view message = error.what();
    if (!message.starts_with(name + ": ") || message.size() > longest_message ||
        fuzz::has_control_character(message)) {
      fuzz::report_finding(fmt::format("the message: {}", message.substr(0, longest_message)));
    }
  } catch (const std::exception& error) {
    fuzz::report_finding(fmt::format("not a UsageError: {}", error.what()));
  }
  return std::nullopt;
}

void expect(bool holds, const char* what) {
  if (!holds) fuzz::report_finding(what);
}

void check_places(const judge::Image& image) {
  const std::uint64_t size = image.base + image.memory.size();
  expect(image.base <= image.first && image.first < image.end && image.end <= size,
         "the code is not in memory");
  const std::uint64_t entry = image.code_at(image.entry);
  expect(entry >= image.first && entry < image.end, "the routine is not in the code");
  expect(std::uint64_t{image.code_at(image.exit)} + judge::exit_bytes <= size,
         "the return is not in memory");
  expect(std::uint64_t{image.data_at(image.data)} + judge::data_bytes <= size,
         "the operands are not in memory");
  expect(image.stack_top <= image.data && image.stack_top > 0, "the stack is not below the data");
  const judge::Decoded first = judge::Listing(image).decoded_at(image.entry);
  expect(first.bytes <= judge::longest_instruction && first.mnemonic.empty() == (first.bytes == 0),
         "the first instruction is neither decoded nor refused");
}

/// The bytes of the file that are in memory, but for 2 of each relocation of an .EXE.
void check_contents(const judge::Image& image, const std::string& bytes) {
  const auto byte_at = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes.at(i)); };
  const bool is_exe = image.container == "MZ .EXE";
  if (!is_exe && image.container.find("ELF") != std::string::npos) return;
  const std::size_t start = is_exe ? 16U * (byte_at(8) + 256U * byte_at(9)) : 0;
  std::size_t changed = 0;
  for (std::size_t i = 0; i < image.end - image.first; ++i) {
    if (image.memory[image.index_of(image.first) + i] != byte_at(start + i)) ++changed;
  }
  const std::size_t relocations = is_exe ? byte_at(6) + 256U * byte_at(7) : 0;
  expect(changed <= 2 * relocations, "memory has not the bytes of the file");
}

/// Sets calls up as `judge` does. The sanitizers watch.
void set_up_calls(const judge::Image& image) {
  const std::vector<std::string_view> frames =
      image.bits == 64   ? std::vector<std::string_view>{"sysv", "ms"}
      : image.bits == 32 ? std::vector<std::string_view>{"c", "stdcall"}
                         : std::vector<std::string_view>{"c", "c-far", "pascal-far", "stdcall"};
  std::vector<std::uint8_t> memory = image.memory;
  for (const auto operation : {cases::Operation::mul, cases::Operation::xformvec}) {
    const cases::Variant variant{.operation = operation, .format = cases::q16_16};
    const std::vector<std::uint32_t> in(words_in(variant), 0x00018000);
    std::vector<std::uint32_t> out(words_out(variant));
    for (const std::string_view name : frames) {
      const judge::Frame frame = judge::frame_named(name, image.bits, variant);
      judge::Call call(image, frame, variant, image.code_segment);
      judge::Registers registers;
      call.enter(memory.data(), registers, in, 1);
      call.leave(memory.data(), registers, out);
    }
  }
  if (image.container == "MZ .EXE") return;  // it brings its own stack
  const std::uint32_t first = image.index_of(image.first);
  expect(std::equal(image.memory.begin() + first, image.memory.begin() + image.index_of(image.end),
                    memory.begin() + first),
         "setting up a call changes the code");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(data, data + size);
  const std::size_t line = input.find('\n');
  if (line == std::string::npos || line == 0) return 0;
  const std::string content = input.substr(line + 1);
  if (content.empty()) return 0;
  judge::LoadOptions options;
  const std::string place = input.substr(1, line - 1);
  if (place.starts_with('$')) {
    options.symbol = place.substr(1);
  } else {
    options.at = place;
  }
  if (input[0] == 'F') options.bits = 32;
  const std::string name = input[0] == 'c' ? "code.com" : "code.bin";
  const auto image = image_of(name, content, options);
  if (!image) return 0;
  check_places(*image);
  check_contents(*image, content);
  set_up_calls(*image);
  return 0;
}
