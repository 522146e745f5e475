/** What << prints of proxies and of the structs of messages, a part of playerc++.h. */
#ifndef LIBPLAYERCPP_PRINT_H
#define LIBPLAYERCPP_PRINT_H

#ifndef PLAYERCC_BASE
#error "include <libplayerc++/playerc++.h>"
#endif

// The structs are of no namespace, so that their operators are not either.

inline std::ostream &operator<<(std::ostream &os, const player_point_2d_t &point) {
  return os << point.px << " " << point.py;
}
inline std::ostream &operator<<(std::ostream &os, const player_point_3d_t &point) {
  return os << point.px << " " << point.py << " " << point.pz;
}
inline std::ostream &operator<<(std::ostream &os, const player_pose2d_t &pose) {
  return os << pose.px << " " << pose.py << " " << pose.pa;
}
inline std::ostream &operator<<(std::ostream &os, const player_pose3d_t &pose) {
  return os << pose.px << " " << pose.py << " " << pose.pz << " " << pose.proll << " " << pose.ppitch << " "
            << pose.pyaw;
}
inline std::ostream &operator<<(std::ostream &os, const player_bbox2d_t &box) {
  return os << box.sw << " " << box.sl;
}
inline std::ostream &operator<<(std::ostream &os, const player_bbox3d_t &box) {
  return os << box.sw << " " << box.sl << " " << box.sh;
}
inline std::ostream &operator<<(std::ostream &os, const player_segment_t &segment) {
  return os << segment.x0 << " " << segment.y0 << " to " << segment.x1 << " " << segment.y1;
}
inline std::ostream &operator<<(std::ostream &os, const player_extent2d_t &extent) {
  return os << extent.x0 << " " << extent.y0 << " to " << extent.x1 << " " << extent.y1;
}
inline std::ostream &operator<<(std::ostream &os, const playerc_device_info_t &device) {
  return os << interf_to_str(device.addr.interf) << ":" << device.addr.index << " (" << device.drivername
            << ")";
}

namespace PlayerCc {

/** Of those that have nothing else to print: "audio:0". */
inline std::ostream &operator<<(std::ostream &os, const ClientProxy &proxy) {
  return os << proxy.GetInterfaceStr() << ":" << proxy.GetIndex();
}

/** "181 ranges: 8 8 8": each is what `of` makes of its number. */
template <typename Of>
std::ostream &PrintList(std::ostream &os, uint32_t count, const char *what, Of of) {
  os << count << " " << what << ":";
  for (uint32_t i = 0; i < count; ++i) os << " " << of(i);
  return os;
}

// --- bases, and where they are

inline std::ostream &operator<<(std::ostream &os, const Position1dProxy &base) {
  return os << "at " << base.GetPos() << ", speed " << base.GetVel() << (base.GetStall() ? ", stalled" : "");
}
inline std::ostream &operator<<(std::ostream &os, const Position2dProxy &base) {
  return os << "at " << base.GetXPos() << " " << base.GetYPos() << " " << base.GetYaw() << ", speed "
            << base.GetXSpeed() << " " << base.GetYSpeed() << " " << base.GetYawSpeed()
            << (base.GetStall() ? ", stalled" : "");
}
inline std::ostream &operator<<(std::ostream &os, const Position3dProxy &base) {
  return os << "at " << base.GetXPos() << " " << base.GetYPos() << " " << base.GetZPos() << " "
            << base.GetRoll() << " " << base.GetPitch() << " " << base.GetYaw() << ", speed "
            << base.GetXSpeed() << " " << base.GetYSpeed() << " " << base.GetZSpeed() << " "
            << base.GetRollSpeed() << " " << base.GetPitchSpeed() << " " << base.GetYawSpeed()
            << (base.GetStall() ? ", stalled" : "");
}
inline std::ostream &operator<<(std::ostream &os, const GpsProxy &gps) {
  return os << "latitude " << gps.GetLatitude() << ", longitude " << gps.GetLongitude() << ", altitude "
            << gps.GetAltitude() << ", " << gps.GetSatellites() << " satellites, quality "
            << gps.GetQuality();
}
inline std::ostream &operator<<(std::ostream &os, const ImuProxy &imu) {
  const player_imu_data_calib_t raw = imu.GetRawValues();
  return os << "pose " << imu.GetPose() << ", acceleration " << raw.accel_x << " " << raw.accel_y << " "
            << raw.accel_z << ", turning " << raw.gyro_x << " " << raw.gyro_y << " " << raw.gyro_z
            << ", magnetic field " << raw.magn_x << " " << raw.magn_y << " " << raw.magn_z;
}
inline std::ostream &operator<<(std::ostream &os, const LocalizeProxy &place) {
  return PrintList(os, place.GetHypothCount(), "hypotheses", [&place](uint32_t i) {
    const player_localize_hypoth_t each = place.GetHypoth(i);
    return std::to_string(each.mean.px) + " " + std::to_string(each.mean.py) + " " +
           std::to_string(each.mean.pa) + " weight " + std::to_string(each.alpha);
  });
}
inline std::ostream &operator<<(std::ostream &os, const PlannerProxy &planner) {
  return os << "at " << planner.GetPose() << ", goal " << planner.GetGoal() << ", waypoint "
            << planner.GetCurrentWaypointId() << " of " << planner.GetWaypointCount()
            << (planner.GetPathDone() != 0    ? ", arrived"
                : planner.GetPathValid() != 0 ? ""
                                              : ", no path");
}
inline std::ostream &operator<<(std::ostream &os, const MapProxy &map) {
  return os << map.GetWidth() << " x " << map.GetHeight() << " cells of " << map.GetResolution() << " m from "
            << map.GetOriginX() << " " << map.GetOriginY();
}
inline std::ostream &operator<<(std::ostream &os, const VectorMapProxy &map) {
  const std::vector<std::string> names = map.GetLayerNames();
  return PrintList(os, static_cast<uint32_t>(names.size()), "layers",
                   [&names](uint32_t i) { return names[i]; });
}

// --- what sensors measure

inline std::ostream &operator<<(std::ostream &os, const LaserProxy &laser) {
  return PrintList(os, laser.GetCount(), "ranges", [&laser](uint32_t i) { return laser[i]; });
}
inline std::ostream &operator<<(std::ostream &os, const RangerProxy &ranger) {
  return PrintList(os, ranger.GetRangeCount(), "ranges", [&ranger](uint32_t i) { return ranger[i]; });
}
inline std::ostream &operator<<(std::ostream &os, const SonarProxy &sonar) {
  return PrintList(os, sonar.GetCount(), "ranges", [&sonar](uint32_t i) { return sonar[i]; });
}
inline std::ostream &operator<<(std::ostream &os, const IrProxy &ir) {
  return PrintList(os, ir.GetCount(), "ranges", [&ir](uint32_t i) { return ir[i]; });
}
inline std::ostream &operator<<(std::ostream &os, const BumperProxy &bumper) {
  return PrintList(os, bumper.GetCount(), "bumpers", [&bumper](uint32_t i) { return bumper.IsBumped(i); });
}
inline std::ostream &operator<<(std::ostream &os, const AioProxy &inputs) {
  return PrintList(os, inputs.GetCount(), "voltages", [&inputs](uint32_t i) { return inputs[i]; });
}
inline std::ostream &operator<<(std::ostream &os, const DioProxy &inputs) {
  return PrintList(os, inputs.GetCount(), "inputs", [&inputs](uint32_t i) { return inputs[i]; });
}
inline std::ostream &operator<<(std::ostream &os, const LinuxjoystickProxy &stick) {
  PrintList(os, stick.GetAxesCount(), "axes", [&stick](uint32_t i) { return stick[i]; });
  return os << ", buttons " << stick.GetButtons();
}
inline std::ostream &operator<<(std::ostream &os, const PowerProxy &power) {
  return os << power.GetCharge() << " V, " << power.GetPercent() << " %, " << power.GetJoules() << " J, "
            << power.GetWatts() << " W" << (power.GetCharging() ? ", charging" : "");
}
inline std::ostream &operator<<(std::ostream &os, const HealthProxy &health) {
  return os << health.GetIdleCPU() << " % idle, memory " << health.GetMemUsed() << " of "
            << health.GetMemTotal() << ", swap " << health.GetSwapUsed() << " of " << health.GetSwapTotal();
}
inline std::ostream &operator<<(std::ostream &os, const RFIDProxy &reader) {
  return PrintList(os, reader.GetTagsCount(), "tags of types",
                   [&reader](uint32_t i) { return reader[i].type; });
}
inline std::ostream &operator<<(std::ostream &os, const WSNProxy &node) {
  const player_wsn_node_data_t data = node.GetNodeDataPacket();
  return os << "node " << node.GetNodeID() << " of type " << node.GetNodeType() << ", light " << data.light
            << ", temperature " << data.temperature << ", battery " << data.battery;
}
inline std::ostream &operator<<(std::ostream &os, const WiFiProxy &radio) {
  return PrintList(os, static_cast<uint32_t>(radio.GetLinkCount()), "links", [&radio](uint32_t i) {
    const int link = static_cast<int>(i);
    return std::string(radio.GetLinkESSID(link)) + " " + std::to_string(radio.GetLinkQuality(link));
  });
}

// --- cameras, and what is found

inline std::ostream &operator<<(std::ostream &os, const CameraProxy &camera) {
  return os << camera.GetWidth() << " x " << camera.GetHeight() << " pixels of " << camera.GetDepth()
            << " bits, format " << camera.GetFormat() << ", compression " << camera.GetCompression() << ", "
            << camera.GetImageSize() << " bytes";
}
inline std::ostream &operator<<(std::ostream &os, const StereoProxy &eyes) {
  return os << eyes.GetLeftWidth() << " x " << eyes.GetLeftHeight() << " and " << eyes.GetRightWidth()
            << " x " << eyes.GetRightHeight() << " pixels, " << eyes.GetCount() << " points";
}
inline std::ostream &operator<<(std::ostream &os, const Pointcloud3dProxy &cloud) {
  return os << cloud.GetCount() << " points";
}
inline std::ostream &operator<<(std::ostream &os, const BlobfinderProxy &finder) {
  return PrintList(os, finder.GetCount(), "blobs", [&finder](uint32_t i) {
    const playerc_blobfinder_blob_t blob = finder[i];
    return std::to_string(blob.id) + " at " + std::to_string(blob.x) + " " + std::to_string(blob.y);
  });
}
inline std::ostream &operator<<(std::ostream &os, const FiducialProxy &finder) {
  os << finder.GetCount() << " fiducials:";
  for (uint32_t i = 0; i < finder.GetCount(); ++i) os << " " << finder[i].id << " at " << finder[i].pose;
  return os;
}
inline std::ostream &operator<<(std::ostream &os, const PtzProxy &camera) {
  return os << "pan " << camera.GetPan() << ", tilt " << camera.GetTilt() << ", zoom " << camera.GetZoom();
}

// --- what moves, speaks and tells

inline std::ostream &operator<<(std::ostream &os, const ActArrayProxy &arm) {
  return PrintList(os, arm.GetCount(), "joints at",
                   [&arm](uint32_t i) { return arm.GetActuatorData(i).position; });
}
inline std::ostream &operator<<(std::ostream &os, const LimbProxy &limb) {
  return os << "at " << limb.GetData().position << ", state " << static_cast<int>(limb.GetData().state);
}
inline std::ostream &operator<<(std::ostream &os, const GripperProxy &gripper) {
  return os << "state " << gripper.GetState() << ", beams " << gripper.GetBeams() << ", stored "
            << gripper.GetStored();
}
inline std::ostream &operator<<(std::ostream &os, const SpeechRecognitionProxy &ears) {
  return PrintList(os, ears.GetCount(), "words", [&ears](uint32_t i) { return ears.GetWord(i); });
}
inline std::ostream &operator<<(std::ostream &os, const LogProxy &log) {
  return os << (log.GetType() == PLAYER_LOG_TYPE_WRITE ? "writes" : "reads")
            << (log.GetState() != 0 ? "" : ", stopped");
}
inline std::ostream &operator<<(std::ostream &os, const OpaqueProxy &device) {
  return os << device.GetCount() << " bytes";
}
inline std::ostream &operator<<(std::ostream &os, const CoopObjectProxy &mote) {
  return os << "message " << mote.MessageType() << " of " << mote.GetID() << ", at " << mote.GetX() << " "
            << mote.GetY() << " " << mote.GetZ() << ", " << mote.GetSensorNumber() << " sensors, "
            << mote.GetAlarmNumber() << " alarms, " << mote.GetUserDataNumber() << " bytes";
}

}  // namespace PlayerCc

#endif /* LIBPLAYERCPP_PRINT_H */
