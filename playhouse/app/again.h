#pragma once

#include <memory>
#include <string>

#include "playhouse/app/options.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/record/rerun.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

/// A recording that can be run: what it says, its scene, and an engine.
struct OpenedRecording {
  record::Recording recording;
  scene::SceneDesc scene;
  std::unique_ptr<record::Rerun> rerun;  // of the two above
};

/// Opens a file and makes the world the one at its start. The error names the file; `others` gets what else
/// is wrong with its scene.
Result<std::unique_ptr<OpenedRecording>> open_recording(const std::string& file, const Running& running,
                                                        std::vector<Error>* others);

/// `playhouse run --again FILE`: the run once more, as fast as it goes, compared with the recording. Nobody
/// is served meanwhile. Exit code 1 where they differ.
int run_again(const RunOptions& options);

}  // namespace playhouse::app
