#include "playhouse/device/data_flow.h"

#include <map>
#include <utility>

#include "playhouse/base/assert.h"

namespace playhouse::device {

void DataFlow::add(DataReader& reader, std::span<const DeviceId> devices) {
  for (const DeviceId device : devices) {
    if (device.row >= ranks_of_.size()) ranks_of_.resize(device.row + 1);
    ranks_of_[device.row].push_back(readers_.size());
  }
  readers_.push_back(&reader);
}

std::span<const DataFlow::Rank> DataFlow::readers_of(DeviceId device) const {
  if (device.row >= ranks_of_.size()) return {};
  return ranks_of_[device.row];
}

void DataFlow::publish(std::vector<Publication> batch) {
  gate_.pass([&] { pass(std::move(batch)); });
}

void DataFlow::pass(std::vector<Publication> batch) {
  std::map<Rank, std::vector<std::size_t>> due;  // batch indices for each reader
  const auto note = [&](std::size_t place) {
    if (!batch[place].is_for(kDrivers)) return;
    for (const Rank rank : readers_of(batch[place].device)) due[rank].push_back(place);
  };
  for (std::size_t place = 0; place < batch.size(); ++place) note(place);

  std::vector<const Publication*> fresh;
  std::vector<Publication> more;
  while (!due.empty()) {
    const auto [rank, places] = std::move(*due.begin());
    due.erase(due.begin());
    fresh.clear();
    for (const std::size_t place : places) fresh.push_back(&batch[place]);
    readers_[rank]->read(fresh, more);
    for (Publication& publication : std::exchange(more, {})) {
      batch.push_back(std::move(publication));
      note(batch.size() - 1);
    }
    PLAYHOUSE_ASSERT(due.empty() || due.begin()->first > rank);  // otherwise a cycle
  }
  if (next_ != nullptr) next_->publish(std::move(batch));
}

}  // namespace playhouse::device
