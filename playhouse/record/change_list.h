#pragma once

/// The changes of a recording as a list for people and programs.

#include <cstdint>
#include <functional>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap/mcap_reader.h"

namespace playhouse::record {

struct ChangeCount {
  std::uint64_t changes = 0;
  bool cut = false;  // the recording is truncated
};

/// Writes lines of comma-separated values, the first with their names: simulated time [s], tick, change,
/// model, fields as JSON (docs/changes.md). In the order in which they were applied; after a
/// `load`, time is that of the state. Fails, without a file name, if the recording cannot be read or has
/// none.
Result<ChangeCount> list_changes(const ByteSource& source,
                                 const std::function<void(std::string_view)>& write);

}  // namespace playhouse::record
