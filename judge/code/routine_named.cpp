#include "judge/code/routine_named.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "judge/code/cxx_names.hpp"
#include "support/edits.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

constexpr std::size_t most_shown = 20;

/// A name in a list.
std::string shortened(const std::string& name) {
  constexpr std::size_t longest = 60;
  return support::printable(name.size() > longest ? name.substr(0, longest) + "..." : name);
}

std::vector<Symbol> all_symbols(const Image& image) {
  std::vector<Symbol> symbols = image.symbols;
  symbols.insert(symbols.end(), image.hidden.begin(), image.hidden.end());
  return symbols;
}

std::vector<std::string> sources_of(const std::vector<Symbol>& symbols) {
  std::vector<std::string> names;
  for (const Symbol& symbol : symbols) names.push_back(symbol.name);
  const auto is_cxx = [](const std::string& name) { return name.starts_with("_Z"); };
  return std::ranges::any_of(names, is_cxx) ? as_in_source(names) : names;
}

/// The names for a message, those of the compiler's library last.
std::string names_of(const std::vector<Symbol>& symbols) {
  std::vector<std::string> names = sources_of(symbols);
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return !name.starts_with("__"); });
  std::string all;
  for (std::size_t i = 0; i < std::min(names.size(), most_shown); ++i) {
    all += (all.empty() ? "" : ", ") + shortened(names[i]);
  }
  if (names.size() > most_shown) all += fmt::format(" and {} others", names.size() - most_shown);
  return all;
}

/// The functions of C++ that a name means, with their names as in the source. Two names of one
/// address, as constructors have them, are one function.
struct Meant {
  std::vector<Symbol> symbols{};
  std::vector<std::string> sources{};
};
Meant meant_by(const std::string& name, const std::vector<Symbol>& symbols) {
  const std::vector<std::string> sources = sources_of(symbols);
  Meant meant;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    if (!symbols[i].name.starts_with("_Z") || !is_meant(name, sources[i])) continue;
    const auto has_address = [&](const Symbol& s) { return s.offset == symbols[i].offset; };
    if (std::ranges::any_of(meant.symbols, has_address)) continue;
    meant.symbols.push_back(symbols[i]);
    meant.sources.push_back(sources[i]);
  }
  return meant;
}

[[noreturn]] void refuse_overloads(const std::string& name, const Meant& meant) {
  std::string all;
  for (std::size_t i = 0; i < std::min(meant.symbols.size(), most_shown); ++i) {
    all += fmt::format("{}{} for {}", all.empty() ? "" : ", ", shortened(meant.symbols[i].name),
                       shortened(meant.sources[i]));
  }
  if (meant.symbols.size() > most_shown) all += " and others";
  throw UsageError(fmt::format("--symbol {}: there are {} functions of that name; choose {}",
                               support::quoted(name), meant.symbols.size(), all));
}

[[noreturn]] void refuse_name(const Image& image, const std::string& name) {
  const bool is_flat = image.container == flat_container;
  if (image.symbols.empty() && image.hidden.empty()) {
    throw UsageError(fmt::format("--symbol {}: this {} has no symbols; use --at{}",
                                 support::quoted(name), image.container,
                                 is_flat ? ", or give the ELF file that it was made from" : ""));
  }
  const std::string all = names_of(all_symbols(image));
  if (name.empty()) {
    throw UsageError(
        fmt::format("name the routine as FILE:ROUTINE or with --symbol; choose one of {}", all));
  }
  const bool is_object = image.container == object_container;
  std::vector<std::string> names;
  for (const Symbol& symbol : all_symbols(image)) names.push_back(shortened(symbol.name));
  throw UsageError(fmt::format("--symbol {}: there is no such {}; choose one of {}{}",
                               support::quoted(name), is_object ? "global function" : "symbol", all,
                               support::suggestion(name, names)));
}

}  // namespace

void enter_symbol(Image& image, const std::string& name) {
  const auto named = std::ranges::find(image.symbols, name, &Symbol::name);
  if (named != image.symbols.end()) {
    image.entry = named->offset;
    return;
  }
  const auto count = std::ranges::count(image.hidden, name, &Symbol::name);
  if (count > 1) {
    throw UsageError(
        fmt::format("--symbol {}: there are {} static functions of that name; use --at",
                    support::quoted(name), count));
  }
  if (count == 1) {
    image.entry = std::ranges::find(image.hidden, name, &Symbol::name)->offset;
    return;
  }
  const Meant meant = name.empty() ? Meant{} : meant_by(name, all_symbols(image));
  if (meant.symbols.empty()) refuse_name(image, name);
  if (meant.symbols.size() > 1) refuse_overloads(name, meant);
  image.entry = meant.symbols.front().offset;
}

}  // namespace fixproof::judge
