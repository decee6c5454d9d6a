/// @file
/// Which error of the number type a call of a function throws.
#pragma once

#include <string>

#include "fixed/error.hpp"
#include "tests/support/test.hpp"

enum class Thrown { nothing, domain_error, overflow_error };

/// Calls `call`, and checks that the text of an error contains `name`.
template <class Call>
Thrown thrown_by(const Call& call, const std::string& name = {}) {
  const auto is_named = [&](const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  };
  try {
    call();
    return Thrown::nothing;
  } catch (const fixproof::domain_error& error) {
    is_named(error);
    return Thrown::domain_error;
  } catch (const fixproof::overflow_error& error) {
    is_named(error);
    return Thrown::overflow_error;
  }
}
