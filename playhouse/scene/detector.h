#pragma once

/// Detectors: what their words have to be besides each for itself.

#include <cstddef>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

class Properties;

/// Along how many lines it looks.
std::size_t lines_of(const DetectorDesc& detector);

/// Conditions that cannot be read are faults.
void check_detector(const Properties& properties, const DetectorDesc& detector);

}  // namespace playhouse::scene
