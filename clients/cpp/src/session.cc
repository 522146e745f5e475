#include "session.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/player.h"

namespace playhouse::client {

namespace {

/// Time limit of close() for the server to read what was sent.
constexpr Seconds kCloseTime{1.0};

/// Seconds since the Unix epoch: the time base of client headers.
double now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Access code of an unsolicited response to DeviceReq: the device was retired. (Failed openings use
/// kErrorMode.)
constexpr std::uint8_t kErrorLetter = 'e';

bool is_answer(const wire::Header& header) {
  return header.type == wire::MessageType::kAck || header.type == wire::MessageType::kNack;
}

void keep(Slot& slot, const std::vector<std::byte>& body) {
  if (slot.kept.size() == slot.kept_limit) slot.kept.pop_front();
  slot.kept.push_back(body);
}

void forget_data(Slot& slot) {
  slot.latest.clear();
  slot.kept.clear();
  slot.timestamp = 0;
  slot.fresh = false;
}

}  // namespace

Result<void> Session::set_mode(Mode mode) {
  wire::player::DeviceDatamodeReq body;
  body.mode = static_cast<std::uint8_t>(mode);
  const auto answer = request(wire::player::kCode, 0, wire::player::kReqDatamode, wire::encode(body));
  if (!answer) return answer.error();
  mode_ = mode;
  return {};
}

Result<void> Session::send(const wire::Header& address, std::span<const std::byte> body) {
  wire::Header header = address;
  header.timestamp = now();
  // As in libplayerc: the port for messages to a device, 0 for messages to the server.
  header.robot = header.interf == wire::player::kCode ? 0u : connection_.port();
  return connection_.send(header, body, deadline_after(timeout_));
}

Result<std::vector<std::byte>> Session::request(std::uint16_t interf, std::uint16_t index,
                                                std::uint8_t subtype, std::span<const std::byte> body) {
  return request(interf, index, subtype, body, deadline_after(timeout_));
}

Result<std::vector<std::byte>> Session::request(std::uint16_t interf, std::uint16_t index,
                                                std::uint8_t subtype, std::span<const std::byte> body,
                                                Deadline deadline) {
  Result<Message> answer = exchange(interf, index, subtype, body, deadline);
  if (!answer) return answer.error();
  if (answer->header.type == wire::MessageType::kNack) return refusal({interf, index, subtype}, *answer);
  return std::move(answer->body);
}

/// Whoever is not admitted gets NACK without a body, also where a refusal has one.
Error Session::refusal(const Key& key, const Message& answer) const {
  const bool is_for_all = key.interf == wire::player::kCode &&
                          (key.subtype == wire::player::kReqDevlist || key.subtype == wire::player::kReqDev);
  const char* const hint =
      is_for_all && answer.body.empty() && !has_token_ ? "; it may need a token (docs/guests.md)" : "";
  return Error{connection_.peer(), "refused: " + describe(key) + hint};
}

Result<std::optional<std::vector<std::byte>>> Session::ask(std::uint16_t interf, std::uint16_t index,
                                                           std::uint8_t subtype,
                                                           std::span<const std::byte> body,
                                                           Deadline deadline) {
  Result<Message> came = exchange(interf, index, subtype, body, deadline);
  if (!came) return came.error();
  if (came->header.type == wire::MessageType::kNack) return std::optional<std::vector<std::byte>>();
  return std::optional(std::move(came->body));
}

Result<Message> Session::exchange(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                                  std::span<const std::byte> body, Deadline deadline) {
  wire::Header header;
  header.interf = interf;
  header.index = index;
  header.type = wire::MessageType::kReq;
  header.subtype = subtype;
  header.seq = sequence_;
  if (const Result<void> sent = send(header, body); !sent) return sent.error();
  return answer({interf, index, subtype}, deadline);
}

/// Waits for the answer to the newest request, identified by its key.
Result<Message> Session::answer(const Key& key, Deadline deadline) {
  bool settled = false;
  for (;;) {
    Result<std::optional<Message>> got = connection_.receive(deadline);
    if (!got) return got.error();
    if (!*got) break;
    Message& message = **got;
    if (take_notice(message)) continue;
    const Match whose = match(message.header, key);
    if (whose == Match::kOurs) return std::move(message);
    if (whose == Match::kOther) {
      sort(std::move(message));
      continue;
    }
    ++skipped_count_;
    const auto old = std::find(abandoned_.begin(), abandoned_.end(), key);
    if (old != abandoned_.end()) {
      abandoned_.erase(old);
      settled = true;
    }
  }
  // After a timeout, requests are numbered, so that a late answer is not mistaken for that of a newer
  // request. If the answer to an abandoned request of this kind arrived meanwhile, the counts balance.
  ++sequence_;
  if (!settled) abandoned_.push_back(key);
  return Error{connection_.peer(), "no answer in time: " + describe(key)};
}

Session::Match Session::match(const wire::Header& header, const Key& key) const {
  if (!is_answer(header) || key != Key{header.interf, header.index, header.subtype}) return Match::kOther;
  if (header.seq == sequence_ && sequence_ != 0) return Match::kOurs;
  // 0: the number of the requests before the first timeout, and of servers that do not echo numbers.
  return header.seq == 0 && !is_abandoned(key) ? Match::kOurs : Match::kLate;
}

bool Session::is_abandoned(const Key& key) const {
  return std::find(abandoned_.begin(), abandoned_.end(), key) != abandoned_.end();
}

/// Files a message that is no answer: notice, data to queue, or skipped.
void Session::sort(Message message) {
  if (take_notice(message)) return;
  if (message.header.type == wire::MessageType::kData) {
    if (waiting_.size() == kWaitingMessages) {
      waiting_.pop_front();
      ++overflow_count_;
      ++unread_count_;
    }
    waiting_.push_back(std::move(message));
  } else if (message.header.type == wire::MessageType::kSynch) {
    end_round(message);
  } else {
    ++skipped_count_;
  }
}

/// Handles the notice that a device was retired by marking its slots; false for any other message.
bool Session::take_notice(const Message& message) {
  const wire::Header& header = message.header;
  if (header.type != wire::MessageType::kAck || header.interf != wire::player::kCode) return false;
  if (header.subtype != wire::player::kReqDev) return false;
  const auto notice = wire::decode<wire::player::DeviceReq>(message.body);
  if (!notice || notice->access != kErrorLetter) return false;
  const DeviceAddress address{notice->addr.robot, notice->addr.interf, notice->addr.index};
  for (Slot* slot : slots_) {
    if (slot->interf != address.interf || slot->index != address.index || !slot->gone.empty()) continue;
    slot->gone = std::to_string(address.port) + ":" + address.name() + " is gone: the server retired it";
  }
  told_ = true;
  return true;
}

void Session::end_round(const Message& message) {
  round_open_ = false;
  round_waits_ = !waiting_.empty();
  if (message.header.subtype != wire::player::kSynchOverflow) return;
  const Result<wire::Uint32> lost = wire::decode<wire::Uint32>(message.body);
  overflow_count_ += lost ? std::max(lost->value, 1u) : 1u;
}

/// Receives and files one message; false on timeout.
Result<bool> Session::sort_next(Deadline deadline) {
  Result<std::optional<Message>> got = connection_.receive(deadline);
  if (!got) return got.error();
  if (*got) sort(std::move(**got));
  return got->has_value();
}

Result<std::size_t> Session::read(Seconds patience) {
  if (reading_)
    return Error{connection_.peer(), "read() was called from a callback that read() itself is running"};
  reading_ = true;
  told_ = false;
  const Deadline deadline = deadline_after(patience);
  Result<std::size_t> delivered = mode_ == Mode::kPull ? read_round(deadline) : read_pushed(deadline);
  reading_ = false;
  return delivered;
}

Result<std::size_t> Session::read_round(Deadline deadline) {
  const bool here = std::exchange(round_waits_, false) && !waiting_.empty();
  std::size_t delivered = deliver();
  if (!round_open_ && !here) {
    round_open_ = true;  // the server counts the request even if its answer is lost
    const auto begun = request(wire::player::kCode, 0, wire::player::kReqData, {}, deadline);
    if (!begun && (!connection_.is_open() || Clock::now() < deadline)) return begun.error();
    delivered += deliver();
  }
  while (round_open_ && !(told_ && delivered == 0)) {
    const Result<bool> more = sort_next(deadline);
    if (!more) return more.error();
    delivered += deliver();
    if (!*more) break;
  }
  return delivered;
}

Result<std::size_t> Session::read_pushed(Deadline deadline) {
  std::size_t delivered = deliver();
  while ((delivered == 0 && !told_) || connection_.has_message()) {
    const Result<bool> more = sort_next(deadline);
    if (!more) return more.error();
    if (!*more) break;
    delivered += deliver();
  }
  return delivered;
}

void Session::deliver_pushed() {
  if (mode_ != Mode::kPush || reading_) return;
  reading_ = true;
  deliver();
  reading_ = false;
}

/// Dispatches the queued data; returns the number of messages that reached a device.
std::size_t Session::deliver() {
  std::size_t count = 0;
  while (!waiting_.empty()) {
    const Message message = std::move(waiting_.front());
    waiting_.pop_front();
    if (deliver_one(message)) {
      ++count;
    } else {
      ++skipped_count_;
    }
  }
  return count;
}

bool Session::deliver_one(const Message& message) {
  const wire::Header& header = message.header;
  const wire::MessageDef* row = wire::find_message(header.interf, wire::MessageType::kData, header.subtype);
  if (row == nullptr || !row->check(message.body).empty()) return false;
  if (goes_back(header)) forget_later(header.timestamp);  // another client restarted or rewound the run
  bool taken = false;
  const bool is_open = has_open(header.interf, header.index);  // else: last data of a retired device
  const std::vector<Slot*> slots = slots_;                     // a callback may open and close devices
  for (Slot* slot : slots) {
    if (std::find(slots_.begin(), slots_.end(), slot) == slots_.end()) continue;
    if (slot->interf != header.interf || slot->index != header.index) continue;
    if (is_open && !slot->gone.empty()) continue;
    slot->latest[header.subtype] = {message.body, header.timestamp};
    if (slot->kept_limit > 0) keep(*slot, message.body);
    slot->timestamp = header.timestamp;
    slot->fresh = true;
    taken = true;
    const Device::OnData on_data = slot->on_data;
    if (on_data) on_data(header.subtype, message.body, header.timestamp);
  }
  return taken;
}

/// Whether data are earlier than the last of their device and kind: the simulated time went back.
bool Session::goes_back(const wire::Header& header) const {
  return std::ranges::any_of(slots_, [&](const Slot* slot) {
    if (slot->interf != header.interf || slot->index != header.index) return false;
    const auto last = slot->latest.find(header.subtype);
    return last != slot->latest.end() && header.timestamp < last->second.timestamp;
  });
}

/// Drops the data of devices whose last are later: of a run that is over when time goes back.
void Session::forget_later(double timestamp) {
  for (Slot* slot : slots_) {
    if (slot->timestamp > timestamp) forget_data(*slot);
  }
}

void Session::forget_run() {
  waiting_.clear();
  forget_later(-std::numeric_limits<double>::infinity());
}

void Session::add(Slot& slot) {
  const bool replaces = std::ranges::any_of(slots_, [&](const Slot* old) {
    return old->interf == slot.interf && old->index == slot.index && !old->gone.empty();
  });
  if (replaces) drop_waiting(slot.interf, slot.index);
  slots_.push_back(&slot);
}

void Session::remove(Slot& slot) {
  std::erase(slots_, &slot);
  if (!slot.gone.empty() && !has_open(slot.interf, slot.index)) drop_waiting(slot.interf, slot.index);
}

/// Data of a closed device must not reach the next one opened at its address.
void Session::drop_waiting(std::uint16_t interf, std::uint16_t index) {
  skipped_count_ += std::erase_if(waiting_, [=](const Message& message) {
    return message.header.interf == interf && message.header.index == index;
  });
}

bool Session::has_open(std::uint16_t interf, std::uint16_t index) const {
  return std::ranges::any_of(slots_, [=](const Slot* slot) {
    return slot->interf == interf && slot->index == index && slot->gone.empty();
  });
}

void Session::close() {
  connection_.close(deadline_after(kCloseTime));
}

std::string Session::describe(const Key& key) const {
  const wire::MessageDef* row = wire::find_message(key.interf, wire::MessageType::kReq, key.subtype);
  const std::string name = row != nullptr ? std::string(row->name) : "request " + std::to_string(key.subtype);
  return name + " to " + DeviceAddress{0, key.interf, key.index}.name();
}

}  // namespace playhouse::client
