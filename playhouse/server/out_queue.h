#pragma once

/// OutQueue: what one session still has to send, and the rules of the protocol for what may go out when: PUSH
/// and PULL, replace rules, answers first, the SYNCH that ends a round (docs/server.md). Bounded: data over
/// the limits pushes out the oldest data, and the loss is counted. No sockets, no clock; one thread.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <list>
#include <map>
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
  /// Takes out the data of one device.
  void forget(std::uint16_t interf, std::uint16_t index);

  /// Moves what may go out now to the end of `out`, until it holds about `max_bytes`. `now` stamps the SYNCH.
  void take(std::vector<net::SharedBytes>& out, std::size_t max_bytes, double now);

  std::size_t waiting() const { return data_.size() + answers_.size(); }
  std::size_t answers_waiting() const { return answers_.size(); }
  std::size_t answer_bytes_waiting() const { return answer_bytes_; }
  /// Data pushed out since the start.
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Entry {
    std::uint64_t number;  // order of arrival over both lists
    Frame frame;
  };
  using Place = std::list<Entry>::iterator;

  void add_data(Frame frame, QueueAction action);
  void add_answer(Frame frame, QueueAction action);
  void remove_data(Place place);
  bool may_send() const;
  bool round_is_over() const;
  Frame pop();
  Frame finish_round(double now);

  DeliveryMode mode_ = DeliveryMode::kPush;
  ReplaceRules rules_;
  std::list<Entry> data_;
  std::deque<Entry> answers_;
  std::map<std::uint64_t, Place> newest_;  // of each kind in data_
  std::size_t data_bytes_ = 0, answer_bytes_ = 0;
  std::uint64_t next_number_ = 1;
  std::uint64_t dropped_ = 0;
  std::uint32_t unreported_drops_ = 0;  // since the last SYNCH

  // A round: from the client's request to the SYNCH.
  bool data_requested_ = false, data_delivered_ = false;
  std::uint64_t round_end_ = 0;  // data up to this number belongs to it, once data_delivered_
};

}  // namespace playhouse::server
