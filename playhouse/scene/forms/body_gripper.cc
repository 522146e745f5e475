/// The body of a gripper: a base, and two paddles in their initial position.

#include "playhouse/scene/forms/gripper_body.h"
#include "playhouse/scene/generated/bodies.h"

namespace playhouse::scene {

void make_gripper_body(const geom::Size& size, ModelDesc& model) {
  const GripperDesc& gripper = *model.gripper;
  const double x = size.x / 2, y = size.y / 2, root = (0.5 - gripper.paddle_length) * size.x;
  if (root > -x) model.blocks.push_back(rectangle(-x, -y, root, y, {0, size.z}));
  if (gripper.paddle_length == 0 || gripper.paddle_width == 0 || gripper.paddle_height == 0) return;
  const double inside = paddle_face(gripper, size, gripper.paddles == Paddles::kClosed ? 1 : 0);
  const double outside = inside + std::min(0.5, gripper.paddle_width) * size.y;
  const double bottom = gripper.lift == Lift::kUp ? (1 - gripper.paddle_height) * size.z : 0;
  const Interval z{bottom, bottom + gripper.paddle_height * size.z};
  model.blocks.push_back(rectangle(root, inside, x, outside, z));
  model.blocks.push_back(rectangle(root, -outside, x, -inside, z));
  model.moving_blocks = 2;
}

}  // namespace playhouse::scene
