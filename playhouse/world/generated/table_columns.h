// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The columns of the tables of kinds and traits, and the table of each. For columns.h only.

namespace playhouse::world {

template <>
inline constexpr auto kColumns<Positions> = std::tuple{
    Column{"positions.model", Role::kDerived, "", "", "", &Positions::model},
    Column{"positions.mode", Role::kMotion, "", "", "decide, commands", &Positions::mode},
    Column{"positions.command", Role::kMotion, "m/s, m/s, m/s, rad/s or m/s^2, m/s^2, m/s^2, rad/s^2", "v_M", "decide, commands", &Positions::command},
    Column{"positions.goal", Role::kMotion, "m, m, m, rad", "X_OG", "decide, commands", &Positions::goal},
    Column{"positions.velocity", Role::kMotion, "m/s, m/s, m/s, rad/s", "v_M", "act", &Positions::velocity},
    Column{"positions.X_OM", Role::kMotion, "m, m, m, rad", "X_OM", "move, set_odometry", &Positions::X_OM},
    Column{"positions.X_WO", Role::kMotion, "m, m, m, rad", "X_WO", "set_odometry", &Positions::X_WO},
    Column{"positions.odom_error", Role::kDerived, "1", "v_M", "", &Positions::odom_error},
    Column{"positions.stall", Role::kMotion, "", "", "move", &Positions::stall},
    Column{"positions.motor_on", Role::kMotion, "", "", "devices", &Positions::motor_on},
};

template <>
inline constexpr auto kColumns<Rangers> = std::tuple{
    Column{"rangers.model", Role::kDerived, "", "", "", &Rangers::model},
    Column{"rangers.first_sensor", Role::kDerived, "", "", "", &Rangers::first_sensor},
    Column{"rangers.sensor_count", Role::kDerived, "", "", "", &Rangers::sensor_count},
    Column{"rangers.measured_tick", Role::kSensed, "", "", "sense", &Rangers::measured_tick},
    Column{"rangers.ring_ranges", Role::kSensed, "m", "", "sense", &Rangers::ring_ranges},
    Column{"rangers.ring_intensities", Role::kSensed, "1", "", "sense", &Rangers::ring_intensities},
};

template <>
inline constexpr auto kColumns<Sensors> = std::tuple{
    Column{"sensors.ranger", Role::kDerived, "", "", "", &Sensors::ranger},
    Column{"sensors.first_beam", Role::kDerived, "", "", "", &Sensors::first_beam},
    Column{"sensors.beam_count", Role::kDerived, "", "", "", &Sensors::beam_count},
    Column{"sensors.ranges", Role::kSensed, "m", "", "sense", &Sensors::ranges, Per::kBeam},
    Column{"sensors.intensities", Role::kSensed, "1", "", "sense", &Sensors::intensities, Per::kBeam},
};

template <>
inline constexpr auto kColumns<Fiducials> = std::tuple{
    Column{"fiducials.model", Role::kDerived, "", "", "", &Fiducials::model},
    Column{"fiducials.hits", Role::kSensed, "", "", "sense", &Fiducials::hits},
    Column{"fiducials.measured_tick", Role::kSensed, "", "", "sense", &Fiducials::measured_tick},
};

template <>
inline constexpr auto kColumns<Blobfinders> = std::tuple{
    Column{"blobfinders.model", Role::kDerived, "", "", "", &Blobfinders::model},
    Column{"blobfinders.blobs", Role::kSensed, "", "", "sense", &Blobfinders::blobs},
    Column{"blobfinders.measured_tick", Role::kSensed, "", "", "sense", &Blobfinders::measured_tick},
};

template <>
inline constexpr auto kColumns<Bumpers> = std::tuple{
    Column{"bumpers.model", Role::kDerived, "", "", "", &Bumpers::model},
    Column{"bumpers.hits", Role::kSensed, "", "", "sense", &Bumpers::hits},
    Column{"bumpers.measured_tick", Role::kSensed, "", "", "sense", &Bumpers::measured_tick},
};

template <>
inline constexpr auto kColumns<Blinkenlights> = std::tuple{
    Column{"blinkenlights.model", Role::kDerived, "", "", "", &Blinkenlights::model},
    Column{"blinkenlights.enabled", Role::kMark, "", "", "commands", &Blinkenlights::enabled},
    Column{"blinkenlights.period", Role::kMark, "s", "", "commands", &Blinkenlights::period},
    Column{"blinkenlights.dutycycle", Role::kMark, "1", "", "commands", &Blinkenlights::dutycycle},
    Column{"blinkenlights.lit", Role::kMark, "", "", "act", &Blinkenlights::lit},
};

template <>
inline constexpr auto kColumns<Lightindicators> = std::tuple{
    Column{"lightindicators.model", Role::kDerived, "", "", "", &Lightindicators::model},
    Column{"lightindicators.lit", Role::kMark, "", "", "commands", &Lightindicators::lit},
};

template <>
inline constexpr auto kColumns<Grippers> = std::tuple{
    Column{"grippers.model", Role::kDerived, "", "", "", &Grippers::model},
    Column{"grippers.paddles", Role::kMotion, "1", "", "act", &Grippers::paddles},
    Column{"grippers.closing", Role::kMotion, "", "", "act, commands", &Grippers::closing},
    Column{"grippers.lift", Role::kMotion, "1", "", "act", &Grippers::lift},
    Column{"grippers.rising", Role::kMotion, "", "", "act, commands", &Grippers::rising},
    Column{"grippers.close_limit", Role::kMotion, "1", "", "act", &Grippers::close_limit},
    Column{"grippers.held", Role::kMotion, "", "", "act", &Grippers::held},
    Column{"grippers.beams", Role::kSensed, "", "", "sense", &Grippers::beams},
    Column{"grippers.contacts", Role::kSensed, "", "", "sense", &Grippers::contacts},
    Column{"grippers.touched", Role::kSensed, "", "", "sense", &Grippers::touched},
    Column{"grippers.measured_tick", Role::kSensed, "", "", "sense", &Grippers::measured_tick},
};

template <>
inline constexpr auto kColumns<Actuators> = std::tuple{
    Column{"actuators.model", Role::kDerived, "", "", "", &Actuators::model},
    Column{"actuators.mode", Role::kMotion, "", "", "commands", &Actuators::mode},
    Column{"actuators.command", Role::kMotion, "m/s or rad/s", "", "commands", &Actuators::command},
    Column{"actuators.goal", Role::kMotion, "m or rad", "", "commands", &Actuators::goal},
    Column{"actuators.speed", Role::kMotion, "m/s or rad/s", "", "devices", &Actuators::speed},
    Column{"actuators.velocity", Role::kMotion, "m/s or rad/s", "", "act", &Actuators::velocity},
    Column{"actuators.position", Role::kMotion, "m or rad", "", "move", &Actuators::position},
    Column{"actuators.X_PJ", Role::kMotion, "m, m, m, rad", "X_PJ", "place", &Actuators::X_PJ},
    Column{"actuators.stall", Role::kMotion, "", "", "move", &Actuators::stall},
    Column{"actuators.motor_on", Role::kMotion, "", "", "devices", &Actuators::motor_on},
    Column{"actuators.braked", Role::kMotion, "", "", "devices", &Actuators::braked},
};

template <>
inline constexpr auto kColumns<Wifis> = std::tuple{
    Column{"wifis.model", Role::kDerived, "", "", "", &Wifis::model},
    Column{"wifis.links", Role::kSensed, "", "", "sense", &Wifis::links},
    Column{"wifis.measured_tick", Role::kSensed, "", "", "sense", &Wifis::measured_tick},
    Column{"wifis.outgoing", Role::kMotion, "", "", "commands, sense", &Wifis::outgoing},
    Column{"wifis.outgoing_bytes", Role::kMotion, "", "", "commands, sense", &Wifis::outgoing_bytes},
    Column{"wifis.incoming", Role::kSensed, "", "", "sense", &Wifis::incoming},
    Column{"wifis.incoming_bytes", Role::kSensed, "", "", "sense", &Wifis::incoming_bytes},
    Column{"wifis.dropped", Role::kSensed, "", "", "commands, sense", &Wifis::dropped},
};

template <>
inline constexpr auto kColumns<Cameras> = std::tuple{
    Column{"cameras.model", Role::kDerived, "", "", "", &Cameras::model},
    Column{"cameras.mode", Role::kMotion, "", "", "devices", &Cameras::mode},
    Column{"cameras.goal_pan", Role::kMotion, "rad", "", "commands", &Cameras::goal_pan},
    Column{"cameras.goal_tilt", Role::kMotion, "rad", "", "commands", &Cameras::goal_tilt},
    Column{"cameras.goal_zoom", Role::kMotion, "rad", "", "commands", &Cameras::goal_zoom},
    Column{"cameras.command_pan", Role::kMotion, "rad/s", "", "commands", &Cameras::command_pan},
    Column{"cameras.command_tilt", Role::kMotion, "rad/s", "", "commands", &Cameras::command_tilt},
    Column{"cameras.pan", Role::kMotion, "rad", "", "act", &Cameras::pan},
    Column{"cameras.tilt", Role::kMotion, "rad", "", "act", &Cameras::tilt},
    Column{"cameras.zoom", Role::kMotion, "rad", "", "act", &Cameras::zoom},
    Column{"cameras.pan_speed", Role::kMotion, "rad/s", "", "act", &Cameras::pan_speed},
    Column{"cameras.tilt_speed", Role::kMotion, "rad/s", "", "act", &Cameras::tilt_speed},
    Column{"cameras.pixels", Role::kSensed, "", "", "sense", &Cameras::pixels},
    Column{"cameras.measured_tick", Role::kSensed, "", "", "sense", &Cameras::measured_tick},
};

template <>
inline constexpr auto kColumns<Detectors> = std::tuple{
    Column{"detectors.model", Role::kDerived, "", "", "", &Detectors::model},
    Column{"detectors.echoes", Role::kSensed, "", "", "sense", &Detectors::echoes},
    Column{"detectors.finds", Role::kSensed, "", "", "sense", &Detectors::finds},
    Column{"detectors.measured_tick", Role::kSensed, "", "", "sense", &Detectors::measured_tick},
};

template <>
inline constexpr auto kColumns<Customs> = std::tuple{
    Column{"customs.model", Role::kDerived, "", "", "", &Customs::model},
    Column{"customs.command", Role::kMotion, "1", "", "act, commands", &Customs::command},
    Column{"customs.state", Role::kMotion, "1", "", "act", &Customs::state},
    Column{"customs.velocity", Role::kMotion, "m/s, m/s, m/s, rad/s", "v_M", "act", &Customs::velocity},
    Column{"customs.stall", Role::kMotion, "", "", "move", &Customs::stall},
    Column{"customs.readings", Role::kSensed, "1", "", "sense", &Customs::readings},
    Column{"customs.measured_tick", Role::kSensed, "", "", "sense", &Customs::measured_tick},
};

template <>
inline constexpr auto kColumns<Imus> = std::tuple{
    Column{"imus.model", Role::kDerived, "", "", "", &Imus::model},
    Column{"imus.reading", Role::kSensed, "m/s^2, m/s^2, m/s^2, rad/s, rad/s, rad/s", "v_B", "sense", &Imus::reading},
    Column{"imus.bias", Role::kSensed, "m/s^2, m/s^2, m/s^2, rad/s, rad/s, rad/s", "v_B", "sense", &Imus::bias},
    Column{"imus.X_WB", Role::kSensed, "m, m, m, rad", "X_WB", "sense", &Imus::X_WB},
    Column{"imus.tilt_WB", Role::kSensed, "rad", "X_WB", "sense", &Imus::tilt_WB},
    Column{"imus.v_WB", Role::kSensed, "m/s", "v_W", "sense", &Imus::v_WB},
    Column{"imus.X_WE", Role::kSensed, "m, m, m, rad", "X_WB", "sense", &Imus::X_WE},
    Column{"imus.tilt_WE", Role::kSensed, "rad", "X_WB", "sense", &Imus::tilt_WE},
    Column{"imus.v_WE", Role::kSensed, "m/s", "v_W", "sense", &Imus::v_WE},
    Column{"imus.heading_error", Role::kSensed, "rad", "", "sense", &Imus::heading_error},
    Column{"imus.reference_heading", Role::kMotion, "rad", "", "devices", &Imus::reference_heading},
    Column{"imus.reference_tilt", Role::kMotion, "rad", "X_WB", "devices", &Imus::reference_tilt},
    Column{"imus.noted_tick", Role::kSensed, "", "", "sense", &Imus::noted_tick},
    Column{"imus.measured_tick", Role::kSensed, "", "", "sense", &Imus::measured_tick},
};

template <>
inline constexpr auto kColumns<Receivers> = std::tuple{
    Column{"receivers.model", Role::kDerived, "", "", "", &Receivers::model},
    Column{"receivers.position", Role::kSensed, "m", "X_WB", "sense", &Receivers::position},
    Column{"receivers.velocity", Role::kSensed, "m/s", "v_W", "sense", &Receivers::velocity},
    Column{"receivers.drift", Role::kSensed, "m", "X_WB", "sense", &Receivers::drift},
    Column{"receivers.p_WB", Role::kSensed, "m", "X_WB", "sense", &Receivers::p_WB},
    Column{"receivers.noted_tick", Role::kSensed, "", "", "sense", &Receivers::noted_tick},
    Column{"receivers.measured_tick", Role::kSensed, "", "", "sense", &Receivers::measured_tick},
};

template <>
inline constexpr auto kColumns<Packs> = std::tuple{
    Column{"packs.model", Role::kDerived, "", "", "", &Packs::model},
    Column{"packs.stored", Role::kMotion, "J", "", "energy", &Packs::stored},
    Column{"packs.capacity", Role::kDerived, "J", "", "", &Packs::capacity},
    Column{"packs.dissipated", Role::kMotion, "J", "", "energy", &Packs::dissipated},
    Column{"packs.watts", Role::kMotion, "W", "", "energy", &Packs::watts},
    Column{"packs.charging", Role::kMotion, "", "", "energy", &Packs::charging},
    Column{"packs.takes", Role::kMotion, "", "", "devices", &Packs::takes},
    Column{"packs.gives", Role::kMotion, "", "", "devices", &Packs::gives},
};

/// The kind whose models have a row each; of parts' and traits' tables there is none.
template <typename Table>
inline constexpr auto kKindOf = nullptr;
template <>
inline constexpr scene::ModelKind kKindOf<Positions> = scene::ModelKind::kPosition;
template <>
inline constexpr scene::ModelKind kKindOf<Rangers> = scene::ModelKind::kRanger;
template <>
inline constexpr scene::ModelKind kKindOf<Fiducials> = scene::ModelKind::kFiducial;
template <>
inline constexpr scene::ModelKind kKindOf<Blobfinders> = scene::ModelKind::kBlobfinder;
template <>
inline constexpr scene::ModelKind kKindOf<Bumpers> = scene::ModelKind::kBumper;
template <>
inline constexpr scene::ModelKind kKindOf<Blinkenlights> = scene::ModelKind::kBlinkenlight;
template <>
inline constexpr scene::ModelKind kKindOf<Lightindicators> = scene::ModelKind::kLightindicator;
template <>
inline constexpr scene::ModelKind kKindOf<Grippers> = scene::ModelKind::kGripper;
template <>
inline constexpr scene::ModelKind kKindOf<Actuators> = scene::ModelKind::kActuator;
template <>
inline constexpr scene::ModelKind kKindOf<Wifis> = scene::ModelKind::kWifi;
template <>
inline constexpr scene::ModelKind kKindOf<Cameras> = scene::ModelKind::kCamera;
template <>
inline constexpr scene::ModelKind kKindOf<Detectors> = scene::ModelKind::kDetector;
template <>
inline constexpr scene::ModelKind kKindOf<Customs> = scene::ModelKind::kCustom;
template <>
inline constexpr scene::ModelKind kKindOf<Imus> = scene::ModelKind::kImu;
template <>
inline constexpr scene::ModelKind kKindOf<Receivers> = scene::ModelKind::kGps;

/// The trait whose models have a row each; of other tables there is none.
template <typename Table>
inline constexpr auto kHas = nullptr;
template <>
inline constexpr auto kHas<Packs> = scene::has_pack;
template <typename Table>
inline constexpr auto kTraitTable = nullptr;
template <>
inline constexpr auto kTraitTable<Packs> = &Tables::packs;

inline constexpr std::tuple kTables{&Tables::models, &Tables::positions, &Tables::rangers, &Tables::sensors, &Tables::fiducials, &Tables::blobfinders, &Tables::bumpers, &Tables::blinkenlights, &Tables::lightindicators, &Tables::grippers, &Tables::actuators, &Tables::wifis, &Tables::cameras, &Tables::detectors, &Tables::customs, &Tables::imus, &Tables::receivers, &Tables::packs};

/// Those of kinds: a row for each model of the kind, in the order of the models.
inline constexpr std::tuple kKindTables{&Tables::positions, &Tables::rangers, &Tables::fiducials, &Tables::blobfinders, &Tables::bumpers, &Tables::blinkenlights, &Tables::lightindicators, &Tables::grippers, &Tables::actuators, &Tables::wifis, &Tables::cameras, &Tables::detectors, &Tables::customs, &Tables::imus, &Tables::receivers};

/// Those of traits: a row for each model that has it, in the order of the models.
inline constexpr std::tuple kTraitTables{&Tables::packs};

}  // namespace playhouse::world
