/// @file
/// The result of `fixproof desync` as JSON.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "judge/desync/compare.hpp"
#include "judge/desync/log_file.hpp"
#include "support/json.hpp"

namespace fixproof::cli {

/// A record as it is shown.
struct ShownRecord {
  desync::word operation = 0;
  std::string text;
  std::string input;  ///< the double that it converts, or empty
  std::string place;  ///< FILE:LINE of the source, or empty
  bool differs = false;
};

/// Returns the record that differs and those around it; nothing if the frame ends before it.
std::vector<ShownRecord> records_around(desync::LogFile& log, const desync::Side& side);

/// Returns the mark in force where a side differs, or an empty text.
std::string mark_of(desync::LogFile& log, const desync::Side& side);

/// Returns the value of FIXPROOF_RECORD_FULL with which both programs record the difference.
std::string range_to_record(const desync::Comparison& found, bool rollback);

/// @param explanation what the kind of difference means
support::Json desync_json(const desync::Comparison& found, desync::LogFile& a, desync::LogFile& b,
                          bool rollback, const std::string& explanation);

}  // namespace fixproof::cli
