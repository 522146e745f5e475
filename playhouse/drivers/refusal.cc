#include "playhouse/drivers/refusal.h"

#include <fmt/format.h>

#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {
namespace {

constexpr std::string_view kRefusal = kRefusalProperties[0].name;

}  // namespace

std::string goal_text(const geom::Pose& X_WT) {
  return fmt::format("({:.3g}, {:.3g})", X_WT.x, X_WT.y);
}

bool keep_refusal(std::string& kept, std::string why) {
  const bool news = !why.empty() && why != kept;
  kept = std::move(why);
  return news;
}

void log_refusal(std::string_view driver, std::string_view why) {
  log::warn("driver {}: {}", driver, why);
}

bool asks_for_refusal(const device::Message& message) {
  if (!may_ask_for_refusal(message.type, message.subtype)) return false;
  const Result<wire::StrpropReq> asked = wire::decode<wire::StrpropReq>(message.body);
  return asked && wire::text(asked->key) == kRefusal;
}

void answer_refusal(std::string_view why, device::Replier replier) {
  replier.ack(wire::encode(wire::StrpropReq{wire::c_string(kRefusal), wire::c_string(why)}));
}

bool may_ask_for_refusal(std::uint8_t type, std::uint8_t subtype) {
  return type == static_cast<std::uint8_t>(wire::MessageType::kReq) && subtype == wire::kReqGetStrprop;
}

void ask_for_refusal(device::DeviceClient& client, std::size_t device,
                     std::function<void(std::string why)> heard) {
  client.ask(device, wire::kReqGetStrprop,
             wire::encode(wire::StrpropReq{wire::c_string(kRefusal), wire::c_string("")}),
             [heard = std::move(heard)](const AnswerBody& body) {
               const std::optional<wire::StrpropReq> told = decoded<wire::StrpropReq>(body);
               heard(told ? std::string(wire::text(told->value)) : std::string());
             });
}

}  // namespace playhouse::drivers
