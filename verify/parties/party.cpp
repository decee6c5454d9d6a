#include "verify/parties/party.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>

namespace fixproof::parties {

PartyFailure::PartyFailure(std::string_view party, std::string_view reason)
    : std::runtime_error(fmt::format("party '{}' failed: {}", party, reason)) {}

void Party::answer(const cases::Variant& variant, const Cases& asked) const {
  try {
    fill(variant, asked);
  } catch (const PartyFailure&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw PartyFailure(name(), "out of memory");
  } catch (const std::exception& error) {
    throw PartyFailure(name(), error.what());
  }
}

}  // namespace fixproof::parties
