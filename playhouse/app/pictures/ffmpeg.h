#pragma once

/// Films by the external program ffmpeg, if it is in PATH; run without a shell.

#include <functional>
#include <string>

#include "playhouse/app/pictures/picture_of_world.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

/// Consumes the next frame of a film.
using PictureTaker = std::function<Result<void>(const scene::RgbImage&)>;

/// Pipes frames to ffmpeg, each shown for `period` seconds; ffmpeg chooses the format by
/// the file's extension. `each` calls its argument with one frame after the other. Fails,
/// without a file name, if there is no ffmpeg, or if it fails, which it reports itself.
Result<void> film_by_ffmpeg(const std::string& file, const Viewport& view, double period,
                            const std::function<Result<void>(const PictureTaker&)>& each);

}  // namespace playhouse::app
