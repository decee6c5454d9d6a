// libfixmath, as Debian ships it.
#include <libfixmath/fix16.h>

#include "verify/measure/subjects.hpp"

namespace fixproof {

namespace {

constexpr const char* library = "libfixmath";

fix16_t fix16(CaseWords in, std::size_t i) { return static_cast<fix16_t>(in[i]); }

std::optional<std::uint32_t> word_of_fix16(fix16_t x) { return static_cast<std::uint32_t>(x); }

}  // namespace

std::optional<Subject> libfixmath_subject(const std::string& operation) {
  if (operation == "mul") {
    return Subject{library, "", [](CaseWords in) {
                     return word_of_fix16(fix16_mul(fix16(in, 0), fix16(in, 1)));
                   }};
  }
  if (operation == "div") {
    return Subject{library, "", [](CaseWords in) {
                     return word_of_fix16(fix16_div(fix16(in, 0), fix16(in, 1)));
                   }};
  }
  if (operation == "sqrt") {
    return Subject{library, "",
                   [](CaseWords in) { return word_of_fix16(fix16_sqrt(fix16(in, 0))); }};
  }
  if (operation == "sin of radians") {
    return Subject{library, "",
                   [](CaseWords in) { return word_of_fix16(fix16_sin(fix16(in, 0))); }};
  }
  return std::nullopt;
}

bool has_libfixmath() { return true; }

}  // namespace fixproof
