#include "tests/judge/code/bare_processor.hpp"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

#include "judge/code/assemble.hpp"
#include "x86model/flags.hpp"

#if defined(__linux__) && defined(__x86_64__) && !defined(__ILP32__)
#include <cpuid.h>
#include <sys/mman.h>

#include <csignal>

#include "verify/machine_code/guarded_call.hpp"
#endif

namespace bare_processor {

namespace {

using user_forms::Feature;

/// What a piece works on; RDI points to it.
struct Frame {
  std::array<std::uint64_t, used_registers.size()> registers{};
  std::uint64_t flags = 0;
};

constexpr std::array<const char*, used_registers.size()> names{"rax", "rcx", "rdx",
                                                               "rbx", "rsi", "r8"};

/// Three offsets for each piece, then for each a function that loads the frame, runs the piece and
/// stores the frame: where the function begins, and where the piece begins and ends.
std::string source_of(const std::vector<user_forms::Form>& forms, int bits) {
  std::string table = fmt::format("bits {}\n", bits);
  std::string code;
  if (bits != 64) {
    for (std::size_t i = 0; i < forms.size(); ++i) {
      table += fmt::format("dd 0, b{0}, e{0}\n", i);
      code += fmt::format("b{0}: {1}\ne{0}:\n", i, forms[i].text);
    }
    return table + code;
  }
  const std::size_t flags_at = sizeof(Frame::registers);
  for (std::size_t i = 0; i < forms.size(); ++i) {
    table += fmt::format("dd f{0}, b{0}, e{0}\n", i);
    code += fmt::format("f{}: push rbx\npush qword [rdi+{}]\npopfq\n", i, flags_at);
    for (std::size_t r = 0; r < names.size(); ++r) {
      code += fmt::format("mov {}, [rdi+{}]\n", names[r], 8 * r);
    }
    code += fmt::format("b{0}: {1}\ne{0}:\n", i, forms[i].text);
    for (std::size_t r = 0; r < names.size(); ++r) {
      code += fmt::format("mov [rdi+{}], {}\n", 8 * r, names[r]);
    }
    code += fmt::format("pushfq\npop qword [rdi+{}]\npop rbx\nret\n", flags_at);
  }
  return table + code;
}

std::uint32_t offset_in(const std::string& bytes, std::size_t index, std::size_t column) {
  std::uint32_t offset = 0;
  std::memcpy(&offset, bytes.data() + 12 * index + 4 * column, sizeof offset);
  return offset;
}

}  // namespace

std::string Pieces::code(std::size_t index) const {
  const std::uint32_t begin = offset_in(bytes_, index, 1);
  return bytes_.substr(begin, offset_in(bytes_, index, 2) - begin);
}

#if defined(__linux__) && defined(__x86_64__) && !defined(__ILP32__)

struct Pieces::Memory : private boost::noncopyable {
  explicit Memory(const std::string& bytes)
      : size(bytes.size()),
        at(mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
    if (at == MAP_FAILED) throw std::runtime_error("no memory for code");
    std::memcpy(at, bytes.data(), size);
    if (mprotect(at, size, PROT_READ | PROT_EXEC) != 0) throw std::runtime_error("no code");
  }
  ~Memory() { munmap(at, size); }

  std::size_t size;
  void* at;
};

std::string absence() { return {}; }

bool has(Feature feature) {
  struct Bit {
    unsigned leaf;
    unsigned word;  ///< of EAX, EBX, ECX and EDX
    unsigned bit;
  };
  // Intel SDM volume 2, CPUID.
  const auto place = [&]() -> Bit {
    switch (feature) {
      case Feature::bmi1:
        return {7, 1, 3};
      case Feature::bmi2:
        return {7, 1, 8};
      case Feature::adx:
        return {7, 1, 19};
      case Feature::lzcnt:
        return {0x80000001, 2, 5};
      case Feature::popcnt:
        return {1, 2, 23};
      case Feature::none:
        break;
    }
    return {1, 3, 0};  // an x87, which all have
  }();
  unsigned eax = 0;
  unsigned ebx = 0;
  unsigned ecx = 0;
  unsigned edx = 0;
  if (__get_cpuid_count(place.leaf, 0, &eax, &ebx, &ecx, &edx) == 0) return false;
  return (std::array{eax, ebx, ecx, edx}.at(place.word) >> place.bit & 1U) != 0;
}

bool Pieces::call(std::size_t index, fixproof::judge::Registers& registers) const {
  Frame frame;
  for (std::size_t i = 0; i < used_registers.size(); ++i) {
    frame.registers.at(i) = registers.general.at(used_registers.at(i));
  }
  // Bit 1 is always set, and interrupts stay allowed.
  frame.flags = registers.flags | 0x202U;
  auto* const begin = static_cast<char*>(memory_->at) + offset_in(bytes_, index, 0);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the bytes are a function
  auto* const function = reinterpret_cast<void (*)(Frame*)>(begin);
  const int signal = fixproof::machine_code::signal_of([&] { function(&frame); });
  if (signal != 0) {
    if (signal != SIGFPE) throw std::runtime_error(fmt::format("signal {}", signal));
    return true;
  }
  for (std::size_t i = 0; i < used_registers.size(); ++i) {
    registers.general.at(used_registers.at(i)) = frame.registers.at(i);
  }
  registers.flags = static_cast<std::uint32_t>(frame.flags) & x86model::arithmetic_flags;
  return false;
}

#else

struct Pieces::Memory {
  explicit Memory(const std::string& /*bytes*/) {}
};

std::string absence() { return "not 64-bit Linux on x86"; }
bool has(Feature /*feature*/) { return false; }
bool Pieces::call(std::size_t /*index*/, fixproof::judge::Registers& /*registers*/) const {
  throw std::logic_error(absence());
}

#endif

Pieces::Pieces(const std::vector<user_forms::Form>& forms, int bits)
    : bytes_(fixproof::judge::assembled(source_of(forms, bits))) {
  if (bytes_.empty()) throw std::runtime_error("NASM refuses a form");
  memory_ = std::make_unique<Memory>(bytes_);
}

Pieces::~Pieces() = default;

}  // namespace bare_processor
