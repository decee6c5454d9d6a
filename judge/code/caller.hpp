/// @file
/// Calls a routine for one case after the other, on any machine.
#pragma once

#include <array>
#include <boost/noncopyable.hpp>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "judge/code/machine.hpp"

namespace fixproof::judge {

/// A routine, how to call it, and what it should compute. It must outlive everything that works on
/// it.
struct Subject {
  Image image;
  Frame frame;
  cases::Variant variant;
};

/// The outcome of one call.
struct Answer {
  Ending ending{};
  RegisterMask broken = 0;                                  ///< see Call::broken()
  RegisterMask changed = 0;                                 ///< see Call::changed()
  std::array<std::uint32_t, cases::max_words_out> words{};  ///< valid if it returned
};

/// Tells whether a call returned or raised #DE.
bool ended_well(const Answer& answer);

enum class On { processor, unicorn };

class Caller : private boost::noncopyable {
 public:
  virtual ~Caller() = default;

  /// @param number decides what the call finds where it has no operand
  virtual Answer answer(std::span<const std::uint32_t> words, std::uint64_t number) = 0;
  /// Returns the memory of the machine, laid out as Image::memory.
  [[nodiscard]] virtual std::uint8_t* memory() const = 0;
};

/// @param trace receives every step of the calls, and must outlive the caller; null for speed
std::unique_ptr<Caller> make_caller(const Subject& subject, On machine, Trace* trace);
/// The same for a processor other than x86.
std::unique_ptr<Caller> make_caller_elsewhere(const Subject& subject,
                                              std::unique_ptr<Machine> machine);

/// Returns the number of general registers of an image's processor.
std::size_t registers_of(const Image& image);
/// Returns the name of a whole general register.
std::string register_name(const Image& image, std::size_t number);

}  // namespace fixproof::judge
