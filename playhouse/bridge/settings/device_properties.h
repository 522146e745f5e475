#pragma once

/// Named properties of any simulated device: its settings (settings.h), which can be set, the model's `name` and
/// `model`, its type, as interface simulation has them, and the words that the world file says of the model
/// (docs/kinds), which cannot be set.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "playhouse/bridge/simulated/simulated_device.h"

namespace playhouse::drivers {

/// True for GET_ and SET_ of INTPROP, DBLPROP, STRPROP and BOOLPROP.
bool is_property_request(std::uint8_t type, std::uint8_t subtype);

/// Answers such a request on the tick thread: NACK for an unknown name, another type than that of the property,
/// and a value that it cannot have.
void answer_property_request(const std::shared_ptr<SimulatedDevice>& device, const device::Message& message,
                             device::Replier replier);

/// The value of a word of the model's kind, in the syntax and units of its world file, without the quotes of a
/// text; none if models of its kind have no such word.
std::optional<std::string> word_of(const world::World& world, world::ModelRow model, std::string_view word);

}  // namespace playhouse::drivers
