#pragma once

/// DataFlow: passes published data through drivers that read it, then to the
/// server. Their output joins the same batch, so a conversion adds no delay, and
/// chained converters work within one batch. Readers are added in topological
/// order during construction; publish() is for any thread and calls readers on it.

#include <cstddef>
#include <span>
#include <vector>

#include "playhouse/device/driver.h"
#include "playhouse/device/gate.h"

namespace playhouse::device {

class DataFlow final : public Publisher {
 public:
  class DataReader {
   public:
    virtual ~DataReader() = default;
    /// The reader's share of a batch, in order, non-empty, once per batch. Appends
    /// derived data to `more`, never for a device that an earlier reader reads. Calls
    /// for one device are sequential; for devices of several threads they may overlap.
    virtual void read(std::span<const Publication* const> fresh, std::vector<Publication>& more) = 0;
  };

  /// Subscribes `reader` to these devices, after all readers so far. It must outlive all publishing.
  void add(DataReader& reader, std::span<const DeviceId> devices);
  /// Sets the final destination.
  void pass_to(Publisher& next) { next_ = &next; }
  /// From now on what is published is dropped; waits for what is being published. For the end of the program,
  /// before the destination is destroyed: threads of drivers may still have something to say.
  void close() { gate_.close(); }

  void publish(std::vector<Publication> batch) override;
  void forget() override {
    if (next_ != nullptr) next_->forget();
  }

 private:
  using Rank = std::size_t;  // position of a reader in the order
  std::span<const Rank> readers_of(DeviceId device) const;
  void pass(std::vector<Publication> batch);

  std::vector<DataReader*> readers_;         // by rank
  std::vector<std::vector<Rank>> ranks_of_;  // by the device's row
  Publisher* next_ = nullptr;
  Gate gate_;
};

}  // namespace playhouse::device
