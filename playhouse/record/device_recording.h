#pragma once

/// Recordings of devices without a world (device_recorder.h), as those who read recordings of runs meet them.

#include <algorithm>
#include <string>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap/mcap_reader.h"

namespace playhouse::record {

inline constexpr const char* kDeviceSchemaEncoding = "jsonschema";
inline constexpr const char* kDeviceMessageEncoding = "json";

/// True if one of the channels read so far is of such a recording: data, in JSON by the names of the definitions.
inline bool is_of_devices(const McapReader& reader) {
  return std::ranges::any_of(reader.channels(), [&](const auto& channel) {
    const auto schema = reader.schemas().find(channel.second.schema);
    return channel.second.encoding == kDeviceMessageEncoding && schema != reader.schemas().end() &&
           schema->second.encoding == kDeviceSchemaEncoding &&
           schema->second.name.find(".data.") != std::string::npos;
  });
}

/// `what` it does not have: "no changes". Without a file name.
inline Error only_of_devices(const std::string& what) {
  return {{},
          "is a recording of devices, without a world: it has " + what +
              ", and Foxglove and other readers of MCAP show it (docs/recording.md)"};
}

}  // namespace playhouse::record
