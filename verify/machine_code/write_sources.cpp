// usage: write_sources FOLDER
// Writes NAME.asm for every program and every form of a loop: an ORG line, then the output of
// `fixproof list`. For routines, NAME.com.asm has the same text framed by dos.asm. It prints
// the names.
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "verify/machine_code/programs.hpp"
#include "x86model/text.hpp"

namespace {

using fixproof::machine_code::ProgramKey;

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text << std::flush;
  if (!file) throw std::runtime_error("cannot write " + path);
}

std::string in_segment(const std::string& listing) {
  return "        org " + std::to_string(fixproof::machine_code::code_origin) + '\n' + listing;
}

std::string in_dos(const ProgramKey& key, const std::string& listing) {
  const x86model::Arity arity = x86model::arity(key.routine);
  const auto define = [](std::string_view name, std::string_view value) {
    return std::string("%define ").append(name).append(" ").append(value).append("\n");
  };
  std::string text = define("ROUTINE", x86model::name_of(key.routine));
  text += define("WORDS_IN", std::to_string(arity.in));
  text += define("WORDS_OUT", std::to_string(arity.out));
  return text + "%include \"dos.asm\"\n\n" + listing;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("usage: write_sources FOLDER");
    for (const ProgramKey& key : fixproof::machine_code::all_programs()) {
      const std::string path = std::string(argv[1]) + '/' + name_of(key);
      const std::string listing = x86model::nasm_source(key.routine, key.target, key.build);
      write(path + ".asm", in_segment(listing));
      write(path + ".com.asm", in_dos(key, listing));
      std::cout << name_of(key) << '\n';
    }
    for (const x86model::LoopForm& form : x86model::all_loop_forms()) {
      write(std::string(argv[1]) + '/' + fixproof::machine_code::name_of(form) + ".asm",
            in_segment(x86model::nasm_source(form)));
      std::cout << fixproof::machine_code::name_of(form) << '\n';
    }
    std::cout.flush();
    return std::cout ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "write_sources: " << error.what() << '\n';
    return 1;
  }
}
