#include "playhouse/app/picture_of_world.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "playhouse/app/animated_png.h"
#include "playhouse/app/commands.h"
#include "playhouse/app/fail.h"
#include "playhouse/app/ffmpeg.h"
#include "playhouse/app/whole_file.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/scene/write_png.h"

namespace playhouse::app {
namespace {

bool is_png(const std::string& path) {
  return std::filesystem::path(path).extension() == ".png";
}

/// A world that runs without anybody: its scene, which the simulation looks at, and that.
struct Run {
  scene::SceneDesc scene;
  std::unique_ptr<drivers::Simulation> simulation;
  const world::World& world() const { return simulation->engine().world(); }
};

/// The run after so many simulated seconds; or none, with the exit code, where its file is wrong.
std::unique_ptr<Run> run_until(const std::string& world, const Running& running, const SensorShapes& seen,
                               double seconds, int& code) {
  std::vector<Error> others;
  Result<scene::SceneDesc> scene = read_scene(world, &others);
  if (!scene) return code = fail_in_file(scene.error(), others), nullptr;
  auto run = std::make_unique<Run>(Run{std::move(*scene), nullptr});
  Result<std::unique_ptr<world::Engine>> engine =
      make_engine(run->scene, running, controllers::Libraries::Use::kLoad, &warn);
  if (!engine) return code = fail(engine.error()), nullptr;
  seen.watch((*engine)->world());
  drivers::Simulation::Options options;
  options.speed = 0;
  options.duration = seconds;
  run->simulation = std::make_unique<drivers::Simulation>(std::move(*engine), std::move(options));
  run->simulation->run();
  return run;
}

/// What --show says, which the command line has checked.
SensorShapes shown(const std::string& text) {
  return text.empty() ? SensorShapes() : *SensorShapes::parse(text);
}

int write(const std::string& path, const std::string& bytes) {
  const Result<void> written = write_file(path, std::as_bytes(std::span(bytes)));
  return written ? int{kDone} : fail(written.error());
}

}  // namespace

int picture(const PictureOptions& options) {
  if (!is_png(options.output)) return fail({escaped(options.output), "a picture is a .png"}, kUsage);
  int code = kDone;
  const SensorShapes seen = shown(options.show);
  const std::unique_ptr<Run> run = run_until(options.world, options.running, seen, options.at, code);
  if (!run) return code;
  const Result<View> view = view_of(run->world(), options.width);
  if (!view) return fail({escaped(options.world), view.error().text}, kUsage);
  const Picture drawn = picture_of(run->world(), *view, seen);
  const Result<std::string> png = scene::png_of(drawn.width, drawn.height, drawn.rgb);
  return png ? write(options.output, *png) : fail({escaped(options.output), png.error().text});
}

int film(const FilmOptions& options) {
  int code = kDone;
  const SensorShapes seen = shown(options.show);
  const std::unique_ptr<Run> run = run_until(options.world, options.running, seen, 0, code);
  if (!run) return code;
  const Result<View> view = view_of(run->world(), options.width);
  if (!view) return fail({escaped(options.world), view.error().text}, kUsage);
  const double tick = run->scene.interval;
  constexpr double kMost = 1e9;  // of pictures, and of ticks between two
  const auto ticks =
      static_cast<std::uint64_t>(std::clamp(std::round(1 / (options.rate * tick)), 1.0, kMost));
  const double period = static_cast<double>(ticks) * tick;
  if (options.duration / period > kMost)
    return fail({"", "--duration: a film has at most a billion pictures"}, kUsage);
  const auto pictures = static_cast<std::uint64_t>(options.duration / period + 1e-9) + 1;
  const auto each = [&](const PictureTaker& take) -> Result<void> {
    for (std::uint64_t k = 0; k < pictures; ++k) {
      if (k > 0) {
        run->simulation->extend(ticks);
        run->simulation->run();
      }
      if (const Result<void> taken = take(picture_of(run->world(), *view, seen)); !taken) return taken;
    }
    return {};
  };
  if (!is_png(options.output)) {
    const Result<void> filmed = film_by_ffmpeg(options.output, *view, period, each);
    return filmed ? int{kDone} : fail({escaped(options.output), filmed.error().text});
  }
  AnimatedPng animation(pictures, period);
  const Result<void> drawn = each([&](const Picture& picture) { return animation.add(picture); });
  return drawn ? write(options.output, animation.take())
               : fail({escaped(options.output), drawn.error().text});
}

}  // namespace playhouse::app
