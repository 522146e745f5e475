#pragma once

/// DatagramViewer: the server's end of one observer, without its socket: acknowledged
/// baselines, model by model, and what to send next within its byte budget. Texts (the
/// scene, population changes, speech) are reliable and in order; of states the latest
/// wins: a lost state is not resent, the current one is sent instead. Thread: the one
/// that serves observers. Cost of a frame: O(models), plus O(n log n) for n changed ones.

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/replicate/datagrams/datagram_channel.h"
#include "playhouse/replicate/datagrams/token_bucket.h"
#include "playhouse/replicate/delta.h"
#include "playhouse/replicate/viewer.h"

namespace playhouse::replicate {

class DatagramViewer {
 public:
  using Send = std::function<void(std::span<const std::byte>)>;

  /// Begins with the scene, which describes this layout.
  DatagramViewer(std::uint64_t session, Terms terms, std::shared_ptr<const Layout> layout,
                 std::shared_ptr<const PackedText> scene, double now);

  /// Processes a packet of its session. Fails on a protocol violation: the observer is to be dropped.
  Result<void> receive(std::span<const std::byte> rest, double now);

  /// Sends what is due of the newest snapshot, within the budget. Call about every 33 ms.
  void offer(const Snapshot& snapshot, ChangesTexts& changes, double now, const Send& send);

  /// Queues a line of text for the observer's user.
  void notice(std::string_view text);

  const Wish& wish() const { return wish_; }
  bool is_gone(double now) const { return now - heard_ >= limits::kObserverQuietSeconds; }
  std::uint64_t session() const { return channel_.session(); }

  /// For tests: nothing is pending and everything has been acknowledged.
  bool holds(const Snapshot& snapshot) const;

 private:
  /// Replication state of one model. States older than `acknowledged` are obsolete.
  struct ReplicatedModel {
    ModelState start, acknowledged, sent;
    Seq acknowledged_seq = 0;  // 0: none, the baseline is `start`
    Seq sent_seq = 0;
    Seq floor = 0;              // packets up to here are of another model with this id
    std::uint64_t told_at = 0;  // stream offset from which on the observer knows it
    double sent_time = -std::numeric_limits<double>::infinity();
    double gathered = 0;   // priority accumulator
    bool is_lost = false;  // the packet with `sent` may be lost
  };
  struct SentRow {
    world::ModelId id;
    ModelState state;
  };
  struct SendCandidate {
    double gathered = 0;
    world::ModelRow row;  // of told_
  };
  struct Written {
    std::uint8_t age = 0, mask = 0;
    std::uint32_t id = 0;
    std::uint32_t begin = 0, end = 0;  // of fields_
  };

  Result<void> execute(const std::string& command);
  void settle(double now);
  void map_rows(const Snapshot& snapshot);
  void follow(const Snapshot& snapshot, ChangesTexts& changes);
  void say(const Snapshot& snapshot);
  void prioritise(const Snapshot& snapshot, double now);
  bool send_packet(const Snapshot& snapshot, double now, bool must, const Send& send);
  void write_rows(const Snapshot& snapshot, double now, Seq seq, std::size_t room);
  bool is_whole(const Snapshot& snapshot, Seq seq);
  bool add_row(const Snapshot& snapshot, Seq seq, world::ModelRow row, std::size_t& room);
  void pack_rows();
  void post(std::string_view text) { channel_.post(pack_text(text)); }

  DatagramChannel channel_;
  const Terms terms_;
  Wish wish_;
  std::shared_ptr<const Layout> told_;    // the population announced to the observer
  world::ByModel<ReplicatedModel> rows_;  // of told_
  std::shared_ptr<const Layout> mapped_;
  world::ByModel<world::ModelRow> now_row_;        // rows of told_ in the layout mapped_; none: removed
  std::map<Seq, std::vector<SentRow>> sent_rows_;  // by seq
  std::map<world::ModelId, std::string> said_;
  std::optional<std::uint64_t> said_number_;  // Snapshot::said up to which all texts were sent

  TokenBucket bucket_;
  double heard_, frame_due_ = 0, life_due_ = 0, quiet_due_ = 0;
  bool owes_ack_ = false, told_paused_ = false, told_whole_ = false;
  bool was_whole_ = false;           // see is_whole(); never reset
  std::uint64_t first_told_at_ = 0;  // stream offset from which on the observer knows the scene
  std::size_t faults_ = 0;
  std::vector<SendCandidate> candidates_;  // of this frame, by priority
  std::size_t next_candidate_ = 0;
  // Scratch buffers of one packet.
  std::vector<std::byte> packet_, fields_;
  std::vector<Written> written_;
};

}  // namespace playhouse::replicate
