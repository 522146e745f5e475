// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The device of each interface of simulated models, defined in playhouse/drivers/interfaces/NAME.cc,
/// and devices specific to a kind, with NAME of the kind.

#include <cstdint>
#include <memory>
#include <optional>

#include "playhouse/drivers/simulated/simulated_device.h"

namespace playhouse::drivers {

/// `model` fits the interface (model_interfaces.h).
std::unique_ptr<SimulatedDevice> make_speech_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_speech_recognition_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_map_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_position2d_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_position3d_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_ranger_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_laser_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_sonar_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_pointcloud3d_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_fiducial_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_blobfinder_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_bumper_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_blinkenlight_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_lightindicator_blinkenlight_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_gripper_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_actarray_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_wifi_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_opaque_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_camera_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_ptz_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_detector_ranger_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_detector_fiducial_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_aio_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_imu_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_gps_device(run::Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_power_device(run::Simulation& simulation, world::ModelRow model);

struct DeviceMaker {
  std::uint16_t interf;
  std::optional<scene::ModelKind> kind;  // any kind, if empty
  std::unique_ptr<SimulatedDevice> (*make)(run::Simulation& simulation, world::ModelRow model);
};
inline constexpr DeviceMaker kDeviceMakers[] = {
    {12, std::nullopt, make_speech_device},
    {50, std::nullopt, make_speech_recognition_device},
    {42, std::nullopt, make_map_device},
    {4, scene::ModelKind::kPosition, make_position2d_device},
    {30, scene::ModelKind::kPosition, make_position3d_device},
    {62, scene::ModelKind::kRanger, make_ranger_device},
    {6, scene::ModelKind::kRanger, make_laser_device},
    {5, scene::ModelKind::kRanger, make_sonar_device},
    {61, scene::ModelKind::kRanger, make_pointcloud3d_device},
    {10, scene::ModelKind::kFiducial, make_fiducial_device},
    {7, scene::ModelKind::kBlobfinder, make_blobfinder_device},
    {14, scene::ModelKind::kBumper, make_bumper_device},
    {33, scene::ModelKind::kBlinkenlight, make_blinkenlight_device},
    {33, scene::ModelKind::kLightindicator, make_lightindicator_blinkenlight_device},
    {3, scene::ModelKind::kGripper, make_gripper_device},
    {53, scene::ModelKind::kActuator, make_actarray_device},
    {23, scene::ModelKind::kWifi, make_wifi_device},
    {51, scene::ModelKind::kWifi, make_opaque_device},
    {40, scene::ModelKind::kCamera, make_camera_device},
    {8, scene::ModelKind::kCamera, make_ptz_device},
    {62, scene::ModelKind::kDetector, make_detector_ranger_device},
    {10, scene::ModelKind::kDetector, make_detector_fiducial_device},
    {21, scene::ModelKind::kCustom, make_aio_device},
    {60, scene::ModelKind::kImu, make_imu_device},
    {13, scene::ModelKind::kGps, make_gps_device},
    {2, std::nullopt, make_power_device},
};

}  // namespace playhouse::drivers
