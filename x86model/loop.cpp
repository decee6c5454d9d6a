#include "x86model/loop.hpp"

#include <array>

#include "x86model/encoding.hpp"

namespace x86model {

std::vector<LoopForm> all_loop_forms() {
  std::vector<LoopForm> all;
  for (int l = 0; l < loop_count; ++l) {
    for (const Target target : {Target::i386, Target::i8088}) {
      for (const bool as_printed : {false, true}) {
        for (const Counting counting : {Counting::loop, Counting::dec_jnz, Counting::unrolled}) {
          const LoopForm form{static_cast<Loop>(l), counting, target, as_printed};
          if (exists(form)) all.push_back(form);
        }
      }
    }
  }
  return all;
}

std::string_view name_of(Loop loop) {
  constexpr std::array<std::string_view, loop_count> names{"GouraudBytes", "GouraudWords",
                                                           "DepthTest", "TextureSpan"};
  return names.at(static_cast<std::size_t>(loop));
}

std::vector<Instruction> code_of(const LoopForm& form, const Program& program) {
  const auto rows = program.instructions();
  if (form.counting != Counting::unrolled || rows.size() < 2) return {rows.begin(), rows.end()};
  std::vector<Instruction> code{rows.front()};
  for (std::uint32_t copy = 0; copy < copies_of(form.loop); ++copy) {
    code.insert(code.end(), rows.begin() + 1, rows.end() - 1);
  }
  code.push_back(rows.back());
  return code;
}

std::vector<Instruction> code_of(const LoopForm& form) {
  return code_of(form, assemble(listing(form), {}));
}

std::uint32_t entry_of(const LoopForm& form, std::uint32_t pixels) {
  const Program program = assemble(listing(form), {});
  std::uint32_t pixel_bytes = 0;
  for (std::size_t i = 1; i + 1 < program.size; ++i) {
    pixel_bytes += static_cast<std::uint32_t>(encoding_of(program.code.at(i)).bytes());
  }
  const std::uint32_t left_out = copies_of(form.loop) - pixels / pixels_per_iteration(form.loop);
  return static_cast<std::uint32_t>(encoding_of(program.code.front()).bytes()) +
         left_out * pixel_bytes;
}

}  // namespace x86model
