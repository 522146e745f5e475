#include "playhouse/server/fanout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"

namespace playhouse::server {

void Fanout::join(device::DeviceId device, Subscriber& reader) {
  std::vector<Subscriber*>& readers = readers_of(device).readers;
  if (std::find(readers.begin(), readers.end(), &reader) == readers.end()) readers.push_back(&reader);
}

void Fanout::leave(device::DeviceId device, Subscriber& reader) {
  if (const auto found = channels_.find(device); found != channels_.end())
    std::erase(found->second.readers, &reader);
}

bool Fanout::has_readers(device::DeviceId device) const {
  const auto found = channels_.find(device);
  return found != channels_.end() && !found->second.readers.empty();
}

std::size_t Fanout::publish(const device::Publication& publication, device::Address address, double now) {
  DeviceReaders& to = readers_of(publication.device);
  const double timestamp = next_timestamp(to, publication, now);
  const auto is_for = [&](const Subscriber* reader) { return publication.is_for(reader->serial()); };
  if (std::ranges::none_of(to.readers, is_for)) return 0;
  if (publication.body.size() > limits::kBodyBytes) {
    if (!std::exchange(logged_too_long_, true)) {
      log::error("data of {} bytes from device {}:{} is over the limit and not sent", publication.body.size(),
                 address.interf, address.index);
    }
    return 0;
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
  const bool shared = is_shared(to, publication, frame) && group_->send(frame, to.number + 1);
  if (shared) ++to.number;
  std::size_t deliveries = shared ? 1 : 0;
  for (Subscriber* reader : to.readers) {
    if (!is_for(reader) || (shared && reader->reads_group())) continue;
    reader->deliver(frame);
    ++deliveries;
  }
  return deliveries;
}

/// Data for some readers alone are not for a group.
bool Fanout::is_shared(const DeviceReaders& to, const device::Publication& publication,
                       const Frame& frame) const {
  return group_ != nullptr && publication.clients.empty() && group_->carries(frame) &&
         std::ranges::any_of(to.readers, &Subscriber::reads_group);
}

Fanout::DeviceReaders& Fanout::readers_of(device::DeviceId device) {
  const auto [entry, first] = channels_.try_emplace(device);
  if (first) entry->second.number = first_number_;
  return entry->second;
}

void Fanout::retire(device::DeviceId device) {
  const auto found = channels_.find(device);
  if (found == channels_.end()) return;
  first_number_ = std::max(first_number_, found->second.number);
  channels_.erase(found);
}

void Fanout::lose(device::DeviceId device, std::uint64_t messages) {
  const auto found = channels_.find(device);
  if (found == channels_.end()) return;
  for (Subscriber* reader : found->second.readers) reader->lose(messages);
}

double Fanout::next_timestamp(DeviceReaders& channel, const device::Publication& publication, double now) {
  const double told = std::isfinite(publication.timestamp) ? publication.timestamp : now;
  const auto [entry, first] = channel.last.try_emplace(publication.subtype, Timestamps{told, told});
  Timestamps& last = entry->second;
  if (first) return told;
  const bool went_back = told < last.told;
  last.told = told;
  if (went_back || told > last.sent) return last.sent = told;
  return last.sent = std::nextafter(last.sent, std::numeric_limits<double>::infinity());
}

}  // namespace playhouse::server
