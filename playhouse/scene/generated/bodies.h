// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Bodies specific to kinds, each built by playhouse/scene/forms/body_NAME.cc.

#include "playhouse/scene/forms/body.h"

namespace playhouse::scene {

void make_gripper_body(const geom::Size& size, ModelDesc& model);

/// Gives a model the body of its kind, which fills `size`.
inline void make_body(const geom::Size& size, ModelDesc& model) {
  switch (model.kind) {
    case ModelKind::kGripper:
      return make_gripper_body(size, model);
    default:
      model.blocks.push_back(box_block(size));
  }
}

}  // namespace playhouse::scene
