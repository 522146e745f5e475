#pragma once

/// WebViewer: one page's socket and what it was sent. Thread: web.

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/net/websocket.h"
#include "playhouse/replicate/snapshot_feed.h"
#include "playhouse/replicate/viewer.h"
#include "playhouse/web_server/guests.h"

namespace playhouse::web_server {

class WebViewer;

/// Who hears of a viewer's commands and its end.
class WebViewerOwner {
 public:
  virtual ~WebViewerOwner() = default;
  /// Carries out a command for everyone (the viewer's own view and selection are set already). An error is
  /// told to the viewer.
  virtual Result<void> carry_out(const replicate::Command& command, WebViewer& from) = 0;
  virtual void refused(const WebViewer& from, const std::string& why) = 0;
  virtual void sent_frame(std::size_t bytes) = 0;
  virtual replicate::ChangesTexts& changes_texts() = 0;
  /// What to tell of the instants to go back to; none: nothing yet.
  virtual std::shared_ptr<const std::string> history() = 0;
  /// Wants to be offered the newest snapshot again after replicate::kFramePeriod, also if it is the same one.
  virtual void waits() = 0;
  /// May destroy the viewer.
  virtual void left(WebViewer& viewer, const std::string& why) = 0;
};

class WebViewer final : public net::WebSocketEvents {
 public:
  WebViewer(std::unique_ptr<net::WebSocket> socket, std::shared_ptr<const replicate::Layout> layout,
            WebViewerOwner& owner, std::uint32_t number, Guest guest)
      : socket_(std::move(socket)),
        viewer_(std::move(layout)),
        owner_(owner),
        number_(number),
        guest_(std::move(guest)) {}

  /// Sends the scene, which tells of the layout, and who watches, and begins to listen.
  void start(std::shared_ptr<const std::string> scene);

  /// The newest snapshot, valid until the next call. A frame goes out now if the page keeps up, else as soon
  /// as it has caught up, from what is newest then.
  void offer(const replicate::Snapshot& snapshot);

  /// The world has had time for what was asked of it: the page may ask for more.
  void new_turn();

  /// Tells the page why, and closes.
  void close(std::string why) { socket_->close(std::move(why)); }

  /// When the page last took a picture in, or came.
  std::chrono::steady_clock::time_point quiet_since() const { return quiet_since_; }

  /// A line for the person at the page; dropped when many wait already.
  void notice(std::string_view text);

  /// This model is the viewer's own now; `walk` is JSON text of how it walks.
  void joined(world::ModelId body, std::string_view walk);

  /// The viewer's command of this number counts in the ticks after this one. Dropped when many texts wait.
  void driven(std::uint32_t input, std::uint64_t tick);

  /// Who watches, as a text of docs/viewer-protocol.md: the newest goes out with the next frame.
  void tell_people(std::string text) { people_ = std::make_shared<const std::string>(std::move(text)); }

  /// A large text is to come for this viewer. False: one is on its way already.
  bool await_text() { return !std::exchange(awaits_text_, true); }
  void send_text(std::shared_ptr<const std::string> text);
  void expect_no_text() { awaits_text_ = false; }

  const replicate::Wish& wish() const { return viewer_.wish(); }
  const std::string& peer() const { return socket_->peer(); }
  std::uint32_t number() const { return number_; }  // never another viewer's
  const Guest& guest() const { return guest_; }
  Rights rights() const { return rights_of(guest_.role); }

 private:
  void received(std::string_view text) override;
  void drained() override;
  void closed(const std::string& why) override { owner_.left(*this, why); }

  Result<void> execute(const replicate::Command& command);
  void send_frame();

  std::unique_ptr<net::WebSocket> socket_;
  replicate::Viewer viewer_;
  WebViewerOwner& owner_;
  const std::uint32_t number_;
  const Guest guest_;
  const replicate::Snapshot* newest_ = nullptr;
  std::shared_ptr<const std::string> told_history_;
  std::shared_ptr<const std::string> people_, told_people_;
  bool awaits_text_ = false, text_is_under_way_ = false;
  // With the socket while a frame is under way, else ours alone and reused.
  std::shared_ptr<std::vector<std::byte>> frame_ = std::make_shared<std::vector<std::byte>>();
  std::chrono::steady_clock::time_point frame_time_;
  std::chrono::steady_clock::time_point quiet_since_ = std::chrono::steady_clock::now();
  std::size_t commands_ = 0;  // of this turn
  std::size_t faults_ = 0;
};

}  // namespace playhouse::web_server
