#pragma once

/// Checks of detector descriptions across words.

#include <cstddef>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

class Properties;

/// Number of lines that it traces.
std::size_t lines_of(const DetectorDesc& detector);

/// Reports invalid conditions as errors.
void check_detector(const Properties& properties, const DetectorDesc& detector);

}  // namespace playhouse::scene
