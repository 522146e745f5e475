#pragma once

/// Tap: lets drivers read what other drivers publish, before it goes on to the server. What they make of it
/// joins the same batch, so a conversion adds no delay. Readers are added before anything is published;
/// publish() is called on the publishing driver's thread.

#include <span>
#include <vector>

#include "playhouse/device/driver.h"

namespace playhouse::drivers {

class Tap final : public device::Publisher {
 public:
  class Reader {
   public:
    virtual ~Reader() = default;
    /// Appends what follows from the batch to `more`.
    virtual void read(std::span<const device::Publication> batch, std::vector<device::Publication>& more) = 0;
  };

  void add_reader(Reader& reader) { readers_.push_back(&reader); }
  /// Where everything goes in the end.
  void pass_to(device::Publisher& next) { next_ = &next; }

  void publish(std::vector<device::Publication> batch) override {
    const std::size_t size = batch.size();
    std::vector<device::Publication> more;
    for (Reader* reader : readers_) reader->read({batch.data(), size}, more);
    for (device::Publication& publication : more) batch.push_back(std::move(publication));
    if (next_ != nullptr) next_->publish(std::move(batch));
  }

 private:
  std::vector<Reader*> readers_;
  device::Publisher* next_ = nullptr;
};

}  // namespace playhouse::drivers
