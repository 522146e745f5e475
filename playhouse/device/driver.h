#pragma once

/// Driver: the implementation of devices. The server calls a driver on the io thread and
/// never blocks on it; other drivers send commands and requests from any thread (client.h).
/// A driver replies through a Replier and publishes through a Publisher, both on any thread.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/address.h"
#include "playhouse/device/caller.h"

namespace playhouse::device {

/// A command or request to a driver: validated against
/// its message definition, so `body` can be decoded.
struct Message {
  DeviceId device;
  std::uint8_t type = 0;  // wire::MessageType
  std::uint8_t subtype = 0;
  std::span<const std::byte> body;  // valid during the call
  Caller* caller = nullptr;         // the sender, valid until it disconnects; null: a driver
};

/// Destination of replies: the server. Any thread.
class Outlet {
 public:
  virtual ~Outlet() = default;
  virtual void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) = 0;
};

/// One-shot reply handle. Destroyed unused it replies
/// NACK, so that every request gets a reply. Move-only.
class Replier {
 public:
  Replier(Outlet& outlet, std::uint64_t ticket) : outlet_(&outlet), ticket_(ticket) {}
  Replier(Replier&& other) noexcept : outlet_(other.outlet_), ticket_(other.ticket_) {
    other.outlet_ = nullptr;
  }
  Replier& operator=(Replier&& other) noexcept {
    std::swap(outlet_, other.outlet_);
    std::swap(ticket_, other.ticket_);
    return *this;
  }
  ~Replier() { finish(false, {}); }

  void ack(std::vector<std::byte> body = {}) { finish(true, std::move(body)); }
  void nack(std::vector<std::byte> body = {}) { finish(false, std::move(body)); }

 private:
  void finish(bool positive, std::vector<std::byte> body) {
    if (outlet_) std::exchange(outlet_, nullptr)->answer(ticket_, positive, std::move(body));
  }
  Outlet* outlet_;
  std::uint64_t ticket_;
};

/// A message to the subscribers of a device: all of them, or some.
struct Publication {
  DeviceId device;
  std::uint8_t subtype = 0;     // of a DATA message
  double timestamp = 0;         // s; less than the previous one of this device and subtype: time went back
  std::vector<std::byte> body;  // encoded once
  /// Serial numbers (Caller::serial()) of those who get it, ascending; kDrivers stands for all drivers. Empty:
  /// everybody.
  std::vector<std::uint32_t> clients{};

  bool is_for(std::uint32_t serial) const {
    return clients.empty() || std::ranges::binary_search(clients, serial);
  }
};

/// Receives published data. Any thread; one wake-up of the io thread per batch.
class Publisher {
 public:
  virtual ~Publisher() = default;
  virtual void publish(std::vector<Publication> batch) = 0;
  /// The world's time goes back: what was published and is not sent yet is void.
  virtual void forget() {}
};

/// Outcome of a command.
enum class Taken : std::uint8_t {
  kNo,       // unknown command, or not possible (the server logs it once)
  kRefused,  // not this caller's to give (the server logs it once)
  kLatest,   // executed, or stored where a newer one replaces it
  kQueued,   // queued; barrier() tells when it has been executed
};

class Driver {
 public:
  virtual ~Driver() = default;

  /// Name for clients ("stage", "rangertolaser", ...), below limits::kDriverNameBytes.
  virtual std::string_view name() const = 0;

  /// Called by the table on the first open, and on the last close or when an open
  /// device retires. Must not block. Io thread; the functions below: any thread.
  virtual Result<void> start(DeviceId device) = 0;
  virtual void stop(DeviceId device) = 0;

  virtual Taken command(const Message& message) = 0;

  /// Reply once, now or later; dropping the replier means NACK.
  virtual void request(const Message& message, Replier replier) = 0;

  /// True if start() has what it needs, as of other servers. Io thread, like prepare(). Override both in drivers
  /// whose devices others provide, or whose hardware takes its time.
  virtual bool ready(DeviceId) const { return true; }
  /// Outcome of prepare(), with the reason.
  using Prepared = std::function<void(const Result<void>&)>;
  /// Gets it, within limits::kRelaySeconds (hardware: some seconds): `heard` is called once, on the io
  /// thread, maybe at once. It stays for a moment, so that whoever asked can start the device.
  virtual void prepare(DeviceId, Prepared heard) { heard({}); }

  /// True if `request` supports this (type, subtype); for CAPABILITIES.
  virtual bool capable(DeviceId device, std::uint8_t type, std::uint8_t subtype) const = 0;

  /// True if capabilities depend on another device: CAPABILITIES
  /// requests go to request() instead of capable().
  virtual bool asks_for_capabilities() const { return false; }

  /// A device of this driver has retired, and was stopped if it
  /// was open: no more messages, except from drivers that are not
  /// notified yet. Io thread. Override to free per-device state.
  virtual void forget(DeviceId) {}

  /// Replies once earlier messages (starts, stops, queued commands) have been executed. The
  /// server sends one after each of them and lets no client get more than limits::kSessionAnswers
  /// ahead, so that no client fills a queue shared with others. Override in drivers that queue.
  virtual void barrier(Replier replier) { replier.ack(); }

  /// The program ends: called once, after the last stop, while the server and all drivers exist. Override in
  /// drivers whose threads are to end what they have begun; may take a few seconds.
  virtual void finish() {}

  /// A held device has retired, which ended the hold; called once per hold, on the io thread.
  /// Its driver may be destroyed after the call. Override in drivers that hold devices.
  virtual void retired(DeviceId) {}
};

}  // namespace playhouse::device
