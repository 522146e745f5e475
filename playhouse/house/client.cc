#include "playhouse/house/client.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "playhouse/server/test_client.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/fiducial.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/localize.h"
#include "playhouse/wire/generated/planner.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::house {
namespace {

using wire::MessageType;

constexpr std::size_t kBannerBytes = 32;
constexpr std::uint32_t kIndices = 8;  // of an interface that clients name; fewer exist, at first
/// And of what drivers provide, from there on.
constexpr std::uint32_t kOfDrivers = 40000, kDriverIndices = 2;
constexpr std::size_t kBodyBytes = 64;
constexpr std::uint8_t kPull = 2;    // data mode
constexpr std::uint8_t kGone = 'e';  // access in a notice of a device that has retired
constexpr std::uint16_t kInterfaces[] = {
    wire::position2d::kCode, wire::laser::kCode,    wire::ranger::kCode, wire::fiducial::kCode,
    wire::simulation::kCode, wire::localize::kCode, wire::planner::kCode};
/// Those whose devices publish in every tick.
constexpr std::uint16_t kSteady[] = {wire::position2d::kCode, wire::laser::kCode, wire::ranger::kCode};

}  // namespace

SimulatedClient::SimulatedClient(net::SimulatedNetwork& network, std::uint16_t port, Manner manner,
                                 double period, std::uint64_t seed)
    : peer_(network.connect(port)), manner_(manner), period_(period), random_(seed) {
  if (manner_ != Manner::kPulls) return;
  const Bytes body = wire::encode(wire::player::DeviceDatamodeReq{kPull});
  send(request(wire::player::kCode, 0, wire::player::kReqDatamode, body));
}

Bytes SimulatedClient::any_bytes(std::size_t most) {
  Bytes bytes(draw(static_cast<std::uint32_t>(most + 1)));
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(draw(256));
  return bytes;
}

Bytes SimulatedClient::request(std::uint16_t interf, std::uint16_t index, std::uint8_t subtype,
                               const Bytes& body) {
  const std::uint32_t seq = next_++;
  if (behaves()) asked_.insert({seq, interf, index, subtype});
  return server::message(MessageType::kReq, interf, index, subtype, body, seq);
}

/// Opens and closes of devices, commands, and requests that make sense or none.
Bytes SimulatedClient::any_message() {
  const std::uint16_t interf = kInterfaces[draw(std::size(kInterfaces))];
  std::uint32_t any_index = draw(kIndices + kDriverIndices);
  if (any_index >= kIndices) any_index += kOfDrivers - kIndices;
  const auto index = static_cast<std::uint16_t>(any_index);
  switch (draw(9)) {
    case 0:
    case 1: {
      const auto access = static_cast<std::uint8_t>(1 + draw(3));  // open, close, all
      const wire::player::DeviceReq body{{0, 0, interf, index}, access, ""};
      return request(wire::player::kCode, 0, wire::player::kReqDev, wire::encode(body));
    }
    case 2: {
      const double speed = draw(100) / 100.0, turn = draw(100) / 50.0 - 1;
      return server::message(MessageType::kCmd, wire::position2d::kCode, index, wire::position2d::kCmdVel,
                             wire::encode(wire::position2d::CmdVel{{speed, 0, turn}, 1}));
    }
    case 3: {
      const auto subtype = static_cast<std::uint8_t>(draw(8));
      return server::message(MessageType::kCmd, interf, index, subtype, any_bytes(kBodyBytes));
    }
    case 4: {
      const wire::simulation::Pose2dReq body{wire::c_string("r" + std::to_string(draw(4))),
                                             {draw(8) - 4.0, draw(8) - 4.0, 0}};
      const std::uint8_t subtype =
          draw(2) == 0 ? wire::simulation::kReqGetPose2d : wire::simulation::kReqSetPose2d;
      return request(wire::simulation::kCode, 0, subtype, wire::encode(body));
    }
    case 5: {
      const double x = draw(100) / 10.0 - 5, y = draw(100) / 10.0 - 5;
      return server::message(MessageType::kCmd, wire::planner::kCode, 0, wire::planner::kCmdGoal,
                             wire::encode(wire::planner::Cmd{{x, y, 0}}));
    }
    case 6:
      return request(wire::player::kCode, 0, wire::player::kReqDevlist, {});
    default: {  // compilers differ in the order of arguments, and random numbers must not
      const auto subtype = static_cast<std::uint8_t>(draw(16));
      return request(interf, index, subtype, any_bytes(kBodyBytes));
    }
  }
}

void SimulatedClient::send(Bytes bytes) {
  if (manner_ == Manner::kGarbles && !bytes.empty())
    for (std::uint32_t times = draw(3); times > 0; --times)
      bytes[draw(static_cast<std::uint32_t>(bytes.size()))] = static_cast<std::byte>(draw(256));
  peer_.send(bytes);
}

void SimulatedClient::act() {
  if (over_) return;
  if (manner_ == Manner::kPulls) send(request(wire::player::kCode, 0, wire::player::kReqData, {}));
  if (finishes_) return;
  for (std::uint32_t messages = draw(3); messages > 0; --messages) send(any_message());
  if (manner_ == Manner::kStalls && draw(20) == 0) {
    (stalled_ ? peer_.read_on() : peer_.stall());
    stalled_ = !stalled_;
  }
  if (manner_ == Manner::kVanishes && draw(50) == 0) {
    Bytes part = any_message();
    part.resize(draw(static_cast<std::uint32_t>(part.size())));
    peer_.send(part);
    (draw(2) == 0 ? peer_.vanish() : peer_.reset());
    over_ = true;
  }
}

void SimulatedClient::finish() {
  finishes_ = true;
  if (std::exchange(stalled_, false)) peer_.read_on();
}

void SimulatedClient::leave() {
  if (!std::exchange(over_, true)) peer_.finish();
}

void SimulatedClient::wrong(std::string what) {
  if (behaves() && !fault_) fault_ = std::move(what);
}

void SimulatedClient::excuse_until(double time) {
  excused_until_ = std::max(excused_until_, time);
}

void SimulatedClient::hear(double now) {
  if (over_) return;
  now_ = now;
  const Bytes more = peer_.take();
  heard_.insert(heard_.end(), more.begin(), more.end());
  if (!greeted_) {
    if (heard_.size() < kBannerBytes) return;
    heard_.erase(heard_.begin(), heard_.begin() + kBannerBytes);
    greeted_ = true;
  }
  for (const server::Received& received : server::cut_messages(heard_)) take(received.header, received.body);
  if (!peer_.closed()) return;
  wrong("the server has closed the connection of a client that behaves");
  over_ = true;
}

void SimulatedClient::take(const wire::Header& header, std::span<const std::byte> body) {
  digest_.add(std::uint64_t{header.interf} << 32 | std::uint64_t{header.index} << 16 | header.subtype);
  for (const std::byte byte : body) digest_.add(static_cast<std::uint64_t>(byte));
  if (header.type == MessageType::kData) return look_at_data(header);
  if (header.type == MessageType::kSynch) return;
  if (header.type != MessageType::kAck && header.type != MessageType::kNack)
    return wrong(fmt::format("a client is sent a message of type {}", static_cast<int>(header.type)));
  if (header.interf == wire::player::kCode && header.subtype == wire::player::kReqDev) {
    const auto reply = wire::decode<wire::player::DeviceReq>(body);
    if (reply) data_times_.erase({reply->addr.interf, reply->addr.index});  // opened, closed or gone
    if (reply && reply->access == kGone) return;                            // a notice, which nobody asks for
  }
  answer(header);
}

/// Who gets data as they come gets those of every tick.
void SimulatedClient::look_at_data(const wire::Header& header) {
  const auto [last, is_first] = data_times_.try_emplace({header.interf, header.index}, header.timestamp);
  const double passed = header.timestamp - last->second;
  const bool is_steady =
      header.index < kOfDrivers && std::ranges::find(kSteady, header.interf) != std::end(kSteady);
  if (loses_tick_ && is_steady && manner_ == Manner::kReads && !is_first && now_ >= excused_until_) {
    loses_tick_ = false;
    return;
  }
  const bool is_late = is_steady && passed > 1.5 * period_;
  if (manner_ == Manner::kReads && is_late && now_ >= excused_until_)
    wrong(fmt::format("a client gets data of interface {}:{} of {:.1f} s, and those before of {:.1f} s",
                      header.interf, header.index, header.timestamp, last->second));
  last->second = header.timestamp;
}

void SimulatedClient::answer(const wire::Header& header) {
  if (std::exchange(loses_answer_, false)) return;
  const RequestKey question{header.seq, header.interf, header.index, header.subtype};
  if (asked_.erase(question) == 0)
    return wrong(fmt::format("request {} of interface {}:{}, subtype {} is answered although it is not open",
                             header.seq, header.interf, header.index, header.subtype));
  ++answered_;
}

}  // namespace playhouse::house
