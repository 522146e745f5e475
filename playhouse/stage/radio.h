#pragma once

/// Radio waves: how much weaker they are at a distance, by each of the models that a radio may have.
///
/// Source: free space, H. T. Friis 1946: 20 log10(d) + 20 log10(f) - 27.55 dB for metres and MHz; buildings,
///   ITU-R P.1238: 20 log10(f) + plc log10(d) - 28 dB; by the power of the distance, T. S. Rappaport,
///   Wireless Communications: free space for the first metre, then 10 ple log10(d) dB.

#include "playhouse/scene/scene_desc.h"

namespace playhouse::stage {

/// What is lost between a radio that sends at `frequency` [MHz] and one that hears, without walls; not below
/// 0. Of two in one place, what is lost over a centimetre. [dB]
double path_loss(const scene::WifiDesc& hears, double frequency, double distance);

/// The largest distance at which what is sent so strongly may be heard, without walls and with `fading` dB
/// more than is said; 1e6 m where it is farther. [dBm, MHz, m]
double farthest_heard(const scene::WifiDesc& hears, double power, double frequency);

/// How far something of this level is above what is heard: 100 from 30 dB on. [dBm, %]
std::uint32_t link_quality(const scene::WifiDesc& hears, double level);

}  // namespace playhouse::stage
