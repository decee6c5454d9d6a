/// @file
/// How a call of a function ends: with a value, or with which error of the number type.
#pragma once

#include <string>

#include "fixed/error.hpp"
#include "tests/support/test.hpp"

enum class Ending { value, domain_error, overflow_error };

/// Calls `call`, and checks that the text of an error contains `name`.
template <class Call>
Ending ending_of(const Call& call, const std::string& name = {}) {
  const auto is_named = [&](const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  };
  try {
    call();
    return Ending::value;
  } catch (const fixproof::domain_error& error) {
    is_named(error);
    return Ending::domain_error;
  } catch (const fixproof::overflow_error& error) {
    is_named(error);
    return Ending::overflow_error;
  }
}
