#include "playhouse/replicate/datagrams/observed_world.h"

#include <algorithm>
#include <boost/json/parse.hpp>
#include <boost/json/value.hpp>
#include <cmath>
#include <limits>

#include "playhouse/base/packing.h"
#include "playhouse/replicate/datagrams/datagram.h"
#include "playhouse/replicate/row_code.h"

namespace playhouse::replicate {
namespace {

namespace json = boost::json;

constexpr std::size_t kMostNotices = 100;
constexpr std::uint32_t kKept = 256;  // packets; kOldestBaseline plus reordering

/// Typed access to a JSON value, with a sticky error.
class Reader {
 public:
  bool ok() const { return ok_; }

  template <typename Number>
  Number whole(const json::value* value) {
    if (value != nullptr) {
      boost::system::error_code failed;
      const auto number = value->to_number<Number>(failed);
      if (!failed) return number;
    }
    ok_ = false;
    return 0;
  }
  std::string text(const json::value* value) {
    if (value != nullptr && value->is_string()) return std::string(value->as_string());
    ok_ = false;
    return {};
  }
  const json::array& list(const json::value* value) {
    static const json::array none;
    if (value != nullptr && value->is_array()) return value->as_array();
    ok_ = false;
    return none;
  }
  const json::value* at(const json::array& list, std::size_t place) {
    return place < list.size() ? &list[place] : nullptr;
  }

 private:
  bool ok_ = true;
};

ModelState state_of(const json::object& model, Reader& read) {
  const json::array& start = read.list(model.if_contains("start"));
  ModelState state;
  state.x = read.whole<std::int32_t>(read.at(start, 0));
  state.y = read.whole<std::int32_t>(read.at(start, 1));
  state.z = read.whole<std::int32_t>(read.at(start, 2));
  state.a = read.whole<std::uint16_t>(read.at(start, 3));
  state.state = read.whole<std::uint8_t>(read.at(start, 4));
  state.color = read.whole<std::uint32_t>(read.at(start, 5));
  state.flags = read.whole<std::uint32_t>(read.at(start, 6));
  if (const json::value* const tilt = model.if_contains("tilt")) {
    state.tilt_x = read.whole<std::uint16_t>(read.at(read.list(tilt), 0));
    state.tilt_y = read.whole<std::uint16_t>(read.at(read.list(tilt), 1));
  }
  return state;
}

double angle_of(std::uint16_t turn) {
  return geom::normalize(turn * (2 * geom::kPi / 65536));
}

}  // namespace

Result<void> ObservedWorld::take_text(std::string_view text, Seq after) {
  boost::system::error_code failed;
  const json::value value = json::parse(text, failed);
  if (failed || !value.is_object()) return Error{"", "the program sent a text that is not a JSON object"};
  const json::object& object = value.as_object();
  Reader read;
  if (object.contains("protocol")) {
    name_ = read.text(object.if_contains("name"));
    if (const json::value* const build = object.if_contains("build")) build_ = read.text(build);
    interval_ = read.whole<double>(object.if_contains("interval"));
    if (!(interval_ > 0)) return Error{"", "the program sent a scene without an interval"};
  }
  if (const json::value* const gone = object.if_contains("gone"))
    for (const json::value& id : read.list(gone)) models_.erase(read.whole<std::uint32_t>(&id));
  if (const json::value* const models = object.if_contains("models")) {
    for (const json::value& each : read.list(models)) {
      if (!each.is_object()) return Error{"", "the program sent an invalid model"};
      ObservedModel model;
      model.name = read.text(each.as_object().if_contains("name"));
      if (const json::value* const parent = each.as_object().if_contains("parent"))
        model.parent = read.whole<std::uint32_t>(parent);
      model.state = model.start = state_of(each.as_object(), read);
      model.floor = after;
      models_[read.whole<std::uint32_t>(each.as_object().if_contains("id"))] = std::move(model);
    }
  }
  if (const json::value* const says = object.if_contains("says")) {
    for (const json::value& each : read.list(says)) {
      const json::array& saying = read.list(&each);
      const auto model = models_.find(read.whole<std::uint32_t>(read.at(saying, 0)));
      std::string words = read.text(read.at(saying, 1));
      if (model != models_.end()) model->second.says = std::move(words);
    }
  }
  if (const json::value* const notice = object.if_contains("notice"))
    if (notices_.size() < kMostNotices) notices_.push_back(read.text(notice));
  if (!read.ok()) return Error{"", "the program sent an incomplete text"};
  return {};
}

Result<void> ObservedWorld::take_state(Seq seq, std::span<const std::byte> bytes) {
  if (bytes.empty()) return {};
  Unpacker in(bytes);
  const std::uint64_t tick = in.varint();
  const std::uint8_t flags = in.u8();
  if (in.ok() && seq > newest_) {
    newest_ = seq;
    tick_ = tick;
    paused_ = (flags & kStatePaused) != 0;
    is_whole_ = is_whole_ || (flags & kStateWhole) != 0;
  }
  while (in.ok() && !in.at_end()) {
    const std::uint8_t age = in.u8();
    std::int64_t id = 0;
    while (const std::uint8_t mask = in.u8()) {
      id += in.zigzag() % (std::int64_t{1} << 33);
      const bool fits = in.ok() && id >= 0 && id < world::ModelId::kNone;
      const auto found = fits ? models_.find(static_cast<std::uint32_t>(id)) : models_.end();
      // Removed, or replaced by another model: parsed and ignored.
      const bool is_known = found != models_.end() && seq > found->second.floor;
      ModelState state;
      if (is_known && age == 0) state = found->second.start;
      if (is_known && age > 0) {
        const auto& history = found->second.history;
        const auto baseline = std::ranges::find(history, seq - age, &std::pair<Seq, ModelState>::first);
        if (baseline == history.end()) return Error{"", "a state refers to one that never came"};
        state = baseline->second;
      }
      if (!read_fields(mask, in, state) || !in.ok()) return Error{"", "invalid state"};
      if (is_known) keep(found->second, seq, state, tick);
    }
  }
  return in.ok() ? Result<void>() : Error{"", "a state is cut short"};
}

/// Late states are kept too: they may be baselines.
void ObservedWorld::keep(ObservedModel& model, Seq seq, const ModelState& state, std::uint64_t tick) {
  std::erase_if(model.history, [&](const auto& old) { return old.first + kKept < seq; });
  model.history.emplace_back(seq, state);
  if (seq <= model.newest) return;
  model.newest = seq;
  model.state = state;
  model.tick = tick;
}

geom::Pose ObservedWorld::pose(std::uint32_t id) const {
  geom::Pose X{};
  std::size_t steps = 0;
  for (auto model = models_.find(id); model != models_.end() && steps <= models_.size(); ++steps) {
    const ModelState& state = model->second.state;
    X = geom::compose({state.x / 1000.0, state.y / 1000.0, state.z / 1000.0, angle_of(state.a)}, X);
    if (!model->second.parent) break;
    model = models_.find(*model->second.parent);
  }
  return X;
}

}  // namespace playhouse::replicate
