/// @file
/// Captures written by hand: what one instruction changes, apart from registers that are the same
/// for all. As JSON, and as binary MOO.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/verify/vectors/cases.hpp"

namespace vectors {

using Values = std::map<std::string, std::uint32_t>;  ///< registers by their 16-bit names
using Bytes = std::map<std::uint32_t, int>;           ///< memory

struct Capture {
  std::string_view name;
  std::vector<int> code;
  Values before;  ///< registers with other values than those of initial_registers()
  Bytes memory;   ///< before, without the code
  Values after;   ///< changed registers; the instruction pointer is that of the next instruction
  Bytes written;
};

/// The registers before every capture. CS:IP is 10010h, DS 30000h, ES 40000h, SS 20000h.
Values initial_registers(std::string_view cpu);

/// The captures of one processor: each form of instruction with memory, the stack, bytes, jumps and
/// the divide error.
const std::vector<Capture>& captures(std::string_view cpu);

/// One case of a JSON file. Since the 286, the instruction pointer is past a HLT.
Json json_of(const Capture& capture, std::string_view cpu);

/// A chunk of a MOO file, and a file of such cases.
std::string chunk(std::string_view tag, const std::string& body);
std::string number(std::size_t value, int bytes);
std::string moo_of(const Json& cases, std::string_view cpu);

}  // namespace vectors
