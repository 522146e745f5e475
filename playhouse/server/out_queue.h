#pragma once

/// OutQueue: the send queue of one session, with the protocol's rules on what may be
/// sent when: PUSH and PULL, replace rules, priority of replies, the SYNCH at the end of
/// a round, notices of retired devices (docs/server.md). Bounded: over the limits old
/// data is dropped, fairly across kinds, and counted. No sockets, no clock; one thread.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <list>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "playhouse/net/network.h"
#include "playhouse/server/frame.h"
#include "playhouse/server/replace_rules.h"

namespace playhouse::server {

enum class DeliveryMode : std::uint8_t { kPush = 1, kPull = 2 };

class OutQueue {
 public:
  void set_mode(DeliveryMode mode) { mode_ = mode; }
  bool add_rule(const ReplaceRule& rule) { return rules_.add(rule); }

  /// Queues DATA or a reply, subject to the rules.
  void add(Frame frame);
  /// Starts a round in PULL mode: its reply goes to the front and ignores the rules.
  void request_data(Frame answer);
  /// Starts rounds automatically from now on, to flush everything at shutdown.
  void send_unasked() { unasked_ = true; }
  /// Removes the queued data of one device.
  void forget(std::uint16_t interf, std::uint16_t index);
  /// Queues a notice that a device has retired, behind its data and
  /// exempt from rules. Sent only when the client cannot mistake it for
  /// a reply: not while one is pending, nor within a round in PULL mode.
  void add_notice(std::uint16_t interf, std::uint16_t index, Frame frame);
  /// True if a notice for this address is queued.
  bool has_notice(std::uint16_t interf, std::uint16_t index) const {
    return notice_numbers_.contains({interf, index});
  }
  /// Whether a request of the client is pending.
  void set_awaited(bool awaited) { awaited_ = awaited; }
  /// A new device takes over the address: data of the old one
  /// is removed, and its notice is sent before the next reply.
  void replace_device(std::uint16_t interf, std::uint16_t index);

  /// Moves what may be sent now to the end of `out`, up to about `max_bytes`. `now` stamps the SYNCH.
  void take(std::vector<net::SharedBytes>& out, std::size_t max_bytes, double now);

  /// True if take() would return something.
  bool has_output() const { return may_send() || round_is_over(); }
  /// Adds messages dropped upstream to the loss counter.
  void lose(std::uint64_t messages) { count_lost(messages); }
  /// Drops all data, like at a limit.
  void drop_data();
  /// Removes all data, which are void: nothing is lost.
  void forget_data();
  /// Drops everything: the peer is gone.
  void clear();

  std::size_t waiting() const { return data_.size() + answers_.size(); }
  std::size_t data_waiting() const { return data_.size(); }
  std::size_t bytes_waiting() const { return data_bytes_ + answer_bytes_ + notice_bytes_; }
  std::size_t answers_waiting() const { return answers_.size(); }
  std::size_t answer_bytes_waiting() const { return answer_bytes_; }
  std::size_t notices_waiting() const { return notices_.size(); }
  /// Number of kinds of data with state.
  std::size_t kinds() const { return kinds_.size(); }
  /// Data messages lost so far, here or upstream.
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct QueuedFrame {
    std::uint64_t number = 0;  // arrival order over both lists
    Frame frame;
  };
  struct QueuedMessage;
  using QueuePlace = std::list<QueuedMessage>::iterator;
  struct QueuedMessage : QueuedFrame {
    QueuePlace older, newer;  // of the same kind; data_.end(): none
  };
  struct Notice {
    std::uint16_t interf = 0, index = 0;  // of the device
    Frame frame;
  };
  /// Queued data of one Frame::kind().
  struct QueuedKind {
    QueuePlace oldest, newest;
    std::size_t waiting = 0;
    std::uint64_t lost = 0;
  };
  /// Order of kinds with queued data: the first one loses the next message.
  struct LossOrder {
    std::size_t waiting;
    std::uint64_t lost;
    std::uint64_t kind;
    bool operator<(const LossOrder& other) const {
      if (waiting != other.waiting) return waiting > other.waiting;
      return lost != other.lost ? lost < other.lost : kind < other.kind;
    }
  };

  void add_data(Frame frame, QueueAction action);
  void add_answer(Frame frame, QueueAction action);
  void remove_data(QueuePlace place);
  void count(std::uint64_t code, std::size_t waiting, std::uint64_t lost);
  bool over_limits() const;
  void drop_one();
  void count_lost(std::uint64_t messages);
  bool may_send() const;
  bool may_send_data() const;
  bool may_tell() const;
  bool round_is_over() const;
  Frame pop();
  Frame take_notice(std::uint64_t number);
  Frame finish_round(double now);

  DeliveryMode mode_ = DeliveryMode::kPush;
  ReplaceRules rules_;
  std::list<QueuedMessage> data_;
  std::deque<QueuedFrame> answers_;
  std::map<std::uint64_t, Notice> notices_;                                          // by number
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint64_t> notice_numbers_;  // by device
  std::map<std::uint64_t, QueuedKind> kinds_;  // since their device was opened
  std::set<LossOrder> shares_;                 // of the kinds in data_
  std::size_t data_bytes_ = 0, answer_bytes_ = 0, notice_bytes_ = 0;
  std::uint64_t next_number_ = 1;
  std::uint64_t dropped_ = 0;
  std::uint32_t unreported_drops_ = 0;  // since the last SYNCH

  // A round: from the client's request to the SYNCH.
  bool data_requested_ = false, data_delivered_ = false;
  bool unasked_ = false, awaited_ = false;
  std::uint64_t round_end_ = 0;  // last message of the round, once data_delivered_
};

}  // namespace playhouse::server
