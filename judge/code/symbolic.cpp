#include "judge/code/symbolic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "judge/code/decoded.hpp"
#include "judge/code/quotient_claim.hpp"
#include "judge/code/symbolic_machine.hpp"
#include "x86model/alu.hpp"
#include "x86model/run.hpp"
#include "x86model/symbolic/explorer.hpp"
#include "x86model/text.hpp"

namespace fixproof::judge {

namespace {

namespace alu = x86model::alu;
namespace sym = x86model::symbolic;
using sym::Term;
using sym::Thread;
using x86model::Register;
using x86model::Size;

/// A disassembled instruction as x86model/execute.hpp takes it.
struct Instruction {
  std::array<Operand, 3> operands{};
  std::size_t count = 0;
  x86model::Mnemonic mnemonic{};  ///< if a listing has it
};

constexpr const char* unknown_flag = "it reads a flag that is undefined or not modelled";

[[noreturn]] void not_modelled() { throw Obstacle("this instruction is not modelled"); }

constexpr std::size_t max_paths = 200;
constexpr std::size_t max_steps = 20'000;

class Explorer : public sym::Explorer<Path> {
 public:
  Explorer(const Image& image, const Frame& frame, const Signature& signature, Listing& listing,
           sym::Terms& terms)
      : sym::Explorer<Path>(terms, max_paths),
        image_(image),
        frame_(frame),
        signature_(signature),
        listing_(listing) {}

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
    if (code.has_repeat || code.overrides_segment || code.operands.size() > 3) not_modelled();
    Instruction i{.count = code.operands.size()};
    std::copy(code.operands.begin(), code.operands.end(), i.operands.begin());
    const bool moves_stack =
        m == "push" || m == "pop" || m == "call" || m == "leave" || m.starts_with("ret");
    if (moves_stack && code.width != image_.bits) not_modelled();
    ImageMachine machine(image_, t_, thread.state);
    if (m == "ret" || m == "retf") {
      const Term to = machine.pop(machine.word());
      if (!t_.is_constant(to)) not_modelled();
      thread.position = t_.value(to);
      if (m == "retf") machine.pop(machine.word());
      if (i.count == 1) machine.move_stack(i.operands[0].value);
      return true;
    }
    if (code.target) return transfer(thread, machine, code, next);
    const Size size = size_of(i, m);
    for (std::size_t n = 0; n < i.count; ++n) {
      Operand& operand = i.operands.at(n);
      if (operand.kind == Operand::Kind::other || operand.kind == Operand::Kind::segment) {
        not_modelled();
      }
      operand.size = size;
    }
    const bool done = execute_shared(machine, m, i) || execute_users(machine, code, i, size);
    if (machine.fault) {
      paths_.push_back(
          {.condition = take_off(thread, machine.fault->condition), .divide_error = true});
    }
    if (!done) not_modelled();
    thread.position = next;
    return true;
  }

  /// The size of the operands: that of the first one. What is pushed has that of the code.
  [[nodiscard]] Size size_of(const Instruction& i, const std::string& m) const {
    const int bits = i.count == 0 || m == "push" ? image_.bits : i.operands[0].bits;
    return bits == 8 ? Size::byte : whole_register(0, bits).size;
  }

  /// A jump or call with a fixed target. Returns whether the thread goes on.
  bool transfer(Thread& thread, ImageMachine& machine, const Decoded& code, std::uint32_t next) {
    if (code.mnemonic == "call") machine.push(t_.constant(next, machine.width()));
    const bool always = code.mnemonic == "call" || code.mnemonic == "jmp";
    if (!always && !code.condition) not_modelled();
    const Term taken = always ? t_.truth(true) : holds(machine, *code.condition);
    return jump(thread, taken, *code.target, next);
  }

  static Term holds(const ImageMachine& machine, alu::ConditionCode condition) {
    if (!machine.flags.are_defined(alu::flags_read(condition))) throw Obstacle(unknown_flag);
    return alu::holds(machine.domain(), condition, machine.flags);
  }

  /// The instructions that the listings use too.
  static bool execute_shared(ImageMachine& machine, const std::string& m, Instruction& i) {
    using x86model::Outcome;
    const auto op = x86model::mnemonic_named(m);
    if (!op || x86model::is_control_flow(*op)) return false;
    using namespace x86model::detail;
    if ((is_multiply(*op) || is_divide(*op)) &&
        (i.count != 1 || i.operands[0].size == Size::byte || i.operands[0].size == Size::qword)) {
      return false;
    }
    if (is_double_shift(*op) && (i.operands[2].value & 31U) >= 16 &&
        i.operands[0].size == Size::word) {
      return false;
    }
    i.mnemonic = *op;
    const Outcome outcome = x86model::execute_any(i, machine);
    if (outcome == Outcome::undefined_flag) throw Obstacle(unknown_flag);
    return outcome == Outcome::proceeds;
  }

  /// The instructions that only users' code has.
  bool execute_users(ImageMachine& machine, const Decoded& code, const Instruction& i, Size size) {
    const std::string& m = code.mnemonic;
    const sym::Domain d = machine.domain();
    const int bits = ImageMachine::bits_of(size);
    const Operand& first = i.operands[0];
    const auto value = [&](std::size_t n) {
      Term term;
      machine.read(i.operands.at(n), size, term);
      return term;
    };
    if (i.count == 0) return execute_without_operands(machine, m);
    if (code.condition && m.starts_with("set") && i.count == 1) {
      const Term truth = holds(machine, *code.condition);
      return machine.write(first, size, t_.ite(truth, t_.constant(1, 8), t_.constant(0, 8)));
    }
    if (m == "not" && i.count == 1) {
      return machine.write(first, size, t_.bit_xor(value(0), t_.constant(~std::uint64_t{0}, bits)));
    }
    if (code.condition && m.starts_with("cmov") && i.count == 2) {
      return machine.write(first, size,
                           t_.ite(holds(machine, *code.condition), value(1), value(0)));
    }
    if (m == "lea" && i.count == 2) {
      const Term address = machine.address_term(i.operands[1]);
      const int given = t_.width(address);
      return machine.write(
          first, size, given < bits ? t_.zero_extend(address, bits) : t_.extract(address, 0, bits));
    }
    if (m == "idiv" && i.count == 1 && size == Size::qword) return divide_64(machine, value(0));
    if (m == "imul" && i.count > 1 && size == Size::qword) {
      machine.flags = d.undefined_flags();
      return machine.write(first, size, low_product(value(i.count - 2), value(i.count - 1)));
    }
    if (m == "imul" && i.count > 1 && size != Size::byte) {
      const auto product = alu::imul(d, value(i.count - 2), value(i.count - 1), bits);
      machine.flags = product.flags;
      return machine.write(first, size, d.extract(product.wide, 0, bits));
    }
    if (i.count != 2) return false;
    if (m == "or" || m == "test") {
      const Term both = d.bit_and(value(0), value(1));
      const Term either = d.bit_xor(d.bit_xor(value(0), value(1)), both);
      const auto result = alu::logic(d, m == "or" ? either : both, bits);
      machine.flags = result.flags;
      return m == "test" || machine.write(first, size, result.value);
    }
    if (m == "xchg") {
      const Term old = value(0);
      return machine.write(first, size, value(1)) && machine.write(i.operands[1], size, old);
    }
    if (m == "movzx" || m.starts_with("movsx")) {
      const Operand& from = i.operands[1];
      const int given = from.bits;
      if (given >= bits) return false;
      Term narrow;
      machine.read(from, given == 8 ? Size::byte : whole_register(0, given).size, narrow);
      return machine.write(
          first, size, m == "movzx" ? t_.zero_extend(narrow, bits) : t_.sign_extend(narrow, bits));
    }
    return false;
  }

  bool execute_without_operands(ImageMachine& machine, const std::string& m) {
    if (m == "leave") {
      const RegisterName frame = whole_register(5, image_.bits);
      machine.write(stack_pointer(), machine.read(frame));
      machine.write(frame, machine.pop(machine.word()));
      return true;
    }
    // CWDE and CDQE extend AX and EAX by their sign to a register of twice the size; CWD, CDQ and
    // CQO fill another register with it.
    if (m == "cwde" || m == "cdqe") {
      const int bits = m == "cwde" ? 16 : 32;
      const Term narrow = machine.read(whole_register(0, bits));
      machine.write(whole_register(0, 2 * bits), t_.sign_extend(narrow, 2 * bits));
      return true;
    }
    if (m == "cwd" || m == "cdq" || m == "cqo") {
      const int bits = m == "cwd" ? 16 : m == "cdq" ? 32 : 64;
      const Term number = machine.read(whole_register(0, bits));
      const Term wide =
          bits == 64 ? sign_of(number) : t_.extract(t_.sign_extend(number, 2 * bits), bits, bits);
      machine.write(whole_register(2, bits), wide);
      return true;
    }
    return false;
  }

  /// IDIV of a dividend that CQO has extended: the only one that fits a term.
  bool divide_64(ImageMachine& machine, Term divisor) {
    const Term n = machine.read(whole_register(0, 64));
    if (machine.read(whole_register(2, 64)) != sign_of(n)) {
      throw Obstacle("a dividend of more than 64 bits is not modelled");
    }
    const auto is = [&](Term term, std::uint64_t number) {
      return t_.equal(term, t_.constant(number, 64));
    };
    const std::uint64_t lowest = std::uint64_t{1} << 63U;
    machine.faults_if(
        t_.either(is(divisor, 0), t_.both(is(n, lowest), is(divisor, ~std::uint64_t{0}))));
    machine.write(whole_register(0, 64), t_.apply(quotient_64, {n, divisor}, 64));
    machine.write(whole_register(2, 64), t_.apply(remainder_64, {n, divisor}, 64));
    machine.flags = machine.domain().undefined_flags();
    return true;
  }

  /// A word of copies of a term's sign.
  Term sign_of(Term number) {
    const int bits = t_.width(number);
    return t_.sign_extend(t_.extract(number, bits - 1, 1), bits);
  }

  /// The low 64 bits of a product. That of two numbers of 32 bits is exact, so it is the abstract
  /// function that claims speak of, with its operands in the order in which they were made.
  Term low_product(Term x, Term y) {
    for (const bool is_signed : {true, false}) {
      auto a = narrowed(x, is_signed);
      auto b = narrowed(y, is_signed);
      if (!a || !b) continue;
      if (*b < *a) std::swap(a, b);
      const sym::Domain d(t_);
      return is_signed ? d.signed_product(*a, *b, 32) : d.unsigned_product(*a, *b, 32);
    }
    throw Obstacle("a product of numbers of more than 32 bits is not modelled");
  }

  /// The number of 32 bits that a term of 64 extends, if it does.
  std::optional<Term> narrowed(Term wide, bool is_signed) {
    const sym::Node node = t_[wide];
    if (node.op == sym::Op::constant) {
      const auto low = static_cast<std::uint32_t>(node.value);
      const std::uint64_t extended =
          is_signed ? static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(low)})
                    : low;
      if (extended != node.value) return std::nullopt;
      return t_.constant(low, 32);
    }
    if (is_signed && node.op == sym::Op::sign_extend && t_.width(node.arguments[0]) <= 32) {
      return t_.sign_extend(node.arguments[0], 32);
    }
    const bool has_zeros = node.op == sym::Op::concat && t_.is_constant(node.arguments[0]) &&
                           t_.value(node.arguments[0]) == 0;
    if (has_zeros && t_.width(node.arguments[1]) <= (is_signed ? 31 : 32)) {
      return t_.zero_extend(node.arguments[1], 32);
    }
    return std::nullopt;
  }

  const Image& image_;
  const Frame& frame_;
  const Signature& signature_;
  Listing& listing_;
  sym::State begin_;
  std::uint32_t after_ = 0;  ///< the right SP after the return
};

}  // namespace

std::string operand_name(std::size_t index) { return {static_cast<char>('a' + index)}; }

SymbolicRun run_symbolically(const Image& image, const Frame& frame, const Signature& signature,
                             Listing& listing, sym::Terms& terms) {
  SymbolicRun run;
  try {
    Explorer explorer(image, frame, signature, listing, terms);
    run.paths = explorer.all(explorer.start());
  } catch (const Obstacle& obstacle) {
    run.obstacle = obstacle.what();
  }
  return run;
}

}  // namespace fixproof::judge
