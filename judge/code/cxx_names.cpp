#include "judge/code/cxx_names.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "judge/code/confined.hpp"

namespace fixproof::judge {

namespace {

constexpr std::size_t longest_name = 1000;
constexpr std::size_t memory_for_names = std::size_t{1} << 26U;
constexpr std::chrono::milliseconds time_for_names{2000};
/// The names of a file may have 4 MiB.
constexpr std::size_t longest_reply = std::size_t{1} << 25U;

std::vector<std::string> parts_at_nul(std::string_view text) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\0'), text.size() - 1);
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return parts;
}

std::string one_as_in_source(const std::string& name) {
  if (!name.starts_with("_Z") || name.size() > longest_name) return name;
  struct Free {
    // NOLINTNEXTLINE(*-no-malloc,*-owning-memory): the text is malloc()'s
    void operator()(char* text) const { std::free(text); }
  };
  int status = 0;
  const std::unique_ptr<char, Free> text(
      abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status));
  if (status != 0 || !text) return name;
  const std::string_view known(text.get());
  return known.size() > longest_name ? name : std::string(known);
}

std::string serve_names(std::string_view request) {
  std::string reply;
  for (const std::string& name : parts_at_nul(request)) reply += one_as_in_source(name) + '\0';
  return reply;
}

std::string without_spaces(std::string_view text) {
  std::string kept(text);
  std::erase(kept, ' ');
  return kept;
}

/// Returns where a list that ends the text begins, or the length of the text if none does.
std::size_t list_at_end(std::string_view text, char open, char close) {
  if (!text.ends_with(close)) return text.size();
  int depth = 0;
  for (std::size_t i = text.size(); i-- > 0;) {
    if (text[i] == close) ++depth;
    if (text[i] == open && --depth == 0) return i;
  }
  return text.size();
}

/// Returns what follows the last space outside of all brackets: functions that are made from a
/// template have the type of the result before their name.
std::string_view without_result(std::string_view text) {
  int depth = 0;
  for (std::size_t i = text.size(); i-- > 0;) {
    if (text[i] == '>' || text[i] == ')') ++depth;
    if (text[i] == '<' || text[i] == '(') --depth;
    if (text[i] == ' ' && depth == 0) return text.substr(i + 1);
  }
  return text;
}

}  // namespace

std::vector<std::string> as_in_source(const std::vector<std::string>& names) {
  std::string request;
  for (const std::string& name : names) request += name + '\0';
  Confined child([](Confined::Steps&) { return serve_names; }, memory_for_names, Calls::fewest);
  const Reply reply = child.ask(
      request,
      {.step = time_for_names, .whole = time_for_names, .steps = 0, .bytes = longest_reply});
  std::vector<std::string> known = parts_at_nul(reply.bytes);
  return known.size() == names.size() ? known : names;
}

bool is_meant(std::string_view wanted, std::string_view in_source) {
  std::string text(in_source);
  // Functions in an unnamed namespace: in the source, their names do not have this part.
  constexpr std::string_view unnamed = "(anonymous namespace)::";
  for (std::size_t at = 0; (at = text.find(unnamed)) != std::string::npos;) {
    text.erase(at, unnamed.size());
  }
  const std::string asked = without_spaces(wanted);
  const auto is_asked = [&asked](std::string_view name) { return without_spaces(name) == asked; };
  std::string_view name = text;
  if (is_asked(name)) return true;
  constexpr std::string_view of_constant = " const";
  if (name.ends_with(of_constant)) name.remove_suffix(of_constant.size());
  const std::string_view bare = name.substr(0, list_at_end(name, '(', ')'));
  const std::string_view plain = without_result(bare);
  const auto result_bytes = static_cast<std::size_t>(plain.data() - name.data());
  return is_asked(bare) || is_asked(plain) || is_asked(name.substr(result_bytes)) ||
         is_asked(plain.substr(0, list_at_end(plain, '<', '>')));
}

}  // namespace fixproof::judge
