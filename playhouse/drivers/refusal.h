#pragma once

/// The string property "refusal" of devices to which goals are sent: why the driver does not drive to the
/// goal that it was given last. Empty while it drives there, once it has arrived, and without a goal. The
/// text is that of the driver's line in the log.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "playhouse/device/client.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

inline constexpr PropertyText kRefusalProperties[] = {
    {"refusal", "string",
     "Why the driver does not drive to the goal that it was given last; empty while it does."}};

/// Of a goal that drivers cannot compute with (is_usable() of decoded.h).
inline constexpr std::string_view kUnusableGoal = "invalid goal: a pose within 1e9 m and 1e9 rad is valid";
inline constexpr std::string_view kDisabled = "it is disabled: ENABLE 1 lets it drive on";

/// "(1.5, -2)".
std::string goal_text(const geom::Pose& X_WT);

/// Keeps a refusal, or none if it is empty; true if it is to be logged: another one than before.
bool keep_refusal(std::string& kept, std::string why);
void log_refusal(std::string_view driver, std::string_view why);

/// True if a request asks for the property.
bool asks_for_refusal(const device::Message& message);
void answer_refusal(std::string_view why, device::Replier replier);
/// As Driver::capable().
bool may_ask_for_refusal(std::uint8_t type, std::uint8_t subtype);

/// Asks a device of a client; empty if it has no such property. Calls as Client::ask() does.
void ask_for_refusal(device::DeviceClient& client, std::size_t device,
                     std::function<void(std::string why)> heard);

}  // namespace playhouse::drivers
