/// @file
/// Writes cases in the format of SingleStepTests.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/draw.hpp"
#include "tests/vectors/processor.hpp"

namespace vectors {

using Bytes = std::vector<std::uint8_t>;

/// General registers by the number of their encoding.
inline constexpr unsigned ax = 0;
inline constexpr unsigned dx = 2;
inline constexpr unsigned bx = 3;
inline constexpr unsigned sp = 4;

/// What the sets record beside the registers that an instruction computes with.
struct Rest {
  std::uint32_t cs = 0;
  std::uint32_t ss = 0;
  std::uint32_t ds = 0;
  std::uint32_t es = 0;
  std::uint32_t ip = 0;
};

struct State {
  Registers registers;
  Rest rest;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ram;
};

/// Adds the two bytes of a word to the memory that is listed.
void store(State& state, std::uint32_t address, std::uint32_t word);

/// Writes one file, case by case. All that is drawn comes from the seed.
class Writer {
 public:
  Writer(bool i386, std::uint64_t seed) : i386_(i386), random_(seed) {}

  /// Operands from here on are of 32 bits, or of 16 again.
  void widen(bool wide) { wide_ = wide; }
  [[nodiscard]] int bits() const { return wide_ ? 32 : 16; }

  unsigned any_register();
  std::uint32_t any_word();

  /// "bx" or "ebx".
  [[nodiscard]] std::string name(unsigned r) const;

  enum class Wanted { value, fault };

  /// A case of an instruction, its result the processor's; operands are drawn until it faults, or
  /// does not, as wanted. `set` may choose operands.
  /// @param code without the 66h of 32-bit operands
  void add(const std::string& text, Bytes code, Wanted wanted = Wanted::value,
           const std::function<void(Registers&)>& set = {});

  /// A case whose result `change` knows: what the processor cannot be asked.
  void add_known(const std::string& text, const Bytes& code,
                 const std::function<void(State& start, State& after)>& change);

  [[nodiscard]] std::string text() const;

 private:
  using Json = nlohmann::ordered_json;

  /// The sets of the 386 end every case with a HLT.
  [[nodiscard]] std::uint32_t halt() const { return i386_ ? 1 : 0; }
  std::uint32_t between(std::uint32_t first, std::uint32_t last);
  State draw(const Bytes& code, bool with_vector);
  void fault(const State& start, State& after, std::uint32_t next);
  [[nodiscard]] Json json_of(const State& state, const State* before) const;
  void write(const std::string& text, Bytes code, const State& start, const State& after);

  bool i386_;
  bool wide_ = false;
  command::Random random_;
  std::string lines_;
  std::size_t count_ = 0;
  std::uint32_t flag_address_ = 0;
};

}  // namespace vectors
