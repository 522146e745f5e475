#pragma once

/// DatagramViewer: the program's end of one observer, without its socket: what the observer has acknowledged,
/// model by model, and what goes to it next within its budget. Texts (the scene, who comes and goes, what is
/// said) arrive once and in order; of states the newest wins, and a lost one is sent again only as what it is
/// by then. Thread: one, that serves observers. Cost of a frame: O(models), and O(n log n) of those that
/// changed.

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/replicate/datagram_channel.h"
#include "playhouse/replicate/delta.h"
#include "playhouse/replicate/viewer.h"

namespace playhouse::replicate {

class DatagramViewer {
 public:
  using Send = std::function<void(std::span<const std::byte>)>;

  /// It is told the scene first, which is of this layout.
  DatagramViewer(std::uint64_t session, Terms terms, std::shared_ptr<const Layout> layout,
                 std::shared_ptr<const PackedText> scene, double now);

  /// A packet of its session. Fails for what no observer sends: it is sent away.
  Result<void> receive(std::span<const std::byte> rest, double now);

  /// Sends what is due and what the budget has room for, of the newest snapshot. Call about every 33 ms.
  void offer(const Snapshot& snapshot, ChangesTexts& changes, double now, const Send& send);

  /// A line for who observes.
  void notice(std::string_view text);

  const Wish& wish() const { return wish_; }
  bool is_gone(double now) const { return now - heard_ >= limits::kObserverQuietSeconds; }
  std::uint64_t session() const { return channel_.session(); }

  /// For tests: nothing waits and everything has been acknowledged.
  bool holds(const Snapshot& snapshot) const;

 private:
  /// What one model was, is and will be to the observer. States before `acknowledged` are of no use any more.
  struct Row {
    ModelState start, acknowledged, sent;
    Seq acknowledged_seq = 0;  // 0: none, the observer has `start`
    Seq sent_seq = 0;
    Seq floor = 0;              // packets up to here told of another model with this id
    std::uint64_t told_at = 0;  // bytes of the stream after which the observer knows it
    double sent_time = -std::numeric_limits<double>::infinity();
    double gathered = 0;   // of importance
    bool is_lost = false;  // `sent` may not have come
  };
  struct SentRow {
    world::ModelId id;
    ModelState state;
  };
  struct Candidate {
    double gathered = 0;
    std::uint32_t row = 0;  // of told_
  };
  struct Written {
    std::uint8_t age = 0, mask = 0;
    std::uint32_t id = 0;
    std::uint32_t begin = 0, end = 0;  // of fields_
  };

  Result<void> obey(const std::string& command);
  void refill(double now);
  void settle(double now);
  void map_rows(const Snapshot& snapshot);
  void follow(const Snapshot& snapshot, ChangesTexts& changes);
  void say(const Snapshot& snapshot);
  void weigh(const Snapshot& snapshot, double now);
  bool send_packet(const Snapshot& snapshot, double now, bool must, const Send& send);
  void write_rows(const Snapshot& snapshot, double now, Seq seq, std::size_t room);
  bool is_whole(const Snapshot& snapshot, Seq seq);
  bool add_row(const Snapshot& snapshot, Seq seq, std::uint32_t row, std::size_t& room);
  void pack_rows();
  void post(std::string_view text) { channel_.post(pack_text(text)); }

  DatagramChannel channel_;
  const Terms terms_;
  Wish wish_;
  std::shared_ptr<const Layout> told_;  // the population that the observer was told of
  std::vector<Row> rows_;               // of told_
  std::shared_ptr<const Layout> mapped_;
  std::vector<std::uint32_t> now_row_;             // of told_'s rows in the layout mapped_; kNone: it is gone
  std::map<Seq, std::vector<SentRow>> sent_rows_;  // by seq
  std::map<world::ModelId, std::string> said_;
  std::optional<std::uint64_t> said_number_;  // Snapshot::said of which it has all texts

  double heard_, filled_, frame_due_ = 0, life_due_ = 0, quiet_due_ = 0;
  double allowance_ = 0;  // B that may go now
  bool owes_ack_ = false, told_paused_ = false, told_whole_ = false;
  bool was_whole_ = false;  // see is_whole(); it stays so: who comes later is told as they are then
  std::size_t faults_ = 0;
  std::vector<Candidate> candidates_;  // of this frame, the first in order
  std::size_t next_candidate_ = 0;
  // Scratch of one packet.
  std::vector<std::byte> packet_, fields_;
  std::vector<Written> written_;
};

}  // namespace playhouse::replicate
