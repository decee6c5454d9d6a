// The JSON format: an array of cases. Most of the text is what is not judged, such as the cycles.
// The scanner finds the ends of values by their brackets and quotation marks alone, and only judged
// members are parsed.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "support/plain_text.hpp"
#include "support/strict_json.hpp"
#include "support/usage_error.hpp"
#include "verify/singlestep/formats.hpp"

namespace fixproof::singlestep {

namespace {

using Json = nlohmann::json;
using x86model::Cpu;

/// The judged members of a case, in the order of `Members`.
constexpr std::array<std::string_view, 4> member_names{"\"name\"", "\"bytes\"", "\"initial\"",
                                                       "\"final\""};
using Members = std::array<std::string_view, member_names.size()>;

/// Finds values in JSON text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  [[noreturn]] void damaged(std::size_t at) const {
    throw support::UsageError(
        fmt::format("not JSON, or cut short, at byte {}, after {} cases", at + 1, cases_));
  }
  /// The next character that is not white space; 0 at the end.
  char peek() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  void expect(char wanted) {
    if (peek() != wanted) damaged(at_);
    ++at_;
  }
  void expect_end() {
    peek();
    if (at_ != text_.size()) damaged(at_);
  }
  /// Passes `,` or the closing bracket. @return whether it was `,`
  bool another(char closing) {
    if (peek() == closing) {
      ++at_;
      return false;
    }
    expect(',');
    return true;
  }

  std::string_view value() {
    const char first = peek();
    const std::size_t begin = at_;
    if (first == '"') {
      pass_string();
    } else if (first == '[' || first == '{') {
      pass_brackets();
    } else {
      at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
      if (at_ == begin || at_ == text_.size()) damaged(at_);
    }
    return text_.substr(begin, at_ - begin);
  }

  /// The judged members of the next case; empty where one is missing.
  Members one_case() {
    // The longest published case, a repeated string instruction, has less than 1 MiB.
    constexpr std::size_t max_size = std::size_t{4} << 20U;
    const std::size_t begin = at_;
    Members members;
    expect('{');
    if (peek() == '}') {
      ++at_;
      return members;
    }
    do {
      if (peek() != '"') damaged(at_);
      const std::string_view name = value();
      expect(':');
      const std::string_view text = value();
      for (std::size_t i = 0; i < members.size(); ++i) {
        if (name != member_names.at(i)) continue;
        if (!members.at(i).empty()) {
          throw support::UsageError(fmt::format("case {}: {} occurs twice", cases_, name));
        }
        members.at(i) = text;
      }
      if (at_ - begin > max_size) {
        throw support::UsageError(fmt::format("case {} is too long", cases_));
      }
    } while (another('}'));
    return members;
  }

  [[nodiscard]] Json parse(std::string_view part) const {
    try {
      return support::parse_strictly(part);
    } catch (const Json::parse_error& error) {
      damaged(static_cast<std::size_t>(part.data() - text_.data()) + error.byte - 1);
    } catch (const Json::out_of_range&) {
      throw support::UsageError("a number is too large for any field");
    } catch (const std::runtime_error& error) {
      throw support::UsageError(error.what());
    }
  }

  [[nodiscard]] std::size_t cases() const { return cases_; }
  void count_case() { ++cases_; }

 private:
  void pass_string() {
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        ++at_;
        return;
      }
      if (text_[at_] == '\\') ++at_;
    }
    damaged(text_.size());
  }

  void pass_brackets() {
    // The format has four levels below the outermost array.
    constexpr std::size_t max_depth = 16;
    std::string open;
    do {
      switch (text_[at_]) {
        case '"':
          pass_string();
          --at_;
          break;
        case '[':
        case '{':
          open += text_[at_] == '[' ? ']' : '}';
          if (open.size() > max_depth) {
            throw support::UsageError(fmt::format("case {} is nested too deeply", cases_));
          }
          break;
        case ']':
        case '}':
          if (text_[at_] != open.back()) damaged(at_);
          open.pop_back();
          break;
        default:
          break;
      }
      ++at_;
    } while (!open.empty() && at_ < text_.size());
    if (!open.empty()) damaged(at_);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t cases_ = 0;
};

void expect_type(const Json& value, Json::value_t type, std::string_view path) {
  if (value.type() == type) return;
  throw support::UsageError(
      fmt::format("{} is {} instead of {}", path, value.type_name(), Json(type).type_name()));
}

std::optional<std::uint32_t> number_in(const Json& value, std::uint32_t max) {
  const auto* found = value.get_ptr<const Json::number_unsigned_t*>();
  if (found == nullptr || *found > max) return std::nullopt;
  return static_cast<std::uint32_t>(*found);
}

[[noreturn]] void refuse_number(const std::string& path, std::uint32_t max) {
  throw support::UsageError(fmt::format("{} is not a number from 0 to {}", path, max));
}

std::optional<Place> place_named(std::string_view name, Cpu cpu) {
  for (std::size_t i = 0; i < place_count; ++i) {
    const auto place = static_cast<Place>(i);
    if (name_of(place, cpu) == name) return place;
  }
  return std::nullopt;
}

void read_registers(const Json& json, Cpu cpu, const std::string& path, State& state) {
  expect_type(json, Json::value_t::object, path);
  for (const auto& [name, value] : json.get_ref<const Json::object_t&>()) {
    const auto place = place_named(name, cpu);
    if (!place) {
      throw support::UsageError(fmt::format("{}: {} is not a register of the {}", path,
                                            support::quoted(name), name_of(cpu)));
    }
    const std::uint32_t max = largest(bits_of(*place, cpu));
    const auto number = number_in(value, max);
    if (!number) refuse_number(path + '.' + name, max);
    state.registers[static_cast<std::size_t>(*place)] = *number;
  }
}

void read_ram(const Json& json, Cpu cpu, const std::string& path, State& state) {
  expect_type(json, Json::value_t::array, path);
  const std::uint32_t last = largest(address_bits(cpu));
  for (std::size_t i = 0; i < json.size(); ++i) {
    const Json& entry = json[i];
    if (!entry.is_array() || entry.size() != 2) {
      throw support::UsageError(fmt::format("{}[{}] is not an address and a byte", path, i));
    }
    const auto address = number_in(entry[0], last);
    const auto byte = number_in(entry[1], 0xFF);
    if (!address) refuse_number(fmt::format("{}[{}][0]", path, i), last);
    if (!byte) refuse_number(fmt::format("{}[{}][1]", path, i), 0xFF);
    state.ram[*address] = static_cast<std::uint8_t>(*byte);
  }
}

const Json& member(const Json& object, const char* name, const std::string& path) {
  const auto found = object.find(name);
  if (found == object.end()) throw support::UsageError(fmt::format("{}.{} is missing", path, name));
  return *found;
}

/// `path` is "initial" or "final".
void read_state(const Json& json, Cpu cpu, const std::string& path, State& state) {
  expect_type(json, Json::value_t::object, path);
  read_registers(member(json, "regs", path), cpu, path + ".regs", state);
  read_ram(member(json, "ram", path), cpu, path + ".ram", state);
}

void read_bytes(const Json& json, std::vector<std::uint8_t>& bytes) {
  expect_type(json, Json::value_t::array, "bytes");
  for (std::size_t i = 0; i < json.size(); ++i) {
    const auto byte = number_in(json[i], 0xFF);
    if (!byte) refuse_number(fmt::format("bytes[{}]", i), 0xFF);
    bytes.push_back(static_cast<std::uint8_t>(*byte));
  }
}

Case case_in(const Members& members, Cpu cpu, const Scanner& scanner) {
  Case c;
  c.index = scanner.cases();
  const auto json_of = [&](std::size_t i) {
    if (!members.at(i).empty()) return scanner.parse(members.at(i));
    const auto name = member_names.at(i);
    throw support::UsageError(fmt::format("{} is missing", name.substr(1, name.size() - 2)));
  };
  try {
    const Json name = json_of(0);
    expect_type(name, Json::value_t::string, "name");
    c.name = name.get<std::string>();
    read_bytes(json_of(1), c.bytes);
    read_state(json_of(2), cpu, "initial", c.initial);
    read_state(json_of(3), cpu, "final", c.final);
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format("{}: {}", label_of(c), error.what()));
  }
  return c;
}

}  // namespace

void read_json(std::string_view text, Cpu cpu, const UseCase& use) {
  Scanner scanner(text);
  if (scanner.peek() != '[') {
    if (!Json::accept(text)) scanner.damaged(0);
    throw support::UsageError("not an array of cases");
  }
  scanner.expect('[');
  if (scanner.peek() == ']') throw support::UsageError("the array has no cases");
  do {
    if (scanner.peek() != '{') {
      static_cast<void>(scanner.parse(scanner.value()));
      throw support::UsageError(fmt::format("case {} is not an object", scanner.cases()));
    }
    Case c = case_in(scanner.one_case(), cpu, scanner);
    finish(c, cpu, use);
    scanner.count_case();
  } while (scanner.another(']'));
  scanner.expect_end();
}

}  // namespace fixproof::singlestep
