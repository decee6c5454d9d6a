// Replaces processor_linux.cpp on systems without 16-bit segments.
#include "verify/machine_code/processor.hpp"

#if !defined(__linux__) || !defined(__x86_64__) || defined(__ILP32__)

#include <stdexcept>

namespace fixproof::machine_code {

struct Processor::Parts {};
struct Processor::Calls::Saved {};

std::string Processor::absence() { return "this party needs Linux on an x86-64 processor"; }

// Callers check absence() first.
Processor::Processor(std::size_t /*data_bytes*/) { throw std::logic_error(absence()); }
Processor::~Processor() = default;
std::uint8_t* Processor::memory() const { return nullptr; }
void Processor::load(std::span<const std::uint8_t> /*code*/) {}
Processor::Calls::Calls(Processor& /*processor*/) {}
Processor::Calls::~Calls() = default;
CallEnding Processor::Calls::call(SegmentMachine& /*m*/) const { return CallEnding::fault; }

}  // namespace fixproof::machine_code

#endif
