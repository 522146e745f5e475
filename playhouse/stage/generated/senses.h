// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The sense phase of each kind that measures; playhouse/stage/sense_NAME.cc defines it.

#include <memory>

#include "playhouse/stage/sense_phase.h"

namespace playhouse::stage {

/// `workers` is how many threads may measure at once.
std::unique_ptr<SensePhase> make_ranger_sense(unsigned workers);
std::unique_ptr<SensePhase> make_fiducial_sense(unsigned workers);
std::unique_ptr<SensePhase> make_blobfinder_sense(unsigned workers);
std::unique_ptr<SensePhase> make_bumper_sense(unsigned workers);
std::unique_ptr<SensePhase> make_gripper_sense(unsigned workers);
std::unique_ptr<SensePhase> make_wifi_sense(unsigned workers);
std::unique_ptr<SensePhase> make_camera_sense(unsigned workers);
std::unique_ptr<SensePhase> make_detector_sense(unsigned workers);
std::unique_ptr<SensePhase> make_custom_sense(unsigned workers);

inline void add_senses(Senses& senses, unsigned workers) {
  senses.add(make_ranger_sense(workers));
  senses.add(make_fiducial_sense(workers));
  senses.add(make_blobfinder_sense(workers));
  senses.add(make_bumper_sense(workers));
  senses.add(make_gripper_sense(workers));
  senses.add(make_wifi_sense(workers));
  senses.add(make_camera_sense(workers));
  senses.add(make_detector_sense(workers));
  senses.add(make_custom_sense(workers));
}

}  // namespace playhouse::stage
