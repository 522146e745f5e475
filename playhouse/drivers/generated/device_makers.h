// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The device of each interface that a simulated model can have; playhouse/drivers/simulated/NAME.cc defines it.

#include <cstdint>
#include <memory>

#include "playhouse/drivers/simulated/simulated_device.h"

namespace playhouse::drivers {

/// `model` fits the interface (model_interfaces.h).
std::unique_ptr<SimulatedDevice> make_speech_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_position2d_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_ranger_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_laser_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_sonar_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_fiducial_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_blobfinder_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_bumper_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_blinkenlight_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_gripper_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_actarray_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_wifi_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_camera_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_ptz_device(Simulation& simulation, world::ModelRow model);
std::unique_ptr<SimulatedDevice> make_power_device(Simulation& simulation, world::ModelRow model);

struct DeviceMaker {
  std::uint16_t interf;
  std::unique_ptr<SimulatedDevice> (*make)(Simulation& simulation, world::ModelRow model);
};
inline constexpr DeviceMaker kDeviceMakers[] = {
    {12, make_speech_device},
    {4, make_position2d_device},
    {62, make_ranger_device},
    {6, make_laser_device},
    {5, make_sonar_device},
    {10, make_fiducial_device},
    {7, make_blobfinder_device},
    {14, make_bumper_device},
    {33, make_blinkenlight_device},
    {3, make_gripper_device},
    {53, make_actarray_device},
    {23, make_wifi_device},
    {40, make_camera_device},
    {8, make_ptz_device},
    {2, make_power_device},
};

}  // namespace playhouse::drivers
