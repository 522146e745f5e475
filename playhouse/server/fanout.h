#pragma once

/// Fanout: publish/subscribe by device: subscribed sessions, and
/// one encoding per message for all of them. Io thread only.

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "playhouse/device/address.h"
#include "playhouse/device/driver.h"
#include "playhouse/server/frame.h"

namespace playhouse::server {

/// A subscriber of devices.
class Subscriber {
 public:
  virtual ~Subscriber() = default;
  /// Its number (device::Publication::clients).
  virtual std::uint32_t serial() const = 0;
  virtual void deliver(const Frame& frame) = 0;
  /// Data for this reader were lost.
  virtual void lose(std::uint64_t messages) = 0;
  /// Whether it gets what is for everybody by the group.
  virtual bool reads_group() const { return false; }
};

/// Carries data at once to all readers that have asked for it so.
class ReaderGroup {
 public:
  virtual ~ReaderGroup() = default;
  /// False: each reader gets the message by itself.
  virtual bool carries(const Frame& frame) const = 0;
  /// `number` counts the messages of its device. One that gets lost is skipped. False: it was not sent.
  virtual bool send(const Frame& frame, std::uint32_t number) = 0;
};

class Fanout {
 public:
  /// `frame_bytes` counts the bytes of encoded frames.
  explicit Fanout(FrameBytes frame_bytes) : frame_bytes_(std::move(frame_bytes)) {}

  /// From now on. `group` must outlive the use of publish().
  void share_by(ReaderGroup& group) { group_ = &group; }

  /// Subscribes a reader once; redundant joins and leaves have no effect.
  void join(device::DeviceId device, Subscriber& reader);
  void leave(device::DeviceId device, Subscriber& reader);
  bool has_readers(device::DeviceId device) const;
  /// Removes the device: its readers and its last timestamps.
  void retire(device::DeviceId device);
  /// Number of devices with state.
  std::size_t size() const { return channels_.size(); }

  /// Encodes the message if it is for readers of the device, and delivers it to the group, if a reader reads it, and in the
  /// order of joining to the others, or to all if the group does not take it. A repeated timestamp is raised by the least step, because
  /// clients take equal ones for old data; a lower one means that time went back,
  /// NaN becomes `now`. Data over limits::kBodyBytes is dropped and logged once.
  /// Returns the number of deliveries.
  std::size_t publish(const device::Publication& publication, device::Address address, double now);

  /// Reports so many lost messages to the readers of a device.
  void lose(device::DeviceId device, std::uint64_t messages);

  std::uint64_t messages_encoded() const { return encoded_; }

 private:
  struct Timestamps {
    double told = 0, sent = 0;
  };
  struct DeviceReaders {
    std::vector<Subscriber*> readers;
    std::map<std::uint8_t, Timestamps> last;  // by subtype
    std::uint32_t number = 0;                 // of the last message that the group carried
  };
  DeviceReaders& readers_of(device::DeviceId device);
  bool is_shared(const DeviceReaders& to, const device::Publication& publication, const Frame& frame) const;
  double next_timestamp(DeviceReaders& channel, const device::Publication& publication, double now);

  const FrameBytes frame_bytes_;
  std::unordered_map<device::DeviceId, DeviceReaders> channels_;
  ReaderGroup* group_ = nullptr;    // null: there is none
  std::uint32_t first_number_ = 0;  // of devices to come: a message of a retired one never overtakes theirs
  std::uint64_t encoded_ = 0;
  bool logged_too_long_ = false;
};

}  // namespace playhouse::server
