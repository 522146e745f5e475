#include "playhouse/replicate/viewer.h"

namespace playhouse::replicate {

std::shared_ptr<const std::string> ChangesTexts::text(const std::shared_ptr<const Layout>& from,
                                                      const std::shared_ptr<const Layout>& to) {
  if (from != from_ || to != to_) {
    from_ = from;
    to_ = to;
    std::string text = changes_text(*from, *to, devices_);
    text_ = text.empty() ? nullptr : std::make_shared<const std::string>(std::move(text));
  }
  return text_;
}

void Viewer::look(const Look& look) {
  wish_.view = view_of(look);
  wish_.sensors = look.sensors;
}

void Viewer::select(const Select& select) {
  const Layout& layout = *replica_.layout;
  const world::ModelRow row = select.model ? layout.row(*select.model) : world::ModelRow{};
  wish_.selected = row ? std::optional(layout.id[layout.root[row]]) : std::nullopt;
}

Result<void> Viewer::acknowledge(std::uint32_t frame) {
  if (frame > sent_) return Error{"", "a frame was acknowledged before it was sent"};
  acknowledged_ = std::max(acknowledged_, frame);
  return {};
}

NextFrame Viewer::next_frame(const Snapshot& snapshot, Emit emit, ChangesTexts& texts,
                             std::vector<std::byte>& out, std::size_t budget) {
  NextFrame next;
  if (!ready()) return next;
  if (replica_.layout != snapshot.layout) {
    next.changes = texts.text(replica_.layout, snapshot.layout);
    replica_.follow(snapshot.layout);
    if (wish_.selected && !snapshot.layout->row(*wish_.selected)) wish_.selected.reset();
    emit = Emit::kAlways;  // so that the population change is acknowledged with it
  }
  const Sent sent = writer_.write(snapshot, wish_, sent_ + 1, budget, replica_, out);
  waiting_ = sent == Sent::kPart;
  next.packet = sent != Sent::kNothing || emit == Emit::kAlways;
  if (next.packet) ++sent_;
  return next;
}

}  // namespace playhouse::replicate
