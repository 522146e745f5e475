#pragma once

/// Client: one client inside the program, by which a driver uses the devices that its section requires. It
/// opens and closes them, subscribes to their data, commands and asks them. Devices are numbered in the order
/// in which the driver named them. Threads: use() and the subscriptions while drivers are made, open() and
/// close() on the io thread, everything else anywhere.

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

/// Opens devices on behalf of drivers. Io thread, or before it runs.
class Opener {
 public:
  virtual ~Opener() = default;
  /// `holder`, if any, hears when the device retires (Driver::retired()), which ends the hold. Fails if the
  /// device cannot start, or has retired.
  virtual Result<void> hold(DeviceId device, Driver* holder) = 0;
  /// Undoes one hold() of the same holder; nothing once the device has retired.
  virtual void release(DeviceId device, Driver* holder) = 0;
};

class Client final : private Outlet, private DataFlow::Reader {
 public:
  /// Called after a batch with news of an open device has reached the subscriptions, on the thread that
  /// publishes. What it appends joins the batch.
  using News = std::function<void(std::vector<Publication>& more)>;
  /// Called once with the answer to a request, on any thread, perhaps before ask() returns; nothing for NACK.
  using Heard = std::function<void(std::optional<std::vector<std::byte>> body)>;

  /// For `devices` devices that `owner` uses. It is told when one of them retires while they are open, and
  /// closes them then. `opener` outlives the client, which outlives the requests that it asks.
  Client(Opener& opener, Driver& owner, std::size_t devices);
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  // While drivers are made.

  /// Keeps the newest message of one kind.
  Subscription& latest(std::size_t device, std::uint8_t subtype);
  /// Keeps up to `limit` messages of every kind.
  Subscription& queue(std::size_t device, std::size_t limit);
  void when_news(News news) { news_ = std::move(news); }
  /// Device number `device` is this one of `driver`. Once for each device.
  void use(std::size_t device, DeviceId id, Driver& driver);
  /// From now on data come from `flow`, after every client that joined before. After every use().
  void join(DataFlow& flow);

  // Io thread.

  /// Opens all devices, or none: the error is that of the first that cannot start. Subscriptions begin empty.
  Result<void> open();
  /// Nothing if they are closed.
  void close();

  // Any thread.

  bool is_open() const { return open_; }
  /// Nothing is taken while the devices are closed.
  Taken command(std::size_t device, std::uint8_t subtype, std::span<const std::byte> body);
  void ask(std::size_t device, std::uint8_t subtype, std::span<const std::byte> body, Heard heard);
  /// Asks on behalf of somebody else, who gets the answer as it is.
  void forward(std::size_t device, std::uint8_t subtype, std::span<const std::byte> body, Replier replier);
  bool capable(std::size_t device, std::uint8_t type, std::uint8_t subtype) const;
  /// Answers once every device has done what it was told.
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
  News news_;
  std::atomic<bool> open_ = false;

  std::mutex mutex_;  // guards what follows
  std::map<std::uint64_t, Heard> asked_;
  std::uint64_t next_ticket_ = 0;
};

}  // namespace playhouse::device
