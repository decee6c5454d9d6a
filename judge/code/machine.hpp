/// @file
/// The machines that run a user's code: this processor, and emulators.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "judge/code/call.hpp"
#include "judge/code/image.hpp"

namespace fixproof::judge {

/// The state before an instruction.
struct Step {
  std::uint32_t at = 0;  ///< its offset in the code segment
  std::uint32_t bytes = 0;
  Registers registers{};
};

/// A read or write of memory by a step.
struct Access {
  std::uint32_t step = 0;
  std::uint64_t address = 0;  ///< linear; also one without memory
  std::uint32_t bytes = 0;
  std::uint32_t is_write = 0;
  std::uint32_t value = 0;  ///< what is read; 0 for a write
};

/// A traced call with more steps than this counts as endless.
inline constexpr std::size_t max_emulated_steps = 100'000;

struct Trace {
  std::vector<Step> steps;
  std::vector<Access> accesses;
};

class Machine : private boost::noncopyable {
 public:
  virtual ~Machine() = default;

  [[nodiscard]] virtual std::uint8_t* memory() const = 0;
  [[nodiscard]] virtual std::uint16_t code_selector() const = 0;
  /// Runs from the image's entry until the routine returns to the image's exit.
  virtual Ending call(Registers& registers) = 0;
};

/// Returns why this processor cannot run the image, or an empty text if it can.
std::string absence_on_processor(const Image& image);
/// @throws std::system_error if the system refuses a segment for the code
std::unique_ptr<Machine> make_processor(const Image& image);

/// Returns why Unicorn cannot run code, or an empty text if it can.
std::string absence_on_unicorn();
/// Returns why the emulator of a processor cannot run code, or an empty text if it can.
/// @param architecture null for x86
std::string absence_on_emulator(const Architecture* architecture);
/// @param trace receives every step of the calls, and must outlive the machine; null for speed
/// @throws machine_code::EmulatorError
std::unique_ptr<Machine> make_emulator(const Image& image, Trace* trace);
// Those of make_emulator(), one for each emulator of processors other than x86.
std::unique_ptr<Machine> make_unicorn_elsewhere(const Image& image, Trace* trace);
std::unique_ptr<Machine> make_simavr(const Image& image, Trace* trace);
/// Returns why simavr cannot run code, or an empty text if it can.
std::string absence_on_simavr();

}  // namespace fixproof::judge
