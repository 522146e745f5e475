// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Sense phases of kinds, each defined in playhouse/senses/sense_NAME.cc.

#include <memory>

#include "playhouse/senses/sense_phase.h"

namespace playhouse::senses {

/// `workers` is the maximum number of concurrent threads.
std::unique_ptr<SensePhase> make_ranger_sense(unsigned workers);
std::unique_ptr<SensePhase> make_fiducial_sense(unsigned workers);
std::unique_ptr<SensePhase> make_blobfinder_sense(unsigned workers);
std::unique_ptr<SensePhase> make_bumper_sense(unsigned workers);
std::unique_ptr<SensePhase> make_gripper_sense(unsigned workers);
std::unique_ptr<SensePhase> make_wifi_sense(unsigned workers);
std::unique_ptr<SensePhase> make_camera_sense(unsigned workers);
std::unique_ptr<SensePhase> make_detector_sense(unsigned workers);
std::unique_ptr<SensePhase> make_custom_sense(unsigned workers);
std::unique_ptr<SensePhase> make_imu_sense(unsigned workers);
std::unique_ptr<SensePhase> make_gps_sense(unsigned workers);

/// Factories of the phase of each kind; an engine with other sensor models has its own.
struct SenseMakers {
  using Make = std::unique_ptr<SensePhase> (*)(unsigned workers);
  Make ranger = make_ranger_sense;
  Make fiducial = make_fiducial_sense;
  Make blobfinder = make_blobfinder_sense;
  Make bumper = make_bumper_sense;
  Make gripper = make_gripper_sense;
  Make wifi = make_wifi_sense;
  Make camera = make_camera_sense;
  Make detector = make_detector_sense;
  Make custom = make_custom_sense;
  Make imu = make_imu_sense;
  Make gps = make_gps_sense;
};

inline void add_senses(Senses& senses, unsigned workers, const SenseMakers& makers = {}) {
  senses.add(makers.ranger(workers));
  senses.add(makers.fiducial(workers));
  senses.add(makers.blobfinder(workers));
  senses.add(makers.bumper(workers));
  senses.add(makers.gripper(workers));
  senses.add(makers.wifi(workers));
  senses.add(makers.camera(workers));
  senses.add(makers.detector(workers));
  senses.add(makers.custom(workers));
  senses.add(makers.imu(workers));
  senses.add(makers.gps(workers));
}

}  // namespace playhouse::senses
