#include "judge/code/symbolic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "judge/code/decoded.hpp"
#include "judge/code/execution.hpp"
#include "judge/code/symbolic_machine.hpp"
#include "x86model/symbolic/explorer.hpp"

namespace fixproof::judge {

namespace {

namespace sym = x86model::symbolic;
using sym::Term;
using sym::Thread;
using x86model::Register;

constexpr std::size_t max_paths = 200;
constexpr std::size_t max_steps = 20'000;

class Explorer : public sym::Explorer<Path> {
 public:
  Explorer(const Image& image, const Frame& frame, const Signature& signature, Listing& listing,
           sym::Terms& terms, const MayHold& may_hold)
      : sym::Explorer<Path>(terms, max_paths),
        image_(image),
        frame_(frame),
        signature_(signature),
        listing_(listing),
        may_hold_(may_hold) {}

  /// The entry of the routine, called with its operands.
  Thread start() {
    Thread thread{.condition = t_.truth(true), .position = image_.entry};
    const int width = image_.bits;
    for (std::size_t r = 0; r < (width == 64 ? register_count : x86model::register_count); ++r) {
      thread.state.registers.at(r) = t_.variable(sym::numbered("register", r), std::max(width, 32));
    }
    ImageMachine machine(image_, t_, thread.state);
    const auto& parameters = signature_.operands;
    std::uint32_t top = image_.stack_top;
    if (width == 64) top -= bytes_of_home;
    const auto push_all = [&](std::size_t i) {
      const Term value = extended(parameters[i], i, std::max(width, parameters[i].bits));
      top -= static_cast<std::uint32_t>(t_.width(value) / 8);
      machine.store_at(image_.data_at(top), value);
    };
    for (std::size_t i = 0; frame_.on_stack && i < parameters.size(); ++i) {
      push_all(frame_.first_is_top ? parameters.size() - 1 - i : i);
    }
    after_ = frame_.callee_pops ? image_.stack_top : top;
    for (std::size_t i = 0; i < frame_.in.size(); ++i) {
      if (frame_.in[i].is_pointer) throw Obstacle("operands behind pointers are not modelled");
      int bits = 0;
      for (const RegisterName& part : frame_.in[i].parts) bits += bits_of(part);
      const Term value = extended(parameters[i], i, bits);
      for (const RegisterName& part : frame_.in[i].parts) {
        bits -= bits_of(part);
        machine.put(part, t_.extract(value, bits, bits_of(part)));
      }
    }
    const std::uint32_t slot = static_cast<std::uint32_t>(width) / 8;
    if (frame_.is_far) {
      top -= slot;
      machine.store_at(image_.data_at(top), t_.constant(image_.code_segment, width));
    }
    top -= slot;
    machine.store_at(image_.data_at(top), t_.constant(image_.exit, width));
    machine.put(stack_pointer(), t_.constant(top, width));
    begin_ = thread.state;
    return thread;
  }

 private:
  Term extended(const Parameter& p, std::size_t index, int bits) {
    const Term value = t_.variable(operand_name(index), p.bits);
    return p.is_signed ? t_.sign_extend(value, bits) : t_.zero_extend(value, bits);
  }

  [[nodiscard]] RegisterName stack_pointer() const { return whole_register(4, image_.bits); }

  bool step(Thread& thread) override {
    const auto at = static_cast<std::uint32_t>(thread.position);
    if (at == image_.exit) {
      returned(thread);
      return false;
    }
    if (thread.steps > max_steps) {
      throw Obstacle(fmt::format("a path has more than {} instructions", max_steps));
    }
    const std::uint32_t linear = image_.code_at(at);
    if (linear < image_.first || linear >= image_.end) {
      const Symbol* const missing = image_.missing_at(linear);
      throw Obstacle(missing == nullptr ? "a path leaves the code"
                                        : fmt::format("it calls {}, which the object does not have",
                                                      missing->name));
    }
    try {
      return execute(thread, listing_.decoded_at(at)) && is_possible(thread);
    } catch (const Obstacle& obstacle) {
      throw Obstacle(fmt::format("{} at {:04x}h: {}", listing_.at(at).text, at, obstacle.what()));
    }
  }

  void give_up(Thread& /*thread*/) override {
    throw Obstacle(fmt::format("there are more than {} paths", max_paths));
  }

  void returned(Thread& thread) {
    const ImageMachine machine(image_, t_, thread.state);
    const ImageMachine before(image_, t_, begin_);
    Path path{.condition = thread.condition};
    const int bits = signature_.result_bits;
    std::vector<RegisterName> parts;
    if (!frame_.on_stack) {
      parts = frame_.out.front().parts;
    } else {
      if (bits > image_.bits) parts.push_back({Register::dx, machine.word()});
      parts.push_back({Register::ax, machine.word()});
    }
    std::optional<Term> value;
    for (const RegisterName& part : parts) {
      const Term read = machine.read(part);
      value = value ? sym::join(t_, *value, read) : read;
    }
    path.result = t_.extract(*value, 0, bits);
    path.kept = t_.equal(machine.read(stack_pointer()), t_.constant(after_, image_.bits));
    for (const RegisterName& kept : frame_.kept) {
      path.kept = t_.both(path.kept, t_.equal(machine.read(kept), before.read(kept)));
    }
    paths_.push_back(path);
  }

  /// Executes one instruction. Returns whether the thread goes on.
  bool execute(Thread& thread, const Decoded& code) {
    const auto next = static_cast<std::uint32_t>(thread.position) + code.bytes;
    const std::string& m = code.mnemonic;
    if (m == "nop" || m.starts_with("endbr")) {
      thread.position = next;
      return true;
    }
    if (m == "ud2") {
      paths_.push_back({.condition = thread.condition, .traps = true});
      return false;
    }
    const bool moves_stack =
        m == "push" || m == "pop" || m == "call" || m == "leave" || m.starts_with("ret");
    if (moves_stack && code.width != image_.bits) not_modelled();
    ImageMachine machine(image_, t_, thread.state);
    if (m == "ret" || m == "retf") {
      const Term to = machine.pop(machine.word());
      if (!t_.is_constant(to)) not_modelled();
      thread.position = t_.value(to);
      if (m == "retf") machine.pop(machine.word());
      if (!code.operands.empty()) machine.move_stack(code.operands[0].value);
      return true;
    }
    if (code.target) return transfer(thread, machine, code, next);
    execute_on(machine, code);
    if (machine.fault) {
      paths_.push_back(
          {.condition = take_off(thread, machine.fault->condition), .divide_error = true});
    }
    thread.position = next;
    return true;
  }

  /// A jump or call with a fixed target. Returns whether the thread goes on.
  bool transfer(Thread& thread, ImageMachine& machine, const Decoded& code, std::uint32_t next) {
    if (code.mnemonic == "call") machine.push(t_.constant(next, machine.width()));
    const bool always = code.mnemonic == "call" || code.mnemonic == "jmp";
    if (!always && !code.condition) not_modelled();
    const Term taken = always ? t_.truth(true) : holds(machine, *code.condition);
    const bool is_open = !t_.is_constant(taken);
    if (!is_open || ++thread.jumps[thread.position] == 1) {
      return jump(thread, taken, *code.target, next);
    }
    const bool may_jump = may_hold_(t_.both(thread.condition, taken));
    const bool may_go_on = may_hold_(t_.both(thread.condition, t_.negation(taken)));
    if (!may_jump && !may_go_on) return false;
    return jump(thread, may_jump && may_go_on ? taken : t_.truth(may_jump), *code.target, next);
  }

  const Image& image_;
  const Frame& frame_;
  const Signature& signature_;
  Listing& listing_;
  const MayHold& may_hold_;
  sym::State begin_;
  std::uint32_t after_ = 0;  ///< the right SP after the return
};

}  // namespace

std::string operand_name(std::size_t index) { return {static_cast<char>('a' + index)}; }

SymbolicRun run_symbolically(const Image& image, const Frame& frame, const Signature& signature,
                             Listing& listing, sym::Terms& terms, const MayHold& may_hold) {
  SymbolicRun run;
  try {
    Explorer explorer(image, frame, signature, listing, terms, may_hold);
    run.paths = explorer.all(explorer.start());
  } catch (const Obstacle& obstacle) {
    run.obstacle = obstacle.what();
  }
  return run;
}

}  // namespace fixproof::judge
