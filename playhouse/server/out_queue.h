#pragma once

/// OutQueue: what one session still has to send, and the rules of the protocol for what may go out when: PUSH
/// and PULL, replace rules, answers first, the SYNCH that ends a round, notices of devices that have retired
/// (docs/server.md). Bounded: data over the limits pushes out old data, evenly over the kinds of it, and the
/// loss is counted. No sockets, no clock; one thread.

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

  /// DATA or an answer, subject to the rules.
  void add(Frame frame);
  /// The client asks for a round of data: its answer overtakes everything and ignores the rules.
  void request_data(Frame answer);
  /// From now on rounds begin by themselves, so that everything goes out: for the end of the server.
  void send_unasked() { unasked_ = true; }
  /// Takes out the data of one device.
  void forget(std::uint16_t interf, std::uint16_t index);
  /// Says, behind the data of a device, that it has retired. No rule leaves it out. It goes out where the
  /// client waits for no answer that it could be taken for: not while one is awaited, and in PULL mode amid a
  /// round.
  void add_notice(std::uint16_t interf, std::uint16_t index, Frame frame);
  /// The client has not been told that a device at this address has retired.
  bool has_notice(std::uint16_t interf, std::uint16_t index) const {
    return notice_numbers_.contains({interf, index});
  }
  /// Some request of the client is not answered yet.
  void set_awaited(bool awaited) { awaited_ = awaited; }
  /// Another device takes the place of one that may have retired: data of the old one is taken out, and the
  /// notice goes out before the next answer.
  void replace_device(std::uint16_t interf, std::uint16_t index);

  /// Moves what may go out now to the end of `out`, until it holds about `max_bytes`. `now` stamps the SYNCH.
  void take(std::vector<net::SharedBytes>& out, std::size_t max_bytes, double now);

  /// take() would give something.
  bool has_output() const { return may_send() || round_is_over(); }
  /// Adds messages dropped upstream to the loss count.
  void lose(std::uint64_t messages) { count_lost(messages); }
  /// Drops all data, as over a limit.
  void drop_data();
  /// Takes out everything: nobody will read it.
  void clear();

  std::size_t waiting() const { return data_.size() + answers_.size(); }
  std::size_t data_waiting() const { return data_.size(); }
  std::size_t bytes_waiting() const { return data_bytes_ + answer_bytes_ + notice_bytes_; }
  std::size_t answers_waiting() const { return answers_.size(); }
  std::size_t answer_bytes_waiting() const { return answer_bytes_; }
  std::size_t notices_waiting() const { return notices_.size(); }
  /// Kinds of data that it counts.
  std::size_t kinds() const { return kinds_.size(); }
  /// Data messages lost since the start: pushed out, or lost before.
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Entry {
    std::uint64_t number = 0;  // order of arrival over both lists
    Frame frame;
  };
  struct Message;
  using Place = std::list<Message>::iterator;
  struct Message : Entry {
    Place older, newer;  // of the same kind; data_.end(): none
  };
  struct Notice {
    std::uint16_t interf = 0, index = 0;  // of the device
    Frame frame;
  };
  /// What waits of one Frame::kind().
  struct Kind {
    Place oldest, newest;
    std::size_t waiting = 0;
    std::uint64_t lost = 0;
  };
  /// A kind's place among those that have data waiting: the first loses the next message.
  struct Share {
    std::size_t waiting;
    std::uint64_t lost;
    std::uint64_t kind;
    bool operator<(const Share& other) const {
      if (waiting != other.waiting) return waiting > other.waiting;
      return lost != other.lost ? lost < other.lost : kind < other.kind;
    }
  };

  void add_data(Frame frame, QueueAction action);
  void add_answer(Frame frame, QueueAction action);
  void remove_data(Place place);
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
  std::list<Message> data_;
  std::deque<Entry> answers_;
  std::map<std::uint64_t, Notice> notices_;                                          // by number
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint64_t> notice_numbers_;  // by device
  std::map<std::uint64_t, Kind> kinds_;  // that came since their device was opened
  std::set<Share> shares_;               // of the kinds in data_
  std::size_t data_bytes_ = 0, answer_bytes_ = 0, notice_bytes_ = 0;
  std::uint64_t next_number_ = 1;
  std::uint64_t dropped_ = 0;
  std::uint32_t unreported_drops_ = 0;  // since the last SYNCH

  // A round: from the client's request to the SYNCH.
  bool data_requested_ = false, data_delivered_ = false;
  bool unasked_ = false, awaited_ = false;
  std::uint64_t round_end_ = 0;  // what came up to this number belongs to it, once data_delivered_
};

}  // namespace playhouse::server
