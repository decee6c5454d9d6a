#include "judge/check/port_trial.hpp"

namespace fixproof::check {

PortTrial::PortTrial(const cases::Variant& variant) : format_(variant.format) {
  for (const PortRule& rule : port_rules()) {
    if (rule.is_for(variant)) followed_.push_back(&rule);
  }
}

void PortTrial::add(const JudgedCase& one) {
  has_cases_ = true;
  std::erase_if(followed_, [&](const PortRule* rule) {
    return result_of(*rule, format_, one.operands()) != one.said;
  });
}

std::vector<const PortRule*> PortTrial::followed() const {
  return has_cases_ ? followed_ : std::vector<const PortRule*>();
}

}  // namespace fixproof::check
