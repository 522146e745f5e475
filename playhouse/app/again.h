#pragma once

#include <memory>
#include <string>

#include "playhouse/app/commands/options.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/record/rerun.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

/// A recording opened for replay: its contents, its scene, and an engine.
struct OpenedRecording {
  record::Recording recording;
  scene::SceneDesc scene;
  std::unique_ptr<record::Rerun> rerun;  // refers to the two above
};

/// Opens a file and loads its initial state. Errors include
/// the file name; `others` gets further errors of its scene.
Result<std::unique_ptr<OpenedRecording>> open_recording(const std::string& file, const Running& running,
                                                        std::vector<Error>* others);

/// `playhouse run --again FILE`: replays a recording at full speed and
/// checks it. Serves no clients meanwhile. Exit code 1 if the runs diverge.
int run_again(const RunOptions& options);

}  // namespace playhouse::app
