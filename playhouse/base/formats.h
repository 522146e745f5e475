#pragma once

/// The numbers of the formats that outlive a program or cross a connection. Each counts by itself, and has
/// nothing to do with the version of the program. A reader takes its own number alone and refuses others by
/// naming both; docs/versions.md says what that means for users. Increase a number with every change after
/// which one side would misread, or not find, what the other one wrote.

#include <cstdint>

namespace playhouse::formats {

/// Saved runs, and the worlds that heads of clusters send (world/saving/saved_run.h): the file, and the state
/// in it. Not for a new or changed column: columns have names, and a state with others is refused by them.
inline constexpr std::uint32_t kSavedRun = 5;
/// What `run --again` and `replay` read of a recording (record/recorder.h). `export` reads every MCAP file.
inline constexpr std::uint32_t kRecording = 2;
/// What Playhouse adds to Player's protocol: notices of retired devices, and properties of `simulation`
/// (docs/wire.md).
inline constexpr std::uint32_t kWireExtensions = 1;
/// The properties by which robots of other machines join (docs/robot-client.md).
inline constexpr std::uint32_t kRobots = 1;
/// Texts and packets of the page (docs/viewer-protocol.md).
inline constexpr std::uint32_t kPage = 4;
/// Observers (replicate/datagrams/datagram.h): the datagrams, and those texts that observers read.
inline constexpr std::uint8_t kObserver = 1;
/// Messages between nodes and the head of a cluster (docs/cluster.md), which also have to be one build.
inline constexpr std::uint32_t kCluster = 3;
/// The memory that a learning program shares, and the requests beside it (docs/gym.md).
inline constexpr std::uint32_t kGym = 1;

}  // namespace playhouse::formats
