#pragma once

/// DeviceClient: an in-process client, through which a driver uses the devices that its section
/// requires: opens and closes them, subscribes to data, sends commands and requests. Devices are
/// numbered in the order in which the driver named them. Threads: use() and subscriptions during
/// construction of drivers, open() and close() on the io thread, everything else on any thread.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/data_flow.h"
#include "playhouse/device/driver.h"
#include "playhouse/device/subscription.h"

namespace playhouse::device {

/// Opens devices for drivers. Io thread, or before it runs.
class Opener {
 public:
  virtual ~Opener() = default;
  /// `holder`, if given, is notified when the device retires (Driver::retired()),
  /// which ends the hold. Fails if the device cannot start, or has retired.
  virtual Result<void> hold(DeviceId device, Driver* holder) = 0;
  /// Undoes one hold() of the same holder; no effect once the device has retired.
  virtual void release(DeviceId device, Driver* holder) = 0;
};

class DeviceClient final : private Outlet, private DataFlow::DataReader {
 public:
  /// Called when a batch with data for the subscriptions has been
  /// delivered, on the publishing thread. Appended messages join the batch.
  using News = std::function<void(std::vector<Publication>& more)>;
  /// Called once with the reply, on any thread, maybe before ask() returns; none for NACK.
  using Heard = std::function<void(std::optional<std::vector<std::byte>> body)>;

  /// For `devices` devices used by `owner`, which is notified when one of them retires while open,
  /// and closes them then. `opener` must outlive the client, and the client its pending requests.
  DeviceClient(Opener& opener, Driver& owner, std::size_t devices);
  DeviceClient(const DeviceClient&) = delete;
  DeviceClient& operator=(const DeviceClient&) = delete;

  // During construction of drivers.

  /// Subscribes to the latest message of one subtype.
  Subscription& latest(std::size_t device, std::uint8_t subtype);
  /// Subscribes to all messages, with a queue of `limit`.
  Subscription& queue(std::size_t device, std::size_t limit);
  void when_news(News news) { news_ = std::move(news); }
  /// Binds number `device` to a device of `driver`. Once for each. Several may be one device, which is held
  /// and read once.
  void use(std::size_t device, DeviceId id, Driver& driver);
  /// Receives data from `flow`, after all clients that joined earlier. After all use() calls.
  void join(DataFlow& flow);

  // Io thread.

  /// True if all devices are (Driver::ready()).
  bool ready() const;
  /// Prepares those that are not (Driver::prepare()), with the first error.
  void prepare(Driver::Prepared heard);
  /// Atomic: opens all devices or none, with the first error. Subscriptions start empty.
  Result<void> open();
  /// No effect if closed.
  void close();

  // Any thread.

  bool is_open() const { return open_; }
  /// kNo while the devices are closed.
  Taken command(std::size_t device, std::uint8_t subtype, std::span<const std::byte> body);
  void ask(std::size_t device, std::uint8_t subtype, std::span<const std::byte> body, Heard heard);
  /// Forwards a request of another client; the reply is passed through.
  void forward(std::size_t device, std::uint8_t subtype, std::span<const std::byte> body, Replier replier);
  bool capable(std::size_t device, std::uint8_t type, std::uint8_t subtype) const;
  /// Replies once all devices have executed earlier messages.
  void barrier(Replier replier);

 private:
  struct Used {
    DeviceId id;
    Driver* driver = nullptr;
    std::vector<std::unique_ptr<Subscription>> subscriptions;
  };
  Replier replier_for(Heard heard);
  void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) override;
  void read(std::span<const Publication* const> fresh, std::vector<Publication>& more) override;

  Opener& opener_;
  Driver& owner_;
  std::vector<Used> used_;
  std::vector<DeviceId> held_;  // theirs, each once
  News news_;
  std::atomic<bool> open_ = false;

  std::mutex mutex_;  // guards what follows
  std::map<std::uint64_t, Heard> asked_;
  std::uint64_t next_ticket_ = 0;
};

}  // namespace playhouse::device
