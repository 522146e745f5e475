/** The C++ client library of Player 3, by its old names, on top of libplayerc/playerc.h. It needs C++11, and has no
 * library of its own. What is missing is not declared: docs/moving-from-player.md. */
#ifndef LIBPLAYERCPP_PLAYERCPP_H
#define LIBPLAYERCPP_PLAYERCPP_H

#include <libplayerc++/clientproxy.h>
#include <libplayerc++/playerc++config.h>

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace PlayerCc {

/** A proxy of the C library as a member, for as long as this object is there. */
template <typename T, T *(*Create)(playerc_client_t *, int), void (*Destroy)(T *), int (*Open)(T *, int),
          int (*Close)(T *)>
class DeviceProxy : public ClientProxy {
 public:
  ~DeviceProxy() override {
    scoped_lock_t lock(mPc->mMutex);
    Leave();
    if (mPc->Connected()) Close(mDevice);
    Destroy(mDevice);
  }

 protected:
  DeviceProxy(PlayerClient *aPc, uint32_t aIndex) : ClientProxy(aPc) {
    scoped_lock_t lock(mPc->mMutex);
    mDevice = Create(mPc->mClient, static_cast<int>(aIndex));
    if (mDevice == NULL) throw PlayerError("ClientProxy", playerc_error_str());
    if (Open(mDevice, PLAYER_OPEN_MODE) != 0) {
      const PlayerError error("ClientProxy", playerc_error_str());
      Destroy(mDevice);
      throw error;
    }
    mInfo = &mDevice->info;
  }

  T *mDevice;
};

/** The base of the proxy of an interface. */
#define PLAYERCC_BASE(NAME)                                                          \
  DeviceProxy<playerc_##NAME##_t, playerc_##NAME##_create, playerc_##NAME##_destroy, \
              playerc_##NAME##_subscribe, playerc_##NAME##_unsubscribe>

/** A request or command of the C library under the lock, which throws if it fails. */
#define PLAYERCC_DO(FUNCTION, ...)           \
  do {                                       \
    scoped_lock_t lock(mPc->mMutex);         \
    Check(FUNCTION(__VA_ARGS__), #FUNCTION); \
  } while (0)

// --- bases

class Position2dProxy : public PLAYERCC_BASE(position2d) {
 public:
  Position2dProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void SetSpeed(double aXSpeed, double aYSpeed, double aYawSpeed) {
    PLAYERCC_DO(playerc_position2d_set_cmd_vel, mDevice, aXSpeed, aYSpeed, aYawSpeed, 1);
  }
  void SetSpeed(double aXSpeed, double aYawSpeed) { SetSpeed(aXSpeed, 0, aYawSpeed); }
  void SetSpeed(player_pose2d_t vel) { SetSpeed(vel.px, vel.py, vel.pa); }
  void SetVelHead(double aXSpeed, double aYSpeed, double aYawHead) {
    PLAYERCC_DO(playerc_position2d_set_cmd_vel_head, mDevice, aXSpeed, aYSpeed, aYawHead, 1);
  }
  void SetVelHead(double aXSpeed, double aYawHead) { SetVelHead(aXSpeed, 0, aYawHead); }
  void GoTo(player_pose2d_t pos, player_pose2d_t vel) {
    PLAYERCC_DO(playerc_position2d_set_cmd_pose_with_vel, mDevice, pos, vel, 1);
  }
  void GoTo(player_pose2d_t pos) { GoTo(pos, player_pose2d_t()); }
  void GoTo(double aX, double aY, double aYaw) {
    const player_pose2d_t pos = {aX, aY, aYaw};
    GoTo(pos);
  }
  void SetCarlike(double aXSpeed, double aDriveAngle) {
    PLAYERCC_DO(playerc_position2d_set_cmd_car, mDevice, aXSpeed, aDriveAngle);
  }
  void SetMotorEnable(bool enable) { PLAYERCC_DO(playerc_position2d_enable, mDevice, enable ? 1 : 0); }
  void SetOdometry(double aX, double aY, double aYaw) {
    PLAYERCC_DO(playerc_position2d_set_odom, mDevice, aX, aY, aYaw);
  }
  void ResetOdometry() { SetOdometry(0, 0, 0); }
  void RequestGeom() { PLAYERCC_DO(playerc_position2d_get_geom, mDevice); }
  player_pose3d_t GetOffset() {
    scoped_lock_t lock(mPc->mMutex);
    const player_pose3d_t pose = {mDevice->pose[0], mDevice->pose[1], 0, 0, 0, mDevice->pose[2]};
    return pose;
  }
  player_bbox3d_t GetSize() {
    scoped_lock_t lock(mPc->mMutex);
    const player_bbox3d_t size = {mDevice->size[1], mDevice->size[0], 0};
    return size;
  }
  double GetXPos() const { return GetVar(mDevice->px); }
  double GetYPos() const { return GetVar(mDevice->py); }
  double GetYaw() const { return GetVar(mDevice->pa); }
  double GetXSpeed() const { return GetVar(mDevice->vx); }
  double GetYSpeed() const { return GetVar(mDevice->vy); }
  double GetYawSpeed() const { return GetVar(mDevice->va); }
  bool GetStall() const { return GetVar(mDevice->stall) != 0; }
};

class Position3dProxy : public PLAYERCC_BASE(position3d) {
 public:
  Position3dProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void SetSpeed(double aXSpeed, double aYSpeed, double aZSpeed, double aRollSpeed, double aPitchSpeed,
                double aYawSpeed) {
    PLAYERCC_DO(playerc_position3d_set_velocity, mDevice, aXSpeed, aYSpeed, aZSpeed, aRollSpeed, aPitchSpeed,
                aYawSpeed, 1);
  }
  void SetSpeed(double aXSpeed, double aYSpeed, double aZSpeed, double aYawSpeed) {
    SetSpeed(aXSpeed, aYSpeed, aZSpeed, 0, 0, aYawSpeed);
  }
  void SetSpeed(double aXSpeed, double aYSpeed, double aYawSpeed) {
    SetSpeed(aXSpeed, aYSpeed, 0, 0, 0, aYawSpeed);
  }
  void SetSpeed(double aXSpeed, double aYawSpeed) { SetSpeed(aXSpeed, 0, 0, 0, 0, aYawSpeed); }
  void SetSpeed(player_pose3d_t vel) { SetSpeed(vel.px, vel.py, vel.pz, vel.proll, vel.ppitch, vel.pyaw); }
  void GoTo(player_pose3d_t aPos, player_pose3d_t aVel) {
    PLAYERCC_DO(playerc_position3d_set_pose_with_vel, mDevice, aPos, aVel);
  }
  void GoTo(player_pose3d_t aPos) { GoTo(aPos, player_pose3d_t()); }
  void GoTo(double aX, double aY, double aZ, double aRoll, double aPitch, double aYaw) {
    const player_pose3d_t pos = {aX, aY, aZ, aRoll, aPitch, aYaw};
    GoTo(pos);
  }
  void SelectVelocityControl(int aMode) { PLAYERCC_DO(playerc_position3d_set_vel_mode, mDevice, aMode); }
  void SetMotorEnable(bool aEnable) { PLAYERCC_DO(playerc_position3d_enable, mDevice, aEnable ? 1 : 0); }
  void ResetOdometry() { PLAYERCC_DO(playerc_position3d_reset_odom, mDevice); }
  void SetOdometry(double aX, double aY, double aZ, double aRoll, double aPitch, double aYaw) {
    PLAYERCC_DO(playerc_position3d_set_odom, mDevice, aX, aY, aZ, aRoll, aPitch, aYaw);
  }
  void RequestGeom() { PLAYERCC_DO(playerc_position3d_get_geom, mDevice); }
  double GetXPos() const { return GetVar(mDevice->pos_x); }
  double GetYPos() const { return GetVar(mDevice->pos_y); }
  double GetZPos() const { return GetVar(mDevice->pos_z); }
  double GetRoll() const { return GetVar(mDevice->pos_roll); }
  double GetPitch() const { return GetVar(mDevice->pos_pitch); }
  double GetYaw() const { return GetVar(mDevice->pos_yaw); }
  double GetXSpeed() const { return GetVar(mDevice->vel_x); }
  double GetYSpeed() const { return GetVar(mDevice->vel_y); }
  double GetZSpeed() const { return GetVar(mDevice->vel_z); }
  double GetRollSpeed() const { return GetVar(mDevice->vel_roll); }
  double GetPitchSpeed() const { return GetVar(mDevice->vel_pitch); }
  double GetYawSpeed() const { return GetVar(mDevice->vel_yaw); }
  bool GetStall() const { return GetVar(mDevice->stall) != 0; }
};

// --- range finders

class LaserProxy : public PLAYERCC_BASE(laser) {
 public:
  LaserProxy(PlayerClient *aPc, uint32_t aIndex = 0)
      : DeviceProxy(aPc, aIndex), conf_min_angle_(0), conf_max_angle_(0) {}

  uint32_t GetCount() const { return static_cast<uint32_t>(GetVar(mDevice->scan_count)); }
  double GetMaxRange() const { return GetVar(mDevice->max_range); }
  double GetScanRes() const { return GetVar(mDevice->scan_res); }
  double GetRangeRes() const { return GetVar(mDevice->range_res); }
  double GetScanningFrequency() const { return GetVar(mDevice->scanning_frequency); }
  double GetMinAngle() const { return GetVar(mDevice->scan_start); }
  double GetMaxAngle() const {
    scoped_lock_t lock(mPc->mMutex);
    return mDevice->scan_start + (mDevice->scan_count - 1) * mDevice->scan_res;
  }
  double GetConfMinAngle() const { return conf_min_angle_; }
  double GetConfMaxAngle() const { return conf_max_angle_; }
  bool IntensityOn() const { return GetVar(mDevice->intensity_on) != 0; }
  player_point_2d_t GetPoint(uint32_t aIndex) const {
    return GetElement<player_point_2d_t>(mDevice->point, mDevice->scan_count, aIndex);
  }
  double GetRange(uint32_t aIndex) const {
    return GetElement<double>(mDevice->ranges, mDevice->scan_count, aIndex);
  }
  double GetBearing(uint32_t aIndex) const {
    scoped_lock_t lock(mPc->mMutex);
    GetRange(aIndex);  // tells if there is none
    return aIndex < GetCount() ? mDevice->scan[aIndex][1] : 0;
  }
  int GetIntensity(uint32_t aIndex) const {
    return GetElement<int>(mDevice->intensity, mDevice->scan_count, aIndex);
  }
  int GetID() const { return GetVar(mDevice->laser_id); }
  double GetMinLeft() const { return GetVar(mDevice->min_left); }
  double GetMinRight() const { return GetVar(mDevice->min_right); }
  double MinLeft() const { return GetMinLeft(); }
  double MinRight() const { return GetMinRight(); }
  double operator[](uint32_t aIndex) const { return GetRange(aIndex); }
  /** Angles are in rad, the resolutions in hundredths of a degree and in mm, the frequency in Hz. */
  void Configure(double aMinAngle, double aMaxAngle, uint32_t aScanRes, uint32_t aRangeRes, bool aIntensity,
                 double aScanningFrequency) {
    PLAYERCC_DO(playerc_laser_set_config, mDevice, aMinAngle, aMaxAngle, dtor(aScanRes / 100.0),
                aRangeRes / 1000.0, static_cast<unsigned char>(aIntensity ? 1 : 0), aScanningFrequency);
  }
  void RequestConfigure() {
    double resolution, range_res, frequency;
    unsigned char intensity;
    PLAYERCC_DO(playerc_laser_get_config, mDevice, &conf_min_angle_, &conf_max_angle_, &resolution,
                &range_res, &intensity, &frequency);
  }
  void RequestGeom() { PLAYERCC_DO(playerc_laser_get_geom, mDevice); }
  void RequestID() { PLAYERCC_DO(playerc_laser_get_id, mDevice); }
  player_pose3d_t GetPose() {
    scoped_lock_t lock(mPc->mMutex);
    const player_pose3d_t pose = {mDevice->pose[0], mDevice->pose[1], 0, 0, 0, mDevice->pose[2]};
    return pose;
  }
  player_pose3d_t GetRobotPose() {
    scoped_lock_t lock(mPc->mMutex);
    const player_pose3d_t pose = {mDevice->robot_pose[0], mDevice->robot_pose[1], 0, 0, 0,
                                  mDevice->robot_pose[2]};
    return pose;
  }
  player_bbox3d_t GetSize() {
    scoped_lock_t lock(mPc->mMutex);
    const player_bbox3d_t size = {mDevice->size[1], mDevice->size[0], 0};
    return size;
  }

 private:
  double conf_min_angle_, conf_max_angle_;
};

/** An element that its lists do not have throws, once there are data. */
class RangerProxy : public PLAYERCC_BASE(ranger) {
 public:
  RangerProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetElementCount() const { return GetVar(mDevice->element_count); }
  player_pose3d_t GetDevicePose() const { return GetVar(mDevice->device_pose); }
  player_bbox3d_t GetDeviceSize() const { return GetVar(mDevice->device_size); }
  player_pose3d_t GetElementPose(uint32_t aIndex) const {
    return GetRanged<player_pose3d_t>(mDevice->element_poses, mDevice->element_count, aIndex);
  }
  player_bbox3d_t GetElementSize(uint32_t aIndex) const {
    return GetRanged<player_bbox3d_t>(mDevice->element_sizes, mDevice->element_count, aIndex);
  }
  uint32_t GetRangeCount() const { return GetVar(mDevice->ranges_count); }
  double GetRange(uint32_t aIndex) const {
    return GetRanged<double>(mDevice->ranges, mDevice->ranges_count, aIndex);
  }
  double operator[](uint32_t aIndex) const { return GetRange(aIndex); }
  uint32_t GetPointCount() const { return GetVar(mDevice->points_count); }
  player_point_3d_t GetPoint(uint32_t aIndex) const {
    return GetRanged<player_point_3d_t>(mDevice->points, mDevice->points_count, aIndex);
  }
  uint32_t GetIntensityCount() const { return GetVar(mDevice->intensities_count); }
  double GetIntensity(uint32_t aIndex) const {
    return GetRanged<double>(mDevice->intensities, mDevice->intensities_count, aIndex);
  }
  void SetPower(bool aEnable) { PLAYERCC_DO(playerc_ranger_power_config, mDevice, aEnable ? 1 : 0); }
  void SetIntensityData(bool aEnable) { PLAYERCC_DO(playerc_ranger_intns_config, mDevice, aEnable ? 1 : 0); }
  void RequestGeom() { PLAYERCC_DO(playerc_ranger_get_geom, mDevice); }
  void Configure(double aMinAngle, double aMaxAngle, double aAngularRes, double aMinRange, double aMaxRange,
                 double aRangeRes, double aFrequency) {
    PLAYERCC_DO(playerc_ranger_set_config, mDevice, aMinAngle, aMaxAngle, aAngularRes, aMinRange, aMaxRange,
                aRangeRes, aFrequency);
  }
  void RequestConfigure() {
    PLAYERCC_DO(playerc_ranger_get_config, mDevice, NULL, NULL, NULL, NULL, NULL, NULL, NULL);
  }
  double GetMinAngle() const { return GetVar(mDevice->min_angle); }
  double GetMaxAngle() const { return GetVar(mDevice->max_angle); }
  double GetAngularRes() const { return GetVar(mDevice->angular_res); }
  double GetMinRange() const { return GetVar(mDevice->min_range); }
  double GetMaxRange() const { return GetVar(mDevice->max_range); }
  double GetRangeRes() const { return GetVar(mDevice->range_res); }
  double GetFrequency() const { return GetVar(mDevice->frequency); }

 private:
  template <typename T>
  T GetRanged(T *const &list, uint32_t count, uint32_t aIndex) const {
    scoped_lock_t lock(mPc->mMutex);
    if (aIndex >= count && IsValid()) throw PlayerError("RangerProxy", Absent(aIndex, count));
    return GetElement<T>(list, count, aIndex);
  }
};

class SonarProxy : public PLAYERCC_BASE(sonar) {
 public:
  SonarProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return static_cast<uint32_t>(GetVar(mDevice->scan_count)); }
  /** -1 if there is no range of that number. */
  double GetScan(uint32_t aIndex) const {
    scoped_lock_t lock(mPc->mMutex);
    return aIndex < GetCount() ? mDevice->scan[aIndex] : -1.0;
  }
  double operator[](uint32_t aIndex) const { return GetScan(aIndex); }
  uint32_t GetPoseCount() const { return static_cast<uint32_t>(GetVar(mDevice->pose_count)); }
  player_pose3d_t GetPose(uint32_t aIndex) const {
    return GetElement<player_pose3d_t>(mDevice->poses, mDevice->pose_count, aIndex);
  }
  void RequestGeom() { PLAYERCC_DO(playerc_sonar_get_geom, mDevice); }
};

class BumperProxy : public PLAYERCC_BASE(bumper) {
 public:
  BumperProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return static_cast<uint32_t>(GetVar(mDevice->bumper_count)); }
  uint32_t IsBumped(uint32_t aIndex) const {
    return GetElement<uint8_t>(mDevice->bumpers, mDevice->bumper_count, aIndex);
  }
  bool IsAnyBumped() {
    scoped_lock_t lock(mPc->mMutex);
    for (uint32_t i = 0; i < GetCount(); ++i) {
      if (IsBumped(i) != 0) return true;
    }
    return false;
  }
  void RequestBumperConfig() { PLAYERCC_DO(playerc_bumper_get_geom, mDevice); }
  uint32_t GetPoseCount() const { return static_cast<uint32_t>(GetVar(mDevice->pose_count)); }
  player_bumper_define_t GetPose(uint32_t aIndex) const {
    return GetElement<player_bumper_define_t>(mDevice->poses, mDevice->pose_count, aIndex);
  }
  bool operator[](uint32_t aIndex) const { return IsBumped(aIndex) != 0; }
};

// --- the simulation, and maps

class SimulationProxy : public PLAYERCC_BASE(simulation) {
 public:
  SimulationProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void SetPose2d(const char *identifier, double x, double y, double a) {
    PLAYERCC_DO(playerc_simulation_set_pose2d, mDevice, identifier, x, y, a);
  }
  void GetPose2d(const char *identifier, double &x, double &y, double &a) {
    PLAYERCC_DO(playerc_simulation_get_pose2d, mDevice, identifier, &x, &y, &a);
  }
  void SetPose3d(const char *identifier, double x, double y, double z, double roll, double pitch,
                 double yaw) {
    PLAYERCC_DO(playerc_simulation_set_pose3d, mDevice, identifier, x, y, z, roll, pitch, yaw);
  }
  void GetPose3d(const char *identifier, double &x, double &y, double &z, double &roll, double &pitch,
                 double &yaw, double &time) {
    PLAYERCC_DO(playerc_simulation_get_pose3d, mDevice, identifier, &x, &y, &z, &roll, &pitch, &yaw, &time);
  }
  void GetProperty(const char *identifier, const char *name, void *value, size_t value_len) {
    PLAYERCC_DO(playerc_simulation_get_property, mDevice, identifier, name, value, value_len);
  }
  void SetProperty(const char *identifier, const char *name, void *value, size_t value_len) {
    PLAYERCC_DO(playerc_simulation_set_property, mDevice, identifier, name, value, value_len);
  }
};

class MapProxy : public PLAYERCC_BASE(map) {
 public:
  MapProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void RequestMap() { PLAYERCC_DO(playerc_map_get_map, mDevice); }
  int GetCellIndex(int x, int y) const { return y * static_cast<int>(GetWidth()) + x; }
  int8_t GetCell(int x, int y) const {
    scoped_lock_t lock(mPc->mMutex);
    return static_cast<int8_t>(GetElement<char>(mDevice->cells, GetWidth() * GetHeight(),
                                                static_cast<uint32_t>(GetCellIndex(x, y))));
  }
  double GetResolution() const { return GetVar(mDevice->resolution); }
  uint32_t GetWidth() const { return static_cast<uint32_t>(GetVar(mDevice->width)); }
  uint32_t GetHeight() const { return static_cast<uint32_t>(GetVar(mDevice->height)); }
  double GetOriginX() const { return GetVar(mDevice->origin[0]); }
  double GetOriginY() const { return GetVar(mDevice->origin[1]); }
  int8_t GetDataRange() const { return GetVar(mDevice->data_range); }
  void GetMap(int8_t *aMap) const {
    scoped_lock_t lock(mPc->mMutex);
    for (uint32_t i = 0; i < GetWidth() * GetHeight(); ++i) aMap[i] = static_cast<int8_t>(mDevice->cells[i]);
  }
};

class LocalizeProxy : public PLAYERCC_BASE(localize) {
 public:
  LocalizeProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetPendingCount() const { return static_cast<uint32_t>(GetVar(mDevice->pending_count)); }
  uint32_t GetHypothCount() const { return static_cast<uint32_t>(GetVar(mDevice->hypoth_count)); }
  uint32_t GetNumHypoths() const { return GetHypothCount(); }
  player_localize_hypoth_t GetHypoth(uint32_t aIndex) const {
    return GetElement<player_localize_hypoth_t>(mDevice->hypoths, mDevice->hypoth_count, aIndex);
  }
  int GetParticles() {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_localize_get_particles(mDevice);
  }
  uint32_t GetNumParticles() const { return static_cast<uint32_t>(GetVar(mDevice->num_particles)); }
  player_pose2d_t GetParticlePose(int index) const {
    const playerc_localize_particle_t particle = GetElement<playerc_localize_particle_t>(
        mDevice->particles, mDevice->num_particles, static_cast<uint32_t>(index));
    const player_pose2d_t pose = {particle.pose[0], particle.pose[1], particle.pose[2]};
    return pose;
  }
  /** `cov`: the variances of x, y and heading; also their covariances xy, y heading and x heading if it is an array of
   * six. */
  template <typename Cov>
  void SetPose(double pose[3], Cov &&cov) {
    const size_t given = std::extent<typename std::remove_reference<Cov>::type>::value;  // 0 of a pointer
    double whole[6] = {cov[0], cov[1], cov[2], 0, 0, 0};
    for (size_t i = 3; i < given && i < 6; ++i) whole[i] = cov[i];
    PLAYERCC_DO(playerc_localize_set_pose, mDevice, pose, whole);
  }
  /** The map is the map interface's: zeros, as they were in the original. */
  uint32_t GetMapSizeX() const { return static_cast<uint32_t>(GetVar(mDevice->map_size_x)); }
  uint32_t GetMapSizeY() const { return static_cast<uint32_t>(GetVar(mDevice->map_size_y)); }
  uint32_t GetMapTileX() const { return static_cast<uint32_t>(GetVar(mDevice->map_tile_x)); }
  uint32_t GetMapTileY() const { return static_cast<uint32_t>(GetVar(mDevice->map_tile_y)); }
  double GetMapScale() const { return GetVar(mDevice->map_scale); }
};

class PlannerProxy : public PLAYERCC_BASE(planner) {
 public:
  PlannerProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void SetGoalPose(double aGx, double aGy, double aGa) {
    PLAYERCC_DO(playerc_planner_set_cmd_pose, mDevice, aGx, aGy, aGa);
  }
  void RequestWaypoints() { PLAYERCC_DO(playerc_planner_get_waypoints, mDevice); }
  void SetEnable(bool aEnable) { PLAYERCC_DO(playerc_planner_enable, mDevice, aEnable ? 1 : 0); }
  uint32_t GetPathValid() const { return static_cast<uint32_t>(GetVar(mDevice->path_valid)); }
  uint32_t GetPathDone() const { return static_cast<uint32_t>(GetVar(mDevice->path_done)); }
  double GetPx() const { return GetVar(mDevice->px); }
  double GetPy() const { return GetVar(mDevice->py); }
  double GetPa() const { return GetVar(mDevice->pa); }
  double GetGx() const { return GetVar(mDevice->gx); }
  double GetGy() const { return GetVar(mDevice->gy); }
  double GetGa() const { return GetVar(mDevice->ga); }
  double GetWx() const { return GetVar(mDevice->wx); }
  double GetWy() const { return GetVar(mDevice->wy); }
  double GetWa() const { return GetVar(mDevice->wa); }
  player_pose2d_t GetPose() const {
    scoped_lock_t lock(mPc->mMutex);
    return PoseOf(GetPx(), GetPy(), GetPa());
  }
  player_pose2d_t GetGoal() const {
    scoped_lock_t lock(mPc->mMutex);
    return PoseOf(GetGx(), GetGy(), GetGa());
  }
  player_pose2d_t GetCurrentWaypoint() const {
    scoped_lock_t lock(mPc->mMutex);
    return PoseOf(GetWx(), GetWy(), GetWa());
  }
  int GetCurrentWaypointId() const { return GetVar(mDevice->curr_waypoint); }
  uint32_t GetWaypointCount() const { return static_cast<uint32_t>(GetVar(mDevice->waypoint_count)); }
  player_pose2d_t GetWaypoint(uint32_t aIndex) const {
    scoped_lock_t lock(mPc->mMutex);
    if (aIndex >= GetWaypointCount())
      throw PlayerError("PlannerProxy::GetWaypoint()", "there is no such waypoint");
    const double *at = mDevice->waypoints[aIndex];
    return PoseOf(at[0], at[1], at[2]);
  }
  player_pose2d_t operator[](uint32_t aIndex) const { return GetWaypoint(aIndex); }
  double GetIx(int i) const { return GetWaypoint(static_cast<uint32_t>(i)).px; }
  double GetIy(int i) const { return GetWaypoint(static_cast<uint32_t>(i)).py; }
  double GetIa(int i) const { return GetWaypoint(static_cast<uint32_t>(i)).pa; }

 private:
  static player_pose2d_t PoseOf(double x, double y, double a) {
    const player_pose2d_t pose = {x, y, a};
    return pose;
  }
};

// --- what cameras and scanners find, and grippers

class BlobfinderProxy : public PLAYERCC_BASE(blobfinder) {
 public:
  BlobfinderProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return GetVar(mDevice->blobs_count); }
  playerc_blobfinder_blob_t GetBlob(uint32_t aIndex) const {
    return GetElement<playerc_blobfinder_blob_t>(mDevice->blobs, mDevice->blobs_count, aIndex);
  }
  uint32_t GetWidth() const { return GetVar(mDevice->width); }
  uint32_t GetHeight() const { return GetVar(mDevice->height); }
  playerc_blobfinder_blob_t operator[](uint32_t aIndex) const { return GetBlob(aIndex); }
};

class FiducialProxy : public PLAYERCC_BASE(fiducial) {
 public:
  FiducialProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return static_cast<uint32_t>(GetVar(mDevice->fiducials_count)); }
  player_fiducial_item_t GetFiducialItem(uint32_t aIndex) const {
    return GetElement<player_fiducial_item_t>(mDevice->fiducials, mDevice->fiducials_count, aIndex);
  }
  player_pose3d_t GetSensorPose() const { return GetVar(mDevice->fiducial_geom.pose); }
  player_bbox3d_t GetSensorSize() const { return GetVar(mDevice->fiducial_geom.size); }
  player_bbox2d_t GetFiducialSize() const { return GetVar(mDevice->fiducial_geom.fiducial_size); }
  void RequestGeometry() { PLAYERCC_DO(playerc_fiducial_get_geom, mDevice); }
  player_fiducial_item_t operator[](uint32_t aIndex) const { return GetFiducialItem(aIndex); }
};

class GripperProxy : public PLAYERCC_BASE(gripper) {
 public:
  GripperProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void RequestGeometry() { PLAYERCC_DO(playerc_gripper_get_geom, mDevice); }
  void Open() { PLAYERCC_DO(playerc_gripper_open_cmd, mDevice); }
  void Close() { PLAYERCC_DO(playerc_gripper_close_cmd, mDevice); }
  void Stop() { PLAYERCC_DO(playerc_gripper_stop_cmd, mDevice); }
  void Store() { PLAYERCC_DO(playerc_gripper_store_cmd, mDevice); }
  void Retrieve() { PLAYERCC_DO(playerc_gripper_retrieve_cmd, mDevice); }
  uint32_t GetState() const { return GetVar(mDevice->state); }
  uint32_t GetBeams() const { return GetVar(mDevice->beams); }
  player_pose3d_t GetPose() const { return GetVar(mDevice->pose); }
  player_bbox3d_t GetOuterSize() const { return GetVar(mDevice->outer_size); }
  player_bbox3d_t GetInnerSize() const { return GetVar(mDevice->inner_size); }
  uint32_t GetNumBeams() const { return GetVar(mDevice->num_beams); }
  uint32_t GetCapacity() const { return GetVar(mDevice->capacity); }
  uint32_t GetStored() const { return GetVar(mDevice->stored); }
};

class PtzProxy : public PLAYERCC_BASE(ptz) {
 public:
  PtzProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void SetCam(double aPan, double aTilt, double aZoom) {
    PLAYERCC_DO(playerc_ptz_set, mDevice, aPan, aTilt, aZoom);
  }
  /** Turns on from where it is. */
  void SetSpeed(double aPanSpeed = 0, double aTiltSpeed = 0, double = 0) {
    PLAYERCC_DO(playerc_ptz_set_ws, mDevice, mDevice->pan, mDevice->tilt, mDevice->zoom, aPanSpeed,
                aTiltSpeed);
  }
  int GetStatus() {
    PLAYERCC_DO(playerc_ptz_query_status, mDevice);
    return GetVar(mDevice->status);
  }
  void SelectControlMode(uint32_t aMode) {
    PLAYERCC_DO(playerc_ptz_set_control_mode, mDevice, static_cast<int>(aMode));
  }
  double GetPan() const { return GetVar(mDevice->pan); }
  double GetTilt() const { return GetVar(mDevice->tilt); }
  double GetZoom() const { return GetVar(mDevice->zoom); }
};

// --- inputs and outputs, arms

class AioProxy : public PLAYERCC_BASE(aio) {
 public:
  AioProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return GetVar(mDevice->voltages_count); }
  double GetVoltage(uint32_t aIndex) const {
    return static_cast<double>(GetElement<float>(mDevice->voltages, mDevice->voltages_count, aIndex));
  }
  void SetVoltage(uint32_t aIndex, double aVoltage) {
    PLAYERCC_DO(playerc_aio_set_output, mDevice, static_cast<uint8_t>(aIndex), static_cast<float>(aVoltage));
  }
  double operator[](uint32_t aIndex) const { return GetVoltage(aIndex); }
};

class DioProxy : public PLAYERCC_BASE(dio) {
 public:
  DioProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return GetVar(mDevice->count); }
  uint32_t GetDigin() const { return GetVar(mDevice->digin); }
  bool GetInput(uint32_t aIndex) const {
    if (aIndex >= GetCount()) throw PlayerError("DioProxy::GetInput()", "there is no such input");
    return (GetDigin() >> aIndex & 1) != 0;
  }
  void SetOutput(uint32_t aCount, uint32_t aDigout) {
    PLAYERCC_DO(playerc_dio_set_output, mDevice, static_cast<uint8_t>(aCount), aDigout);
  }
  uint32_t operator[](uint32_t aIndex) const { return GetInput(aIndex); }
};

class IrProxy : public PLAYERCC_BASE(ir) {
 public:
  IrProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return GetVar(mDevice->data.ranges_count); }
  double GetRange(uint32_t aIndex) const {
    return static_cast<double>(GetElement<float>(mDevice->data.ranges, mDevice->data.ranges_count, aIndex));
  }
  double GetVoltage(uint32_t aIndex) const {
    return static_cast<double>(
        GetElement<float>(mDevice->data.voltages, mDevice->data.voltages_count, aIndex));
  }
  uint32_t GetPoseCount() const { return GetVar(mDevice->poses.poses_count); }
  player_pose3d_t GetPose(uint32_t aIndex) const {
    return GetElement<player_pose3d_t>(mDevice->poses.poses, mDevice->poses.poses_count, aIndex);
  }
  void RequestGeom() { PLAYERCC_DO(playerc_ir_get_geom, mDevice); }
  double operator[](uint32_t aIndex) const { return GetRange(aIndex); }
};

class GpsProxy : public PLAYERCC_BASE(gps) {
 public:
  GpsProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  double GetLatitude() const { return GetVar(mDevice->lat); }
  double GetLongitude() const { return GetVar(mDevice->lon); }
  double GetAltitude() const { return GetVar(mDevice->alt); }
  uint32_t GetSatellites() const { return static_cast<uint32_t>(GetVar(mDevice->sat_count)); }
  uint32_t GetQuality() const { return static_cast<uint32_t>(GetVar(mDevice->quality)); }
  double GetHdop() const { return GetVar(mDevice->hdop); }
  double GetVdop() const { return GetVar(mDevice->vdop); }
  double GetUtmEasting() const { return GetVar(mDevice->utm_e); }
  double GetUtmNorthing() const { return GetVar(mDevice->utm_n); }
  double GetTime() const { return GetVar(mDevice->utc_time); }
  double GetErrHorizontal() const { return GetVar(mDevice->err_horz); }
  double GetErrVertical() const { return GetVar(mDevice->err_vert); }
};

class ImuProxy : public PLAYERCC_BASE(imu) {
 public:
  ImuProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  player_pose3d_t GetPose() const { return GetVar(mDevice->pose); }
  player_imu_data_calib_t GetRawValues() const { return GetVar(mDevice->calib_data); }
  float GetXAccel() { return GetRawValues().accel_x; }
  float GetYAccel() { return GetRawValues().accel_y; }
  float GetZAccel() { return GetRawValues().accel_z; }
  float GetXGyro() { return GetRawValues().gyro_x; }
  float GetYGyro() { return GetRawValues().gyro_y; }
  float GetZGyro() { return GetRawValues().gyro_z; }
  float GetXMagn() { return GetRawValues().magn_x; }
  float GetYMagn() { return GetRawValues().magn_y; }
  float GetZMagn() { return GetRawValues().magn_z; }
  void SetDatatype(int aDatatype) { PLAYERCC_DO(playerc_imu_datatype, mDevice, aDatatype); }
  void ResetOrientation(int aValue) { PLAYERCC_DO(playerc_imu_reset_orientation, mDevice, aValue); }
  void ResetEuler(float aRoll, float aPitch, float aYaw) {
    PLAYERCC_DO(playerc_imu_reset_euler, mDevice, aRoll, aPitch, aYaw);
  }
};

class ActArrayProxy : public PLAYERCC_BASE(actarray) {
 public:
  ActArrayProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void RequestGeometry() { PLAYERCC_DO(playerc_actarray_get_geom, mDevice); }
  void SetPowerConfig(bool aVal) { PLAYERCC_DO(playerc_actarray_power, mDevice, aVal ? 1 : 0); }
  void SetBrakesConfig(bool aVal) { PLAYERCC_DO(playerc_actarray_brakes, mDevice, aVal ? 1 : 0); }
  void SetSpeedConfig(uint32_t aJoint, float aSpeed) {
    PLAYERCC_DO(playerc_actarray_speed_config, mDevice, static_cast<int>(aJoint), aSpeed);
  }
  void SetAccelerationConfig(uint32_t aJoint, float aAcc) {
    PLAYERCC_DO(playerc_actarray_accel_config, mDevice, static_cast<int>(aJoint), aAcc);
  }
  void MoveTo(uint32_t aJoint, float aPos) {
    PLAYERCC_DO(playerc_actarray_position_cmd, mDevice, static_cast<int>(aJoint), aPos);
  }
  void MoveToMulti(std::vector<float> aPos) {
    PLAYERCC_DO(playerc_actarray_multi_position_cmd, mDevice, aPos.data(), static_cast<int>(aPos.size()));
  }
  void MoveAtSpeed(uint32_t aJoint, float aSpeed) {
    PLAYERCC_DO(playerc_actarray_speed_cmd, mDevice, static_cast<int>(aJoint), aSpeed);
  }
  void MoveAtSpeedMulti(std::vector<float> aSpeed) {
    PLAYERCC_DO(playerc_actarray_multi_speed_cmd, mDevice, aSpeed.data(), static_cast<int>(aSpeed.size()));
  }
  void SetActuatorCurrent(uint32_t aJoint, float aCurrent) {
    PLAYERCC_DO(playerc_actarray_current_cmd, mDevice, static_cast<int>(aJoint), aCurrent);
  }
  void SetActuatorCurrentMulti(std::vector<float> aCurrent) {
    PLAYERCC_DO(playerc_actarray_multi_current_cmd, mDevice, aCurrent.data(),
                static_cast<int>(aCurrent.size()));
  }
  void MoveHome(int aJoint) { PLAYERCC_DO(playerc_actarray_home_cmd, mDevice, aJoint); }
  uint32_t GetCount() const { return GetVar(mDevice->actuators_count); }
  player_actarray_actuator_t GetActuatorData(uint32_t aJoint) const {
    return GetElement<player_actarray_actuator_t>(mDevice->actuators_data, mDevice->actuators_count, aJoint);
  }
  player_actarray_actuatorgeom_t GetActuatorGeom(uint32_t aJoint) const {
    return GetElement<player_actarray_actuatorgeom_t>(mDevice->actuators_geom, mDevice->actuators_geom_count,
                                                      aJoint);
  }
  player_point_3d_t GetBasePos() const { return GetVar(mDevice->base_pos); }
  player_orientation_3d_t GetBaseOrientation() const { return GetVar(mDevice->base_orientation); }
  player_actarray_actuator_t operator[](uint32_t aJoint) { return GetActuatorData(aJoint); }
};

// --- pictures

/** "PREFIX0007.ppm", the number in so many digits. */
inline std::string FrameFile(const std::string &prefix, uint32_t frame, uint32_t width) {
  std::string number = std::to_string(frame);
  if (number.size() < width) number.insert(0, width - number.size(), '0');
  return prefix + number + ".ppm";
}

class CameraProxy : public PLAYERCC_BASE(camera) {
 public:
  CameraProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex), frame_(0) {}

  /** Writes `aPrefix`, the number of the frame in so many digits, and ".ppm". */
  void SaveFrame(const std::string aPrefix, uint32_t aWidth = 4) {
    scoped_lock_t lock(mPc->mMutex);
    playerc_camera_save(mDevice, FrameFile(aPrefix, frame_++, aWidth).c_str());
  }
  uint32_t GetDepth() const { return static_cast<uint32_t>(GetVar(mDevice->bpp)); }
  uint32_t GetWidth() const { return static_cast<uint32_t>(GetVar(mDevice->width)); }
  uint32_t GetHeight() const { return static_cast<uint32_t>(GetVar(mDevice->height)); }
  uint32_t GetFormat() const { return static_cast<uint32_t>(GetVar(mDevice->format)); }
  uint32_t GetImageSize() const { return static_cast<uint32_t>(GetVar(mDevice->image_count)); }
  uint32_t GetCompression() const { return static_cast<uint32_t>(GetVar(mDevice->compression)); }
  /** Makes a JPEG image an uncompressed one, which GetCompression() tells afterwards. */
  void Decompress() {
    scoped_lock_t lock(mPc->mMutex);
    playerc_camera_decompress(mDevice);
  }
  void GetImage(uint8_t *aImage) const {
    scoped_lock_t lock(mPc->mMutex);
    playerc_camera_copy_image(mDevice, aImage, GetImageSize());
  }

 private:
  uint32_t frame_;
};

class Graphics2dProxy : public PLAYERCC_BASE(graphics2d) {
 public:
  Graphics2dProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void Color(player_color_t col) { PLAYERCC_DO(playerc_graphics2d_setcolor, mDevice, col); }
  void Color(uint8_t red, uint8_t green, uint8_t blue, uint8_t alpha) {
    const player_color_t color = {alpha, red, green, blue};
    Color(color);
  }
  void Clear() { PLAYERCC_DO(playerc_graphics2d_clear, mDevice); }
  void DrawPoints(player_point_2d_t pts[], int count) {
    PLAYERCC_DO(playerc_graphics2d_draw_points, mDevice, pts, count);
  }
  void DrawPolygon(player_point_2d_t pts[], int count, bool filled, player_color_t fill_color) {
    PLAYERCC_DO(playerc_graphics2d_draw_polygon, mDevice, pts, count, filled ? 1 : 0, fill_color);
  }
  void DrawPolyline(player_point_2d_t pts[], int count) {
    PLAYERCC_DO(playerc_graphics2d_draw_polyline, mDevice, pts, count);
  }
  void DrawMultiline(player_point_2d_t pts[], int count) {
    PLAYERCC_DO(playerc_graphics2d_draw_multiline, mDevice, pts, count);
  }
};

// --- others

class PowerProxy : public PLAYERCC_BASE(power) {
 public:
  PowerProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  double GetCharge() const { return GetVar(mDevice->charge); }
  double GetPercent() const { return GetVar(mDevice->percent); }
  double GetJoules() const { return GetVar(mDevice->joules); }
  double GetWatts() const { return GetVar(mDevice->watts); }
  bool GetCharging() const { return GetVar(mDevice->charging) != 0; }
  /** Whether the battery tells anything. */
  bool IsValid() const { return GetVar(mDevice->valid) != 0; }
};

class SpeechProxy : public PLAYERCC_BASE(speech) {
 public:
  SpeechProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  void Say(std::string aStr) { PLAYERCC_DO(playerc_speech_say, mDevice, aStr.c_str()); }
};

class SpeechRecognitionProxy : public PLAYERCC_BASE(speechrecognition) {
 public:
  SpeechRecognitionProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return static_cast<uint32_t>(GetVar(mDevice->wordCount)); }
  std::string GetWord(uint32_t aWord) const {
    scoped_lock_t lock(mPc->mMutex);
    if (aWord >= GetCount()) throw PlayerError("SpeechRecognitionProxy::GetWord()", "there is no such word");
    return mDevice->words[aWord];
  }
  std::string operator[](uint32_t aWord) { return GetWord(aWord); }
};

class OpaqueProxy : public PLAYERCC_BASE(opaque) {
 public:
  OpaqueProxy(PlayerClient *aPc, uint32_t aIndex = 0) : DeviceProxy(aPc, aIndex) {}

  uint32_t GetCount() const { return static_cast<uint32_t>(GetVar(mDevice->data_count)); }
  void GetData(uint8_t *aDest) const {
    scoped_lock_t lock(mPc->mMutex);
    for (uint32_t i = 0; i < GetCount(); ++i) aDest[i] = mDevice->data[i];
  }
  void SendCmd(player_opaque_data_t *aData) { PLAYERCC_DO(playerc_opaque_cmd, mDevice, aData); }
  int SendReq(player_opaque_data_t *aRequest) {
    scoped_lock_t lock(mPc->mMutex);
    return playerc_opaque_req(mDevice, aRequest, NULL);
  }
};

}  // namespace PlayerCc

#include <libplayerc++/equipment.h>
#include <libplayerc++/print.h>

#undef PLAYERCC_DO
#undef PLAYERCC_BASE

#endif /* LIBPLAYERCPP_PLAYERCPP_H */
