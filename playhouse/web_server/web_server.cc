#include "playhouse/web_server/web_server.h"

#include <arpa/inet.h>
#include <unistd.h>

#include <fmt/format.h>

#include <algorithm>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/serialize.hpp>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/net/http.h"
#include "playhouse/replicate/physics_text.h"
#include "playhouse/replicate/snapshot_feed.h"
#include "playhouse/web_server/driven_robots.h"
#include "playhouse/web_server/mesh_files.h"
#include "playhouse/web_server/web_viewer.h"
#include "playhouse/world/as_scene.h"
#include "playhouse/world/population.h"

namespace playhouse::web_server {
namespace {

/// Minimum interval between history updates.
constexpr std::chrono::seconds kPastPeriod{1};

constexpr std::string_view kNoPage =
    "This program was built without its web page. Build it (cd web && npm ci && npm run build), then build "
    "the "
    "program again.\n";

/// The page loads its own files alone (textures of meshes are in files that it has, which is "blob:"), talks
/// to this server alone, and is shown in nobody's frame, where a click meant for another site could drive a
/// robot.
constexpr std::string_view kPagePolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self' "
    "blob:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// "host:port" or "host" to "host"; the brackets of an IPv6 address stay.
std::string_view without_port(std::string_view authority) {
  const std::size_t bracket = authority.find(']');
  return authority.substr(0, authority.find(':', bracket == std::string_view::npos ? 0 : bracket));
}

bool is_address(std::string_view host) {
  in6_addr address;
  if (host.starts_with('[') && host.ends_with(']'))
    return inet_pton(AF_INET6, std::string(host.substr(1, host.size() - 2)).c_str(), &address) == 1;
  return inet_pton(AF_INET, std::string(host).c_str(), &address) == 1;
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// True for "robo", "robo.local" and the whole name where the machine calls itself "robo.lab.example".
bool is_name_of(std::string_view machine, std::string_view host) {
  if (machine.empty()) return false;
  const std::string first(machine.substr(0, machine.find('.')));
  return same_letters(host, machine) || same_letters(host, first) || same_letters(host, first + ".local");
}

std::string machine_name() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

/// Subscriptions taken for a selection, so that exactly these are released.
using Measuring = std::vector<world::Use>;

void watch_sensors(world::World& world, const world::Control& control, world::ModelId robot,
                   Measuring& measuring) {
  const world::ModelRow top = world.row(robot);
  if (!top) return;
  for (std::uint32_t row = 0; row < world.models.size(); ++row) {
    if (world.models.root[row] != top.index || !replicate::may_be_watched(world.models.kind[row])) continue;
    measuring.emplace_back().watch(world, control, world.id({row}));
  }
}

}  // namespace

class WebServer::Impl final : public net::HttpService,
                              public WebViewerOwner,
                              public std::enable_shared_from_this<WebServer::Impl> {
 public:
  Impl(net::IoLoop& loop, WebOptions options, world::Control& control, const world::World& world,
       replicate::DeviceNames devices)
      : loop_(loop),
        options_(std::move(options)),
        host_name_(options_.host_name.empty() ? machine_name() : options_.host_name),
        control_(control),
        scene_(world.scene()),
        engine_(world.engine),
        light_(replicate::light_text(world)),
        prototypes_(scene_),
        mesh_files_(prototypes_.meshes()),
        feed_(world, prototypes_, std::move(devices)),
        newest_(feed_.first_layout()),
        driven_(loop, control),
        ids_given_(newest_->ids_given) {}

  Result<std::uint16_t> listen() {
    auto listener = net::listen_http(loop_, options_.bind, options_.port, *this);
    if (!listener) return listener.error();
    listener_ = std::move(*listener);
    return listener_->port();
  }

  bool wants_show() const { return feed_.wants_show(); }

  void show(const world::World& world, const world::Pace& pace) {
    if (!feed_.show(world, pace)) return;
    loop_.post([weak = weak_from_this()] {
      if (const auto self = weak.lock()) self->serve();
    });
  }

  void close() {
    listener_.reset();
    offer_timer_.reset();
    subscription_timer_.reset();
    viewers_.clear();
  }

  WebStatus status() const {
    WebStatus status = status_;
    status.viewers = viewers_.size();
    return status;
  }

 private:
  /// The model that a viewer has joined the world as.
  struct Body {
    std::optional<world::ModelId> model;  // none: it has not come yet
    std::uint32_t desc = 0;               // what it was made from
    std::string walk;                     // how it walks, for its viewer
    bool is_left = false;                 // the viewer has gone, or has another one
  };

  /// One turn: the newest snapshot for every viewer, and its next commands.
  void serve() {
    for (const auto& viewer : viewers_) viewer->new_turn();
    feed_.take(front_);
    ids_given_ = std::max(ids_given_, front_.layout->ids_given);
    look_at_past();
    offer();
    if (std::exchange(newest_, front_.layout) != front_.layout)
      interest_changed();  // somebody who was selected may be gone
  }

  /// At most once a second.
  void look_at_past() {
    const auto now = std::chrono::steady_clock::now();
    if (now - past_time_ < kPastPeriod) return;
    auto past = control_.past();
    if (past == past_ || (past->ticks.empty() && past->why_none.empty())) return;
    past_ = std::move(past);
    past_time_ = now;
    history_text_ = std::make_shared<const std::string>(replicate::history_text(*past_));
  }

  void offer() {
    for (const auto& viewer : viewers_) viewer->offer(front_);
  }

  // HttpService

  Result<void> serves(const std::string& host) override {
    if (host.empty() || is_our_name(without_port(host))) return {};
    const std::string text = in_quotes(host) + " is no name of this program; open it by its address or as " +
                             host_name_ + " (--web-host gives it another name)";
    if (hosts_refused_++ == 0) log::warn("web: a request refused: {} (told once)", text);
    return Error{"", text};
  }

  net::HttpReply get(const net::HttpRequest& request) override {
    net::HttpReply reply;
    if (options_.page.empty()) {
      reply.status = 503;
      reply.constant = kNoPage;
      return reply;
    }
    const std::string_view path = request.path == "/" ? "/index.html" : std::string_view(request.path);
    if (const MeshFiles::File* mesh = mesh_files_.find(path)) {
      reply.content_type = "model/gltf-binary";
      reply.etag = mesh->etag;
      reply.text = mesh->bytes;
      return reply;
    }
    const auto file = std::ranges::find(options_.page, path, &PageFile::path);
    if (file == options_.page.end()) {
      reply.status = 404;
      reply.constant = "There is no such page; the viewer is at /\n";
      return reply;
    }
    const bool gzip = request.accepts_gzip && !file->gzip.empty();
    reply.content_type = file->content_type;
    reply.content_security_policy = kPagePolicy;
    reply.etag = file->etag;
    reply.varies = !file->gzip.empty();
    reply.content_encoding = gzip ? "gzip" : "";
    reply.constant = gzip ? file->gzip : file->bytes;
    // The build puts a hash of the contents into the names under /assets/.
    if (path.starts_with("/assets/")) reply.cache_control = "public, max-age=31536000, immutable";
    return reply;
  }

  Result<void> may_upgrade(const net::HttpRequest& request) override {
    if (request.path != "/live") return Error{"", "viewers connect to /live"};
    if (!request.origin.empty() && !may_control(request.origin, request.host)) {
      const std::string text = "a page from " + in_quotes(request.origin) + " may not control this program";
      if (origins_refused_++ == 0)
        log::warn("web: {} refused: {}; its own page may, at http://{}/ (told once)", request.peer, text,
                  request.host);
      return Error{"", text};
    }
    return {};
  }

  void upgraded(std::unique_ptr<net::WebSocket> socket, const net::HttpRequest& request) override {
    const std::string token = token_of(request);
    const std::optional<Guest> guest = options_.guests.admit(token, socket->peer());
    if (!guest) return turn_away(*socket, token);
    if (viewers_.size() >= options_.viewers && !make_room(net::network_of(socket->peer())))
      return refuse(*socket);
    viewers_.push_back(
        std::make_unique<WebViewer>(std::move(socket), newest_, *this, ++viewers_ever_, *guest));
    log::info("web: {} watches{} ({} now)", viewers_.back()->peer(), as_whom(*guest), viewers_.size());
    feed_.watch(true);
    if (viewers_.size() == 1) control_.record(true);
    tell_people();
    viewers_.back()->start(scene_text());
  }

  // WebViewerOwner

  Result<void> carry_out(const replicate::Command& command, WebViewer& from) override {
    ++status_.commands;
    if (std::string why = why_not(command, from); !why.empty()) return Error{"", std::move(why)};
    if (const auto* mute = std::get_if<replicate::Mute>(&command)) return this->mute(*mute);
    if (const auto* kick = std::get_if<replicate::Kick>(&command)) return this->kick(*kick, from);
    if (std::holds_alternative<replicate::Pause>(command)) control_.pause();
    if (std::holds_alternative<replicate::Resume>(command)) control_.resume();
    if (std::holds_alternative<replicate::Step>(command)) control_.step_once();
    if (const auto* speed = std::get_if<replicate::SetSpeed>(&command))
      control_.set_speed(speed->times_real_time);
    if (const auto* rewind = std::get_if<replicate::Rewind>(&command)) return this->rewind(*rewind);
    if (const auto* drag = std::get_if<replicate::Drag>(&command)) return move(*drag);
    if (const auto* drive = std::get_if<replicate::Drive>(&command)) return this->drive(*drive, from);
    if (const auto* copy = std::get_if<replicate::Copy>(&command)) return this->copy(*copy, from);
    if (const auto* add = std::get_if<replicate::Add>(&command)) return this->add(*add, from);
    if (const auto* join = std::get_if<replicate::Join>(&command)) return this->join(*join, from);
    if (const auto* say = std::get_if<replicate::Say>(&command)) return this->say(*say, from);
    if (const auto* remove = std::get_if<replicate::Remove>(&command)) return this->remove(*remove);
    if (std::holds_alternative<replicate::Save>(command)) return save(from);
    if (std::holds_alternative<replicate::ShowPhysics>(command)) return show_physics(from);
    if (std::holds_alternative<replicate::Select>(command) ||
        std::holds_alternative<replicate::Look>(command)) {
      interest_changed();
    }
    return {};
  }

  /// What somebody comes with; "*": nothing.
  static std::string token_of(const net::HttpRequest& request) {
    constexpr std::string_view kToken = "token=";
    return request.query.starts_with(kToken) ? request.query.substr(kToken.size()) : std::string("*");
  }

  void turn_away(net::WebSocket& socket, const std::string& token) {
    if (turned_away_++ == 0)
      log::warn("web: {} turned away: no guest of this run, or sent out (told once)", socket.peer());
    socket.close(options_.guests.is_sent_out(token, socket.peer())
                     ? kSentOut
                     : "open the page by the link that you were given");
  }

  std::string as_whom(const Guest& guest) const {
    if (options_.guests.guests().empty()) return {};
    return fmt::format(" as {}{}{}", name_of(guest.role), guest.name.empty() ? "" : " ", guest.name);
  }

  /// Why a viewer may not have this carried out; empty: it may.
  std::string why_not(const replicate::Command& command, const WebViewer& from) const {
    const Rights rights = from.rights();
    if (std::holds_alternative<replicate::Select>(command) ||
        std::holds_alternative<replicate::Look>(command) ||
        std::holds_alternative<replicate::ShowPhysics>(command) ||
        std::holds_alternative<replicate::Acknowledge>(command))
      return {};
    bool may = rights.manages;
    if (const auto* drive = std::get_if<replicate::Drive>(&command))
      may = rights.drives || (rights.joins && is_body(drive->model, from));
    if (const auto* remove = std::get_if<replicate::Remove>(&command))
      may = may || is_body(remove->model, from);  // who leaves
    if (std::holds_alternative<replicate::Join>(command)) may = rights.joins;
    if (std::holds_alternative<replicate::Say>(command)) {
      if (rights.joins && muted_.contains(from.number())) return "an admin has muted you";
      may = rights.joins;
    }
    return may ? std::string() : fmt::format("a guest who is {} may not do that", name_of(from.guest().role));
  }

  bool is_body(world::ModelId model, const WebViewer& of) const {
    const auto own = bodies_.find(of.number());
    return own != bodies_.end() && own->second->model == model && is_still(*own->second);
  }

  /// The body's id names nobody else, as far as viewers know: what a controller makes within a tick may have
  /// it once the run began again.
  bool is_still(const Body& body) const {
    const std::optional<std::uint32_t> row = body.model ? newest_->row(*body.model) : std::nullopt;
    return !row || (newest_->root[*row] == *row && newest_->prototype[*row] == prototypes_.of(body.desc));
  }

  WebViewer* viewer(std::uint32_t number) const {
    const auto found =
        std::ranges::find_if(viewers_, [number](const auto& viewer) { return viewer->number() == number; });
    return found == viewers_.end() ? nullptr : found->get();
  }

  Result<void> mute(const replicate::Mute& mute) {
    if (!viewer(mute.viewer)) return Error{"", "nobody has this number"};
    if (mute.on) {
      muted_.insert(mute.viewer);
    } else {
      muted_.erase(mute.viewer);
    }
    tell_people();
    return {};
  }

  Result<void> kick(const replicate::Kick& kick, const WebViewer& from) {
    WebViewer* const out = viewer(kick.viewer);
    if (!out) return Error{"", "nobody has this number"};
    if (out == &from) return Error{"", "this is yourself"};
    // Else it would shut the admin out, too.
    if (out->guest().token != "*" || net::network_of(out->peer()) != net::network_of(from.peer()))
      options_.guests.send_out(out->guest().token, out->peer());
    out->close(kSentOut);
    left(*out, "an admin has sent them out");
    return {};
  }

  /// To everybody: who watches, and what each may do.
  void tell_people() {
    boost::json::array people;
    for (const auto& viewer : viewers_) {
      const auto own = bodies_.find(viewer->number());
      const bool has_body = own != bodies_.end() && own->second->model;
      boost::json::object person{{"viewer", viewer->number()}, {"role", name_of(viewer->guest().role)}};
      if (!viewer->guest().name.empty()) person["name"] = viewer->guest().name;
      if (has_body) person["body"] = own->second->model->value;
      if (muted_.contains(viewer->number())) person["muted"] = true;
      people.push_back(std::move(person));
    }
    const bool is_fixed = !control_.why_fixed().empty();
    for (const auto& viewer : viewers_) {
      const Rights rights = viewer->rights();
      viewer->tell_people(
          boost::json::serialize(boost::json::object{{"people", people},
                                                     {"you", viewer->number()},
                                                     {"drives", rights.drives && !is_fixed},
                                                     {"joins", rights.joins && !is_fixed},
                                                     {"manages", rights.manages},
                                                     {"edits", rights.manages && !is_fixed}}));
    }
  }

  /// Whether browsers may call us by this name: as this machine, by an address, by the machine's own name or
  /// one that we were told. Whoever owns another name can make it point at us once their page is in
  /// somebody's browser.
  bool is_our_name(std::string_view name) const {
    return name == "localhost" || is_address(name) || is_name_of(host_name_, name) || is_further_name(name);
  }

  bool is_further_name(std::string_view name) const {
    return std::ranges::any_of(options_.further_names,
                               [name](const std::string& other) { return same_letters(other, name); });
  }

  /// Whether a page from `origin` may watch and control the program that its browser calls `host`: it came
  /// from here, the same name and port. Another port is another program, whoever's that is. In front of a
  /// name that we were told there may be a proxy that speaks TLS.
  bool may_control(std::string_view origin, const std::string& host) const {
    if (origin == "http://" + host) return true;
    return origin == "https://" + host && is_further_name(without_port(host));
  }

  /// Closes a viewer for one that comes: of the network with the most viewers, or else one that has
  /// acknowledged nothing for long, as hidden pages do. False: all are busy, and no network has more than its
  /// share.
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
    if (std::chrono::steady_clock::now() - holders[quietest].quiet_since >= options_.viewer_quiet)
      return close_for_another(*viewers_[quietest]);
    return false;
  }

  bool close_for_another(WebViewer& viewer) {
    viewer.close("gave way to another viewer");
    left(viewer, "gave way to another viewer");
    return true;
  }

  void refuse(net::WebSocket& socket) {
    if (status_.viewers_refused++ == 0)
      log::warn("web: {} refused: {} viewers is the limit (told once)", socket.peer(), options_.viewers);
    socket.close("there are as many viewers as this program serves");
  }

  /// Does `then(row)` for the row of a model that a viewer names, and succeeds silently if it has been
  /// removed. Fails for one that never was.
  template <typename Then>
  Result<void> with_row(world::ModelId model, const Then& then) const {
    if (model.value >= ids_given_) return Error{"", "no such model"};
    const std::optional<std::uint32_t> row = newest_->row(model);
    return row ? then(*row) : Result<void>{};
  }

  Result<void> rewind(const replicate::Rewind& rewind) {
    const auto past = control_.past();
    if (!past->why_none.empty()) return Error{"", "this run cannot go back: " + past->why_none};
    if (past->ticks.empty()) return Error{"", "no moment of this run is kept yet"};
    control_.rewind(rewind.tick);
    return {};
  }

  Result<void> move(const replicate::Drag& drag) {
    return with_row(drag.model, [&](std::uint32_t row) -> Result<void> {
      if (!may_be_moved(row)) return Error{"", "this model may not be moved by hand"};
      return post_change([drag](world::World& world) {
        const world::ModelRow model = world.row(drag.model);
        if (!model) return;  // it is gone
        geom::Pose X_PM = world.models.X_PM[model.index];
        X_PM.x = drag.x;
        X_PM.y = drag.y;
        X_PM.a = geom::normalize(drag.a);
        world::set_pose(world, model, X_PM);
      });
    });
  }

  Result<void> drive(const replicate::Drive& drive, WebViewer& from) {
    return with_row(drive.model, [&](std::uint32_t row) -> Result<void> {
      if (std::string why = control_.why_fixed(); !why.empty()) return Error{"", std::move(why)};
      if (!(newest_->traits[row] & replicate::kDrives)) return Error{"", "no such robot to drive"};
      driven_.drive(drive, &from);
      if (drive.input != 0) tell_when_driven(drive, from);
      return {};
    });
  }

  /// Reports from which tick the input took effect, so that the page's prediction can estimate latency. Where
  /// the queue is full the next input is reported.
  void tell_when_driven(const replicate::Drive& drive, const WebViewer& from) {
    const auto tell = [input = drive.input, reach = reacher(from)](const world::World& world) {
      reach([input, tick = world.tick()](WebViewer& viewer) { viewer.driven(input, tick); });
    };
    if (!control_.post(tell, drive.model)) log::info("web: {} is not told of a command", from.peer());
  }

  bool may_be_moved(std::uint32_t row) const { return newest_->traits[row] & replicate::kMovable; }

  Result<void> copy(const replicate::Copy& copy, const WebViewer& from) {
    return with_row(copy.model, [&](std::uint32_t row) -> Result<void> {
      if (!may_be_moved(newest_->root[row])) return Error{"", "this model may not be copied"};
      return post_change([copy, tell = teller(from)](world::World& world) {
        const world::ModelRow model = world.row(copy.model);
        if (!model) return;
        const auto came = world::spawn_like(world, model, {copy.x, copy.y, 0, copy.a});
        if (!came) tell(came.error().text);
      });
    });
  }

  Result<void> add(const replicate::Add& add, const WebViewer& from) {
    if (add.robot >= prototypes_.addable().size()) return Error{"", "there is no such robot to add"};
    const std::uint32_t desc = prototypes_.addable()[add.robot].desc;
    return post_change([add, desc, tell = teller(from)](world::World& world) {
      const geom::Pose X_WM{add.x, add.y, world.scene().models[desc].X_PM.z, add.a};
      const auto came = world::spawn(world, desc, X_WM);
      if (!came) tell(came.error().text);
    });
  }

  /// A person comes for the viewer; the model that the viewer had before goes.
  Result<void> join(const replicate::Join& join, WebViewer& from) {
    const auto person = std::ranges::find_if(
        prototypes_.addable(), [this](const auto& each) { return walks(scene_.models[each.desc]); });
    if (person == prototypes_.addable().end())
      return Error{"",
                   "nobody can join this world: it has no position with drive \"walk\" (worlds/person.inc)"};
    leave_body(from);
    const auto body = bodies_[from.number()] = std::make_shared<Body>();
    body->desc = person->desc;
    body->walk = walk_text(*scene_.models[person->desc].position);
    const std::string& known = from.guest().name;
    return post_change([join, wanted = known.empty() ? join.name : known, body, desc = person->desc,
                        tell = teller(from), weak = weak_from_this(), &loop = loop_](world::World& world) {
      const geom::Pose X_WM{join.x, join.y, world.scene().models[desc].X_PM.z, join.a};
      const std::string name = world.find(wanted) ? world::fresh_name(world, wanted) : wanted;
      const auto came = world::spawn(world, desc, X_WM, name);
      if (!came) return tell(came.error().text);
      loop.post([weak, body, model = *came] {
        if (const auto self = weak.lock()) self->embody(*body, model);
      });
    });
  }

  static bool walks(const scene::ModelDesc& model) {
    return model.position && model.position->drive == scene::Drive::kWalk;
  }

  /// What a viewer needs to predict how its body walks.
  std::string walk_text(const scene::PositionDesc& desc) const {
    const auto bounds = [&desc](int axis) {
      return fmt::format("[{},{}]", desc.velocity_bounds[axis].min, desc.velocity_bounds[axis].max);
    };
    return fmt::format(R"({{"engine":"{}","ahead":{},"aside":{},"turn":{}}})", engine_, bounds(0), bounds(1),
                       bounds(3));
  }

  void embody(Body& body, world::ModelId model) {
    body.model = model;
    if (body.is_left) return remove_body(body);
    for (const auto& viewer : viewers_) {
      const auto own = bodies_.find(viewer->number());
      if (own != bodies_.end() && own->second.get() == &body) viewer->joined(model, body.walk);
    }
    tell_people();
  }

  void leave_body(const WebViewer& viewer) {
    const auto own = bodies_.find(viewer.number());
    if (own == bodies_.end()) return;
    own->second->is_left = true;
    remove_body(*own->second);
    bodies_.erase(own);
  }

  void remove_body(const Body& body) {
    if (!body.model) return;
    const Result<void> posted = post_change([model = *body.model, desc = body.desc](world::World& world) {
      const world::ModelRow row = world.row(model);
      if (!row || world.models.desc[row.index] != desc) return;  // it has gone already
      const Result<void> gone = world::despawn(world, model);
      if (!gone) log::warn("web: the body of somebody who left stays: {}", gone.error().text);
    });
    if (!posted) log::warn("web: the body of somebody who left stays: {}", posted.error().text);
  }

  Result<void> say(const replicate::Say& say, const WebViewer& from) {
    const auto own = bodies_.find(from.number());
    if (own == bodies_.end() || !own->second->model || !is_still(*own->second))
      return Error{"", "only who has joined can say something"};
    return post_change([say, model = *own->second->model](world::World& world) {
      if (const world::ModelRow row = world.row(model)) world::set_say(world, row, say.text);
    });
  }

  Result<void> remove(const replicate::Remove& remove) {
    return with_row(remove.model, [&](std::uint32_t row) -> Result<void> {
      if (!may_be_moved(newest_->root[row])) return Error{"", "this model may not be removed"};
      return post_change([remove](world::World& world) {
        const world::ModelRow model = world.row(remove.model);
        if (!model) return;
        const Result<void> gone = world::despawn(world, world.id({world.models.root[model.index]}));
        PLAYHOUSE_ASSERT(gone.ok());
      });
    });
  }

  Result<void> save(WebViewer& from) {
    if (!from.await_text()) return Error{"", "the world is on its way already"};
    const auto posted = post_change([reach = reacher(from)](const world::World& world) {
      const auto standing = std::make_shared<const scene::SceneDesc>(world::as_scene(world));
      reach([standing, time = world.time()](WebViewer& viewer) { send_world(*standing, time, viewer); });
    });
    if (!posted) from.expect_no_text();
    return posted;
  }

  Result<void> show_physics(WebViewer& from) {
    if (!options_.physics_shapes)
      return Error{"", "a recording does not tell what its physics took bodies for"};
    if (!from.await_text()) return Error{"", "a large text is on its way already"};
    const bool posted =
        control_.post([reach = reacher(from), shapes = options_.physics_shapes](world::World&) {
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
    for (const std::string& warning : standing.warnings) viewer.notice(warning);
  }

  Result<void> post_change(std::function<void(world::World&)> change) {
    if (std::string why = control_.why_fixed(); !why.empty()) return Error{"", std::move(why)};
    if (control_.post(std::move(change))) return {};
    return Error{"", "the program is too busy to do that"};
  }

  /// Does something with a viewer on the web thread, if it is still there. Any thread, and also when the
  /// server is gone.
  std::function<void(std::function<void(WebViewer&)>)> reacher(const WebViewer& viewer) {
    return [&loop = loop_, weak = weak_from_this(),
            number = viewer.number()](std::function<void(WebViewer&)> task) {
      loop.post([weak, number, task = std::move(task)] {
        const auto self = weak.lock();
        WebViewer* const found = self ? self->viewer(number) : nullptr;
        if (found) task(*found);
      });
    };
  }

  /// Tells a viewer a line.
  std::function<void(std::string)> teller(const WebViewer& viewer) {
    return [reach = reacher(viewer)](std::string text) {
      reach([text = std::move(text)](WebViewer& other) { other.notice(text); });
    };
  }

  void refused(const WebViewer& from, const std::string& why) override {
    if (status_.commands_refused++ == 0)
      log::warn("web: {} sent a command that cannot be: {} (told once)", from.peer(), why);
  }

  void sent_frame(std::size_t bytes) override {
    ++status_.frames_sent;
    status_.bytes_sent += bytes;
  }

  void waits() override {
    if (offer_timer_) return;
    offer_timer_ = loop_.after(std::chrono::duration<double>(replicate::kFramePeriod).count(), [this] {
      offer_timer_.reset();
      offer();
    });
  }

  void left(WebViewer& viewer, const std::string& why) override {
    log::info("web: {} left: {}", viewer.peer(), why);
    driven_.left(&viewer);
    leave_body(viewer);
    muted_.erase(viewer.number());
    std::erase_if(viewers_, [&](const auto& other) { return other.get() == &viewer; });
    feed_.watch(!viewers_.empty());
    if (viewers_.empty()) control_.record(false);
    interest_changed();
    tell_people();
  }

  /// The scene with its present population.
  std::shared_ptr<const std::string> scene_text() {
    if (newest_ != scene_layout_) {
      scene_layout_ = newest_;
      scene_text_ =
          std::make_shared<const std::string>(replicate::scene_text(scene_, light_, prototypes_, *newest_));
    }
    return scene_text_;
  }

  replicate::ChangesTexts& changes_texts() override { return changes_texts_; }
  std::shared_ptr<const std::string> history() override { return history_text_; }

  /// What all viewers look at, for the next capture; and what they selected, for the sensors.
  void interest_changed() {
    replicate::Interest interest;
    std::set<world::ModelId> selected;
    for (const auto& viewer : viewers_) {
      const replicate::Wish& wish = viewer->wish();
      if (wish.selected) selected.insert(*wish.selected);
      if (!wish.sensors || wish.view.empty()) continue;
      interest.view.add({wish.view.x_min, wish.view.y_min});
      interest.view.add({wish.view.x_max, wish.view.y_max});
    }
    interest.selected.assign(selected.begin(), selected.end());
    selected_ = std::move(selected);
    feed_.set_interest(std::move(interest));
    reconcile_subscriptions();
  }

  /// A selected robot's sensors measure while somebody looks at them. What the tick's queue has no room for
  /// is tried again.
  void reconcile_subscriptions() {
    bool done = true;
    for (const world::ModelId robot : selected_)
      if (!subscribed_.contains(robot) && !subscribe(robot)) done = false;
    std::erase_if(subscribed_, [&](const auto& held) {
      if (selected_.contains(held.first)) return false;
      const bool posted = control_.post([models = held.second, &control = control_](world::World& world) {
        for (world::Use& use : *models) use.end(world, control);
      });
      if (!posted) done = false;
      return posted;
    });
    if (done) return;
    subscription_timer_ = loop_.after(std::chrono::duration<double>(replicate::kFramePeriod).count(),
                                      [this] { reconcile_subscriptions(); });
  }

  bool subscribe(world::ModelId robot) {
    auto models = std::make_shared<Measuring>();  // the tick thread's once it is posted
    const bool posted = control_.post([robot, models, &control = control_](world::World& world) {
      watch_sensors(world, control, robot, *models);
    });
    if (!posted) return false;
    subscribed_[robot] = std::move(models);
    return true;
  }

  net::IoLoop& loop_;
  WebOptions options_;
  const std::string host_name_;
  world::Control& control_;
  const scene::SceneDesc& scene_;
  const std::string engine_;  // its name
  const std::string light_;   // see replicate::light_text()
  const replicate::Prototypes prototypes_;
  MeshFiles mesh_files_;
  replicate::SnapshotFeed feed_;

  // web thread
  std::shared_ptr<const replicate::Layout> newest_;  // that viewers were told of
  std::unique_ptr<net::Listener> listener_;
  std::vector<std::unique_ptr<WebViewer>> viewers_;
  std::set<world::ModelId> selected_;                                // robots
  std::map<world::ModelId, std::shared_ptr<Measuring>> subscribed_;  // robots that the world was asked for
  std::unique_ptr<net::Timer> offer_timer_, subscription_timer_;
  std::map<std::uint32_t, std::shared_ptr<Body>> bodies_;  // of those who join, by the viewer's number
  DrivenRobots driven_;
  replicate::Snapshot front_;
  std::shared_ptr<const replicate::Layout> scene_layout_;  // of scene_text_
  std::shared_ptr<const std::string> scene_text_;
  replicate::ChangesTexts changes_texts_;
  std::uint32_t ids_given_;  // most ever: a run that went back had given more
  std::shared_ptr<const world::Past> past_;
  std::chrono::steady_clock::time_point past_time_;
  std::shared_ptr<const std::string> history_text_;  // of past_
  WebStatus status_;
  std::uint64_t hosts_refused_ = 0, origins_refused_ = 0, turned_away_ = 0;
  std::uint32_t viewers_ever_ = 0;
  std::set<std::uint32_t> muted_;  // numbers of viewers
};

WebServer::WebServer(net::IoLoop& loop, WebOptions options, world::Control& control,
                     const world::World& world, replicate::DeviceNames devices)
    : impl_(std::make_shared<Impl>(loop, std::move(options), control, world, std::move(devices))) {}
WebServer::~WebServer() {
  impl_->close();
}

Result<std::uint16_t> WebServer::listen() {
  return impl_->listen();
}
bool WebServer::wants_show() const {
  return impl_->wants_show();
}
void WebServer::show(const world::World& world, const world::Pace& pace) {
  impl_->show(world, pace);
}
WebStatus WebServer::status() const {
  return impl_->status();
}

}  // namespace playhouse::web_server
