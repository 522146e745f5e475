#pragma once

/// DataFlow: takes what drivers publish past the drivers that read it, before it goes on to the server. What
/// they make of it joins the same batch, so a conversion adds no delay, and a converter's data reach its own
/// readers in that batch too. Readers are added while drivers are made, each behind those whose data it
/// reads; publish() is for any thread and calls readers there.

#include <cstddef>
#include <span>
#include <vector>

#include "playhouse/device/driver.h"

namespace playhouse::device {

class DataFlow final : public Publisher {
 public:
  class Reader {
   public:
    virtual ~Reader() = default;
    /// What a batch has of the reader's devices, in order, once per batch; never nothing. Appends what
    /// follows from it to `more`, never for a device that a reader before this one reads. Calls for one
    /// device come one after another; for devices of several threads they may overlap.
    virtual void read(std::span<const Publication* const> fresh, std::vector<Publication>& more) = 0;
  };

  /// `reader` reads these devices, and comes after every reader added so far. It outlives what is published.
  void add(Reader& reader, std::span<const DeviceId> devices);
  /// Where everything goes in the end.
  void pass_to(Publisher& next) { next_ = &next; }

  void publish(std::vector<Publication> batch) override;

 private:
  using Rank = std::size_t;  // a reader's place in the order
  std::span<const Rank> readers_of(DeviceId device) const;

  std::vector<Reader*> readers_;             // by rank
  std::vector<std::vector<Rank>> ranks_of_;  // by the device's row
  Publisher* next_ = nullptr;
};

}  // namespace playhouse::device
