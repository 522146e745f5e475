#pragma once

/// Limits of what comes from outside and of what waits for it, in one place; each part names the modules that
/// heed them, but for app and house, which link everything. tools/limits.py checks names, and values in docs/.

#include <cstddef>
#include <cstdint>

namespace playhouse::limits {

// Wire, facts of the Player protocol; heeded by bridge, device, drivers, server, wire.
inline constexpr std::size_t kHeaderBytes = 40;
inline constexpr std::size_t kBannerBytes = 32;
inline constexpr std::size_t kMessageBytes = 33554432;  // header and body on the wire
inline constexpr std::size_t kBodyBytes = kMessageBytes - kHeaderBytes;
inline constexpr std::size_t kDevices = 4096;        // entries of a device list
inline constexpr std::size_t kDriverNameBytes = 64;  // with the final NUL

// Server; heeded by bridge, device, device_server, drivers, net, run, server, world.
inline constexpr std::size_t kSessions = 16384;
// Of one address that is not this machine's: nobody shuts out all others alone.
inline constexpr std::size_t kSessionsOfHost = 1024;
inline constexpr int kSilentSeconds = 60;  // a client that has not said anything yet is closed then
// Connections that wait for their peers to end: over it the first is closed.
inline constexpr std::size_t kLingering = 4096;
inline constexpr std::size_t kSerialBytes = 16u << 10;  // waiting for a serial line that takes no more
// A session over UDP that says nothing for so long is gone: there is no other sign, where nothing refuses.
inline constexpr int kDatagramSilentSeconds = 600;
// One that has commanded, and to which nothing is sent whose refusal would show that it is gone: what it moves stops.
inline constexpr int kDatagramBlindSeconds = 10;
inline constexpr std::size_t kDatagramSessions =
    4096;  // by UDP, of kSessions: over it the one heard longest ago ends
inline constexpr std::size_t kDatagramMostBytes = 65507;          // of one datagram of UDP over IPv4
inline constexpr std::size_t kDatagramWaitingBytes = 256u << 10;  // received for a session that is busy
inline constexpr std::size_t kSocketMessageBytes = 128u << 10;    // of one message of a WebSocket of a client
inline constexpr std::size_t kSessionQueueMessages = 1024;        // data waiting for one client
inline constexpr std::size_t kSessionQueueBytes = 64u << 20;      // the same in bytes, headers included
inline constexpr std::size_t kSessionRules = 256;                 // replace rules of one client
// Answers one client is owed (docs/server.md); what it says next waits.
inline constexpr std::size_t kSessionAnswers = 1024;
// The same in bytes, of requests that drivers have and of answers.
inline constexpr std::size_t kSessionAnswerBytes = 1u << 20;
inline constexpr std::size_t kTurnMessages = 32;  // of one client, before it is the next one's turn
inline constexpr std::size_t kTurnWork = 256;  // messages and clients, before the sockets are looked at again
inline constexpr std::size_t kTurnDeliveries = 1024;    // messages queued for clients, the same
inline constexpr std::size_t kRequestQueue = 16384;     // requests of all clients waiting for a tick
inline constexpr std::uint32_t kStepTicks = 1u << 20;   // of one step of a world in lock-step
inline constexpr std::uint32_t kSingleSteps = 1000;     // of one that is not: all that wait
inline constexpr std::size_t kInputBytes = 128u << 20;  // of messages of all clients that have not come whole
// Of answers and data of all clients that have not been sent.
inline constexpr std::size_t kOutputBytes = 128u << 20;
// Of these, what each client may have uncounted.
inline constexpr std::size_t kSessionInputBytes = 128u << 10;
// Devices one client may hold open; those that retired unread count.
inline constexpr std::size_t kSubscriptions = 8192;
inline constexpr std::size_t kListedModels = 4096;          // of one answer to "which models are there"
inline constexpr std::size_t kModelListBytes = 256u << 10;  // of its text; one model is always told
inline constexpr std::size_t kOutboxBytes = 64u << 20;      // data the io thread has not taken yet
inline constexpr std::size_t kOutboxMessages = 65536;       // the same in messages
// Of the three above together, as an option divides it: MiB.
inline constexpr std::size_t kClientMiB = (kInputBytes + kOutputBytes + kOutboxBytes) >> 20;
inline constexpr std::size_t kClientMiBLeast = 5, kClientMiBMost = 1u << 20;
// What clients have set of one device of driver "dummy", which remembers it; over it a further set is refused.
inline constexpr std::size_t kDummyBytes = 1u << 20;

// Devices of other servers; heeded by device, drivers.
// Until a device there is open, from the first connection on; the original's clients wait for 5 s.
inline constexpr double kRelaySeconds = 3;
inline constexpr std::size_t kRelayWaiting = 1024;  // opens, requests and commands of one device until then
inline constexpr std::uint32_t kRelayHops = 8;      // servers from a device to where it is made

// Blackboards; heeded by drivers.
// Of one blackboard: a group fits into what waits for one client (kSessionQueueMessages).
inline constexpr std::size_t kBlackboardEntries = 1024;
inline constexpr std::size_t kBlackboardEntryBytes = 32768;   // of its key, its group and its value
inline constexpr std::size_t kBlackboardNameBytes = 256;      // of a key and its group
inline constexpr std::size_t kBlackboardSubscriptions = 256;  // keys and groups of one client

// Viewers, in the browser page; heeded by device_server, net, replicate, web_server.
// Viewers included; over it the one that waited longest is closed.
inline constexpr std::size_t kHttpConnections = 256;
// The same of one address; viewers are not counted.
inline constexpr std::size_t kHttpConnectionsPerAddress = 128;
inline constexpr std::size_t kHttpHeaderBytes = 16384;  // of one request
// Without a request; a viewer that answers no ping is closed then.
inline constexpr int kHttpIdleSeconds = 30;
inline constexpr int kHttpHeadSeconds = 10;    // from the first byte of a request's head to its last
inline constexpr int kHttpAnswerSeconds = 30;  // until a whole answer is taken
inline constexpr std::size_t kViewers = 64;
inline constexpr int kViewerQuietSeconds = 30;  // without an acknowledgement: gives way to one that comes
inline constexpr std::size_t kViewerCommandsPerTurn = 64;  // of one page between two pictures; the rest waits
inline constexpr std::size_t kViewerCommandBytes = 4096;   // of one message from a page
inline constexpr std::size_t kViewerFaults = 16;           // invalid messages before a viewer is closed
inline constexpr std::size_t kViewerTextMessages = 32;     // notices waiting for a page
inline constexpr std::size_t kViewerFrameBytes = 65536;    // the rest of the changes waits for the next frame
inline constexpr std::uint32_t kViewerFramesInFlight = 4;  // sent and not acknowledged
// To one page, unless the program says otherwise.
inline constexpr std::uint32_t kPageBytesPerSecond = 4000000;
inline constexpr std::uint32_t kPageBytesLeast = 4000, kPageBytesMost = 1000000000;  // a second
inline constexpr double kViewerDriveSeconds = 0.5;  // a velocity from a page holds so long unless renewed
inline constexpr std::size_t kSnapshotBeams = 1u << 18;  // of all sensors shown to all viewers

// Observers, clients by datagrams; heeded by observers, replicate, server, web_server.
inline constexpr std::size_t kObservers = 64;        // at once
inline constexpr std::size_t kDatagramBytes = 1200;  // of one, which goes through every network in one piece
// Of IPv4 and UDP in front of it, which the budget counts too.
inline constexpr std::size_t kDatagramHeadBytes = 28;
// To one observer, unless it or the program says otherwise.
inline constexpr std::uint32_t kObserverBytesPerSecond = 64000;
inline constexpr std::uint32_t kObserverBytesLeast = 4000;     // a second; less is not asked for
inline constexpr std::uint32_t kObserverBytesMost = 10000000;  // a second
inline constexpr std::uint32_t kObserverFrames = 30;           // a second, at most
// An observer, or a program, that is not heard of for so long is gone.
inline constexpr int kObserverQuietSeconds = 10;
// Of texts sent to one observer and not acknowledged.
inline constexpr std::size_t kStreamWindowBytes = 65536;
inline constexpr std::size_t kStreamTextBytes = 256u << 20;  // of one text to an observer, unpacked
inline constexpr std::size_t kObserverCommandBytes = 4096;   // of one text from an observer
inline constexpr std::size_t kTokenBytes = 32;      // of a guest's token, as AUTH of Player has room for
inline constexpr std::size_t kTokenBytesLeast = 8;  // of one that a file of guests gives

// The last minutes of a run that somebody watches; heeded by run.
inline constexpr double kHistorySeconds = 600;            // simulated, back from the newest instant
inline constexpr double kHistoryPeriodSeconds = 1;        // simulated, from one instant to the next
inline constexpr std::size_t kHistoryBytes = 128u << 20;  // of all states

// Recordings; heeded by record.
// A chunk that has so many is written, else twice a second.
inline constexpr std::size_t kRecordChunkBytes = 1u << 20;
inline constexpr std::size_t kRecordQueueBytes = 64u << 20;  // waiting for the disk; the run waits then
inline constexpr std::size_t kRecordChannels = 65535;        // of a file; the rest is left out
inline constexpr std::size_t kReadChunkBytes = 256u << 20;   // of a chunk that is read, unpacked
inline constexpr std::size_t kReadRecordBytes = 1u << 30;    // of any other record that is read

// Stage engine; heeded by stage.
inline constexpr unsigned kMotionSteps = 1024;  // collision tests along one robot's way in one tick

// Models; heeded by bridge, custom_kinds, web_server, world.
inline constexpr std::uint32_t kSubscribers = 1u << 30;  // of a model: far more than sessions and viewers
inline constexpr std::size_t kSayBytes = 1024;           // of what a model says; the rest is cut off
inline constexpr std::size_t kDrawnCorners = 16384;      // of what clients draw for a model by one interface
inline constexpr std::size_t kUtterances = 1024;  // kept for who listens; a tick with more loses the oldest
inline constexpr std::size_t kCustomNumbers = 4096;  // commands, state or readings of a custom model

// Messages between radios; heeded by bridge, world.
inline constexpr std::size_t kRadioMessageBytes = 2304;  // of one, as of a frame of IEEE 802.11
inline constexpr std::size_t kRadioSends = 64;           // messages that one radio sends in a tick
inline constexpr std::size_t kRadioReceives = 256;       // messages that one radio receives in a tick

// Plug-ins; heeded by drivers.
inline constexpr double kPluginSeconds = 5;         // of one hook; who takes longer has failed
inline constexpr int kPluginEndSeconds = 2;         // of the last hook, at the end of the program
inline constexpr double kPluginStepSeconds = 1e-3;  // between two steps
inline constexpr std::size_t kPluginQueue = 1024;   // hooks that wait
// Of one in a process of its own, from the start of that to the end of configure().
inline constexpr int kPluginStartSeconds = 15;
inline constexpr std::size_t kPluginLineBytes = 4096;  // of a line that such a process prints or says

// Files; heeded by bodies, bridge, config, controllers, drivers, scene, world.
inline constexpr std::size_t kFileBytes = 64u << 20;
inline constexpr std::size_t kSavedRunBytes = 1u << 30;
inline constexpr int kIncludeDepth = 32;
inline constexpr std::size_t kIncludes = 1u << 16;   // of all include statements, each as often as it is met
inline constexpr std::size_t kWarningsOfAKind = 20;  // of one file; the others are counted
inline constexpr int kEntityDepth = 64;
// After macro expansion; of a world, those that are like no other.
inline constexpr std::size_t kEntities = 1u << 20;
inline constexpr std::size_t kSceneModels = 1u << 21;  // of a world file, however many are alike
inline constexpr std::size_t kModels = 1u << 22;       // alive at a time, with those that came during the run
inline constexpr int kTreeDepth = 128;                 // models inside and attached to each other
inline constexpr std::size_t kExpandedFields = 1u << 27;  // properties of all entities, macros' included
inline constexpr std::size_t kBitmapPixels = 1u << 28;    // of all bitmaps of a world
inline constexpr std::size_t kBitmapBytes = 64u << 20;    // of their files
inline constexpr std::size_t kCorners = 1u << 22;    // of all bodies of a world, bitmaps' contours included
inline constexpr std::size_t kTextBytes = 1u << 27;  // names and texts of all models
inline constexpr std::size_t kBroughtModels = 1u << 14;   // of them, that clients and pages brought in all
inline constexpr std::size_t kBroughtSensors = 1u << 16;  // of those
inline constexpr std::size_t kBroughtBeams = 1u << 22;    // of those
inline constexpr std::size_t kBroughtByOneModels = 1u << 12;   // of those, that one client or page brought
inline constexpr std::size_t kBroughtByOneSensors = 1u << 14;  // of those
inline constexpr std::size_t kBroughtByOneBeams = 1u << 20;    // of those
// Of one client or page, which is what removing and bringing again costs: at once, and a second of the run.
inline constexpr double kBringsAtOnce = 16384, kBringsPerSecond = 1000;
inline constexpr std::size_t kSensors = 1u << 24;  // of all rangers of a world
// Of rangers and bodies, that worlds of Stage 2 tell of by numbered words.
inline constexpr std::size_t kOldParts = 1u << 18;
inline constexpr std::size_t kOldPartsOfOne = 1024;       // the same of one model
inline constexpr std::size_t kGlbBytes = 1u << 30;        // of a world as glTF
inline constexpr std::size_t kPicturePixels = 1u << 26;   // of a world from above
inline constexpr std::size_t kFilmBytes = 1u << 30;       // of a film that is an animated PNG
inline constexpr std::size_t kBrowserMessage = 1u << 29;  // from a browser that draws: a picture is one
inline constexpr int kRangerSamples = 1 << 16;            // beams of one sensor
inline constexpr std::size_t kStereoPixels =
    1000000;                                     // of a camera with two lenses: its data are one message
inline constexpr std::size_t kBeams = 1u << 26;  // of all sensors of a world, and pixels of its cameras

static_assert(kBodyBytes + kHeaderBytes == kMessageBytes);
static_assert(kViewers + kHttpConnectionsPerAddress <= kHttpConnections,
              "viewers alone must not fill the server");
static_assert(kViewers * kViewerCommandsPerTurn * 2 <= kRequestQueue / 2,
              "viewers alone must not fill the queue of all; a command is two entries at most");
static_assert(kBlackboardEntries <= kSessionQueueMessages, "a group must reach who subscribes to it");
static_assert(kSessionAnswers * 8 <= kRequestQueue, "one client alone must not fill the queue of all");

// Clusters; heeded by cluster.
inline constexpr std::size_t kClusterNodes = 255;        // beside the head, and connections that want to join
inline constexpr std::size_t kClusterHelloBytes = 4096;  // of a message of a node that does not take part yet
inline constexpr std::size_t kClusterMessageBytes = 1u << 30;  // of one that does
inline constexpr double kClusterSilentSeconds = 5;             // of a tick, or a hello: then a node is lost
inline constexpr double kClusterBytesPerSecond = 10e6;         // of a slow network: more bytes have more time
inline constexpr std::size_t kClusterWorldBytes = 16u << 20;   // of the world, sent between two ticks
inline constexpr double kClusterQuarantineSeconds = 60;        // of the network of a node that was silent

}  // namespace playhouse::limits
