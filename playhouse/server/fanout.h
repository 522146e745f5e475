#pragma once

/// Fanout: which sessions read which device, and one encoding of each message for all of them. Io thread
/// only.

#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "playhouse/device/address.h"
#include "playhouse/device/driver.h"
#include "playhouse/server/frame.h"

namespace playhouse::server {

/// Receives published data of devices.
class Reader {
 public:
  virtual ~Reader() = default;
  virtual void deliver(const Frame& frame) = 0;
  /// Data that it should have got are lost.
  virtual void lose(std::uint64_t messages) = 0;
};

class Fanout {
 public:
  /// What it encodes counts in `frame_bytes`.
  explicit Fanout(FrameBytes frame_bytes) : frame_bytes_(std::move(frame_bytes)) {}

  /// A reader joins a device once; joining again and leaving what was not joined do nothing.
  void join(device::DeviceId device, Reader& reader);
  void leave(device::DeviceId device, Reader& reader);
  bool has_readers(device::DeviceId device) const;
  /// Forgets the device: its readers and its last timestamps.
  void retire(device::DeviceId device) { channels_.erase(device); }
  /// Devices that were read or published.
  std::size_t size() const { return channels_.size(); }

  /// Encodes the message if anybody reads the device, and delivers it in the order of joining. A timestamp
  /// that repeats is raised by the least step, because clients take equal ones for old data; a lower one is
  /// that of a time that has gone back, and one that is no number becomes `now`. Data over
  /// limits::kBodyBytes goes to nobody and is logged once.
  void publish(const device::Publication& publication, device::Address address, double now);

  /// Tells the readers of a device that so many messages of it are lost.
  void lose(device::DeviceId device, std::uint64_t messages);

  std::uint64_t messages_encoded() const { return encoded_; }

 private:
  struct Timestamps {
    double told = 0, sent = 0;
  };
  struct Channel {
    std::vector<Reader*> readers;
    std::map<std::uint8_t, Timestamps> last;  // by subtype
  };
  double next_timestamp(Channel& channel, const device::Publication& publication, double now);

  const FrameBytes frame_bytes_;
  std::unordered_map<device::DeviceId, Channel> channels_;
  std::uint64_t encoded_ = 0;
  bool logged_too_long_ = false;
};

}  // namespace playhouse::server
