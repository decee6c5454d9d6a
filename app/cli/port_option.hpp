/// @file
/// The option that names the rule of a program: `--rule doom`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "judge/check/ports.hpp"

namespace fixproof::cli {

/// Adds --rule, which excludes the options with these names.
void add_port_option(CLI::App& command, std::string& name,
                     std::initializer_list<const char*> excluded);

/// Returns the rules of a program for an operation.
/// @throws UsageError if it has none in this format, naming those that there are
check::Rules port_rules_named(const std::string& name, const cases::Variant& variant);

/// Returns the rules as a verdict names them: `the rule doom (FixedDiv)`.
std::string port_text(const check::PortRule& rule);

}  // namespace fixproof::cli
