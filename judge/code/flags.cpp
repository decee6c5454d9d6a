#include "judge/code/flags.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "x86model/flags.hpp"

namespace fixproof::judge {

namespace {

using x86model::AF;
using x86model::CF;
using x86model::OF;
using x86model::PF;
using x86model::SF;
using x86model::ZF;

constexpr std::uint16_t all_flags = x86model::arithmetic_flags;
constexpr std::uint16_t of_result = SF | ZF | PF;

template <std::size_t n>
bool is_one_of(std::string_view name, const std::array<std::string_view, n>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Returns the flags that a condition such as `nbe` reads.
std::optional<std::uint16_t> read_by_condition(std::string_view c) {
  if (c.starts_with('n') && c != "n") c.remove_prefix(1);
  if (c == "o") return OF;
  if (c == "b" || c == "c" || c == "ae") return CF;
  if (c == "z" || c == "e") return ZF;
  if (c == "be" || c == "a") return std::uint16_t{CF | ZF};
  if (c == "s") return SF;
  if (c == "p" || c == "pe" || c == "po") return PF;
  if (c == "l" || c == "ge") return std::uint16_t{SF | OF};
  if (c == "le" || c == "g") return std::uint16_t{SF | OF | ZF};
  return std::nullopt;
}

std::uint16_t read_by(std::string_view m) {
  if (m == "adc" || m == "sbb" || m == "rcl" || m == "rcr" || m == "cmc") return CF;
  if (m == "loope" || m == "loopne") return ZF;
  if (m == "into") return OF;
  if (m == "daa" || m == "das") return CF | AF;
  if (m == "aaa" || m == "aas") return AF;
  for (const std::string_view prefix : {"j", "set", "cmov"}) {
    if (!m.starts_with(prefix)) continue;
    if (const auto read = read_by_condition(m.substr(prefix.size()))) return *read;
  }
  return 0;
}

bool shifts_by_one(const Line& line) {
  return line.text.ends_with(",1") || line.text.ends_with(",0x1");
}

}  // namespace

FlagEffects flag_effects(const Line& line) {
  const std::string m = mnemonic_of(line);
  FlagEffects effects{.reads = read_by(m)};
  const auto sets = [&](unsigned defined, unsigned undefined) {
    effects.defines = static_cast<std::uint16_t>(defined);
    effects.undefines = static_cast<std::uint16_t>(undefined);
  };
  if (is_one_of<9>(m, {"add", "adc", "sub", "sbb", "cmp", "neg", "cmpxchg", "xadd", "popf"}) ||
      m.starts_with("cmps") || m.starts_with("scas")) {
    sets(all_flags, 0);
  } else if (m == "inc" || m == "dec") {
    sets(all_flags & ~CF, 0);
  } else if (is_one_of<4>(m, {"and", "or", "xor", "test"})) {
    sets(all_flags & ~AF, AF);
  } else if (m == "mul" || m == "imul") {
    sets(CF | OF, of_result | AF);
  } else if (m == "div" || m == "idiv") {
    sets(0, all_flags);
  } else if (is_one_of<6>(m, {"shl", "sal", "shr", "sar", "shld", "shrd"})) {
    sets(CF | of_result | (shifts_by_one(line) ? OF : 0), AF | (shifts_by_one(line) ? 0 : OF));
  } else if (is_one_of<4>(m, {"rol", "ror", "rcl", "rcr"})) {
    sets(CF | (shifts_by_one(line) ? OF : 0), shifts_by_one(line) ? 0 : OF);
  } else if (m == "bsf" || m == "bsr") {
    sets(ZF, all_flags & ~ZF);
  } else if (is_one_of<4>(m, {"bt", "bts", "btr", "btc"})) {
    sets(CF, OF | SF | AF | PF);
  } else if (is_one_of<3>(m, {"clc", "stc", "cmc"})) {
    sets(CF, 0);
  } else if (m == "sahf") {
    sets(all_flags & ~OF, 0);
  } else if (m == "aam" || m == "aad") {
    sets(of_result, CF | AF | OF);
  } else if (m == "daa" || m == "das") {
    sets(all_flags & ~OF, OF);
  } else if (m == "aaa" || m == "aas") {
    sets(CF | AF, of_result | OF);
  }
  return effects;
}

}  // namespace fixproof::judge
