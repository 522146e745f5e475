#include "playhouse/server/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/player.h"

namespace playhouse::server {
namespace {

std::string describe(const wire::Header& header) {
  const wire::InterfaceDef* interf = wire::find_interface(header.interf);
  const wire::MessageDef* def = wire::find_message(header.interf, header.type, header.subtype);
  const std::string device =
      fmt::format("{}:{}", interf ? std::string(interf->name) : std::to_string(header.interf), header.index);
  if (def) return fmt::format("{} to {}", def->name, device);
  return fmt::format("{} {} to {}", wire::name(header.type), header.subtype, device);
}

constexpr const char* kNoToken = "*";  // as in files of guests
constexpr device::Rights kNothing{.reads = false, .drives = false, .manages = false};

/// True for requests without side effects but for the client itself. By
/// message name: get_*, capabilities, and the exceptions below.
bool only_reads(const wire::MessageDef& def) {
  constexpr std::array<std::string_view, 12> kReadersByOtherNames = {"ptz.req.geom",
                                                                     "ptz.req.status",
                                                                     "ir.req.pose",
                                                                     "wifi.req.mac",
                                                                     "rfid.req.readtag",
                                                                     "limb.req.geom",
                                                                     "audio.req.mixer_channel_list",
                                                                     "audio.req.sample_retrieve",
                                                                     "blackboard.req.subscribe_to_key",
                                                                     "blackboard.req.unsubscribe_from_key",
                                                                     "blackboard.req.subscribe_to_group",
                                                                     "blackboard.req.unsubscribe_from_group"};
  const std::string_view last = def.name.substr(def.name.rfind('.') + 1);
  return last.starts_with("get_") || last == "capabilities" ||
         std::find(kReadersByOtherNames.begin(), kReadersByOtherNames.end(), def.name) !=
             kReadersByOtherNames.end();
}

/// Also true if the claimed size exceeds the limit: no need to wait for the rest.
bool begins_with_message(std::span<const std::byte> input) {
  if (input.size() < limits::kHeaderBytes) return false;
  const std::uint32_t size = wire::decode_header(input.first<limits::kHeaderBytes>()).size;
  return size > limits::kBodyBytes || input.size() - limits::kHeaderBytes >= size;
}

}  // namespace

Session::Session(Switchboard& board, std::uint32_t serial, std::uint32_t robot, std::string peer)
    : board_(board),
      serial_(serial),
      robot_(robot),
      peer_(std::move(peer)),
      token_(kNoToken),
      caller_(peer_, serial_) {
  caller_.set_holder(net::holder_of(token_, peer_));
  if (board_.admit) caller_.set_rights(board_.admit(token_, peer_).value_or(kNothing));
}

Session::~Session() {
  leave();
  for (const auto& [number, request] : pending_)
    board_.uses.answer(request.device, make_ticket(serial_, number));
  count_input(0);
  if (commands_dropped_ > 1) log::warn("{}: {} commands were dropped in all", peer_, commands_dropped_);
  if (queue_.dropped() > 0) log::warn("{}: {} data messages were lost in all", peer_, queue_.dropped());
}

// --- input
// -----------------------------------------------------------------------------------------------------------

void Session::receive(std::span<const std::byte> bytes) {
  if (!broken_.empty()) return;
  input_.insert(input_.end(), bytes.begin(), bytes.end());
  count_input(input_.capacity() > limits::kSessionInputBytes ? input_.capacity() : 0);
  if (has_message()) mark_due();
}

void Session::mark_due() {
  if (!std::exchange(due_, true)) board_.due.push_back(serial_);
}

void Session::lose_peer() {
  peer_lost_ = true;
  queue_.clear();
}

void Session::leave() {
  caller_.leave();
  for (const auto& [device, opened] : std::exchange(open_, {})) {
    board_.fanout.leave(device, *this);
    board_.uses.close(device, serial_);
    board_.devices.close(device);
  }
}

std::vector<device::Address> Session::open_devices() const {
  std::vector<device::Address> all;
  for (const auto& [device, opened] : open_) all.push_back(board_.devices[device].address);
  return all;
}

void Session::retire(device::DeviceId device, device::Address address, const Frame& notice) {
  open_.erase(device);
  if (peer_lost_) return;
  queue_.add_notice(address.interf, address.index, notice);
  if (queue_.has_output()) mark_due();
}

std::size_t Session::device_rows() const {
  return open_.size() + pending_.size() + queue_.kinds() + queue_.notices_waiting();
}

std::size_t Session::owed_answers() const {
  // Long requests and replies count more, so that the limit also bounds bytes.
  constexpr std::size_t kShare = limits::kSessionAnswerBytes / limits::kSessionAnswers;
  return std::max(pending_.size() + barriers_.size(), pending_bytes_ / kShare) +
         std::max(queue_.answers_waiting(), queue_.answer_bytes_waiting() / kShare);
}

// For a message that the driver does not reply to: its barrier occupies a slot until then.
void Session::take_credit(device::DeviceId device) {
  const std::uint32_t number = next_request_++;
  barriers_.insert(number);
  board_.devices[device].driver->barrier(device::Replier(*board_.outlet, make_ticket(serial_, number)));
}

std::size_t Session::work() {
  std::size_t at = 0, messages = 0;
  while (messages < limits::kTurnMessages && owed_answers() < limits::kSessionAnswers) {
    const MessageBody rest = std::span(input_).subspan(at);
    if (!begins_with_message(rest)) break;
    const wire::Header header = wire::decode_header(rest.first<limits::kHeaderBytes>());
    if (waits_for_turn(header)) break;
    if (header.size > limits::kBodyBytes) {
      give_up(fmt::format("{} claims {} bytes, over the limit of {}", describe(header), header.size,
                          limits::kBodyBytes));
      return messages;
    }
    const MessageBody body = rest.subspan(limits::kHeaderBytes, header.size);
    if (waits_for_opening(header, body)) break;
    dispatch(header, body);
    at += limits::kHeaderBytes + header.size;
    ++messages;
  }
  forget_input(at);
  return messages;
}

bool Session::has_message() const {
  return begins_with_message(input_);
}

// Shrinks a large buffer once little of it is used.
void Session::forget_input(std::size_t count) {
  input_.erase(input_.begin(), input_.begin() + static_cast<std::ptrdiff_t>(count));
  const bool is_long = input_.capacity() > limits::kSessionInputBytes;
  if (is_long && input_.size() < input_.capacity() / 4) input_.shrink_to_fit();
  if (count > 0 || input_bytes_ == 0) input_turn_ = ++board_.input_turns;
  count_input(input_.capacity() > limits::kSessionInputBytes ? input_.capacity() : 0);
}

void Session::count_input(std::size_t bytes) {
  board_.input_bytes += bytes - input_bytes_;
  input_bytes_ = bytes;
}

void Session::give_up(std::string why) {
  broken_ = std::move(why);
  forget_input(input_.size());
  mark_due();
}

bool Session::is_held_back() const {
  if ((board_.turns == nullptr && opening_.empty()) || !has_message()) return false;
  const wire::Header header = wire::decode_header(std::span(input_).first<limits::kHeaderBytes>());
  const MessageBody rest = std::span(input_).subspan(limits::kHeaderBytes);
  return waits_for_turn(header) ||
         waits_for_opening(header, rest.first(std::min<std::size_t>(rest.size(), header.size)));
}

/// What a client says to a device comes behind its open. All else goes on, since it may be what that waits for:
/// opens of other devices, and the CAPABILITIES by which circles of servers are found.
bool Session::waits_for_opening(const wire::Header& header, MessageBody body) const {
  if (opening_.empty() || header.subtype == wire::kReqCapabilities) return false;
  device::Address address = address_of(header);
  if (header.interf == wire::player::kCode) {
    if (header.subtype != wire::player::kReqDev) return false;
    const auto asked = wire::decode<wire::player::DeviceReq>(body);
    if (!asked) return false;
    address = {robot_, asked->addr.interf, asked->addr.index};
  }
  return std::ranges::any_of(opening_, [&](const auto& entry) { return entry.second.address == address; });
}

/// Reads, opens and closes are never delayed: the run does not depend on their timing.
bool Session::waits_for_turn(const wire::Header& header) const {
  if (board_.turns == nullptr || header.interf == wire::player::kCode || !matters_without_peer(header))
    return false;
  board_.held_back = true;  // set before the check, so that no change is missed
  return !board_.turns->may_act(caller_);
}

bool Session::matters_without_peer(const wire::Header& header) const {
  if (header.type == wire::MessageType::kCmd) return true;
  if (header.type != wire::MessageType::kReq) return false;
  if (header.interf == wire::player::kCode) return header.subtype == wire::player::kReqDev;
  const wire::MessageDef* def = wire::find_message(header.interf, header.type, header.subtype);
  return def && !only_reads(*def);
}

void Session::dispatch(const wire::Header& header, MessageBody body) {
  if (peer_lost_ && !matters_without_peer(header)) return;
  ++board_.counters.messages_received;
  if (header.interf == wire::player::kCode) return player_message(header, body);
  switch (header.type) {
    case wire::MessageType::kCmd:
      return command(header, body);
    case wire::MessageType::kReq:
      return request(header, body);
    default:
      return drop_command(header, Fault::kNotForServer, "clients send commands and requests");
  }
}

void Session::command(const wire::Header& header, MessageBody body) {
  const device::DeviceId device = board_.devices.find(address_of(header));
  if (!device.valid())
    return drop_command(header, Fault::kUnknownDevice, board_.devices.why_missing(address_of(header)));
  if (means_one_that_retired(header))
    return drop_command(header, Fault::kUnknownDevice,
                        "the device has retired, and the client has not read so");
  if (opened_for_reading_only(device))
    return drop_command(header, Fault::kReadOnly, "opened for reading only");
  if (!caller_.rights().drives) return drop_command(header, Fault::kRights, why_not_admitted());
  const wire::MessageDef* def = wire::find_message(header.interf, header.type, header.subtype);
  if (!def) return drop_command(header, Fault::kUnknownMessage, "no such command");
  if (const std::string wrong = def->check(body); !wrong.empty()) {
    return drop_command(header, Fault::kUndecodable, wrong);
  }
  const auto type = static_cast<std::uint8_t>(header.type);
  switch (board_.devices[device].driver->command({device, type, header.subtype, body, &caller_})) {
    case device::Taken::kRefused:
      return drop_command(header, Fault::kRights, "not this client's to command");
    case device::Taken::kNo:
      return drop_command(header, Fault::kUnsupported,
                          "the device has no such command, or not with these values");
    case device::Taken::kQueued:
      return take_credit(device);
    case device::Taken::kLatest:
      return;
  }
}

void Session::request(const wire::Header& header, MessageBody body) {
  const device::DeviceId device = board_.devices.find(address_of(header));
  if (!device.valid())
    return refuse(header, Fault::kUnknownDevice, board_.devices.why_missing(address_of(header)));
  if (means_one_that_retired(header))
    return refuse(header, Fault::kUnknownDevice, "the device has retired, and the client has not read so");
  const wire::MessageDef* def = wire::find_message(header.interf, header.type, header.subtype);
  if (!def) return refuse(header, Fault::kUnknownMessage, "no such request");
  if (const std::string wrong = def->check(body); !wrong.empty())
    return refuse(header, Fault::kUndecodable, wrong);
  if (opened_for_reading_only(device) && !only_reads(*def)) {
    return refuse(header, Fault::kReadOnly, "opened for reading only");
  }
  const device::Rights& rights = caller_.rights();
  if (only_reads(*def) ? !rights.reads : !rights.drives)
    return refuse(header, Fault::kRights, why_not_admitted());
  if (header.subtype == wire::kReqCapabilities && !board_.devices[device].driver->asks_for_capabilities())
    return capability(device, header, body);

  const std::uint32_t number = next_request_++;
  const std::uint64_t ticket = make_ticket(serial_, number);
  pending_[number] = {header, device};
  pending_bytes_ += header.size;
  queue_.set_awaited(true);
  board_.uses.ask(device, ticket);
  const auto type = static_cast<std::uint8_t>(header.type);
  board_.devices[device].driver->request({device, type, header.subtype, body, &caller_},
                                         device::Replier(*board_.outlet, ticket));
}

void Session::capability(device::DeviceId device, const wire::Header& header, MessageBody body) {
  const Result<wire::CapabilitiesReq> asked = wire::decode<wire::CapabilitiesReq>(body);
  constexpr std::uint32_t kLargest = std::numeric_limits<std::uint8_t>::max();
  const bool capable = asked && asked->type <= kLargest && asked->subtype <= kLargest &&
                       board_.devices[device].driver->capable(device, static_cast<std::uint8_t>(asked->type),
                                                              static_cast<std::uint8_t>(asked->subtype));
  reply(header, capable);
}

void Session::drop_command(const wire::Header& header, Fault fault, const std::string& why) {
  ++commands_dropped_;
  ++board_.counters.commands_dropped;
  log_once(fault, describe(header), why + "; dropped");
}

void Session::refuse(const wire::Header& header, Fault fault, const std::string& why) {
  ++board_.counters.requests_refused;
  log_once(fault, describe(header), why + "; answered NACK");
  reply(header, false);
}

void Session::log_once(Fault fault, const std::string& what, const std::string& why) {
  if (logged_.insert(fault).second) log::warn("{}: {}: {}", peer_, what, why);
}

device::Address Session::address_of(const wire::Header& header) const {
  return {robot_, header.interf, header.index};
}

/// True if a retired device at this address has not been reported to the client yet.
bool Session::means_one_that_retired(const wire::Header& header) const {
  return queue_.has_notice(header.interf, header.index);
}

/// Why a right is missing.
std::string Session::why_not_admitted() const {
  return caller_.rights().reads ? "a guest who only observes may not"
                                : "this run admits guests: AUTH with a token comes first (docs/guests.md)";
}

bool Session::opened_for_reading_only(device::DeviceId device) const {
  const auto found = open_.find(device);
  return found != open_.end() && found->second.access == Access::kRead;
}

// --- output
// ----------------------------------------------------------------------------------------------------------

void Session::answer(std::uint32_t number, bool ack, std::span<const std::byte> body) {
  mark_due();  // a slot is free, even if the reply is dropped
  if (barriers_.erase(number) > 0) return;
  const auto found = pending_.find(number);
  if (found == pending_.end()) return;  // already replied
  const auto [header, device] = found->second;
  pending_.erase(found);
  pending_bytes_ -= header.size;
  queue_.set_awaited(!pending_.empty());
  board_.uses.answer(device, make_ticket(serial_, number));
  if (const auto opening = opening_.extract(number)) return prepared(header, opening.mapped(), ack, body);
  // A request dropped at the end of the run was not refused: that the connection is closed says why.
  if (!ack && body.empty() && board_.run_is_over) return;
  if (body.size() > limits::kBodyBytes)
    return refuse(header, Fault::kLimit, "the answer is over the limit of a body");
  reply(header, ack, body);
}

void Session::reply(const wire::Header& to, bool ack, MessageBody body) {
  if (peer_lost_) return;
  queue_.add(make_reply(to, ack, body));
  mark_due();
}

Frame Session::make_reply(const wire::Header& to, bool ack, MessageBody body) const {
  wire::Header header = to;
  header.host = wire::kLocalhost;
  header.robot = robot_;
  header.type = ack ? wire::MessageType::kAck : wire::MessageType::kNack;
  header.timestamp = board_.clock();
  return counted(make_frame(header, body), board_.frame_bytes);
}

void Session::deliver(const Frame& frame) {
  if (peer_lost_) return;
  const std::uint64_t dropped = queue_.dropped();
  queue_.add(frame);
  if (queue_.has_output()) mark_due();
  count_dropped(queue_.dropped() - dropped);
}

void Session::drop_data() {
  const std::uint64_t dropped = queue_.dropped();
  queue_.drop_data();
  count_dropped(queue_.dropped() - dropped);
}

void Session::count_dropped(std::uint64_t messages) {
  if (messages == 0) return;
  board_.counters.data_dropped += messages;
  if (logged_.insert(Fault::kDrop).second) {
    log::warn("{}: reads too slowly: {} messages wait, old data is dropped", peer_, queue_.waiting());
  }
}

void Session::take(std::vector<net::SharedBytes>& out, std::size_t max_bytes) {
  const std::size_t before = out.size();
  queue_.take(out, max_bytes, board_.clock());
  board_.counters.messages_sent += out.size() - before;
  for (std::size_t i = before; i < out.size(); ++i) board_.counters.bytes_sent += out[i]->size();
}

}  // namespace playhouse::server
