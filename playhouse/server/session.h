#pragma once

/// One client session: decodes its messages, calls drivers, queues its replies. Knows no sockets: Server
/// feeds it what arrives and sends what it gives. One connection, one session; io thread.
///
/// work() handles at most limits::kTurnMessages messages per call, and the server goes round all sessions
/// that have something to do: those that put themselves on its list (Switchboard::due). A session stops
/// working on its input while it owes limits::kSessionAnswers answers, those of drivers that have yet to
/// open, close or carry out what it told them included, so a client that asks without reading, or faster than
/// the world turns, holds up itself and nobody else.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/device/address.h"
#include "playhouse/server/out_queue.h"
#include "playhouse/server/switchboard.h"
#include "playhouse/wire/header.h"
#include "playhouse/wire/messages.h"

namespace playhouse::server {

/// How a session has a device open.
enum class Access : std::uint8_t { kAll, kRead, kWrite };

class Session final : public Reader {
 public:
  /// `serial` numbers the sessions of a server, never reused; `robot` is the port the client came in by;
  /// `peer` is for log lines.
  Session(Switchboard& board, std::uint32_t serial, std::uint32_t robot, std::string peer);
  /// As leave().
  ~Session() override;
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Bytes from the client, in any segmentation; work() takes them up.
  void receive(std::span<const std::byte> bytes);
  /// Carries out the next messages, as many as one turn allows, and returns their number.
  std::size_t work();
  /// A message has come whole and is not carried out yet.
  bool has_message() const;
  /// work() would do something: has_message(), and neither answers nor the turns of others hold it up.
  bool can_work() const {
    return has_message() && owed_answers() < limits::kSessionAnswers && !is_held_back();
  }
  /// The peer can no longer receive: only messages that change state are still processed (commands, requests
  /// that set, devices opened and closed).
  void lose_peer();
  /// Closes every device the session has open.
  void leave();
  /// A device that it has open has retired: its subscription ends, and `notice` tells the client.
  void retire(device::DeviceId device, device::Address address, const Frame& notice);
  /// Some driver has not answered yet.
  bool waits_for_answers() const { return !pending_.empty(); }
  /// take() would give something.
  bool has_output() const { return queue_.has_output(); }

  /// Puts the session on the list of those with something to do, unless it is there or is having its turn.
  void mark_due();
  /// The server took it from the list and has done what there was.
  void unmark_due() { due_ = false; }

  /// Why the session has to be closed; empty while it need not.
  const std::string& broken() const { return broken_; }

  /// Memory for a long message that has not come whole; up to limits::kSessionInputBytes it does not count.
  std::size_t input_bytes() const { return input_bytes_; }
  /// Smaller for a message that began earlier, among all sessions.
  std::uint64_t input_turn() const { return input_turn_; }
  /// From now on the session is broken().
  void give_up(std::string why);

  /// A driver's answer to the request or the barrier with this number (the low 32 bits of its ticket).
  void answer(std::uint32_t number, bool ack, std::span<const std::byte> body);
  void deliver(const Frame& frame) override;
  void lose(std::uint64_t messages) override { queue_.lose(messages); }

  /// Of answers and data that wait; data that others wait for too is counted for each.
  std::size_t output_bytes() const { return queue_.bytes_waiting(); }
  /// Drops the data that waits, as if the queue were full.
  void drop_data();

  /// Moves what may be sent now to the end of `out`, until it holds about `max_bytes`.
  void take(std::vector<net::SharedBytes>& out, std::size_t max_bytes);

  const std::string& peer() const { return peer_; }
  device::Caller& caller() { return caller_; }
  /// Entries of its tables that are about some device.
  std::size_t device_rows() const;
  std::size_t messages_waiting() const { return queue_.waiting(); }
  std::size_t data_waiting() const { return queue_.data_waiting(); }
  /// As OutQueue.
  void send_unasked() { queue_.send_unasked(); }

 private:
  struct OpenDevice {
    Access access = Access::kAll;
    std::size_t opens = 0;  // closes that the client still owes
  };
  struct PendingRequest {
    wire::Header header;
    device::DeviceId device;
  };
  /// Why something was not done; each is logged once per session.
  enum class Fault : std::uint8_t {
    kUnknownDevice,
    kUnknownMessage,
    kUndecodable,
    kReadOnly,
    kUnsupported,
    kNotForServer,
    kLimit,
    kStart,
    kDrop,
  };
  using Body = std::span<const std::byte>;

  // session.cc: framing, commands and requests
  std::size_t owed_answers() const;
  void take_credit(device::DeviceId device);
  bool is_held_back() const;
  bool waits_for_turn(const wire::Header& header) const;
  bool matters_without_peer(const wire::Header& header) const;
  void forget_input(std::size_t count);
  void count_input(std::size_t bytes);
  void dispatch(const wire::Header& header, Body body);
  void command(const wire::Header& header, Body body);
  void request(const wire::Header& header, Body body);
  void capability(device::DeviceId device, const wire::Header& header, Body body);
  void drop_command(const wire::Header& header, Fault fault, const std::string& why);
  void refuse(const wire::Header& header, Fault fault, const std::string& why);
  void reply(const wire::Header& to, bool ack, Body body = {});
  Frame make_reply(const wire::Header& to, bool ack, Body body) const;
  void count_dropped(std::uint64_t messages);
  void log_once(Fault fault, const std::string& what, const std::string& why);
  device::Address address_of(const wire::Header& header) const;
  bool means_one_that_retired(const wire::Header& header) const;
  bool opened_for_reading_only(device::DeviceId device) const;

  // player_requests.cc: requests to the server itself
  void player_message(const wire::Header& header, Body body);
  void list_devices(const wire::Header& header);
  void tell_driver(const wire::Header& header, Body body);
  void open_or_close(const wire::Header& header, Body body);
  void set_data_mode(const wire::Header& header, Body body);
  void add_replace_rule(const wire::Header& header, Body body);
  void tell_lost(const wire::Header& header, Body body);
  std::uint8_t open(device::DeviceId device, Access access, std::uint8_t code);
  bool close(device::DeviceId device);

  Switchboard& board_;
  const std::uint32_t serial_;
  const std::uint32_t robot_;
  const std::string peer_;
  device::Caller caller_;

  std::vector<std::byte> input_;  // begins at a header
  std::size_t input_bytes_ = 0;
  std::uint64_t input_turn_ = 0;
  OutQueue queue_;
  std::map<device::DeviceId, OpenDevice> open_;
  std::map<std::uint32_t, PendingRequest> pending_;
  std::size_t pending_bytes_ = 0;     // of the requests in pending_
  std::set<std::uint32_t> barriers_;  // that drivers have not answered
  std::uint32_t next_request_ = 0;    // numbers both
  bool due_ = false, peer_lost_ = false;
  std::string broken_;
  std::set<Fault> logged_;
  std::uint64_t commands_dropped_ = 0;
};

/// The ticket of a session's request: what a driver hands back with its answer.
constexpr std::uint64_t make_ticket(std::uint32_t serial, std::uint32_t number) {
  return std::uint64_t{serial} << 32 | number;
}

}  // namespace playhouse::server
