#pragma once

/// Radio propagation: path loss over distance, by each of the models that a radio may have.
///
/// Source: free space, H. T. Friis 1946: 20 log10(d) + 20 log10(f) - 27.55 dB for metres and MHz; buildings,
///   ITU-R P.1238: 20 log10(f) + plc log10(d) - 28 dB; by the power of the distance, T. S. Rappaport,
///   Wireless Communications: free space for the first metre, then 10 ple log10(d) dB.

#include "playhouse/scene/scene_desc.h"

namespace playhouse::senses {

/// Path loss from a sender at `frequency` [MHz] to this receiver without walls,
/// at least 0. Distances under a centimetre count as one centimetre. [dB]
double path_loss(const scene::WifiDesc& hears, double frequency, double distance);

/// The largest distance at which a sender of this power may be received, without walls and with
/// fading up to six standard deviations in its favour; at most 1e6 m, 0 if nowhere. [dBm, MHz, m]
double farthest_heard(const scene::WifiDesc& hears, double power, double frequency);

/// Link quality by the margin of the level over the receiver's sensitivity; 100 from 30 dB on. [dBm, %]
std::uint32_t link_quality(const scene::WifiDesc& hears, double level);

}  // namespace playhouse::senses
