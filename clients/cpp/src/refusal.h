#pragma once

/// The string property "refusal" of devices to which goals are sent.

#include <string>

#include "playhouse_client/device.h"

namespace playhouse::client {

/// Why the driver does not drive to its last goal; empty if it does, or has no such property.
inline Result<std::string> refusal_of(Device& device) {
  const wire::StrpropReq question{wire::c_string("refusal"), wire::c_string("")};
  const auto told = device.ask<wire::StrpropReq>(wire::kReqGetStrprop, question);
  if (!told) return told.error();
  return *told ? std::string(wire::text((*told)->value)) : std::string();
}

}  // namespace playhouse::client
