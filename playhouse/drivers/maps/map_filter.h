#pragma once

/// MapFilter: a map that is a function of another one, which is read while it is opened. A filter is the options of its
/// driver, with
///   Result<GridMap> map(const GridMap&) const;  // the error says what is wrong with it, after "its map "

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/grid_map/grid_map.h"

namespace playhouse::drivers {

inline constexpr DeviceText kMapFilterProvides[] = {{"map"}};
inline constexpr DeviceText kMapFilterUses[] = {
    {"map", {}, HowMany::kOne, "is read when this one is opened"}};

/// Requests that come before the map is read wait for it.
class FilteredMap final : public Algorithm {
 public:
  using Convert = std::function<Result<GridMap>(const GridMap&)>;

  FilteredMap(Shell& shell, const Convert& convert);

  void opened() override;
  void closed() override;
  void take_news(std::vector<device::Publication>&) override {}

 private:
  struct WaitingRequest {
    device::Message message;  // without its body
    std::vector<std::byte> body;
    device::Replier replier;
  };
  void answer(const device::Message& message, device::Replier replier);
  void take(Result<GridMap> read);

  Shell& shell_;
  const Convert convert_;

  std::mutex mutex_;                    // guards what follows
  std::shared_ptr<const GridMap> map_;  // once it is read
  bool failed_ = false;
  std::vector<WaitingRequest> waiting_;
};

/// The `make` of a filter's driver.
template <auto kReadOptions, typename Filter>
Result<std::unique_ptr<device::Driver>> make_map_filter(const config::CfgSection& section, Site& site) {
  return make_algorithm<FilteredMap>(
      section, site, {.provides = {{"map"}}, .uses = {{"map"}}},
      [](const config::CfgSection& from) -> Result<FilteredMap::Convert> {
        const Result<Filter> filter = kReadOptions(from);
        if (!filter) return filter.error();
        return FilteredMap::Convert([filter = *filter](const GridMap& map) { return filter.map(map); });
      });
}

}  // namespace playhouse::drivers
