#include "verify/machine_code/frame.hpp"

#include "verify/cases/draw.hpp"
#include "x86model/call.hpp"
#include "x86model/with_routine.hpp"

namespace fixproof::machine_code {

namespace {

using x86model::Register;
using x86model::Routine;
using x86model::Size;

template <Routine routine>
constexpr Frame frame{
    [](SegmentMachine& m, std::span<const std::uint32_t> in) { x86model::enter<routine>(m, in); },
    [](const SegmentMachine& m, std::span<std::uint32_t> out) { x86model::leave<routine>(m, out); },
    [](SegmentMachine& m, std::uint32_t junk) {
      x86model::fill_results_with_junk<routine>(m, junk);
    }};

}  // namespace

Frame frame_of(Routine routine) {
  return x86model::with_routine(routine, []<Routine one> { return frame<one>; });
}

void scramble(SegmentMachine& m, const Frame& frame, std::uint64_t call) {
  cases::Draw draw(386, call);
  const std::uint32_t sp = m.registers.read(Register::sp, Size::word);
  for (std::size_t r = 0; r < x86model::register_count; ++r) {
    m.registers.write(static_cast<Register>(r), Size::dword,
                      static_cast<std::uint32_t>(draw.bits()));
  }
  m.registers.write(Register::sp, Size::word, sp);
  m.flags = {static_cast<std::uint16_t>(draw.bits() & x86model::arithmetic_flags), 0};
  frame.fill_results_with_junk(m, static_cast<std::uint32_t>(draw.bits()));
}

bool kept_for_caller(const x86model::Registers<16>& entered, const x86model::Registers<16>& left) {
  for (const Register kept : {Register::bp, Register::si, Register::di}) {
    if (left.read(kept, Size::dword) != entered.read(kept, Size::dword)) return false;
  }
  return left.read(Register::sp, Size::word) == entered.read(Register::sp, Size::word) + 2;
}

}  // namespace fixproof::machine_code
