#include "playhouse/web_server/web_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/serialize.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/net/http.h"
#include "playhouse/replicate/physics_text.h"
#include "playhouse/replicate/snapshot_feed.h"
#include "playhouse/web_server/bodies.h"
#include "playhouse/web_server/driven_robots.h"
#include "playhouse/web_server/mesh_files.h"
#include "playhouse/web_server/page_gate.h"
#include "playhouse/web_server/page_reply.h"
#include "playhouse/web_server/speech_log.h"
#include "playhouse/web_server/watched_sensors.h"
#include "playhouse/web_server/web_viewer.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/as_scene.h"

namespace playhouse::web_server {
namespace {

constexpr std::string_view kLive = "/live";  // of viewers

/// Minimum interval between history updates.
constexpr double kPastPeriod = 1;  // s

bool has_right(const server::GuestRights& rights, replicate::May may) {
  switch (may) {
    case replicate::May::kAnybody:
      return true;
    case replicate::May::kDrives:
      return rights.drives;
    case replicate::May::kJoins:
      return rights.joins;
    case replicate::May::kManages:
      return rights.manages;
  }
  return false;
}

}  // namespace

class WebServer::Impl final : public net::HttpService,
                              public WebViewerOwner,
                              public std::enable_shared_from_this<WebServer::Impl> {
 public:
  Impl(net::Network& network, WebOptions options, world::Control& control, const world::World& world,
       replicate::SnapshotFeed& feed)
      : network_(network),
        options_(std::move(options)),
        gate_(options_.host_name, options_.further_names, options_.proxies),
        control_(control),
        scene_(world.scene()),
        feed_(feed),
        mesh_files_(feed.prototypes().meshes()),
        reader_(
            feed, [&network](std::function<void()> task) { network.post(std::move(task)); },
            [this] { serve(); }),
        bodies_(std::make_shared<Bodies>(network, control, scene_, feed.prototypes(), world.engine,
                                         options_.join_period, options_.place_of_body,
                                         [this](std::uint32_t viewer, world::ModelId body,
                                                const std::string& walk) { joined(viewer, body, walk); })),
        sensors_(network, control),
        driven_(network, control),
        ids_given_(newest().ids_given) {}

  Result<std::uint16_t> listen() {
    auto listener = network_.listen_http(options_.bind, options_.port, *this);
    if (!listener) return listener.error();
    listener_ = std::move(*listener);
    return listener_->port();
  }

  void close() {
    listener_.reset();
    offer_timer_.reset();
    sensors_.close();
    viewers_.clear();
  }

  WebStatus status() const {
    WebStatus status = status_;
    status.viewers = viewers_.size();
    return status;
  }

 private:
  using Person = std::pair<std::string, std::uint32_t>;  // see person_at()

  /// One turn: offers the newest snapshot to all viewers, and resumes their commands.
  void serve() {
    for (const auto& viewer : viewers_) viewer->new_turn();
    const std::shared_ptr<const replicate::Layout> before = snapshot().layout;
    take();
    look_at_past();
    offer();
    if (before != snapshot().layout) interest_changed();  // a selected model may be gone
  }

  void take() {
    reader_.take();
    speech_.note(snapshot());
    ids_given_ = std::max(ids_given_, newest().ids_given);
  }

  /// At most once a second.
  void look_at_past() {
    const double now = network_.now();
    if (now - past_time_ < kPastPeriod) return;
    auto timeline = control_.timeline();
    if (timeline == timeline_ || (timeline->ticks.empty() && timeline->why_none.empty())) return;
    timeline_ = std::move(timeline);
    past_time_ = now;
    history_text_ = std::make_shared<const std::string>(replicate::history_text(*timeline_));
  }

  void offer() {
    for (const auto& viewer : viewers_) viewer->offer();
  }

  // HttpService

  Result<void> serves(const std::string& host) override { return gate_.serves(host); }
  Result<std::string> client_of(const net::HttpRequest& request) override { return gate_.client_of(request); }

  net::HttpReply get(const net::HttpRequest& request) override {
    const MeshFiles::File* const mesh = mesh_files_.find(request.path);
    if (mesh && !options_.page.empty()) return mesh_reply(*mesh);
    return page_reply(options_.page, request.path == "/" ? "/index.html" : request.path,
                      request.accepts_gzip);
  }

  Result<void> may_upgrade(const net::HttpRequest& request) override {
    if (request.path != kLive && !player_port_of(request))
      return Error{"", fmt::format("viewers connect to {}{}", kLive,
                                   options_.player_clients ? std::string("; ") + kPlayerPaths : "")};
    return gate_.may_control(request);
  }

  std::optional<std::uint16_t> player_port_of(const net::HttpRequest& request) const {
    if (!options_.player_clients) return std::nullopt;
    return web_server::player_port_of(request.path, options_.player_clients->port);
  }

  std::optional<net::OtherLoop> other_loop(const net::HttpRequest& request) override {
    const std::optional<std::uint16_t> port = player_port_of(request);
    if (!port) return std::nullopt;
    const WebOptions::PlayerClients& clients = *options_.player_clients;
    return net::OtherLoop{*clients.loop, [came = clients.came, port](std::unique_ptr<net::WebSocket> socket) {
                            came(*port, std::move(socket));
                          }};
  }

  void upgraded(std::unique_ptr<net::WebSocket> socket, const net::HttpRequest& request) override {
    const std::string token = token_of(request);
    const std::optional<server::Guest> guest = options_.guests.admit(token, socket->peer());
    if (!guest) return turn_away(*socket, token);
    if (viewers_.size() >= options_.viewers && !make_room(net::network_of(socket->peer())) &&
        !(server::rights_of(guest->role).manages && make_room_for_admin()))
      return refuse(*socket);
    if (viewers_.empty()) take();  // others may have watched meanwhile
    viewers_.push_back(std::make_unique<WebViewer>(std::move(socket), snapshot().layout, *this,
                                                   ++viewers_ever_, *guest, options_.bytes_per_second,
                                                   network_));
    log::info("web: {} watches{} ({} now)", viewers_.back()->peer(), as_whom(*guest), viewers_.size());
    reader_.watch(true);
    if (viewers_.size() == 1) control_.record(true);
    tell_people();
    viewers_.back()->start(scene_text(), speech_.text());
  }

  // WebViewerOwner

  const replicate::Snapshot& snapshot() const override { return reader_.snapshot(); }
  const replicate::Layout& newest() const { return *snapshot().layout; }

  Result<void> carry_out(const replicate::Command& command, WebViewer& from) override {
    ++status_.commands;
    if (std::string why = why_not(command, from); !why.empty()) return Error{"", std::move(why)};
    return std::visit([&](const auto& each) { return execute(each, from); }, command);
  }

  // An overload for each command; a missing one does not compile.
  Result<void> execute(const replicate::Pause&, WebViewer&) {
    control_.pause();
    return {};
  }
  Result<void> execute(const replicate::Resume&, WebViewer&) {
    control_.resume();
    return {};
  }
  Result<void> execute(const replicate::Step&, WebViewer&) {
    control_.step_once();
    return {};
  }
  Result<void> execute(const replicate::SetSpeed& speed, WebViewer&) {
    control_.set_speed(speed.times_real_time);
    return {};
  }
  // Handled by the viewer before (WebViewer::execute()).
  Result<void> execute(const replicate::Select&, WebViewer&) {
    interest_changed();
    return {};
  }
  Result<void> execute(const replicate::Look&, WebViewer&) {
    interest_changed();
    return {};
  }
  Result<void> execute(const replicate::Acknowledge&, WebViewer&) { return {}; }

  void turn_away(net::WebSocket& socket, const std::string& token) {
    if (turned_away_++ == 0)
      log::warn("web: {} turned away: not a guest of this run, or sent out (logged once)", socket.peer());
    socket.close(options_.guests.is_sent_out(token, socket.peer())
                     ? server::kSentOut
                     : "open the page by the link that you were given");
  }

  std::string as_whom(const server::Guest& guest) const {
    if (options_.guests.guests().empty()) return {};
    return fmt::format(" as {}{}{}", name_of(guest.role), guest.name.empty() ? "" : " ", guest.name);
  }

  /// Reason why a viewer may not do this; empty if it may.
  std::string why_not(const replicate::Command& command, const WebViewer& from) const {
    const auto* const driven = std::get_if<replicate::Drive>(&command);
    if (driven && bodies_->is_of_another(driven->model, from.number())) return "nobody drives another person";
    bool may = has_right(from.rights(), replicate::who_may(command));
    if (driven) may = may || (from.rights().joins && is_body(driven->model, from));
    if (const auto* remove = std::get_if<replicate::Remove>(&command))
      may = may || is_body(remove->model, from);  // own body
    if (may && std::holds_alternative<replicate::Say>(command) && is_muted(from))
      return "an admin has muted you";
    return may ? std::string() : fmt::format("a guest who is {} may not do that", name_of(from.guest().role));
  }

  bool is_body(world::ModelId model, const WebViewer& of) const {
    return bodies_->of(of.number(), newest()) == model;
  }

  WebViewer* viewer(std::uint32_t number) const {
    const auto found =
        std::ranges::find_if(viewers_, [number](const auto& viewer) { return viewer->number() == number; });
    return found == viewers_.end() ? nullptr : found->get();
  }

  /// Mutes all pages of a guest with a token, later ones included.
  Result<void> execute(const replicate::Mute& mute, WebViewer&) {
    const WebViewer* const who = viewer(mute.viewer);
    if (!who) return Error{"", "nobody has this number"};
    if (mute.on) {
      muted_.insert(person_at(*who));
    } else {
      muted_.erase(person_at(*who));
    }
    tell_people();
    return {};
  }

  bool is_muted(const WebViewer& viewer) const { return muted_.contains(person_at(viewer)); }

  /// Identity behind a page: the guest's token; without one every page is its own.
  static Person person_at(const WebViewer& viewer) {
    const std::string& token = viewer.guest().token;
    return token == "*" ? Person{"", viewer.number()} : Person{token, 0};
  }

  Result<void> execute(const replicate::Kick& kick, WebViewer& from) {
    WebViewer* const out = viewer(kick.viewer);
    if (!out) return Error{"", "nobody has this number"};
    if (out == &from) return Error{"", "this is yourself"};
    bar(*out, from);
    std::vector<std::uint32_t> pages;  // of that guest
    for (const auto& other : viewers_)
      if (other.get() == out || options_.guests.is_sent_out(other->guest().token, other->peer()))
        pages.push_back(other->number());
    for (const std::uint32_t page : pages) {
      viewer(page)->close(server::kSentOut);
      left(*viewer(page), "an admin has sent them out");
    }
    return {};
  }

  /// Blocks the guest, by the token and without one: else who was sent out comes back by the plain link.
  /// Not what the admin has come by, who would be locked out too, nor, for whoever comes from elsewhere
  /// without a token, the machine itself.
  void bar(const WebViewer& out, const WebViewer& admin) {
    const std::string &token = out.guest().token, &own = admin.guest().token;
    if (token != "*" && token == own) return;
    if (token != "*") options_.guests.send_out(token);
    for (const auto& page : viewers_) {
      const bool is_theirs = page.get() == &out || (token != "*" && page->guest().token == token);
      const bool is_own = own == "*" && net::network_of(page->peer()) == net::network_of(admin.peer());
      const bool is_house = own == "*" && net::is_local(page->peer()) && !net::is_local(admin.peer());
      if (is_theirs && !is_own && !is_house) options_.guests.send_out_network(page->peer());
    }
    if (options_.sent_out) options_.sent_out();
  }

  /// Sends the list of viewers and their rights to all.
  void tell_people() {
    boost::json::array people;
    for (const auto& viewer : viewers_) {
      boost::json::object person{{"viewer", viewer->number()}, {"role", name_of(viewer->guest().role)}};
      if (!viewer->guest().name.empty()) person["name"] = viewer->guest().name;
      if (const auto body = bodies_->of(viewer->number())) person["body"] = body->value;
      if (is_muted(*viewer)) person["muted"] = true;
      people.push_back(std::move(person));
    }
    const bool is_fixed = !control_.why_fixed().empty();
    for (const auto& viewer : viewers_) {
      const server::GuestRights rights = viewer->rights();
      viewer->tell_people(
          boost::json::serialize(boost::json::object{{"people", people},
                                                     {"you", viewer->number()},
                                                     {"drives", rights.drives && !is_fixed},
                                                     {"joins", rights.joins && !is_fixed},
                                                     {"manages", rights.manages},
                                                     {"edits", rights.manages && !is_fixed}}));
    }
  }

  /// Evicts a viewer for a new one: from the network with the most
  /// viewers, otherwise one without acknowledgements for long, like hidden
  /// pages. False: all are active, and no network exceeds its share.
  bool make_room(const std::string& network) {
    std::vector<std::string> networks;
    std::vector<net::Holder> holders;
    for (const auto& viewer : viewers_) networks.push_back(net::network_of(viewer->peer()));
    for (std::size_t k = 0; k < viewers_.size(); ++k)
      holders.push_back({networks[k], viewers_[k]->quiet_since()});
    const std::size_t of_largest = net::gives_way(holders);
    const std::size_t quietest = static_cast<std::size_t>(
        std::ranges::min_element(holders, {}, &net::Holder::quiet_since) - holders.begin());
    if (net::places_of(holders, networks[of_largest]) > net::places_of(holders, network) + 1)
      return close_for_another(*viewers_[of_largest]);
    if (network_.now() - holders[quietest].quiet_since >= options_.viewer_quiet)
      return close_for_another(*viewers_[quietest]);
    return false;
  }

  /// Evicts the guest who is no admin and has been quiet longest: no link can lock admins out.
  bool make_room_for_admin() {
    WebViewer* quietest = nullptr;
    for (const auto& viewer : viewers_) {
      if (viewer->rights().manages) continue;
      if (!quietest || viewer->quiet_since() < quietest->quiet_since()) quietest = viewer.get();
    }
    return quietest && close_for_another(*quietest);
  }

  bool close_for_another(WebViewer& viewer) {
    viewer.close("gave way to another viewer");
    left(viewer, "gave way to another viewer");
    return true;
  }

  void refuse(net::WebSocket& socket) {
    if (status_.viewers_refused++ == 0)
      log::warn("web: {} refused: {} viewers is the limit (logged once)", socket.peer(), options_.viewers);
    socket.close("there are as many viewers as this program serves");
  }

  /// Calls `then(row)` for a model named by a viewer; silently succeeds
  /// if it has been removed. Fails for an id that was never used.
  template <typename Then>
  Result<void> with_row(world::ModelId model, const Then& then) const {
    if (model.value >= ids_given_) return Error{"", "no such model"};
    const world::ModelRow row = newest().row(model);
    return row ? then(row) : Result<void>{};
  }

  Result<void> execute(const replicate::Rewind& rewind, WebViewer&) {
    const auto timeline = control_.timeline();
    if (!timeline->why_none.empty()) return Error{"", "this run cannot go back: " + timeline->why_none};
    if (timeline->ticks.empty()) return Error{"", "no moment of this run is kept yet"};
    control_.rewind(rewind.tick);
    return {};
  }

  Result<void> execute(const replicate::Drag& drag, WebViewer&) {
    return with_row(drag.model, [&](world::ModelRow row) -> Result<void> {
      if (!may_be_moved(row)) return Error{"", "this model may not be moved by hand"};
      return post_change([drag](world::Journal& journal) {
        const world::World& world = journal.world();
        const world::ModelRow model = world.row(drag.model);
        if (!model) return;  // removed
        geom::Pose X_PM = world.models.X_PM[model];
        X_PM.x = drag.x;
        X_PM.y = drag.y;
        X_PM.a = geom::normalize(drag.a);
        journal.apply(world::changes::Place{drag.model, X_PM});
      });
    });
  }

  Result<void> execute(const replicate::Drive& drive, WebViewer& from) {
    if (std::string why = control_.why_fixed(); !why.empty()) return Error{"", std::move(why)};
    const auto turn_wheels = [&]() -> Result<void> {
      driven_.drive(drive, &from);
      if (drive.input != 0) tell_when_driven(drive, from);
      return {};
    };
    if (is_body(drive.model, from)) return turn_wheels();  // may be newer than the latest layout
    return with_row(drive.model, [&](world::ModelRow row) -> Result<void> {
      if (!(newest().traits[row] & replicate::kDrives)) return Error{"", "no such robot to drive"};
      return turn_wheels();
    });
  }

  /// Reports the tick in which the input took effect, so that the page can estimate
  /// latency for prediction. If the queue is full, a later input is reported.
  void tell_when_driven(const replicate::Drive& drive, const WebViewer& from) {
    const auto tell = [input = drive.input, reach = reacher(from)](const world::Journal& journal) {
      reach([input, tick = journal.world().tick()](WebViewer& viewer) { viewer.driven(input, tick); });
    };
    if (!control_.post(tell, drive.model)) log::info("web: {} is not told of a command", from.peer());
  }

  bool may_be_moved(world::ModelRow row) const { return newest().traits[row] & replicate::kMovable; }

  Result<void> execute(const replicate::Copy& copy, WebViewer& from) {
    return with_row(copy.model, [&](world::ModelRow row) -> Result<void> {
      if (!may_be_moved(newest().root[row])) return Error{"", "this model may not be copied"};
      const auto tree = [copy](const world::World& world) -> std::optional<std::uint32_t> {
        const world::ModelRow model = world.row(copy.model);
        return model ? std::optional(world.models.desc[model]) : std::nullopt;
      };
      return post_spawn(from, tree, [copy](world::Journal& journal) {
        return journal.spawn_copy(copy.model, {copy.x, copy.y, 0, copy.a});
      });
    });
  }

  Result<void> execute(const replicate::Add& add, WebViewer& from) {
    const auto& addable = feed_.prototypes().addable();
    if (add.robot >= addable.size()) return Error{"", "there is no such robot to add"};
    const std::uint32_t desc = addable[add.robot].desc;
    const auto tree = [desc](const world::World&) { return std::optional(desc); };
    return post_spawn(from, tree, [add, desc](world::Journal& journal) {
      const geom::Pose X_WM{add.x, add.y, journal.world().scene().models[desc].X_PM.z, add.a};
      return journal.spawn(desc, X_WM);
    });
  }

  /// Of the viewer's share. `tree`: the description of what comes; none if what would be copied was removed.
  Result<void> post_spawn(const WebViewer& from,
                          std::function<std::optional<std::uint32_t>(const world::World&)> tree,
                          std::function<Result<world::ModelId>(world::Journal&)> spawn) {
    return post_change([tree = std::move(tree), spawn = std::move(spawn), tell = teller(from),
                        shares = options_.shares,
                        holder = net::holder_of(from.guest().token, from.peer())](world::Journal& journal) {
      const world::World& world = journal.world();
      const std::optional<std::uint32_t> desc = tree(world);
      if (!desc) return;
      if (const Result<void> room = shares->check(world, holder, {&*desc, 1}); !room)
        return tell(room.error().text);
      const Result<world::ModelId> came = spawn(journal);
      if (!came) return tell(came.error().text);
      shares->add(world, holder, *came);
    });
  }

  Result<void> execute(const replicate::Join& join, WebViewer& from) {
    const std::string& known = from.guest().name;
    return bodies_->join(join, from.number(), known.empty() ? join.name : known, teller(from));
  }

  void joined(std::uint32_t number, world::ModelId body, const std::string& walk) {
    if (WebViewer* const who = viewer(number)) who->joined(body, walk);
    tell_people();
  }

  Result<void> execute(const replicate::Say& say, WebViewer& from) {
    const std::optional<world::ModelId> body = bodies_->of(from.number(), newest());
    if (!body) return Error{"", "only who has joined can say something"};
    return post_change([say, model = *body](world::Journal& journal) {
      journal.apply(world::changes::Say{model, say.text});
    });
  }

  Result<void> execute(const replicate::Remove& remove, WebViewer&) {
    return with_row(remove.model, [&](world::ModelRow row) -> Result<void> {
      if (!may_be_moved(newest().root[row])) return Error{"", "this model may not be removed"};
      return post_change([remove](world::Journal& journal) {
        const world::World& world = journal.world();
        const world::ModelRow model = world.row(remove.model);
        if (!model) return;
        const Result<void> gone = journal.despawn(world.id(world.models.root[model]));
        PLAYHOUSE_ASSERT(gone.ok());
      });
    });
  }

  Result<void> execute(const replicate::Save&, WebViewer& from) {
    if (!from.await_text()) return Error{"", "the world is on its way already"};
    const auto posted = post_change([reach = reacher(from)](const world::Journal& journal) {
      const world::World& world = journal.world();
      const auto standing = std::make_shared<const scene::SceneDesc>(world::as_scene(world));
      reach([standing, time = world.time()](WebViewer& viewer) { send_world(*standing, time, viewer); });
    });
    if (!posted) from.expect_no_text();
    return posted;
  }

  Result<void> execute(const replicate::ShowPhysics&, WebViewer& from) {
    if (!options_.physics_shapes)
      return Error{"", "a recording does not tell what its physics took bodies for"};
    if (!from.await_text()) return Error{"", "a large text is on its way already"};
    const bool posted =
        control_.post([reach = reacher(from), shapes = options_.physics_shapes](const world::Journal&) {
          reach([now = std::make_shared<const world::PhysicsShapes>(shapes())](WebViewer& viewer) {
            Result<std::string> text = replicate::physics_text(*now);
            if (text) return viewer.send_text(std::make_shared<const std::string>(std::move(*text)));
            viewer.expect_no_text();
            viewer.notice(text.error().text);
          });
        });
    if (posted) return {};
    from.expect_no_text();
    return Error{"", "the program is too busy to do that"};
  }

  static void send_world(const scene::SceneDesc& standing, double time, WebViewer& viewer) {
    const Result<std::string> text = world::world_file(standing, time, {});
    if (!text) {
      viewer.expect_no_text();
      return viewer.notice(text.error().text);
    }
    const std::string name = std::filesystem::path(standing.path).stem().string() + ".saved.world";
    viewer.send_text(std::make_shared<const std::string>(replicate::world_file_text(name, *text)));
  }

  Result<void> post_change(std::function<void(world::Journal&)> change) {
    return web_server::post_change(control_, std::move(change));
  }

  /// Returns a function that runs a task for a viewer on the web thread,
  /// if it still exists. Any thread, even after the server's destruction.
  std::function<void(std::function<void(WebViewer&)>)> reacher(const WebViewer& viewer) {
    return [&network = network_, weak = weak_from_this(),
            number = viewer.number()](std::function<void(WebViewer&)> task) {
      network.post([weak, number, task = std::move(task)] {
        const auto self = weak.lock();
        WebViewer* const found = self ? self->viewer(number) : nullptr;
        if (found) task(*found);
      });
    };
  }

  /// Returns a function that sends a line to a viewer.
  std::function<void(std::string)> teller(const WebViewer& viewer) {
    return [reach = reacher(viewer)](std::string text) {
      reach([text = std::move(text)](WebViewer& other) { other.notice(text); });
    };
  }

  void refused(const WebViewer& from, const std::string& why) override {
    if (status_.commands_refused++ == 0)
      log::warn("web: {} sent an invalid command: {} (logged once)", from.peer(), why);
  }

  void sent_frame(std::size_t bytes) override {
    ++status_.frames_sent;
    status_.bytes_sent += bytes;
  }

  void waits() override {
    if (offer_timer_) return;
    offer_timer_ = network_.after(replicate::kFramePeriod, [this] {
      offer_timer_.reset();
      offer();
    });
  }

  void left(WebViewer& viewer, const std::string& why) override {
    log::info("web: {} left: {}", viewer.peer(), why);
    driven_.left(&viewer);
    bodies_->leave(viewer.number());
    if (viewer.guest().token == "*") muted_.erase(person_at(viewer));
    std::erase_if(viewers_, [&](const auto& other) { return other.get() == &viewer; });
    reader_.watch(!viewers_.empty());
    if (viewers_.empty()) control_.record(false);
    interest_changed();
    tell_people();
  }

  /// The scene text for the present population, cached.
  std::shared_ptr<const std::string> scene_text() {
    if (scene_layout_ != snapshot().layout) {
      scene_layout_ = snapshot().layout;
      scene_text_ =
          std::make_shared<const std::string>(feed_.scene_text(*scene_layout_, replicate::TellDevices::kYes));
    }
    return scene_text_;
  }

  replicate::ChangesTexts& changes_texts() override { return changes_texts_; }
  std::shared_ptr<const std::string> history() override { return history_text_; }

  /// Updates the union of interests for captures, and the selected sensors.
  void interest_changed() {
    replicate::Interest interest;
    for (const auto& viewer : viewers_) interest.add(replicate::interest_of(viewer->wish()));
    sensors_.select({interest.selected.begin(), interest.selected.end()});
    reader_.set_interest(std::move(interest));
  }

  net::Network& network_;
  WebOptions options_;
  PageGate gate_;
  world::Control& control_;
  const scene::SceneDesc& scene_;
  const replicate::SnapshotFeed& feed_;
  MeshFiles mesh_files_;
  replicate::SnapshotReader reader_;

  // web thread
  std::unique_ptr<net::Listener> listener_;
  std::vector<std::unique_ptr<WebViewer>> viewers_;
  std::unique_ptr<net::Timer> offer_timer_;
  std::shared_ptr<Bodies> bodies_;
  WatchedSensors sensors_;
  DrivenRobots driven_;
  SpeechLog speech_;
  std::shared_ptr<const replicate::Layout> scene_layout_;  // of scene_text_
  std::shared_ptr<const std::string> scene_text_;
  replicate::ChangesTexts changes_texts_;
  std::uint32_t ids_given_;  // maximum so far: a rewound run had used more
  std::shared_ptr<const world::Timeline> timeline_;
  double past_time_ = -kPastPeriod;
  std::shared_ptr<const std::string> history_text_;  // of timeline_
  WebStatus status_;
  std::uint64_t turned_away_ = 0;
  std::uint32_t viewers_ever_ = 0;
  std::set<Person> muted_;
};

WebServer::WebServer(net::Network& network, WebOptions options, world::Control& control,
                     const world::World& world, replicate::SnapshotFeed& feed)
    : impl_(std::make_shared<Impl>(network, std::move(options), control, world, feed)) {}
WebServer::~WebServer() {
  impl_->close();
}

Result<std::uint16_t> WebServer::listen() {
  return impl_->listen();
}
WebStatus WebServer::status() const {
  return impl_->status();
}

}  // namespace playhouse::web_server
