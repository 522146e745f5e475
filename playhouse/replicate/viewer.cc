#include "playhouse/replicate/viewer.h"

namespace playhouse::replicate {

void Viewer::look(const Look& look) {
  wish_.view = look.view;
  wish_.sensors = look.sensors;
}

Result<void> Viewer::select(const Select& select) {
  if (select.model && *select.model >= layout_->root.size()) return Error{"", "no such model to select"};
  wish_.selected = select.model ? std::optional(layout_->root[*select.model]) : std::nullopt;
  return {};
}

Result<void> Viewer::acknowledge(std::uint32_t frame) {
  if (frame > sent_) return Error{"", "a frame was acknowledged before it was sent"};
  acknowledged_ = std::max(acknowledged_, frame);
  return {};
}

bool Viewer::next_frame(const Snapshot& snapshot, Emit emit, std::vector<std::byte>& out) {
  if (!ready()) return false;
  const Sent sent = writer_.write(snapshot, wish_, sent_ + 1, limits::kViewerFrameBytes, replica_, out);
  waiting_ = sent == Sent::kPart;
  if (sent == Sent::kNothing && emit == Emit::kIfChanged) return false;
  ++sent_;
  return true;
}

}  // namespace playhouse::replicate
