#pragma once

/// WebViewer: the connection of one page: its socket and what was sent. Thread: web.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/net/websocket.h"
#include "playhouse/replicate/datagrams/token_bucket.h"
#include "playhouse/replicate/snapshot_feed.h"
#include "playhouse/replicate/viewer.h"
#include "playhouse/server/guests/guest_book.h"

namespace playhouse::web_server {

class WebViewer;

/// Callbacks of a viewer.
class WebViewerOwner {
 public:
  virtual ~WebViewerOwner() = default;
  /// The newest snapshot; valid until the owner's next turn.
  virtual const replicate::Snapshot& snapshot() const = 0;
  /// Executes a command that affects others (view and selection
  /// are handled by the viewer). An error is sent to the viewer.
  virtual Result<void> carry_out(const replicate::Command& command, WebViewer& from) = 0;
  virtual void refused(const WebViewer& from, const std::string& why) = 0;
  virtual void sent_frame(std::size_t bytes) = 0;
  virtual replicate::ChangesTexts& changes_texts() = 0;
  /// The keyframe list to send; null: none yet.
  virtual std::shared_ptr<const std::string> history() = 0;
  /// Requests another offer() after replicate::kFramePeriod, even of the same snapshot.
  virtual void waits() = 0;
  /// The connection has closed. May destroy the viewer.
  virtual void left(WebViewer& viewer, const std::string& why) = 0;
};

class WebViewer final : public net::WebSocketEvents {
 public:
  WebViewer(std::unique_ptr<net::WebSocket> socket, std::shared_ptr<const replicate::Layout> layout,
            WebViewerOwner& owner, std::uint32_t number, server::Guest guest, std::uint32_t bytes_per_second,
            const net::Network& network)
      : socket_(std::move(socket)),
        viewer_(std::move(layout)),
        owner_(owner),
        number_(number),
        guest_(std::move(guest)),
        network_(network),
        quiet_since_(network.now()),
        bucket_(bytes_per_second, replicate::kLeastPacket, quiet_since_) {}

  /// Sends the scene, which describes the layout, the list of viewers, and
  /// what was said before (null: nothing); starts reading.
  void start(std::shared_ptr<const std::string> scene, std::shared_ptr<const std::string> said);

  /// From the first call on it sends frames: one now, of the newest snapshot, or, under back-pressure, once the
  /// page has caught up, of the newest one then.
  void offer();

  /// Resets the rate limit of commands: the previous ones have been executed.
  void new_turn();

  /// Closes the connection with a reason.
  void close(std::string why) { socket_->close(std::move(why)); }

  /// Time of the page's last acknowledgement, or of the connection [s].
  double quiet_since() const { return quiet_since_; }

  /// A line of text for the user; dropped if many are queued.
  void notice(std::string_view text);

  /// Announces the viewer's own body; `walk` is JSON with its gait parameters.
  void joined(world::ModelId body, std::string_view walk);

  /// Acknowledges input number `input`: it applies to ticks after this one. Dropped if many texts are queued.
  void driven(std::uint32_t input, std::uint64_t tick);

  /// Sets the list of viewers (docs/viewer-protocol.md): the latest is sent with the next frame.
  void tell_people(std::string text) { people_ = std::make_shared<const std::string>(std::move(text)); }

  /// Reserves the slot for a large text. False: one is pending already.
  bool await_text() { return !std::exchange(awaits_text_, true); }
  void send_text(std::shared_ptr<const std::string> text);
  void expect_no_text() { awaits_text_ = false; }

  const replicate::Wish& wish() const { return viewer_.wish(); }
  const std::string& peer() const { return socket_->peer(); }
  std::uint32_t number() const { return number_; }  // never reused
  const server::Guest& guest() const { return guest_; }
  server::GuestRights rights() const { return server::rights_of(guest_.role); }

 private:
  /// A page that gets nothing for a second assumes that the program hangs; the present world is offered every
  /// 0.25 s at least (run/simulation.cc).
  static constexpr double kSignOfLife = 0.75;  // s

  void received(std::string_view text) override;
  void drained() override;
  void closed(const std::string& why) override { owner_.left(*this, why); }

  void reject(const std::string& why);
  Result<void> execute(const replicate::Command& command);
  void send_frame();

  std::unique_ptr<net::WebSocket> socket_;
  replicate::Viewer viewer_;
  WebViewerOwner& owner_;
  const std::uint32_t number_;
  const server::Guest guest_;
  const net::Network& network_;    // its clock
  double quiet_since_;             // s
  replicate::TokenBucket bucket_;  // for packets and population updates
  bool was_offered_ = false;
  std::shared_ptr<const std::string> told_history_;
  std::shared_ptr<const std::string> people_, told_people_;
  bool awaits_text_ = false, text_is_under_way_ = false;
  // Owned by the socket while a frame is being sent, otherwise by us, and reused.
  std::shared_ptr<std::vector<std::byte>> frame_ = std::make_shared<std::vector<std::byte>>();
  double frame_time_ = -kSignOfLife;  // s
  std::size_t commands_ = 0;          // since new_turn()
  std::size_t faults_ = 0;
};

}  // namespace playhouse::web_server
