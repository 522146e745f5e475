#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <span>
#include <vector>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/kept_files.h"
#include "playhouse/app/pictures/gltf.h"
#include "playhouse/app/whole_file.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/bodies/plan_of_solids.h"
#include "playhouse/config/text/file_search.h"
#include "playhouse/scene/images/bitmap.h"
#include "playhouse/scene/images/ros_map.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/scene/write_world.h"
#include "playhouse/world/population/population.h"

namespace playhouse::app {
namespace {

namespace fs = std::filesystem;

/// Images that are not read, and no worlds either.
constexpr std::array<std::string_view, 6> kOtherImages = {".gif", ".tif", ".tiff", ".webp", ".svg", ".pdf"};
constexpr double kWallHeight = 0.6, kMapResolution = 0.05;  // m

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

bool is_image(const std::string& path) {
  return scene::is_image_name(path) ||
         std::ranges::find(kOtherImages, fs::path(path).extension()) != kOtherImages.end();
}

bool is_gltf(const std::string& path) {
  return fs::path(path).extension() == ".glb";
}

int write_text(const std::string& path, const std::string& text) {
  if (path.empty()) {
    fmt::print("{}", text);
    return kDone;
  }
  const Result<void> written = write_file(path, std::as_bytes(std::span(text)));
  return written ? int{kDone} : fail_at(written.error());
}

/// Name of a file relative to the folder of `beside`, or absolute if that is empty.
std::string named_from(const std::string& beside, const fs::path& file) {
  return (beside.empty() ? config::physical_path(file) : config::path_from(beside, file)).string();
}

int write_plan(const ConvertOptions& options, const scene::Plan& plan, const std::string& bitmap) {
  const Result<std::string> text = scene::world_of_plan(plan, bitmap, options.height.value_or(kWallHeight));
  if (!text) return fail_in_file({escaped(options.input), text.error().text});
  const auto& free = plan.free.solid;
  if (std::ranges::find(free, 1) == free.end())
    warn(escaped(options.input) + ": has no free pixel, so the world has no robot");
  return write_text(options.output, *text);
}

int convert_image(const ConvertOptions& options) {
  if (!scene::is_image_name(options.input))
    return fail_at({escaped(options.input),
                    "is an image of a kind that is not read: PNG, JPEG, PNM (.pgm, .ppm, .pbm) and BMP are"},
                   kUsage);
  if (!options.scale)
    return fail_at({escaped(options.input), "is an image: --scale says how many metres a pixel measures"},
                   kUsage);
  const Result<std::string> bytes = read_file(options.input);
  if (!bytes) return fail_in_file(bytes.error());
  const Result<scene::Plan> plan =
      scene::plan_of_image(*bytes, fs::path(options.input).stem().string(), *options.scale);
  if (!plan) return fail_in_file({escaped(options.input), plan.error().text});
  return write_plan(options, *plan, named_from(options.output, options.input));
}

/// A map whose thresholds are not those of bitmaps has its walls in an image of its own, beside the world.
int convert_map(const ConvertOptions& options) {
  const Result<std::string> text = read_file(options.input);
  if (!text) return fail_in_file(text.error());
  const Result<scene::RosMap> map = scene::read_ros_map(*text);
  if (!map) {
    const std::string line = map.error().where.empty() ? "" : ":" + map.error().where;
    return fail_in_file({escaped(options.input) + line, map.error().text});
  }
  for (const Error& warning : map->warnings)
    warn(escaped(options.input) + ":" + warning.where + ": " + warning.text + "; it has no effect");
  const scene::MapImage found = scene::image_of(*map, options.input);
  if (found.is_instead)
    warn(escaped(options.input) + ": there is no " + in_quotes(map->image) + "; " + in_quotes(found.path) +
         " is read instead");
  const fs::path image = found.path;
  const Result<std::string> bytes = read_file(image.string(), config::NamedBy::kFile);
  if (!bytes) return fail_in_file(bytes.error());
  const Result<scene::Plan> plan =
      scene::plan_of_ros_map(*map, *bytes, fs::path(options.input).stem().string());
  if (!plan) return fail_in_file({escaped(image.string()), plan.error().text});
  if (scene::is_plain(*plan, *bytes)) return write_plan(options, *plan, named_from(options.output, image));
  if (options.output.empty())
    return fail_at(
        {escaped(options.input),
         "has thresholds of its own, so its walls become an image beside the world: -o says where"},
        kUsage);
  const fs::path walls = fs::path(options.output).replace_extension(".pgm");
  if (is_same_file(walls.string(), image.string()))
    return fail_at({escaped(walls.string()), "is the image of the map: give the world another name"}, kUsage);
  if (const int failed = write_text(walls.string(), scene::pgm_of(plan->solid)); failed != kDone)
    return failed;
  return write_plan(options, *plan, walls.filename().string());
}

Result<scene::SceneDesc> load(const ConvertOptions& options, std::vector<Error>& others,
                              config::SourceFiles& sources) {
  Result<scene::SceneDesc> scene =
      scene::load_world(options.input, config::NamedBy::kPerson, &others, &sources);
  if (scene)
    for (const std::string& warning : scene->warnings) warn(warning);
  return scene;
}

/// The image is beside the map, under its name.
std::string image_of_map(const ConvertOptions& options) {
  return fs::path(options.output).replace_extension(".pgm").string();
}

/// The walls at `height` above the floor. [m]
Result<scene::Plan> plan_of_world(const scene::SceneDesc& scene, double resolution, double height) {
  bodies::Shapes shapes(scene);
  const bodies::Solids solids = bodies::make_fixed_solids(world::World(scene, 1), shapes);
  const auto is_cut = [&](bodies::SolidRow row) { return bodies::is_wall_at(solids, row, height); };
  const Result<scene::Plan> plan = bodies::plan_of_solids(solids, resolution, is_cut);
  if (!plan) return Error{"", plan.error().text + ": choose a larger --scale"};
  if (plan->solid.width > 0) return plan;
  return Error{"",
               fmt::format("nothing is fixed {} m above the floor (--height sets another height)", height)};
}

int write_map(const ConvertOptions& options, const scene::SceneDesc& scene) {
  const Result<scene::Plan> plan = plan_of_world(scene, options.scale.value_or(kMapResolution),
                                                 options.height.value_or(bodies::kMapHeight));
  if (!plan) return fail_in_file({escaped(options.input), plan.error().text});
  const std::string image = image_of_map(options);
  if (const int failed = write_text(image, scene::pgm_of(plan->solid)); failed != kDone) return failed;
  return write_text(options.output, scene::ros_map_of(*plan, fs::path(image).filename().string()));
}

int write_gltf(const ConvertOptions& options, const scene::SceneDesc& scene) {
  world::World world(scene, 1);
  world::tilt_as_described(world);
  const Result<std::string> glb = glb_of(world);
  if (!glb) return fail_in_file({escaped(options.input), glb.error().text});
  return write_text(options.output, *glb);
}

int convert_world(const ConvertOptions& options) {
  std::vector<Error> others;
  config::SourceFiles sources;
  const Result<scene::SceneDesc> scene = load(options, others, sources);
  if (!scene) return fail_in_file(scene.error(), others);
  const std::string image = scene::is_map_name(options.output) ? image_of_map(options) : "";
  for (const std::string& output : {options.output, image})
    if (const Result<void> kept = keep_files(output, names_of(sources)); !kept)
      return fail_in_file(kept.error());
  if (scene::is_map_name(options.output)) return write_map(options, *scene);
  if (options.scale || options.height)
    return fail({"", "--scale and --height are for images and maps"}, kUsage);
  if (is_gltf(options.output)) return write_gltf(options, *scene);
  // For standard output, bitmaps have absolute paths.
  const Result<std::string> text = scene::write_world(*scene, options.output);
  if (!text) return fail_in_file({escaped(options.input), "not converted: " + text.error().text});
  return write_text(options.output, *text);
}

}  // namespace

int convert(const ConvertOptions& options) {
  log::open(0);
  if (is_same_file(options.input, options.output))
    return fail_at({escaped(options.output), "is what is read: give another name"}, kUsage);
  const bool is_plan = is_image(options.input) || scene::is_map_name(options.input);
  if (is_gltf(options.output) && is_plan)
    return fail_at({escaped(options.output), "is made of a world: convert the plan to a .world first"},
                   kUsage);
  if (is_image(options.output))
    return fail_at({escaped(options.output),
                    "is an image: a world is written as .world, a map as .yaml, bodies as .glb"},
                   kUsage);
  if (fs::path(options.output).extension() == ".gltf")
    return fail_at({escaped(options.output), "is glTF as text, which is not written: name it .glb"}, kUsage);
  if (is_image(options.input)) return convert_image(options);
  return scene::is_map_name(options.input) ? convert_map(options) : convert_world(options);
}

}  // namespace playhouse::app
