#include "x86model/bus.hpp"

#include "x86model/encoding.hpp"
#include "x86model/execute.hpp"

namespace x86model {

namespace {

std::uint64_t bytes_of(Size size) {
  if (size == Size::byte) return 1;
  return size == Size::word ? 2 : 4;
}

bool only_reads(Mnemonic op) {
  return op == Mnemonic::cmp || op == Mnemonic::push || detail::is_multiply(op) ||
         detail::is_divide(op) || is_control_flow(op);
}
bool only_writes(Mnemonic op) { return op == Mnemonic::mov || op == Mnemonic::pop; }

std::uint64_t operand_bytes(const Instruction& i) {
  std::uint64_t bytes = 0;
  for (std::size_t place = 0; place < i.operands.size(); ++place) {
    const Operand& o = i.operands.at(place);
    if (o.kind != Operand::Kind::memory) continue;
    const bool once = place > 0 || only_reads(i.mnemonic) || only_writes(i.mnemonic);
    bytes += bytes_of(o.size) * (once ? 1 : 2);
  }
  return bytes;
}

/// The bytes of implicit operands: the stack, and the destination of STOS.
std::uint64_t implied_bytes(const Instruction& i) {
  switch (i.mnemonic) {
    case Mnemonic::push:
    case Mnemonic::pop:
      return bytes_of(i.operands[0].size);
    case Mnemonic::call:
    case Mnemonic::ret:
    case Mnemonic::stosw:
      return 2;
    case Mnemonic::stosb:
      return 1;
    default:
      return 0;
  }
}

}  // namespace

BusBytes bus_bytes(const Instruction& instruction) {
  return {static_cast<std::uint64_t>(encoding_of(instruction).bytes()),
          operand_bytes(instruction) + implied_bytes(instruction)};
}

}  // namespace x86model
