#pragma once

/// The simulator's list of models: asked for, and read from its text.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse_client/model.h"

namespace playhouse::client {

class Session;

/// Appends the models of one answer. `text` is from outside.
Result<void> read_model_list(std::string_view text, std::vector<Model>& models);

/// Asks a simulation device, which must be open, for all models; none if it refuses.
Result<std::optional<std::vector<Model>>> ask_models(Session& session, std::uint16_t simulation);

/// The place in the list of the model at the top that carries model `row`, or is it.
std::size_t top_of(const std::vector<Model>& models, std::size_t row);

}  // namespace playhouse::client
