#pragma once

/// Driver: the code behind devices. The server calls a driver on the io thread and never waits for it; other
/// drivers command it and ask it from any thread (client.h). A driver answers requests through a Replier and
/// sends data through a Publisher, both from any thread.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/address.h"
#include "playhouse/device/caller.h"

namespace playhouse::device {

/// A command or request as it reaches a driver: already checked against its message definition, so `body`
/// decodes.
struct Message {
  DeviceId device;
  std::uint8_t type = 0;  // wire::MessageType
  std::uint8_t subtype = 0;
  std::span<const std::byte> body;  // valid for the call
  Caller* caller = nullptr;         // who says so, until it has gone; none: a driver
};

/// Where answers and data go: the server. Every function may be called from any thread.
class Outlet {
 public:
  virtual ~Outlet() = default;
  virtual void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) = 0;
};

/// One-shot reply handle. Destroyed unused it answers NACK, so no request stays silent.
/// Move-only.
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

/// One message for every subscriber of a device.
struct Publication {
  DeviceId device;
  std::uint8_t subtype = 0;     // of a DATA message
  double timestamp = 0;         // s; one before the last of the device and subtype: time has gone back
  std::vector<std::byte> body;  // encoded once
};

/// Hand-over 2 to 3: what drivers publish. Any thread; a batch wakes the io thread once.
class Publisher {
 public:
  virtual ~Publisher() = default;
  virtual void publish(std::vector<Publication> batch) = 0;
};

/// What became of a command.
enum class Taken : std::uint8_t {
  kNo,      // the device has no such command, or cannot do what it says (the server logs it once)
  kLatest,  // carried out, or kept where a newer one replaces it
  kQueued,  // waits behind other things; barrier() tells when it is carried out
};

class Driver {
 public:
  virtual ~Driver() = default;

  /// The name clients are told ("stage", "rangertolaser", ...), below limits::kDriverNameBytes.
  virtual std::string_view name() const = 0;

  /// Called by the table for the first open, and after the last close of one device or when it retires while
  /// it is open. Must not block. Io thread; all that follows is called on any thread.
  virtual Result<void> start(DeviceId device) = 0;
  virtual void stop(DeviceId device) = 0;

  virtual Taken command(const Message& message) = 0;

  /// Answer now or later, once; returning without keeping the replier means NACK.
  virtual void request(const Message& message, Replier replier) = 0;

  /// True when `request` understands this (type, subtype); answers CAPABILITIES.
  virtual bool capable(DeviceId device, std::uint8_t type, std::uint8_t subtype) const = 0;

  /// Another device has to be asked which messages it understands: CAPABILITIES go to request(), as other
  /// requests do, instead of to capable().
  virtual bool asks_for_capabilities() const { return false; }

  /// A device of this driver has retired, and was stopped if it was open: nothing is asked of it any more,
  /// but by drivers that are not told yet. Io thread. To be overridden by drivers that keep something for
  /// each.
  virtual void forget(DeviceId) {}

  /// Answers once what came before (starts, stops, queued commands) is carried out. The server asks behind
  /// each of them and lets no client get more than limits::kSessionAnswers ahead, so that none fills a queue
  /// which the others need too. To be overridden by drivers that let things wait.
  virtual void barrier(Replier replier) { replier.ack(); }

  /// A device that this driver held has retired, which ended the hold; comes once per hold, on the io thread.
  /// The other driver may be gone after the call. To be overridden by drivers that hold devices.
  virtual void retired(DeviceId) {}
};

}  // namespace playhouse::device
