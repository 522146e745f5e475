// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

#include "playhouse/scene/scene_desc.h"

namespace playhouse::behaviour {

/// Power consumption of a subscribed model, without motion: that of its kind, else of its words. [W]
inline double draw_of(const scene::ModelDesc& model) {
  switch (model.kind) {
    case scene::ModelKind::kPosition:
      return 1;
    case scene::ModelKind::kRanger:
      return 0.2 * static_cast<double>(model.sensors.size());
    case scene::ModelKind::kBlobfinder:
      return 2;
    case scene::ModelKind::kBumper:
      return 0.1;
    case scene::ModelKind::kActuator:
      return 2;
    case scene::ModelKind::kWifi:
      return 1;
    case scene::ModelKind::kDetector:
      return 1;
    default:
      return model.watts;
  }
}

}  // namespace playhouse::behaviour
