#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/kept_files.h"
#include "playhouse/app/pictures/animated_png.h"
#include "playhouse/app/pictures/drawing.h"
#include "playhouse/app/pictures/drawn_run.h"
#include "playhouse/app/pictures/ffmpeg.h"
#include "playhouse/app/pictures/sight.h"
#include "playhouse/app/whole_file.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log_output.h"
#include "playhouse/images/write_png.h"
#include "playhouse/world/periods.h"

namespace playhouse::app {
namespace {

bool is_png(const std::string& path) {
  return std::filesystem::path(path).extension() == ".png";
}

/// Value of --show, validated already.
SensorShapes shown(const std::string& text) {
  return text.empty() ? SensorShapes() : *SensorShapes::parse(text);
}

bool is_recording(const std::string& path) {
  return std::filesystem::path(path).extension() == ".mcap";
}

/// The run of a recording at its start; null, with the exit code, if there is none.
template <typename Options>
std::unique_ptr<DrawnRun> open_recorded(const Options& options, int& code) {
  std::vector<Error> others;
  Result<std::unique_ptr<OpenedRecording>> opened = open_recording(options.world, options.running, &others);
  if (!opened) return code = fail_in_file(opened.error(), others), nullptr;
  if (const Result<void> kept = keep_files(options.output, std::vector<std::string>{options.world}); !kept)
    return code = fail_in_file(kept.error()), nullptr;
  return std::make_unique<DrawnRun>(std::move(*opened), shown(options.show));
}

/// A run at its start; null, with the exit code, if it cannot be rendered or its file is invalid.
template <typename Options>
std::unique_ptr<DrawnRun> open_run(const Options& options, const Drawing& drawing, int& code) {
  if (const Result<void> possible = drawing.possible(); !possible)
    return code = fail(possible.error()), nullptr;
  if (const Result<void> writable = check_writable(options.output); !writable)
    return code = fail_at(writable.error()), nullptr;
  if (is_recording(options.world)) return open_recorded(options, code);
  std::vector<Error> others;
  config::SourceFiles sources;
  Result<scene::SceneDesc> scene = read_scene(options.world, &others, &sources);
  if (!scene) return code = fail_in_file(scene.error(), others), nullptr;
  if (const Result<void> kept = keep_files(options.output, names_of(sources)); !kept)
    return code = fail_in_file(kept.error()), nullptr;
  auto run = std::make_unique<DrawnRun>(std::move(*scene), options.running, shown(options.show));
  others.clear();
  if (const Result<void> begun = run->begin(&others); !begun)
    return code = fail_in_file(begun.error(), others), nullptr;
  return run;
}

int write(const std::string& path, const std::string& bytes) {
  const Result<void> written = write_file(path, std::as_bytes(std::span(bytes)));
  return written ? int{kDone} : fail_at(written.error());
}

int fail_different(const std::string& recording, const std::string& where) {
  return fail_at({escaped(recording), "the run differs from its recording " + where});
}

/// Frame times of a film.
struct Shots {
  std::uint64_t count = 0;
  std::uint64_t ticks = 0;  // per frame
  double period = 0;        // s; the same

  /// A recording ends a film.
  static Result<Shots> of(const FilmOptions& options, const DrawnRun& run) {
    const double interval = run.interval();
    double duration = options.duration.value_or(kFilmSeconds);
    if (const std::optional<std::uint64_t> last = run.last_tick()) {
      const double all = static_cast<double>(*last - run.first_tick()) * interval;
      duration = std::min(options.duration.value_or(all), all);
    }
    constexpr double kMost = 1e9;  // of frames, and of ticks per frame
    Shots shots;
    shots.ticks =
        static_cast<std::uint64_t>(std::clamp(std::round(1 / (options.rate * interval)), 1.0, kMost));
    shots.period = static_cast<double>(shots.ticks) * interval;
    if (duration / shots.period > kMost)
      return Error{"", "--duration: a film has at most a billion pictures"};
    shots.count = static_cast<std::uint64_t>(duration / shots.period + 1e-9) + 1;
    return shots;
  }
};

/// One film by one renderer.
class Filming {
 public:
  Filming(const FilmOptions& options, const Shots& shots, DrawnRun& run, WorldRenderer& renderer,
          const Interrupt& interrupt)
      : options_(options), shots_(shots), run_(run), renderer_(renderer), interrupt_(interrupt) {}
  ~Filming() {
    if (shows_progress_) log::show_progress("");
  }
  Filming(const Filming&) = delete;
  Filming& operator=(const Filming&) = delete;

  /// See Drawing::Draw.
  Result<int> film() {
    if (const Result<void> begun = run_.begin(); !begun) return fail_in_file(begun.error());
    Result<Sight> sight = Sight::of(options_.sight, run_.world());
    if (!sight) return fail(sight.error(), kUsage);
    const Result<Viewport> view = sight->at(run_.world(), options_.width);
    if (!view) return fail_at({escaped(options_.world), view.error().text}, kUsage);
    const auto each = [&](const PictureTaker& take) { return take_all(*sight, *view, take); };
    if (!is_png(options_.output)) return ended(film_by_ffmpeg(options_.output, *view, shots_.period, each));
    AnimatedPng animation(shots_.count, shots_.period);
    const Result<int> code =
        ended(each([&](const images::RgbImage& picture) { return animation.add(picture); }));
    return code && *code == kDone ? write(options_.output, animation.take()) : code;
  }

 private:
  Result<void> take_all(Sight& sight, Viewport view, const PictureTaker& take) {
    for (std::uint64_t k = 0; k < shots_.count; ++k) {
      const Result<void> ran = run_.advance(run_.first_tick() + k * shots_.ticks, renderer_, interrupt_);
      if (!ran) return refuse(ran.error());
      if (!sight.is_fixed()) view = *sight.at(run_.world(), options_.width);
      const Result<images::RgbImage> drawn = renderer_.draw(run_.world(), view);
      if (!drawn) return refuse(drawn.error());
      if (const Result<void> taken = take(*drawn); !taken) return taken;
      if (shows_progress_) log::show_progress(fmt::format("{} of {} pictures ", k + 1, shots_.count));
    }
    return {};
  }

  Error refuse(Error error) {
    not_drawn_ = error;
    return error;
  }

  Result<int> ended(const Result<void>& result) const {
    if (run_.differs()) return fail_different(options_.world, *run_.differs());
    if (not_drawn_) return *not_drawn_;
    return result ? int{kDone} : fail_at({escaped(options_.output), result.error().text});
  }

  const FilmOptions& options_;
  const Shots& shots_;
  DrawnRun& run_;
  WorldRenderer& renderer_;
  const Interrupt& interrupt_;
  const bool shows_progress_ = isatty(STDERR_FILENO) == 1;
  std::optional<Error> not_drawn_;  // error of the renderer, or a signal
};

/// The tick of a picture. Fails outside of a recording.
Result<std::uint64_t> tick_of(const PictureOptions& options, const DrawnRun& run) {
  const std::uint64_t tick = options.at > 0 ? world::ticks_of(options.at, run.interval()) : run.first_tick();
  const std::uint64_t last = run.last_tick().value_or(tick);
  if (tick >= run.first_tick() && tick <= last) return tick;
  const auto seconds = [&](std::uint64_t at) { return static_cast<double>(at) * run.interval(); };
  return Error{"--at", fmt::format("{} s is not in the recording, which is from {:.6g} to {:.6g} s",
                                   options.at, seconds(run.first_tick()), seconds(last))};
}

}  // namespace

int picture(const PictureOptions& options) {
  if (!is_png(options.output)) return fail_at({escaped(options.output), "a picture is a .png"}, kUsage);
  Drawing drawing("picture", options.renderer);
  int code = kDone;
  const std::unique_ptr<DrawnRun> run = open_run(options, drawing, code);
  if (!run) return code;
  const Result<std::uint64_t> tick = tick_of(options, *run);
  if (!tick) return fail(tick.error(), kUsage);
  const Interrupt interrupt;
  return drawing.run(*run, interrupt, [&](WorldRenderer& renderer) -> Result<int> {
    if (const Result<void> ran = run->advance(*tick, renderer, interrupt); !ran) {
      if (run->differs()) return fail_different(options.world, *run->differs());
      return ran.error();
    }
    Result<Sight> sight = Sight::of(options.sight, run->world());
    if (!sight) return fail(sight.error(), kUsage);
    const Result<Viewport> view = sight->at(run->world(), options.width);
    if (!view) return fail_at({escaped(options.world), view.error().text}, kUsage);
    const Result<images::RgbImage> drawn = renderer.draw(run->world(), *view);
    if (!drawn) return drawn.error();
    const Result<std::string> png = images::png_of(drawn->width, drawn->height, 3, drawn->rgb);
    return png ? write(options.output, *png) : fail_at({escaped(options.output), png.error().text});
  });
}

int film(const FilmOptions& options) {
  Drawing drawing("film", options.renderer);
  int code = kDone;
  const std::unique_ptr<DrawnRun> run = open_run(options, drawing, code);
  if (!run) return code;
  const Result<Shots> shots = Shots::of(options, *run);
  if (!shots) return fail(shots.error(), kUsage);
  const Interrupt interrupt;
  return drawing.run(*run, interrupt, [&](WorldRenderer& renderer) {
    return Filming(options, *shots, *run, renderer, interrupt).film();
  });
}

}  // namespace playhouse::app
