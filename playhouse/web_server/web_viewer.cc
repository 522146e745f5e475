#include "playhouse/web_server/web_viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/json/serialize.hpp>
#include <boost/json/string.hpp>

#include "playhouse/base/limits.h"

namespace playhouse::web_server {

void WebViewer::start(std::shared_ptr<const std::string> scene, std::shared_ptr<const std::string> said) {
  socket_->start(*this);
  socket_->send_text(std::move(scene));
  if (people_) socket_->send_text(told_people_ = people_);
  if (said) socket_->send_text(std::move(said));
}

void WebViewer::offer() {
  was_offered_ = true;
  send_frame();
}

void WebViewer::new_turn() {
  commands_ = 0;
  socket_->resume();
}

void WebViewer::notice(std::string_view text) {
  if (socket_->messages_in_flight() >= limits::kViewerTextMessages) return;
  const std::string quoted = boost::json::serialize(boost::json::string(text));
  socket_->send_text(std::make_shared<const std::string>(fmt::format("{{\"notice\":{}}}", quoted)));
}

void WebViewer::joined(world::ModelId body, std::string_view walk) {
  socket_->send_text(
      std::make_shared<const std::string>(fmt::format(R"({{"joined":{},"walk":{}}})", body.value, walk)));
}

void WebViewer::driven(std::uint32_t input, std::uint64_t tick) {
  if (socket_->messages_in_flight() >= limits::kViewerTextMessages) return;
  socket_->send_text(std::make_shared<const std::string>(
      fmt::format(R"({{"driven":{{"input":{},"tick":{}}}}})", input, tick)));
}

void WebViewer::send_text(std::shared_ptr<const std::string> text) {
  text_is_under_way_ = true;
  socket_->send_text(std::move(text));
}

void WebViewer::drained() {
  if (std::exchange(text_is_under_way_, false)) awaits_text_ = false;
  send_frame();
}

void WebViewer::received(std::string_view text) {
  // Back-pressure: excess commands stay in the socket; nothing is lost, and only the sender is delayed.
  if (++commands_ >= limits::kViewerCommandsPerTurn) socket_->pause();
  const Result<replicate::Command> command = replicate::parse_command(text);
  if (!command) return reject(command.error().text);
  if (const Result<void> done = execute(*command); !done) {
    owner_.refused(*this, done.error().text);
    notice(done.error().text);
  }
}

/// What no page of ours sends. A command that cannot be carried out now is none of these: whoever tries things
/// for an hour is not sent away.
void WebViewer::reject(const std::string& why) {
  owner_.refused(*this, why);
  if (++faults_ < limits::kViewerFaults) return notice(why);
  socket_->close("too many invalid commands: " + why);
  owner_.left(*this, "too many invalid commands");
}

Result<void> WebViewer::execute(const replicate::Command& command) {
  if (const auto* acknowledge = std::get_if<replicate::Acknowledge>(&command)) {
    const Result<void> known = viewer_.acknowledge(acknowledge->frame);
    if (!known) return known;
    quiet_since_ = network_.now();
    send_frame();
    return {};
  }
  if (const auto* look = std::get_if<replicate::Look>(&command)) viewer_.look(*look);
  if (const auto* select = std::get_if<replicate::Select>(&command)) viewer_.select(*select);
  return owner_.carry_out(command, *this);
}

void WebViewer::send_frame() {
  if (!was_offered_ || socket_->messages_in_flight() > 0 || !viewer_.ready()) return;
  const double now = network_.now();
  // Rows deferred to the next frame must not advance it.
  if (now - frame_time_ < replicate::kFramePeriod * 3 / 4) return owner_.waits();
  bucket_.refill(now);
  const bool is_due = now - frame_time_ >= kSignOfLife;
  if (bucket_.left() < replicate::kLeastPacket && !is_due) return owner_.waits();
  const auto budget =
      static_cast<std::size_t>(std::clamp<double>(bucket_.left(), 0, limits::kViewerFrameBytes));
  const auto emit = is_due ? replicate::Emit::kAlways : replicate::Emit::kIfChanged;
  const replicate::NextFrame next =
      viewer_.next_frame(owner_.snapshot(), emit, owner_.changes_texts(), *frame_, budget);
  if (!next.packet) return;
  frame_time_ = now;
  bucket_.spend(static_cast<double>(frame_->size() + (next.changes ? next.changes->size() : 0)));
  if (const auto history = owner_.history(); history != told_history_)
    socket_->send_text(told_history_ = history);
  if (people_ != told_people_) socket_->send_text(told_people_ = people_);
  if (next.changes) socket_->send_text(next.changes);
  owner_.sent_frame(frame_->size());
  socket_->send_binary(frame_);
  if (viewer_.waiting()) owner_.waits();
}

}  // namespace playhouse::web_server
