#include "tests/verify/vectors/cases.hpp"

#include <fmt/format.h>

#include "support/file.hpp"
#include "tests/support/bitwise.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "verify/singlestep/gunzip.hpp"

namespace vectors {

namespace {

std::string replaced(std::string text, const std::string& from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from)) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace

std::string path_of(const Committed& file) {
  return paths::source("tests/verify/vectors/" + std::string(file.name));
}

Json load(const Committed& file) {
  return Json::parse(fixproof::singlestep::gunzip(fixproof::support::read_file(path_of(file))));
}

bool is_run(const Json& c) {
  static const std::set<std::string> skipped{"or ax, bx",  "xor ax, bx", "mov bx, 1234h",
                                             "add al, cl", "neg dh",     "es add ax, bx"};
  return !skipped.contains(c.at("name").get<std::string>());
}

bool is_fault(const Json& c) { return c.at("final").at("regs").contains("cs"); }

std::string name_in_set(std::string_view name, std::string_view cpu) {
  const bool segment = name.size() == 2 && name[1] == 's';
  return fmt::format("{}{}", cpu == "386" && !segment ? "e" : "", name);
}

std::uint32_t final_value(const Json& c, const std::string& name) {
  const Json& changed = c.at("final").at("regs");
  return (changed.contains(name) ? changed : c.at("initial").at("regs"))
      .at(name)
      .get<std::uint32_t>();
}

std::uint16_t undefined_flags(const Json& c) {
  const auto name = c.at("name").get<std::string>();
  const auto mnemonic = name.substr(0, name.find(' '));
  if (mnemonic == "or") return bitwise::AF;
  if (!is_run(c) || name.starts_with("push") || name.starts_with("jmp")) return 0;
  const auto bytes = c.at("bytes").get<std::vector<int>>();
  const bool wide = bytes.front() == 0x66;
  const auto opcode = bytes.at(wide ? 1 : 0);
  bitwise::Operands operands{.second = 1};
  if (opcode == 0xD1) operands.count = 1;
  if (opcode == 0xC1 || opcode == 0x0F) operands.count = bytes.at(bytes.size() - 2);
  return bitwise::execute(mnemonic, operands, wide ? 32 : 16).undefined;
}

command::Run judge_text(const std::string& text, std::string_view cpu) {
  const ScratchFolder folder;
  const std::string path = folder.write("cases.json", text);
  auto run = command::fixproof(fmt::format("step --cpu {} --singlestep {}", cpu, path));
  run.out = replaced(run.out, path, "FILE");
  run.err = replaced(run.err, path, "FILE");
  return run;
}

command::Run judge(const Json& cases, std::string_view cpu) {
  return judge_text(cases.dump(), cpu);
}

}  // namespace vectors
