#pragma once

/// Films by the program ffmpeg, where it is in PATH. No shell is involved.

#include <functional>
#include <string>

#include "playhouse/app/picture_of_world.h"
#include "playhouse/base/result.h"

namespace playhouse::app {

/// Takes the next picture of a film.
using PictureTaker = std::function<Result<void>(const Picture&)>;

/// Has ffmpeg write a film of pictures of this view, each shown for `period` seconds; what the ending of the
/// file says is for ffmpeg to know. `each` calls what it is given with one picture after the other. Fails,
/// with a text that names no file, where there is no ffmpeg, and where it fails, which it tells itself.
Result<void> film_by_ffmpeg(const std::string& file, const View& view, double period,
                            const std::function<Result<void>(const PictureTaker&)>& each);

}  // namespace playhouse::app
