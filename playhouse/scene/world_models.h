#pragma once

/// What one entity of a world file says about itself, without its place in the tree: property by property, in
/// SI units.

#include "playhouse/scene/properties.h"
#include "playhouse/scene/scene_desc.h"
#include "playhouse/scene/vocabulary.h"

namespace playhouse::scene {

/// Fills everything of `model` but its names, parent and body. `row` is the model's row; `interval` the tick
/// [s], which is the shortest update interval.
void read_model(const Properties& properties, const ModelType& type, std::size_t row, double interval,
                ModelDesc& model);

/// Reads a `sensor( ... )` of a ranger.
RangerSensorDesc read_sensor(const Properties& properties, std::size_t row);

/// Reads the `window( ... )` of the file.
WindowDesc read_window(const Properties& properties);

}  // namespace playhouse::scene
