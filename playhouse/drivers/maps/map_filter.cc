#include "playhouse/drivers/maps/map_filter.h"

#include "playhouse/base/log.h"
#include "playhouse/drivers/grid_map/map_reader.h"

namespace playhouse::drivers {

namespace {

constexpr std::size_t kMostWaiting = 256;  // requests

}  // namespace

FilteredMap::FilteredMap(Shell& shell, const Convert& convert) : shell_(shell), convert_(convert) {
  for (const std::uint8_t subtype : {wire::map::kReqGetInfo, wire::map::kReqGetData})
    shell.on_request(subtype, [this](const device::Message& message, device::Replier replier) {
      answer(message, std::move(replier));
    });
}

void FilteredMap::opened() {
  read_map(shell_.client(), 0, [this](Result<GridMap> read) { take(std::move(read)); });
}

void FilteredMap::closed() {
  std::vector<WaitingRequest> dropped;  // NACK, when nothing is locked
  const std::lock_guard lock(mutex_);
  map_.reset();
  failed_ = false;
  dropped.swap(waiting_);
}

void FilteredMap::take(Result<GridMap> read) {
  Result<GridMap> made = read ? convert_(*read) : read.error();
  if (!made) log::warn("driver {}: it has no map, as of its map {}", shell_.name(), made.error().text);
  std::vector<WaitingRequest> waiting;
  std::shared_ptr<const GridMap> map;
  {
    const std::lock_guard lock(mutex_);
    failed_ = !made;
    if (made) map = map_ = std::make_shared<const GridMap>(std::move(*made));
    waiting.swap(waiting_);
  }
  if (map == nullptr) return;
  for (WaitingRequest& each : waiting) {
    each.message.body = each.body;
    answer_map_request(*map, each.message, std::move(each.replier));
  }
}

void FilteredMap::answer(const device::Message& message, device::Replier replier) {
  std::shared_ptr<const GridMap> map;
  {
    const std::lock_guard lock(mutex_);
    map = map_;
    if (map == nullptr) {
      if (failed_ || !shell_.client().is_open() || waiting_.size() >= kMostWaiting) return;
      waiting_.push_back({message, {message.body.begin(), message.body.end()}, std::move(replier)});
      return;
    }
  }
  answer_map_request(*map, message, std::move(replier));
}

}  // namespace playhouse::drivers
