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
};

class Fanout {
 public:
  /// `frame_bytes` counts the bytes of encoded frames.
  explicit Fanout(FrameBytes frame_bytes) : frame_bytes_(std::move(frame_bytes)) {}

  /// Subscribes a reader once; redundant joins and leaves have no effect.
  void join(device::DeviceId device, Subscriber& reader);
  void leave(device::DeviceId device, Subscriber& reader);
  bool has_readers(device::DeviceId device) const;
  /// Removes the device: its readers and its last timestamps.
  void retire(device::DeviceId device) { channels_.erase(device); }
  /// Number of devices with state.
  std::size_t size() const { return channels_.size(); }

  /// Encodes the message if it is for readers of the device, and delivers it in the order
  /// of joining. A repeated timestamp is raised by the least step, because
  /// clients take equal ones for old data; a lower one means that time went back,
  /// NaN becomes `now`. Data over limits::kBodyBytes is dropped and logged once.
  /// Returns the number of readers it was delivered to.
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
  };
  double next_timestamp(DeviceReaders& channel, const device::Publication& publication, double now);

  const FrameBytes frame_bytes_;
  std::unordered_map<device::DeviceId, DeviceReaders> channels_;
  std::uint64_t encoded_ = 0;
  bool logged_too_long_ = false;
};

}  // namespace playhouse::server
