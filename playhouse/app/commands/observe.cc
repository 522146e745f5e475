/// `playhouse observe`: an observer without a browser, over datagrams.
/// Prints poses and texts of models as JSON lines. docs/observers.md.

#include <fmt/format.h>

#include <algorithm>
#include <boost/json/serialize.hpp>
#include <boost/json/string.hpp>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/interrupt.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/net/io_loop.h"
#include "playhouse/observers/observer_client.h"

namespace playhouse::app {
namespace {

constexpr double kPatience = 0.05;  // s, period of checks for the end

std::string quoted(const std::string& text) {
  return boost::json::serialize(boost::json::string(text));
}

class Observing {
 public:
  Observing(const ObserveOptions& options, const Interrupt& interrupt)
      : options_(options), interrupt_(interrupt) {}

  int observe(const net::Endpoint& server) {
    const std::uint32_t frames =
        options_.rate > 0 ? static_cast<std::uint32_t>(std::clamp(options_.rate, 1.0, 30.0)) : 30;
    auto client = observers::ObserverClient::open(loop_, server, {options_.bytes_per_second, frames},
                                                  options_.token, [this] { turn(); });
    if (!client) return fail(client.error());
    client_ = std::move(*client);
    if (options_.view) look(*options_.view);
    look_for_end();
    loop_.run();
    client_->leave();
    const std::optional<std::string> ended = client_->observer().ended();
    if (options_.stats && client_->observer().has_joined()) print_figures();
    if (failure_) return fail(*failure_);
    if (interrupt_.signal() != 0) return interrupt_.exit_code(kDone);
    if (ended && !is_over_) return fail({net::to_text(server), *ended});
    return kDone;
  }

 private:
  void look(const ViewSquare& view) {
    client_->observer().command(
        fmt::format(R"({{"do":"look","x_min":{},"y_min":{},"x_max":{},"y_max":{},"sensors":false}})",
                    view.x - view.radius, view.y - view.radius, view.x + view.radius, view.y + view.radius));
  }

  /// Called after input, and periodically.
  void turn() {
    replicate::DatagramObserver& observer = client_->observer();
    for (const std::string& notice : observer.world().take_notices()) log::warn("{}", escaped(notice));
    if (observer.world().is_whole()) {
      if (!begun_) begun_ = loop_.now();
      if (!names_are_known_) check_names();
      if (!is_over_) print_due();
    }
    if (observer.ended() || failure_) loop_.stop();
  }

  void look_for_end() {
    const bool is_late = begun_ && options_.seconds > 0 && loop_.now() - *begun_ >= options_.seconds;
    if (is_late) is_over_ = true;
    if (interrupt_.signal() != 0 || is_over_) return loop_.stop();
    timer_ = loop_.after(kPatience, [this] { look_for_end(); });
  }

  /// Warns of unknown names once the scene is there.
  void check_names() {
    names_are_known_ = true;
    std::vector<std::string_view> names;
    for (const auto& [id, model] : client_->observer().world().models()) names.push_back(model.name);
    for (const std::string& wanted : options_.names) {
      if (std::ranges::find(names, wanted) != names.end()) continue;
      log::warn("nobody here is called {}{}; who comes later may be", in_quotes(wanted),
                did_you_mean(wanted, names));
    }
  }

  void print_due() {
    const double span = loop_.now() - *begun_;
    if (options_.seconds > 0 && span >= options_.seconds) return;
    if (options_.rate > 0) {
      const auto period = static_cast<std::int64_t>(span * options_.rate);
      if (period < next_period_) return;
      next_period_ = period + 1;
    }
    const replicate::ObservedWorld& world = client_->observer().world();
    for (const auto& [id, model] : world.models()) {
      if (!is_wanted(model)) continue;
      const Printed is{world.pose(id), model.says};
      const auto [printed, is_new] = printed_.try_emplace(id, is);
      if (options_.rate <= 0 && !is_new && printed->second == is) continue;
      printed->second = is;
      if (!print(world, id, model)) return;
    }
    std::erase_if(printed_, [&](const auto& each) { return gone(world, each.first); });
    std::fflush(stdout);
  }

  /// The roots, or the named models.
  bool is_wanted(const replicate::ObservedModel& model) const {
    if (options_.names.empty()) return !model.parent;
    return std::ranges::find(options_.names, model.name) != options_.names.end();
  }

  bool gone(const replicate::ObservedWorld& world, std::uint32_t id) {
    if (world.models().contains(id)) return false;
    if (!failure_)
      put(fmt::format("{{\"time\":{:.3f},\"id\":{},\"gone\":true}}\n", time_of(world.tick()), id));
    return true;
  }

  double time_of(std::uint64_t tick) const {
    return static_cast<double>(tick) * client_->observer().world().interval();
  }

  bool print(const replicate::ObservedWorld& world, std::uint32_t id, const replicate::ObservedModel& model) {
    const geom::Pose X_WM = world.pose(id);
    return put(fmt::format(
        "{{\"time\":{:.3f},\"id\":{},\"name\":{},\"pose\":[{:.3f},{:.3f},{:.3f},{:.4f}],\"says\":{}}}\n",
        time_of(world.tick()), id, quoted(model.name), X_WM.x, X_WM.y, X_WM.z, X_WM.a, quoted(model.says)));
  }

  /// False if standard output is closed.
  bool put(const std::string& line) {
    if (std::fwrite(line.data(), 1, line.size(), stdout) == line.size()) return true;
    if (!failure_) failure_ = Error{"", "standard output cannot be written"};
    return false;
  }

  void print_figures() {
    const replicate::DatagramObserver& observer = client_->observer();
    const double span = begun_ ? loop_.now() - *begun_ : 0;
    const double all = static_cast<double>(observer.packets() + observer.packets_missing());
    put(fmt::format(
        "{{\"seconds\":{:.3f},\"datagrams\":{},\"bytes\":{},\"bytes_per_second\":{:.0f},"
        "\"budget\":{},\"packets\":{},\"lost\":{:.4f},\"round_trip\":{:.4f},\"build\":{}}}\n",
        span, observer.datagrams(), observer.bytes(),
        span > 0 ? static_cast<double>(observer.bytes()) / span : 0, observer.terms().bytes_per_second,
        observer.packets(), all > 0 ? static_cast<double>(observer.packets_missing()) / all : 0,
        observer.round_trip(), quoted(observer.world().build())));
    std::fflush(stdout);
  }

  struct Printed {
    geom::Pose X_WM;
    std::string says;
    friend bool operator==(const Printed&, const Printed&) = default;
  };

  const ObserveOptions& options_;
  const Interrupt& interrupt_;
  net::IoLoop loop_;
  std::unique_ptr<observers::ObserverClient> client_;
  std::unique_ptr<net::Timer> timer_;
  std::optional<double> begun_;  // when the scene had come
  bool names_are_known_ = false, is_over_ = false;
  std::int64_t next_period_ = 0;  // of 1 / rate since the scene had come, in which nothing is printed yet
  std::map<std::uint32_t, Printed> printed_;  // by id
  std::optional<Error> failure_;
};

}  // namespace

int observe(const ObserveOptions& options) {
  const Result<client::Address> server = parse_server(options.server, kObserverPort);
  if (!server) return fail(server.error(), kUsage);
  const Result<net::Endpoint> endpoint = net::resolve(server->host, server->port);
  if (!endpoint) return fail(endpoint.error());
  const Interrupt interrupt;  // the session has to be closed from here on
  return Observing(options, interrupt).observe(*endpoint);
}

}  // namespace playhouse::app
