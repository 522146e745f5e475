// Generated from kinds/ by codegen (python3 -m codegen). Do not edit.
#pragma once

/// The columns of the tables of kinds and traits, and the table of each. For columns.h only.

namespace playhouse::world {

template <>
struct ColumnsOf<Positions> {
  static constexpr const char* kTable = "positions";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"positions.model", Role::kDerived, "", "", "", &Positions::model});
    visit(Column{"positions.mode", Role::kMotion, "", "", "decide, commands", &Positions::mode});
    visit(Column{"positions.command", Role::kMotion, "m/s, m/s, m/s, rad/s or m/s^2, m/s^2, m/s^2, rad/s^2", "v_M", "decide, commands", &Positions::command});
    visit(Column{"positions.goal", Role::kMotion, "m, m, m, rad", "X_OG", "decide, commands", &Positions::goal});
    visit(Column{"positions.velocity", Role::kMotion, "m/s, m/s, m/s, rad/s", "v_M", "act", &Positions::velocity});
    visit(Column{"positions.X_OM", Role::kMotion, "m, m, m, rad", "X_OM", "move, set_odometry", &Positions::X_OM});
    visit(Column{"positions.X_WO", Role::kMotion, "m, m, m, rad", "X_WO", "set_odometry", &Positions::X_WO});
    visit(Column{"positions.odom_error", Role::kDerived, "1", "v_M", "", &Positions::odom_error});
    visit(Column{"positions.stall", Role::kMotion, "", "", "move", &Positions::stall});
    visit(Column{"positions.motor_on", Role::kMotion, "", "", "devices", &Positions::motor_on});
  }
};

template <>
struct ColumnsOf<Rangers> {
  static constexpr const char* kTable = "rangers";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"rangers.model", Role::kDerived, "", "", "", &Rangers::model});
    visit(Column{"rangers.first_sensor", Role::kDerived, "", "", "", &Rangers::first_sensor});
    visit(Column{"rangers.sensor_count", Role::kDerived, "", "", "", &Rangers::sensor_count});
    visit(Column{"rangers.measured_tick", Role::kSensed, "", "", "sense", &Rangers::measured_tick});
    visit(Column{"rangers.ring_ranges", Role::kSensed, "m", "", "sense", &Rangers::ring_ranges});
    visit(Column{"rangers.ring_intensities", Role::kSensed, "1", "", "sense", &Rangers::ring_intensities});
  }
};

template <>
struct ColumnsOf<Sensors> {
  static constexpr const char* kTable = "sensors";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"sensors.ranger", Role::kDerived, "", "", "", &Sensors::ranger});
    visit(Column{"sensors.first_beam", Role::kDerived, "", "", "", &Sensors::first_beam});
    visit(Column{"sensors.beam_count", Role::kDerived, "", "", "", &Sensors::beam_count});
    visit(Column{"sensors.ranges", Role::kSensed, "m", "", "sense", &Sensors::ranges, Per::kBeam});
    visit(Column{"sensors.intensities", Role::kSensed, "1", "", "sense", &Sensors::intensities, Per::kBeam});
  }
};

template <>
struct ColumnsOf<Fiducials> {
  static constexpr const char* kTable = "fiducials";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"fiducials.model", Role::kDerived, "", "", "", &Fiducials::model});
    visit(Column{"fiducials.hits", Role::kSensed, "", "", "sense", &Fiducials::hits});
    visit(Column{"fiducials.measured_tick", Role::kSensed, "", "", "sense", &Fiducials::measured_tick});
  }
};

template <>
struct ColumnsOf<Blobfinders> {
  static constexpr const char* kTable = "blobfinders";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"blobfinders.model", Role::kDerived, "", "", "", &Blobfinders::model});
    visit(Column{"blobfinders.blobs", Role::kSensed, "", "", "sense", &Blobfinders::blobs});
    visit(Column{"blobfinders.measured_tick", Role::kSensed, "", "", "sense", &Blobfinders::measured_tick});
  }
};

template <>
struct ColumnsOf<Bumpers> {
  static constexpr const char* kTable = "bumpers";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"bumpers.model", Role::kDerived, "", "", "", &Bumpers::model});
    visit(Column{"bumpers.hits", Role::kSensed, "", "", "sense", &Bumpers::hits});
    visit(Column{"bumpers.measured_tick", Role::kSensed, "", "", "sense", &Bumpers::measured_tick});
  }
};

template <>
struct ColumnsOf<Blinkenlights> {
  static constexpr const char* kTable = "blinkenlights";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"blinkenlights.model", Role::kDerived, "", "", "", &Blinkenlights::model});
    visit(Column{"blinkenlights.enabled", Role::kMark, "", "", "commands", &Blinkenlights::enabled});
    visit(Column{"blinkenlights.period", Role::kMark, "s", "", "commands", &Blinkenlights::period});
    visit(Column{"blinkenlights.dutycycle", Role::kMark, "1", "", "commands", &Blinkenlights::dutycycle});
    visit(Column{"blinkenlights.lit", Role::kMark, "", "", "act", &Blinkenlights::lit});
  }
};

template <>
struct ColumnsOf<Lightindicators> {
  static constexpr const char* kTable = "lightindicators";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"lightindicators.model", Role::kDerived, "", "", "", &Lightindicators::model});
    visit(Column{"lightindicators.lit", Role::kMark, "", "", "commands", &Lightindicators::lit});
  }
};

template <>
struct ColumnsOf<Grippers> {
  static constexpr const char* kTable = "grippers";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"grippers.model", Role::kDerived, "", "", "", &Grippers::model});
    visit(Column{"grippers.paddles", Role::kMotion, "1", "", "act", &Grippers::paddles});
    visit(Column{"grippers.closing", Role::kMotion, "", "", "act, commands", &Grippers::closing});
    visit(Column{"grippers.lift", Role::kMotion, "1", "", "act", &Grippers::lift});
    visit(Column{"grippers.rising", Role::kMotion, "", "", "act, commands", &Grippers::rising});
    visit(Column{"grippers.close_limit", Role::kMotion, "1", "", "act", &Grippers::close_limit});
    visit(Column{"grippers.held", Role::kMotion, "", "", "act", &Grippers::held});
    visit(Column{"grippers.beams", Role::kSensed, "", "", "sense", &Grippers::beams});
    visit(Column{"grippers.contacts", Role::kSensed, "", "", "sense", &Grippers::contacts});
    visit(Column{"grippers.touched", Role::kSensed, "", "", "sense", &Grippers::touched});
    visit(Column{"grippers.measured_tick", Role::kSensed, "", "", "sense", &Grippers::measured_tick});
  }
};

template <>
struct ColumnsOf<Actuators> {
  static constexpr const char* kTable = "actuators";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"actuators.model", Role::kDerived, "", "", "", &Actuators::model});
    visit(Column{"actuators.mode", Role::kMotion, "", "", "commands", &Actuators::mode});
    visit(Column{"actuators.command", Role::kMotion, "m/s or rad/s", "", "commands", &Actuators::command});
    visit(Column{"actuators.goal", Role::kMotion, "m or rad", "", "commands", &Actuators::goal});
    visit(Column{"actuators.speed", Role::kMotion, "m/s or rad/s", "", "devices", &Actuators::speed});
    visit(Column{"actuators.velocity", Role::kMotion, "m/s or rad/s", "", "act", &Actuators::velocity});
    visit(Column{"actuators.position", Role::kMotion, "m or rad", "", "move", &Actuators::position});
    visit(Column{"actuators.X_PJ", Role::kMotion, "m, m, m, rad", "X_PJ", "place", &Actuators::X_PJ});
    visit(Column{"actuators.stall", Role::kMotion, "", "", "move", &Actuators::stall});
    visit(Column{"actuators.motor_on", Role::kMotion, "", "", "devices", &Actuators::motor_on});
    visit(Column{"actuators.braked", Role::kMotion, "", "", "devices", &Actuators::braked});
  }
};

template <>
struct ColumnsOf<Wifis> {
  static constexpr const char* kTable = "wifis";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"wifis.model", Role::kDerived, "", "", "", &Wifis::model});
    visit(Column{"wifis.links", Role::kSensed, "", "", "sense", &Wifis::links});
    visit(Column{"wifis.measured_tick", Role::kSensed, "", "", "sense", &Wifis::measured_tick});
    visit(Column{"wifis.outgoing", Role::kMotion, "", "", "commands, sense", &Wifis::outgoing});
    visit(Column{"wifis.outgoing_bytes", Role::kMotion, "", "", "commands, sense", &Wifis::outgoing_bytes});
    visit(Column{"wifis.incoming", Role::kSensed, "", "", "sense", &Wifis::incoming});
    visit(Column{"wifis.incoming_bytes", Role::kSensed, "", "", "sense", &Wifis::incoming_bytes});
    visit(Column{"wifis.dropped", Role::kSensed, "", "", "commands, sense", &Wifis::dropped});
  }
};

template <>
struct ColumnsOf<Cameras> {
  static constexpr const char* kTable = "cameras";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"cameras.model", Role::kDerived, "", "", "", &Cameras::model});
    visit(Column{"cameras.mode", Role::kMotion, "", "", "devices", &Cameras::mode});
    visit(Column{"cameras.goal_pan", Role::kMotion, "rad", "", "commands", &Cameras::goal_pan});
    visit(Column{"cameras.goal_tilt", Role::kMotion, "rad", "", "commands", &Cameras::goal_tilt});
    visit(Column{"cameras.goal_zoom", Role::kMotion, "rad", "", "commands", &Cameras::goal_zoom});
    visit(Column{"cameras.command_pan", Role::kMotion, "rad/s", "", "commands", &Cameras::command_pan});
    visit(Column{"cameras.command_tilt", Role::kMotion, "rad/s", "", "commands", &Cameras::command_tilt});
    visit(Column{"cameras.pan", Role::kMotion, "rad", "", "act", &Cameras::pan});
    visit(Column{"cameras.tilt", Role::kMotion, "rad", "", "act", &Cameras::tilt});
    visit(Column{"cameras.zoom", Role::kMotion, "rad", "", "act", &Cameras::zoom});
    visit(Column{"cameras.pan_speed", Role::kMotion, "rad/s", "", "act", &Cameras::pan_speed});
    visit(Column{"cameras.tilt_speed", Role::kMotion, "rad/s", "", "act", &Cameras::tilt_speed});
    visit(Column{"cameras.pixels", Role::kSensed, "", "", "sense", &Cameras::pixels});
    visit(Column{"cameras.measured_tick", Role::kSensed, "", "", "sense", &Cameras::measured_tick});
  }
};

template <>
struct ColumnsOf<Detectors> {
  static constexpr const char* kTable = "detectors";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"detectors.model", Role::kDerived, "", "", "", &Detectors::model});
    visit(Column{"detectors.echoes", Role::kSensed, "", "", "sense", &Detectors::echoes});
    visit(Column{"detectors.finds", Role::kSensed, "", "", "sense", &Detectors::finds});
    visit(Column{"detectors.measured_tick", Role::kSensed, "", "", "sense", &Detectors::measured_tick});
  }
};

template <>
struct ColumnsOf<Customs> {
  static constexpr const char* kTable = "customs";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"customs.model", Role::kDerived, "", "", "", &Customs::model});
    visit(Column{"customs.command", Role::kMotion, "1", "", "act, commands", &Customs::command});
    visit(Column{"customs.state", Role::kMotion, "1", "", "act", &Customs::state});
    visit(Column{"customs.velocity", Role::kMotion, "m/s, m/s, m/s, rad/s", "v_M", "act", &Customs::velocity});
    visit(Column{"customs.stall", Role::kMotion, "", "", "move", &Customs::stall});
    visit(Column{"customs.readings", Role::kSensed, "1", "", "sense", &Customs::readings});
    visit(Column{"customs.measured_tick", Role::kSensed, "", "", "sense", &Customs::measured_tick});
  }
};

template <>
struct ColumnsOf<Imus> {
  static constexpr const char* kTable = "imus";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"imus.model", Role::kDerived, "", "", "", &Imus::model});
    visit(Column{"imus.reading", Role::kSensed, "m/s^2, m/s^2, m/s^2, rad/s, rad/s, rad/s", "v_B", "sense", &Imus::reading});
    visit(Column{"imus.bias", Role::kSensed, "m/s^2, m/s^2, m/s^2, rad/s, rad/s, rad/s", "v_B", "sense", &Imus::bias});
    visit(Column{"imus.X_WB", Role::kSensed, "m, m, m, rad", "X_WB", "sense", &Imus::X_WB});
    visit(Column{"imus.tilt_WB", Role::kSensed, "rad", "X_WB", "sense", &Imus::tilt_WB});
    visit(Column{"imus.v_WB", Role::kSensed, "m/s", "v_W", "sense", &Imus::v_WB});
    visit(Column{"imus.X_WE", Role::kSensed, "m, m, m, rad", "X_WB", "sense", &Imus::X_WE});
    visit(Column{"imus.tilt_WE", Role::kSensed, "rad", "X_WB", "sense", &Imus::tilt_WE});
    visit(Column{"imus.v_WE", Role::kSensed, "m/s", "v_W", "sense", &Imus::v_WE});
    visit(Column{"imus.heading_error", Role::kSensed, "rad", "", "sense", &Imus::heading_error});
    visit(Column{"imus.reference_heading", Role::kMotion, "rad", "", "devices", &Imus::reference_heading});
    visit(Column{"imus.reference_tilt", Role::kMotion, "rad", "X_WB", "devices", &Imus::reference_tilt});
    visit(Column{"imus.noted_tick", Role::kSensed, "", "", "sense", &Imus::noted_tick});
    visit(Column{"imus.measured_tick", Role::kSensed, "", "", "sense", &Imus::measured_tick});
  }
};

template <>
struct ColumnsOf<Receivers> {
  static constexpr const char* kTable = "receivers";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"receivers.model", Role::kDerived, "", "", "", &Receivers::model});
    visit(Column{"receivers.position", Role::kSensed, "m", "X_WB", "sense", &Receivers::position});
    visit(Column{"receivers.velocity", Role::kSensed, "m/s", "v_W", "sense", &Receivers::velocity});
    visit(Column{"receivers.drift", Role::kSensed, "m", "X_WB", "sense", &Receivers::drift});
    visit(Column{"receivers.p_WB", Role::kSensed, "m", "X_WB", "sense", &Receivers::p_WB});
    visit(Column{"receivers.noted_tick", Role::kSensed, "", "", "sense", &Receivers::noted_tick});
    visit(Column{"receivers.measured_tick", Role::kSensed, "", "", "sense", &Receivers::measured_tick});
  }
};

template <>
struct ColumnsOf<Packs> {
  static constexpr const char* kTable = "packs";
  template <typename Visit>
  static constexpr void each(const Visit& visit) {
    visit(Column{"packs.model", Role::kDerived, "", "", "", &Packs::model});
    visit(Column{"packs.stored", Role::kMotion, "J", "", "energy", &Packs::stored});
    visit(Column{"packs.capacity", Role::kDerived, "J", "", "", &Packs::capacity});
    visit(Column{"packs.dissipated", Role::kMotion, "J", "", "energy", &Packs::dissipated});
    visit(Column{"packs.watts", Role::kMotion, "W", "", "energy", &Packs::watts});
    visit(Column{"packs.charging", Role::kMotion, "", "", "energy", &Packs::charging});
    visit(Column{"packs.takes", Role::kMotion, "", "", "devices", &Packs::takes});
    visit(Column{"packs.gives", Role::kMotion, "", "", "devices", &Packs::gives});
  }
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
