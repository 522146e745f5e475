#include "playhouse/house/simulated_viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/json/parse.hpp>
#include <boost/json/value.hpp>
#include <cmath>
#include <exception>
#include <iterator>
#include <utility>

#include "playhouse/net/http.h"

namespace playhouse::house {
namespace {

namespace json = boost::json;

constexpr std::size_t kStartFields = 7;  // of a model's first state, without its tilt

std::vector<std::int64_t> start_of(const json::object& model) {
  std::vector<std::int64_t> start;
  for (const json::value& value : model.at("start").as_array())
    start.push_back(value.to_number<std::int64_t>());
  return start;
}

std::vector<std::int64_t> start_of(const replicate::ModelState& state) {
  return {state.x, state.y, state.z, state.a, state.state, state.color, state.flags};
}

net::HttpRequest request_from(const std::string& address) {
  net::HttpRequest request;
  request.path = "/live";
  request.host = "127.0.0.1";
  request.peer = address + ":1";
  return request;
}

}  // namespace

SimulatedViewer::SimulatedViewer(net::SimulatedNetwork& network, std::uint16_t port,
                                 const std::string& address, const ShownWorlds& shown, PageManner manner,
                                 std::uint64_t seed)
    : network_(network),
      page_(network.open_page(port, request_from(address))),
      shown_(shown),
      manner_(manner),
      random_(seed),
      heard_(network.now()) {}

void SimulatedViewer::leave() {
  if (!std::exchange(over_, true)) page_.finish();
}

void SimulatedViewer::excuse_until(double time) {
  heard_ = std::max(heard_, time);
}

void SimulatedViewer::wrong(std::string what) {
  if (behaves() && !fault_) fault_ = "a page " + std::move(what);
}

std::uint32_t SimulatedViewer::any_model() {
  if (starts_.empty()) return draw(20);
  return std::next(starts_.begin(), draw(static_cast<std::uint32_t>(starts_.size())))->first;
}

std::string SimulatedViewer::any_command() {
  // One draw at a time: compilers differ in the order of arguments, and random numbers must not.
  const std::uint32_t model = any_model(), number = draw(100);
  const double x = draw_place();
  switch (draw(10)) {
    case 0:
      return fmt::format(R"({{"do":"look","x_min":-9,"y_min":-9,"x_max":9,"y_max":9,"sensors":{}}})",
                         draw(2) == 0);
    case 1:
      return fmt::format(R"({{"do":"select","model":{}}})", model);
    case 2:
      return fmt::format(R"({{"do":"join","name":"p{}","x":{},"y":1,"a":0}})", number % 3, x);
    case 3:
      return fmt::format(R"({{"do":"say","text":"hello {}"}})", number);
    case 4:
      return fmt::format(R"({{"do":"drag","model":{},"x":{},"y":2,"a":1}})", model, x);
    case 5:
      return fmt::format(R"({{"do":"speed","times_real_time":{}}})", 1 + number % 3);
    case 6:
      return draw(5) == 0 ? R"({"do":"physics"})" : R"({"do":"resume"})";
    case 7:
      return draw(5) == 0 ? R"({"do":"step"})" : R"({"do":"resume"})";
    default:
      return fmt::format(R"({{"do":"drive","model":{},"forward":{},"sideways":0,"turn":0.5,"input":{}}})",
                         model, std::abs(x) / 5, 1 + number);
  }
}

void SimulatedViewer::act() {
  if (over_ || !has_scene_) return;
  if (draw(4) == 0) page_.send(manner_ == PageManner::kGarbles && draw(2) == 0 ? "{\"do\":" : any_command());
  if (manner_ == PageManner::kStalls && draw(30) == 0) {
    (stalled_ ? page_.read_on() : page_.stall());
    stalled_ = !stalled_;
    excuse_until(network_.now());
  }
  if (manner_ == PageManner::kVanishes && draw(100) == 0) {
    page_.vanish();
    over_ = true;
  }
}

void SimulatedViewer::hear(double patience) {
  if (over_) return;
  for (const net::SimulatedPage::SocketMessage& message : page_.take()) {
    heard_ = std::max(heard_, network_.now());
    if (message.is_text) {
      take_text({reinterpret_cast<const char*>(message.bytes.data()), message.bytes.size()});
    } else {
      take_frame(message.bytes);
    }
  }
  if (!stalled_ && network_.now() - heard_ > patience)
    wrong(fmt::format("has heard nothing for {:.1f} s", network_.now() - heard_));
  if (!page_.closed()) return;
  wrong("is closed: " + *page_.closed());
  over_ = true;
}

/// Texts that describe models; others are for people.
void SimulatedViewer::take_text(std::string_view text) {
  boost::system::error_code failed;
  const json::value value = json::parse(text, failed);
  const json::object* const object = failed ? nullptr : value.if_object();
  if (object == nullptr) return wrong("gets a text that is no JSON object");
  if (!object->contains("models")) return;
  try {
    take_models(*object);
  } catch (const std::exception& error) {
    wrong(fmt::format("gets models that cannot be read: {}", error.what()));
  }
}

/// Throws if what it has is of another form.
void SimulatedViewer::take_models(const json::object& text) {
  if (const json::value* const gone = text.if_contains("gone"))
    for (const json::value& id : gone->as_array())
      if (starts_.erase(id.to_number<std::uint32_t>()) == 0)
        wrong("hears of a model that is gone and that it never had");
  std::vector<std::uint32_t> came;
  for (const json::value& model : text.at("models").as_array()) {
    came.push_back(model.at("id").to_number<std::uint32_t>());
    starts_[came.back()] = start_of(model.as_object());
    digest_.add(std::uint64_t{came.back()});
  }
  has_scene_ = true;
  const auto population = shown_.population([&](const replicate::Layout& layout) {
    const auto is_same = [](world::ModelId id, const auto& start) { return id.value == start.first; };
    if (!std::ranges::equal(layout.id, starts_, is_same)) return false;
    return std::ranges::all_of(came, [&](std::uint32_t id) {
      const std::vector<std::int64_t> start = start_of(layout.start[layout.row({id})]);
      return std::ranges::equal(std::span(starts_.at(id)).first(kStartFields), start);
    });
  });
  if (!population) return wrong("hears of models that never were together in the world");
  if (replica_) {
    replica_->follow(population);
  } else {
    replica_.emplace(population);
  }
}

void SimulatedViewer::take_frame(std::span<const std::byte> packet) {
  if (!replica_) return wrong("gets a frame before the scene");
  for (const std::byte byte : packet) digest_.add(static_cast<std::uint64_t>(byte));
  const world::ByModel<replicate::ModelState> before = replica_->models;
  const Result<std::uint32_t> frame = replicate::apply_packet(packet, *replica_);
  if (!frame) return wrong("gets a frame that cannot be applied: " + frame.error().text);
  if (*frame != ++frames_) return wrong(fmt::format("gets frame {} instead of {}", *frame, frames_));
  if (loses_changes_ && replica_->models != before) {
    replica_->models = before;
    loses_changes_ = false;
  }
  const bool is_part = (static_cast<std::uint8_t>(packet[1]) & replicate::packet::kWaiting) != 0;
  if (!is_part && !shown_.has(replica_->tick, *replica_->layout, replica_->models))
    return wrong(fmt::format("holds a world that tick {} never was", replica_->tick));
  if (!is_part) ++whole_frames_;
  page_.send(fmt::format(R"({{"do":"ack","frame":{}}})", *frame));
}

}  // namespace playhouse::house
