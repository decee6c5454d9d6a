#include "app/cli/json/result_file.hpp"

#include <fmt/format.h>

#include "app/cli/arguments.hpp"
#include "support/build_info/build_info.hpp"
#include "support/file.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

std::string_view word_of_status(int status) {
  if (status == support::interrupted_status) return "stopped";
  return status == 0 ? "ok" : status == 1 ? "wrong" : "undecided";
}

/// Returns `prove type` for the subcommand `type` of `prove`.
std::string words_of(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  const bool is_first = parent == nullptr || parent->get_parent() == nullptr;
  return (is_first ? "" : words_of(*parent) + " ") + command.get_name();
}

}  // namespace

Json result_json(std::string_view command, int status, const Json& members) {
  Json json;
  json["fixproof"] = support::program_version();
  json["command"] = command;
  json["status"] = word_of_status(status);
  json.update(members);
  return json;
}

void ResultFile::add_to(CLI::App& command) {
  command_ = words_of(command);
  command
      .add_option("--json", path_,
                  "also write the result to this file as JSON (docs/json.md); with - to standard "
                  "output, and the text to standard error")
      ->transform(output_file());
}

std::string ResultFile::loss_text() const {
  return is_wanted() ? fmt::format("; {} is not written", support::printable(path_)) : "";
}

void ResultFile::open(const std::vector<std::string>& others, std::string_view whose) {
  if (!is_wanted()) return;
  for (const std::string& other : others) {
    if (other.empty() || !support::same_file(path_, other)) continue;
    throw support::UsageError(
        fmt::format("--json {}: this is a file of {}; name another", path_, whose));
  }
  file_ = std::make_unique<support::OutputFile>(path_);
}

int ResultFile::write(int status, const std::function<Json()>& members) {
  if (file_) file_->replace(support::json_text(result_json(command_, status, members())));
  return status;
}

}  // namespace fixproof::cli
