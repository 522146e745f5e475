#pragma once

/// One client session: decodes messages, calls drivers, queues replies. Independent of
/// sockets: Server feeds it input and sends its output. One per connection; io thread.
///
/// work() handles at most limits::kTurnMessages messages per call, and the server
/// serves all sessions with work round robin: those on its list (Switchboard::due).
/// Back-pressure: a session stops reading input while it owes limits::kSessionAnswers
/// replies, pending opens, closes and commands of drivers included, so that a client
/// that asks without reading, or faster than the world ticks, blocks only itself. It also
/// stops at a message to a device that it opens and that is not prepared yet (Driver::prepare).

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

/// Access mode of an open device.
enum class Access : std::uint8_t { kAll, kRead, kWrite };

class Session final : public Subscriber {
 public:
  /// `serial`: unique number of the session in its server;
  /// `robot`: the port of the connection; `peer`: for the log.
  Session(Switchboard& board, std::uint32_t serial, std::uint32_t robot, std::string peer);
  /// Calls leave().
  ~Session() override;
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Appends bytes from the client, in any segmentation, for work().
  void receive(std::span<const std::byte> bytes);
  /// Executes the next messages, at most one turn's worth, and returns their number.
  std::size_t work();
  /// True if a complete message is buffered.
  bool has_message() const;
  /// True if work() would do something: has_message(), and not blocked by owed replies or by turns.
  bool can_work() const {
    return has_message() && owed_answers() < limits::kSessionAnswers && !is_held_back();
  }
  /// The peer cannot receive any more: only messages with side effects are
  /// still executed (commands, requests that set, devices opened and closed).
  void lose_peer();
  /// Closes all devices that the session has open.
  void leave();
  /// An open device has retired: ends its subscription; `notice` informs the client.
  void retire(device::DeviceId device, device::Address address, const Frame& notice);
  /// True if requests to drivers are pending.
  bool waits_for_answers() const { return !pending_.empty(); }
  /// True if take() would return something.
  bool has_output() const { return queue_.has_output(); }

  /// Appends the session to the list of those with work, unless it is there or being served.
  void mark_due();
  /// The server has removed it from the list and served it.
  void unmark_due() { due_ = false; }

  /// Reason to close the session; empty if there is none.
  const std::string& broken() const { return broken_; }

  /// Memory of an incomplete long message; up to limits::kSessionInputBytes it does not count.
  std::size_t input_bytes() const { return input_bytes_; }
  /// Start order of such messages over all sessions.
  std::uint64_t input_turn() const { return input_turn_; }
  /// Marks the session as broken().
  void give_up(std::string why);

  /// A driver's reply to the request or barrier of this number (low 32 bits of its ticket).
  void answer(std::uint32_t number, bool ack, std::span<const std::byte> body);
  std::uint32_t serial() const override { return serial_; }
  void deliver(const Frame& frame) override;
  void lose(std::uint64_t messages) override { queue_.lose(messages); }
  bool reads_group() const override { return reads_group_; }

  /// Bytes of queued replies and data; shared data counts in each session.
  std::size_t output_bytes() const { return queue_.bytes_waiting(); }
  /// Removes the queued data, which are void.
  void forget_data() { queue_.forget_data(); }
  /// Drops the queued data, like at a limit.
  void drop_data();

  /// Moves what may be sent now to the end of `out`, up to about `max_bytes`.
  void take(std::vector<net::SharedBytes>& out, std::size_t max_bytes);

  const std::string& peer() const { return peer_; }
  /// The port of its connection.
  std::uint32_t robot() const { return robot_; }
  /// What it has open.
  std::vector<device::Address> open_devices() const;
  /// That it has the rights of; "*": none.
  const std::string& token() const { return token_; }
  device::Caller& caller() { return caller_; }
  /// Number of its table entries for devices.
  std::size_t device_rows() const;
  std::size_t messages_waiting() const { return queue_.waiting(); }
  std::size_t data_waiting() const { return queue_.data_waiting(); }
  /// See OutQueue.
  void send_unasked() { queue_.send_unasked(); }

 private:
  struct OpenDevice {
    Access access = Access::kAll;
    std::size_t opens = 0;  // opens minus closes
  };
  struct PendingRequest {
    wire::Header header;
    device::DeviceId device;
  };
  /// A device that is being prepared.
  struct Opening {
    device::Address address;
    std::uint8_t code = 0;  // the access that the client asked for
  };
  /// Categories of errors; each is logged once per session.
  enum class Fault : std::uint8_t {
    kUnknownDevice,
    kUnknownMessage,
    kUndecodable,
    kReadOnly,
    kRights,
    kUnsupported,
    kNotForServer,
    kLimit,
    kStart,
    kDrop,
  };
  using MessageBody = std::span<const std::byte>;

  // session.cc: framing, commands and requests
  std::size_t owed_answers() const;
  void take_credit(device::DeviceId device);
  bool is_held_back() const;
  bool waits_for_turn(const wire::Header& header) const;
  bool waits_for_opening(const wire::Header& header, MessageBody body) const;
  bool matters_without_peer(const wire::Header& header) const;
  void forget_input(std::size_t count);
  void count_input(std::size_t bytes);
  void dispatch(const wire::Header& header, MessageBody body);
  void command(const wire::Header& header, MessageBody body);
  void request(const wire::Header& header, MessageBody body);
  void capability(device::DeviceId device, const wire::Header& header, MessageBody body);
  void drop_command(const wire::Header& header, Fault fault, const std::string& why);
  void refuse(const wire::Header& header, Fault fault, const std::string& why);
  void reply(const wire::Header& to, bool ack, MessageBody body = {});
  Frame make_reply(const wire::Header& to, bool ack, MessageBody body) const;
  void count_dropped(std::uint64_t messages);
  void log_once(Fault fault, const std::string& what, const std::string& why);
  device::Address address_of(const wire::Header& header) const;
  bool means_one_that_retired(const wire::Header& header) const;
  bool opened_for_reading_only(device::DeviceId device) const;
  std::string why_not_admitted() const;

  // player_requests.cc: requests to the server itself
  void player_message(const wire::Header& header, MessageBody body);
  void authenticate(const wire::Header& header, MessageBody body);
  void list_devices(const wire::Header& header);
  void tell_driver(const wire::Header& header, MessageBody body);
  void open_or_close(const wire::Header& header, MessageBody body);
  void set_data_mode(const wire::Header& header, MessageBody body);
  void add_replace_rule(const wire::Header& header, MessageBody body);
  void tell_lost(const wire::Header& header, MessageBody body);
  void tell_group(const wire::Header& header, MessageBody body);
  void read_group(const wire::Header& header, MessageBody body);
  void prepare(const wire::Header& header, device::DeviceId device, std::uint8_t code);
  void prepared(const wire::Header& header, const Opening& opening, bool ack, MessageBody why);
  void tell_access(const wire::Header& header, device::Address address, std::uint8_t access);
  std::uint8_t open(device::DeviceId device, Access access, std::uint8_t code);
  bool close(device::DeviceId device);

  Switchboard& board_;
  const std::uint32_t serial_;
  const std::uint32_t robot_;
  const std::string peer_;
  std::string token_;
  device::Caller caller_;

  std::vector<std::byte> input_;  // starts with a header
  std::size_t input_bytes_ = 0;
  std::uint64_t input_turn_ = 0;
  OutQueue queue_;
  std::map<device::DeviceId, OpenDevice> open_;
  std::map<std::uint32_t, PendingRequest> pending_;
  std::map<std::uint32_t, Opening> opening_;  // of those in pending_
  std::size_t pending_bytes_ = 0;             // of the requests in pending_
  std::set<std::uint32_t> barriers_;          // pending barriers
  std::uint32_t next_request_ = 0;            // counter for both
  bool due_ = false, peer_lost_ = false;
  bool reads_group_ = false;  // its data go by multicast
  std::string broken_;
  std::set<Fault> logged_;
  std::uint64_t commands_dropped_ = 0;
};

/// The ticket of a session's request: returned by the driver with its reply.
constexpr std::uint64_t make_ticket(std::uint32_t serial, std::uint32_t number) {
  return std::uint64_t{serial} << 32 | number;
}

}  // namespace playhouse::server
