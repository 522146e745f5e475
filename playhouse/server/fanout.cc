#include "playhouse/server/fanout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"

namespace playhouse::server {

Fanout::Channel& Fanout::channel(device::DeviceId device) {
  PLAYHOUSE_ASSERT(device.valid());
  if (device.row >= channels_.size()) channels_.resize(device.row + 1);
  return channels_[device.row];
}

void Fanout::join(device::DeviceId device, Reader& reader) {
  std::vector<Reader*>& readers = channel(device).readers;
  if (std::find(readers.begin(), readers.end(), &reader) == readers.end()) readers.push_back(&reader);
}

void Fanout::leave(device::DeviceId device, Reader& reader) {
  std::erase(channel(device).readers, &reader);
}

bool Fanout::has_readers(device::DeviceId device) const {
  return device.row < channels_.size() && !channels_[device.row].readers.empty();
}

void Fanout::publish(const device::Publication& publication, device::Address address, double now) {
  Channel& to = channel(publication.device);
  const double timestamp = next_timestamp(to, publication, now);
  if (to.readers.empty()) return;
  if (publication.body.size() > limits::kBodyBytes) {
    if (!std::exchange(logged_too_long_, true)) {
      log::error("data of {} bytes from device {}:{} is over the limit and not sent", publication.body.size(),
                 address.interf, address.index);
    }
    return;
  }
  wire::Header header;
  header.host = wire::kLocalhost;
  header.robot = address.robot;
  header.interf = address.interf;
  header.index = address.index;
  header.type = wire::MessageType::kData;
  header.subtype = publication.subtype;
  header.timestamp = timestamp;
  const Frame frame = counted(make_frame(header, publication.body), frame_bytes_);
  ++encoded_;
  for (Reader* reader : to.readers) reader->deliver(frame);
}

double Fanout::next_timestamp(Channel& channel, const device::Publication& publication, double now) {
  double timestamp = std::isfinite(publication.timestamp) ? publication.timestamp : now;
  const auto [last, first] = channel.last_timestamp.try_emplace(publication.subtype, timestamp);
  if (!first && timestamp <= last->second) {
    timestamp = std::nextafter(last->second, std::numeric_limits<double>::infinity());
  }
  return last->second = timestamp;
}

}  // namespace playhouse::server
