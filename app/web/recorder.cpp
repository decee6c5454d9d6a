#include "app/web/recorder.hpp"

#include <algorithm>
#include <utility>

#include "verify/machine_code/programs.hpp"
#include "x86model/count_clocks.hpp"
#include "x86model/forms.hpp"
#include "x86model/text.hpp"
#include "x86model/with_routine.hpp"

namespace fixproof::web {

namespace {

namespace x86 = x86model;

/// Takes a snapshot after every instruction.
/// @tparam Read returns the contents of a cell, from a machine and the cell
template <class Read>
class Recorder {
 public:
  Recorder(Run& run, const Read& read)
      : run_(run),
        read_(read),
        counter_(run.code, run.target == x86::Target::i386 ? x86::Cpu::i386 : x86::Cpu::i8088) {}

  template <class M>
  void take(std::size_t position, const M& m) {
    Snapshot taken{.position = position, .flags = m.flags, .clocks = counter_.total()};
    for (std::size_t r = 0; r < taken.registers.size(); ++r) {
      taken.registers[r] = m.registers.read(static_cast<x86::Register>(r), x86::Size::dword);
    }
    for (const Cell& cell : run_.cells) taken.memory.push_back(read_(m, cell));
    run_.snapshots.push_back(std::move(taken));
  }

  template <class M>
  void before(std::size_t position, const M& m) {
    if (run_.lacks_instruction) return;
    if (!x86::is_modelled(run_.code[position], run_.target)) {
      run_.lacks_instruction = true;
      stopped_ = position;
      return;
    }
    counter_.before(position, m);
  }
  template <class M>
  void operator()(std::size_t position, const M& m) {
    if (run_.lacks_instruction) return;
    counter_(position, m);
    take(position, m);
  }

  /// Returns the position of the instruction that the processor lacks.
  [[nodiscard]] std::size_t stopped() const { return stopped_; }

 private:
  Run& run_;
  const Read& read_;
  x86::ClockCounter counter_;
  std::size_t stopped_ = 0;
};

/// Runs run.code on a machine that is ready.
template <class M, class Read>
void run_recorded(Run& run, M& machine, std::uint64_t limit, const Read& read) {
  Recorder<Read> recorder(run, read);
  recorder.take(0, machine);
  run.ending = x86::run(run.code, machine, recorder, limit);
  if (run.lacks_instruction) run.ending.position = recorder.stopped();
}

/// Puts typed code in place of the build's.
void take_code(Run& run, Edit& edit) {
  if (edit.code.empty()) return;
  run.code = std::move(edit.code);
  run.names = std::move(edit.names);
}

template <class M>
void set_registers(M& machine, const Edit& edit) {
  for (const auto& [reg, value] : edit.registers) {
    machine.registers.write(reg, x86::Size::dword, value);
  }
}

template <x86::Routine routine>
void call_recorded(Run& run, std::span<const std::uint32_t> in, const Edit& edit) {
  x86::CallMachine<routine, 16> machine;
  x86::enter<routine>(machine, in);
  set_registers(machine, edit);
  std::uint32_t word = 0;
  for (std::uint32_t address = 0; machine.memory.read(address, word); address += 2) {
    run.cells.push_back({address});
  }
  run_recorded(run, machine, most_of_routine, [](const auto& m, const Cell& cell) {
    std::uint32_t read = 0;
    m.memory.read(cell.address, read);
    return static_cast<std::uint16_t>(read);
  });
  if (run.lacks_instruction || run.ending.outcome != x86::Outcome::returned) return;
  run.result.resize(static_cast<std::size_t>(x86::arity(routine).out));
  x86::leave<routine>(machine, run.result);
}

/// The forms of a loop that the page has, with their names after the loop's own.
std::vector<std::pair<std::string, x86::LoopForm>> forms_of(std::string_view loop) {
  std::vector<std::pair<std::string, x86::LoopForm>> forms;
  for (const x86::LoopForm& form : x86::all_loop_forms()) {
    const std::string name = machine_code::name_of(form);
    if (form.counting == x86::Counting::unrolled || !name.starts_with(loop)) continue;
    forms.emplace_back(name.substr(loop.size() + 1), form);
  }
  return forms;
}

/// Where STOSB and STOSW draw.
constexpr std::uint32_t drawn_row = 0x2800;

/// Returns the pixels of a call and some beyond its end, and for DepthTest also their depths.
std::vector<Cell> cells_of(x86::Loop loop, std::uint32_t pixels) {
  const bool tests = loop == x86::Loop::depth_test;
  const auto screen =
      tests ? static_cast<std::uint32_t>(x86::address_of(x86::Symbol::screen)) : drawn_row;
  const auto depths = static_cast<std::uint32_t>(x86::address_of(x86::Symbol::z_buff));
  const std::uint32_t shown = pixels / 8 * 8 + 8;
  std::vector<Cell> cells;
  for (std::uint32_t i = 0; i < shown; ++i) cells.push_back({screen + i, Cell::Kind::pixel});
  for (std::uint32_t i = 0; tests && i < shown; ++i) {
    cells.push_back({depths + 2 * i, Cell::Kind::depth});
  }
  return cells;
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace

std::vector<std::string> builds_of(x86::Routine routine) {
  using enum x86::Routine;
  if (routine == cossin) return {"i386", "i8088", "i8088-printed"};
  std::vector<std::string> builds{"i386-on", "i386-off", "i8088-on", "i8088-off"};
  if (routine == mul || routine == div || routine == concat) builds.emplace_back("i386-52");
  if (routine == concat) builds.emplace_back("i8088-on-repaired");
  if (routine == div) builds.emplace_back("i8088-off-scanned");
  return builds;
}

Run record(x86::Routine routine, std::string_view build, std::span<const std::uint32_t> in,
           Edit edit) {
  Run run{.name = std::string(build),
          .target = build.starts_with("i386") ? x86::Target::i386 : x86::Target::i8088};
  const bool rounds = !contains(build, "-off");
  const x86::Program program = x86::assemble(x86::listing(routine, run.target),
                                             {.mul_rounding = rounds,
                                              .div_rounding = rounds,
                                              .chapter_52 = contains(build, "-52"),
                                              .endif_as_scanned = contains(build, "-scanned"),
                                              .repaired = contains(build, "-repaired"),
                                              .shl_as_printed = contains(build, "-printed")});
  const auto code = program.instructions();
  run.code.assign(code.begin(), code.end());
  take_code(run, edit);
  x86::with_routine(routine,
                    [&]<x86::Routine constant> { call_recorded<constant>(run, in, edit); });
  return run;
}

std::vector<std::string> builds_of_loop(std::string_view loop) {
  std::vector<std::string> builds;
  for (const auto& [name, form] : forms_of(loop)) builds.push_back(name);
  return builds;
}

Run record_loop(std::string_view loop, std::string_view build, x86::LoopCall call, Edit edit) {
  x86::LoopForm form;
  for (const auto& [name, each] : forms_of(loop)) {
    if (name == build) form = each;
  }
  Run run{.name = std::string(build),
          .target = form.target,
          .code = x86::code_of(form),
          .is_loop = true,
          .cells = cells_of(form.loop, call.pixels)};
  take_code(run, edit);
  constexpr std::size_t segment = 0x10000;
  std::vector<std::uint8_t> data(segment);
  std::vector<std::uint8_t> extra(segment);
  const bool tests = form.loop == x86::Loop::depth_test;
  if (form.loop == x86::Loop::texture) {
    const auto first = static_cast<std::size_t>(x86::address_of(x86::Symbol::texture));
    for (std::size_t texel = 0; first + texel < segment; ++texel) {
      data[first + texel] = static_cast<std::uint8_t>(texel / 256 + texel);
    }
  }
  call.place = tests ? 0 : drawn_row;
  call.colour = 0xFF;
  x86::LoopMachine machine{.registers = {}, .memory = x86::ByteMemory(data, extra, data)};
  x86::enter_loop(form, machine, call);
  set_registers(machine, edit);
  const auto& drawn = tests ? data : extra;
  run_recorded(run, machine, most_instructions, [&](const auto& /*m*/, const Cell& cell) {
    const unsigned low = drawn[cell.address];
    const unsigned high = cell.kind == Cell::Kind::pixel ? 0U : drawn[cell.address + 1];
    return static_cast<std::uint16_t>(low | high << 8U);
  });
  return run;
}

std::size_t first_difference(const Run& a, const Run& b) {
  const auto text = [](const Run& run, std::size_t step) {
    return x86::text_of(run.code[run.snapshots[step].position]);
  };
  const std::size_t both = std::min(a.snapshots.size(), b.snapshots.size());
  for (std::size_t step = 1; step < both; ++step) {
    const Snapshot& one = a.snapshots[step];
    const Snapshot& other = b.snapshots[step];
    if (text(a, step) != text(b, step) || one.registers != other.registers ||
        one.flags != other.flags || one.memory != other.memory) {
      return step;
    }
  }
  return a.snapshots.size() == b.snapshots.size() ? 0 : both;
}

}  // namespace fixproof::web
