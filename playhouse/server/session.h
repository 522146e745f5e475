#pragma once

/// Session: one client's half of the conversation, from its bytes to calls of drivers and to the frames it is
/// owed. Knows no sockets: Server feeds it what arrives and sends what it gives. One connection, one session;
/// io thread.
///
/// A session stops working on its input while it owes limits::kSessionAnswers answers, those of drivers that
/// have yet to open or close what it told them included (wants_bytes() is false), so a client that asks
/// without reading, or faster than the world turns, holds up itself and nobody else.

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

  /// Bytes from the client, in any segmentation.
  void receive(std::span<const std::byte> bytes);
  /// Goes on with input that had to wait. Call while can_work_on(), once answers have gone out.
  void work_on();
  /// Input waits for answers to go out.
  bool held_up() const { return held_up_; }
  bool can_work_on() const { return held_up_ && wants_bytes(); }
  /// Closes every device the session has open.
  void leave();
  /// Some driver has not answered yet.
  bool waits_for_answers() const { return !pending_.empty(); }
  /// False while input waits for answers to go out: the connection should pause.
  bool wants_bytes() const { return owed_answers() < limits::kSessionAnswers; }
  /// Why the session has to be closed; empty while it need not.
  const std::string& broken() const { return broken_; }

  /// Memory for a long message that has not come whole; up to limits::kSessionInputBytes it does not count.
  std::size_t input_bytes() const { return input_bytes_; }
  /// Smaller for a message that began earlier, among all sessions.
  std::uint64_t input_turn() const { return input_turn_; }
  /// From now on the session is broken().
  void give_up(std::string why);

  /// A driver's answer to the request with this number (the low half of its ticket), or the end of a receipt.
  void answer(std::uint32_t number, bool ack, std::span<const std::byte> body);
  void deliver(const Frame& frame) override;

  /// Moves what may be sent now to the end of `out`, until it holds about `max_bytes`.
  void take(std::vector<net::SharedBytes>& out, std::size_t max_bytes);

  std::uint32_t robot() const { return robot_; }
  const std::string& peer() const { return peer_; }
  std::size_t devices_open() const { return open_.size(); }
  std::size_t messages_waiting() const { return queue_.waiting(); }
  std::uint64_t messages_sent() const { return messages_sent_; }
  std::uint64_t data_dropped() const { return queue_.dropped(); }

 private:
  struct OpenDevice {
    Access access = Access::kAll;
    std::size_t opens = 0;  // closes that the client still owes
  };
  struct PendingRequest {
    wire::Header header;
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
  device::Receipt make_receipt();
  void process();
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
  void log_once(Fault fault, const wire::Header& header, const std::string& why);
  device::Address address_of(const wire::Header& header) const;
  bool opened_for_reading_only(device::DeviceId device) const;

  // player_requests.cc: requests to the server itself
  void player_message(const wire::Header& header, Body body);
  void list_devices(const wire::Header& header);
  void tell_driver(const wire::Header& header, Body body);
  void open_or_close(const wire::Header& header, Body body);
  void set_data_mode(const wire::Header& header, Body body);
  void add_replace_rule(const wire::Header& header, Body body);
  std::uint8_t open(device::DeviceId device, Access access, std::uint8_t code, const wire::Header& header);
  bool close(device::DeviceId device);

  Switchboard& board_;
  const std::uint32_t serial_;
  const std::uint32_t robot_;
  const std::string peer_;

  std::vector<std::byte> input_;  // begins at a header
  std::size_t input_bytes_ = 0;
  std::uint64_t input_turn_ = 0;
  OutQueue queue_;
  std::map<device::DeviceId, OpenDevice> open_;
  std::map<std::uint32_t, PendingRequest> pending_;
  std::size_t pending_bytes_ = 0;     // of the requests in pending_
  std::set<std::uint32_t> receipts_;  // that drivers keep
  std::uint32_t next_request_ = 0;    // numbers both
  bool held_up_ = false;
  std::string broken_;
  std::set<Fault> logged_;
  std::uint64_t messages_sent_ = 0, commands_dropped_ = 0;
};

/// The ticket of a session's request: what a driver hands back with its answer.
constexpr std::uint64_t make_ticket(std::uint32_t serial, std::uint32_t number) {
  return std::uint64_t{serial} << 32 | number;
}

}  // namespace playhouse::server
