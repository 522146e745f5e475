#pragma once

/// CSV export of a recording: a file of comma-separated values for each
/// channel, with a header row. Source: RFC 4180, except that lines end in LF.

#include <string>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap/mcap_reader.h"

namespace playhouse::record {

/// Limit on the fields of all tables together, with one more for every 64 letters of their names.
inline constexpr std::size_t kExportFields = 1u << 22;

/// Result of an export.
struct CsvTables {
  std::size_t tables = 0;
  std::uint64_t rows = 0;
  std::vector<std::string> left_out;  // channels that were skipped, with reasons
  bool cut = false;                   // the recording is truncated
};

/// Writes a table for each channel into a folder, which is created. Column `time` is the
/// simulated time of the message [s]; a list gets as many columns as its longest value
/// has elements. Channels beyond `most_fields` in all tables are left out. Internal channels (states,
/// changes) are skipped. Fails if the recording cannot be read, without a file name, or if a table cannot be
/// written, with its name.
Result<CsvTables> write_csv(const ByteSource& source, const std::string& folder,
                            std::size_t most_fields = kExportFields);

}  // namespace playhouse::record
