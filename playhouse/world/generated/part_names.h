// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Names of the numbers of records, in the order of each_number(). "(model)" is behind that of a model's id.

#include "playhouse/world/generated/tables.h"

namespace playhouse::world {

template <typename Record>
inline constexpr const char* kPartNames = "";
template <>
inline constexpr const char* kPartNames<FiducialHit> =
    "target(model) id range bearing heading size.x size.y size.z";
template <>
inline constexpr const char* kPartNames<Blob> =
    "color.red color.green color.blue color.alpha channel left right top bottom range";
template <>
inline constexpr const char* kPartNames<WifiLink> =
    "station(model) level quality";
template <>
inline constexpr const char* kPartNames<RadioMessage> =
    "station(model) size";
template <>
inline constexpr const char* kPartNames<Pixel> =
    "sample";
template <>
inline constexpr const char* kPartNames<Echo> =
    "range level";
template <>
inline constexpr const char* kPartNames<Detection> =
    "target(model) number range bearing level bodies";

}  // namespace playhouse::world
