#include "judge/code/register_name.hpp"

#include <fmt/format.h>

#include "x86model/text.hpp"

namespace fixproof::judge {

using x86model::Register;
using x86model::Size;

std::string name_of(const RegisterName& name) {
  if (name.is_legacy()) return std::string(x86model::name_of(name.number, name.size));
  const std::size_t number = name.holder();
  if (number >= x86model::register_count) {
    const char* const part = name.size == Size::byte    ? "b"
                             : name.size == Size::word  ? "w"
                             : name.size == Size::dword ? "d"
                                                        : "";
    return fmt::format("r{}{}", number, part);
  }
  const std::string_view word = x86model::name_of(static_cast<Register>(number), Size::word);
  return name.size == Size::byte ? fmt::format("{}l", word) : fmt::format("r{}", word);
}

std::optional<RegisterName> register_named(std::string_view text) {
  const auto found = [&](unsigned number, Size size) -> std::optional<RegisterName> {
    const RegisterName name{static_cast<Register>(number), size};
    return name_of(name) == text ? std::optional(name) : std::nullopt;
  };
  for (unsigned number = 0; number < register_count; ++number) {
    for (const Size size : {Size::byte, Size::word, Size::dword, Size::qword}) {
      if (const auto name = found(number, size)) return name;
    }
  }
  for (unsigned number = RegisterName::low_bytes + 4; number < RegisterName::low_bytes + 8;
       ++number) {
    if (const auto name = found(number, Size::byte)) return name;
  }
  return std::nullopt;
}

}  // namespace fixproof::judge
