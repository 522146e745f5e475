#pragma once

/// Tables of a recording: a file of comma-separated values for each channel, with a row of names first.
/// Source of the format: RFC 4180, with lines that end in a line feed.

#include <string>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap_reader.h"

namespace playhouse::record {

/// What was written.
struct CsvTables {
  std::size_t tables = 0;
  std::uint64_t rows = 0;
  std::vector<std::string> left_out;  // channels, each with the reason
  bool cut = false;                   // the recording was not finished
};

/// Writes a table for each channel into a folder, which is made. Column `time` is the simulated time of the
/// message [s]; a list has a column for each of as many elements as it ever has. What only Playhouse reads,
/// states and changes, has no table. Fails where the recording cannot be read, naming no file, and where a
/// table cannot be written, naming that.
Result<CsvTables> write_csv(const Source& source, const std::string& folder);

}  // namespace playhouse::record
