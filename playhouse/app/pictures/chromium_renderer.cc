#include "playhouse/app/pictures/chromium_renderer.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "playhouse/base/base64.h"
#include "playhouse/base/limits.h"
#include "playhouse/replicate/json_text.h"
#include "playhouse/replicate/scene_text.h"
#include "playhouse/scene/images/read_png.h"
#include "playhouse/web_server/page_files.h"

namespace playhouse::app {
namespace {

namespace json = boost::json;
using web_server::PageFile;

// Timeouts, generous for slow machines under load. [s]
constexpr double kStart = 60;  // of the browser, and of loading the page
constexpr double kTell = 60;   // of one update
constexpr double kDraw = 180;  // of one picture, up to 67 million pixels

constexpr const char* kNames[] = {"chromium", "chromium-browser", "google-chrome"};

/// Evaluates to the reason why the browser cannot render; null: none (web/src/main.ts).
constexpr std::string_view kMissing =
    "typeof playhousePicture === 'undefined' ? 'cannot run the page' : playhousePicture ? null : 'has no "
    "WebGL 2'";

/// A host that is never resolved: all requests are intercepted.
constexpr std::string_view kSite = "http://playhouse.localhost";

std::shared_ptr<const replicate::Layout> layout_of(const world::World& world,
                                                   const replicate::Prototypes& prototypes,
                                                   const replicate::Layout* before = nullptr) {
  const auto no_devices = [](world::ModelId) { return std::vector<std::string>(); };
  return std::make_shared<const replicate::Layout>(world, prototypes, no_devices, before);
}

std::string base64_of(const void* bytes, std::size_t count) {
  std::string text;
  append_base64(text, {static_cast<const std::uint8_t*>(bytes), count});
  return text;
}

/// Path of a URL: "http://playhouse.localhost/?picture" is "/index.html".
std::string_view path_of(std::string_view url) {
  if (!url.starts_with(kSite)) return {};
  url.remove_prefix(kSite.size());
  url = url.substr(0, url.find_first_of("?#"));
  return url == "/" ? "/index.html" : url;
}

json::array list_of(json::object only) {
  json::array list;
  list.push_back(std::move(only));
  return list;
}

std::string view_text(const Viewport& view) {
  std::string eye;
  if (view.eye)
    eye = fmt::format(R"(,"eye":{{"x":{},"y":{},"z":{},"yaw":{},"pitch":{},"fov":{}}},"hides":{})",
                      view.eye->p.x, view.eye->p.y, view.eye->p.z, view.eye->yaw, view.eye->pitch,
                      view.eye->fov, view.eye->of ? fmt::format("{}", view.eye->of->value) : "null");
  return fmt::format(R"({{"width":{},"height":{},"left":{},"top":{},"scale":{}{}}})", view.width, view.height,
                     view.left, view.top, view.pixels_per_metre, eye);
}

/// JSON of an Area of the page (web/src/view/areas.ts). Sensor
/// shapes have one loop, star-shaped about its first corner.
std::string area_text(const FilledShape& shape) {
  std::string outline;
  for (const geom::Vec2 p : shape.loops.front())
    outline +=
        fmt::format("{}{},{}", outline.empty() ? "" : ",", replicate::number(p.x), replicate::number(p.y));
  return fmt::format("[{},{},[{}]]", replicate::color(shape.color), replicate::number(shape.z_max), outline);
}

}  // namespace

std::optional<std::string> find_chromium() {
  return find_program(kNames);
}

std::string chromium_names() {
  return fmt::format("{}", fmt::join(kNames, " or "));
}

ChromiumRenderer::ChromiumRenderer(std::string program, const world::World& world, const SensorShapes& seen,
                                   const Interrupt& interrupt)
    : program_(std::move(program)),
      seen_(seen),
      browser_(interrupt),
      tools_(browser_),
      prototypes_(world.scene()),
      mesh_files_(prototypes_.meshes()),
      layout_(layout_of(world, prototypes_)),
      scene_(replicate::scene_text(world.scene(), replicate::light_text(world), prototypes_, *layout_)),
      viewer_(layout_) {}

Result<void> ChromiumRenderer::start() {
  if (web_server::page_files().empty())
    return Error{"", "has nothing to draw with: this program was built without its web page"};
  if (const Result<void> started = browser_.start(program_); !started) return started;
  tools_.on_events([this](std::string_view event, const json::object& about) {
    if (event == "Fetch.requestPaused") answer_request(about);
    if (event == "Page.loadEventFired") loaded_ = true;
  });
  if (const Result<void> opened = open_page(); !opened) return opened;
  const Result<json::value> missing = tools_.evaluate(kMissing, kTell);
  if (!missing) return missing.error();
  if (missing->is_string()) return Error{"", std::string(missing->get_string())};
  return run(fmt::format("tell({})", replicate::quoted(std::exchange(scene_, {}))));
}

Result<void> ChromiumRenderer::open_page() {
  const Result<json::object> made = tools_.call("Target.createTarget", {{"url", "about:blank"}}, kStart);
  if (!made) return made.error();
  const json::value* const target = made->if_contains("targetId");
  if (target == nullptr) return Error{"", "opens no page"};
  const Result<json::object> attached =
      tools_.call("Target.attachToTarget", {{"targetId", *target}, {"flatten", true}}, kStart);
  if (!attached) return attached.error();
  const json::value* const session = attached->if_contains("sessionId");
  if (session == nullptr || !session->is_string()) return Error{"", "opens no page"};
  tools_.attach(std::string(session->get_string()));

  const std::pair<std::string_view, json::object> steps[] = {
      {"Inspector.enable", {}},
      {"Page.enable", {}},
      {"Fetch.enable", {}},
      {"Emulation.setEmulatedMedia",
       {{"features", list_of({{"name", "prefers-color-scheme"}, {"value", "light"}})}}},
      {"Page.navigate", {{"url", fmt::format("{}/?picture", kSite)}}},
  };
  for (const auto& [method, parameters] : steps)
    if (const Result<json::object> done = tools_.call(method, parameters, kStart); !done) return done.error();
  return tools_.wait([this] { return loaded_; }, kStart);
}

/// Replies with a page file or a mesh; other requests fail.
void ChromiumRenderer::answer_request(const json::object& about) {
  const json::value* const id = about.if_contains("requestId");
  const json::value* const request = about.if_contains("request");
  const json::value* const url =
      request == nullptr || !request->is_object() ? nullptr : request->get_object().if_contains("url");
  if (id == nullptr || url == nullptr || !url->is_string()) return;
  const auto answer = [&](std::string_view type, std::string_view bytes) {
    tools_.tell("Fetch.fulfillRequest",
                {{"requestId", *id},
                 {"responseCode", 200},
                 {"responseHeaders", list_of({{"name", "Content-Type"}, {"value", type}})},
                 {"body", base64_of(bytes.data(), bytes.size())}});
  };
  const std::string_view path = path_of(url->get_string());
  if (const web_server::MeshFiles::File* mesh = mesh_files_.find(path))
    return answer("model/gltf-binary", *mesh->bytes);
  const std::span<const PageFile> files = web_server::page_files();
  const auto file = std::ranges::find(files, path, &PageFile::path);
  if (file == files.end())
    return tools_.tell("Fetch.fulfillRequest", {{"requestId", *id}, {"responseCode", 404}});
  answer(file->content_type, file->bytes);
}

/// Calls a function of the page's PicturePage (web/src/picture_page.ts).
Result<void> ChromiumRenderer::run(const std::string& script) {
  const Result<json::value> done = tools_.evaluate("playhousePicture." + script, kTell);
  return done ? Result<void>() : done.error();
}

Result<void> ChromiumRenderer::see(const world::World& world) {
  if (!std::exchange(started_, true))
    if (const Result<void> started = start(); !started) return started;
  if (layout_->population != world.population()) layout_ = layout_of(world, prototypes_, layout_.get());
  replicate::capture(world, {}, layout_, {}, snapshot_);
  do {
    const replicate::NextFrame next =
        viewer_.next_frame(snapshot_, replicate::Emit::kAlways, changes_texts_, packet_);
    if (next.changes)
      if (const Result<void> told = run(fmt::format("tell({})", replicate::quoted(*next.changes))); !told)
        return told;
    if (const Result<void> told = run(fmt::format("apply('{}')", base64_of(packet_.data(), packet_.size())));
        !told)
      return told;
    if (const Result<void> known = viewer_.acknowledge(++frames_); !known) return known;
  } while (viewer_.waiting());
  return {};
}

Result<scene::RgbImage> ChromiumRenderer::draw(const world::World& world, const Viewport& view) {
  if (const Result<void> told = see(world); !told) return told.error();
  std::vector<FilledShape> shapes;
  seen_.add_to(shapes, world, view.line_width());
  const Result<json::value> drawn = tools_.evaluate(
      fmt::format("playhousePicture.draw({},{})", view_text(view), replicate::list(shapes, area_text)),
      kDraw);
  if (!drawn) return drawn.error();
  const std::optional<std::string> png =
      drawn->is_string() ? bytes_of_base64(drawn->get_string()) : std::nullopt;
  if (!png) return Error{"", "gives no picture"};
  Result<scene::RgbImage> image = scene::read_rgb(*png, limits::kPicturePixels);
  if (!image) return Error{"", "gives a picture that " + image.error().text};
  if (image->width != view.width || image->height != view.height)
    return Error{"", fmt::format("gives a picture of {} x {} pixels", image->width, image->height)};
  return scene::RgbImage{image->width, image->height, std::move(image->rgb)};
}

}  // namespace playhouse::app
