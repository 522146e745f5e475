// As programs of libplayerc++ are, which include nothing else: printing PORT prints every proxy of made-up devices.
#include <libplayerc++/playerc++.h>

using namespace PlayerCc;

/** A proxy of a program's own. */
class Compass : public ClientProxy {
 public:
  explicit Compass(PlayerClient *client, uint32_t index = 0) : ClientProxy(client, index), device(NULL) {
    Subscribe(index);
    mInfo = &device->info;
  }
  ~Compass() { Unsubscribe(); }
  double Heading() const { return GetVar(device->pose.pyaw); }
  std::vector<float> Gyro() const {
    const player_imu_data_calib_t raw = GetVar(device->calib_data);
    float gyro[3] = {raw.gyro_x, raw.gyro_y, raw.gyro_z};
    std::vector<float> copy(3);
    GetVarByRef(&gyro[0], &gyro[3], copy.data());
    return copy;
  }

 private:
  void Subscribe(uint32_t index) override {
    scoped_lock_t lock(mPc->mMutex);
    device = playerc_imu_create(mClient, static_cast<int>(index));
    if (device == NULL || playerc_imu_subscribe(device, PLAYER_OPEN_MODE) != 0)
      throw PlayerError("Compass::Compass()", "could not subscribe");
  }
  void Unsubscribe() override {
    scoped_lock_t lock(mPc->mMutex);
    playerc_imu_unsubscribe(device);
    playerc_imu_destroy(device);
    device = NULL;
  }
  playerc_imu_t *device;
};

static bool stopped = false;
static void on_signal(int) {
  stopped = true;
}

/** Data of it, printed. */
template <typename Proxy>
static void print(PlayerClient &robot) {
  Proxy proxy(&robot, 0);
  while (!proxy.IsValid()) robot.Read();
  std::cout << proxy << std::endl;
}

/** Of a device that sends no data by itself. */
template <typename Proxy>
static void print_silent(PlayerClient &robot) {
  Proxy proxy(&robot, 0);
  std::cout << proxy << std::endl;
}

static void print_structs(PlayerClient &robot) {
  const player_point_2d_t point = {1, 2};
  const player_point_3d_t high = {1, 2, 3};
  const player_pose2d_t pose = {1, 2, 3};
  const player_pose3d_t posture = {1, 2, 3, 4, 5, 6};
  const player_bbox2d_t flat = {1, 2};
  const player_bbox3d_t box = {1, 2, 3};
  const player_segment_t segment = {1, 2, 3, 4};
  const player_extent2d_t extent = {1, 2, 3, 4};
  std::cout << point << ", " << high << ", " << pose << ", " << posture << std::endl;
  std::cout << flat << ", " << box << ", " << segment << ", " << extent << std::endl;
  robot.RequestDeviceList();
  std::cout << robot.GetDeviceList().front() << std::endl;
}

static void count_too_far(PlayerClient &robot) {
  IrProxy ir(&robot, 0);
  RangerProxy ranger(&robot, 0);
  BumperProxy bumper(&robot, 0);
  std::cout << "before data " << ir[99] << " " << bumper.IsBumped(99) << std::endl;
  while (!ir.IsValid() || !ranger.IsValid()) robot.Read();
  std::cout << "after it " << ir[99] << " " << ir[98] << std::endl;
  try {
    ranger.GetRange(999);
  } catch (const PlayerError &error) {
    std::cout << error << std::endl;
  }
}

static void use_what_came_late(PlayerClient &robot) {
  ActArrayProxy arm(&robot, 0);
  CoopObjectProxy mote(&robot, 0);
  Position3dProxy air(&robot, 0);
  PtzProxy camera(&robot, 0);
  LocalizeProxy place(&robot, 0);
  PlannerProxy planner(&robot, 0);
  PowerProxy power(&robot, 0);
  ImuProxy imu(&robot, 0);
  while (!power.IsValid() || !planner.IsValid() || !mote.IsValid()) robot.Read();
  arm.SetActuatorCurrent(0, 0.5f);
  arm.SetActuatorCurrentMulti(std::vector<float>(2, 0.5f));
  air.SelectVelocityControl(1);
  air.SetSpeed(player_pose3d_t());
  air.GoTo(1, 2, 3, 0, 0, 0.5);
  camera.SetSpeed(0.1, 0.1, 0);
  imu.ResetEuler(0, 0, 0);
  double pose[3] = {1, 2, 0};
  double variances[3] = {0.1, 0.1, 0.01};
  double covariances[6] = {0.1, 0.1, 0.01, 0, 0, 0};
  place.SetPose(pose, variances);
  place.SetPose(pose, covariances);
  const bool has_way = planner.GetWaypointCount() > 0;
  const float height = mote.GetZ();
  std::cout << "late " << place.GetMapSizeX() << " "
            << (!has_way || planner.GetIx(0) == planner.GetWaypoint(0).px) << " " << power.IsValid() << " "
            << (mote.GetRSSIsenderId() + mote.GetRSSIvalue() + mote.GetRSSIstamp() >= 0 && height == height)
            << std::endl;
}

int main(int argc, char *argv[]) {
  signal(SIGINT, on_signal);
  (void)&usleep;  // from unistd.h, as theirs has it
  PlayerClient robot(PLAYER_HOSTNAME, argc > 1 ? static_cast<uint32_t>(atoi(argv[1])) : PLAYER_PORTNUM);
  print_structs(robot);
  print<ActArrayProxy>(robot);
  print<AioProxy>(robot);
  print_silent<AudioProxy>(robot);
  print_silent<BlackBoardProxy>(robot);
  print<BlobfinderProxy>(robot);
  print<BumperProxy>(robot);
  print<CameraProxy>(robot);
  print<CoopObjectProxy>(robot);
  print<DioProxy>(robot);
  print<FiducialProxy>(robot);
  print<GpsProxy>(robot);
  print_silent<Graphics2dProxy>(robot);
  print_silent<Graphics3dProxy>(robot);
  print<GripperProxy>(robot);
  print<HealthProxy>(robot);
  print<ImuProxy>(robot);
  print<IrProxy>(robot);
  print<LaserProxy>(robot);
  print<LimbProxy>(robot);
  print<LinuxjoystickProxy>(robot);
  print<LocalizeProxy>(robot);
  print_silent<LogProxy>(robot);
  print_silent<MapProxy>(robot);
  print<OpaqueProxy>(robot);
  print<PlannerProxy>(robot);
  print<Pointcloud3dProxy>(robot);
  print<Position1dProxy>(robot);
  print<Position2dProxy>(robot);
  print<Position3dProxy>(robot);
  print<PowerProxy>(robot);
  print<PtzProxy>(robot);
  print<RangerProxy>(robot);
  print<RFIDProxy>(robot);
  print_silent<SimulationProxy>(robot);
  print<SonarProxy>(robot);
  print_silent<SpeechProxy>(robot);
  print<SpeechRecognitionProxy>(robot);
  print<StereoProxy>(robot);
  print_silent<VectorMapProxy>(robot);
  print<WiFiProxy>(robot);
  print<WSNProxy>(robot);
  count_too_far(robot);
  use_what_came_late(robot);
  Compass compass(&robot);
  while (!compass.IsValid()) robot.Read();
  std::cout << "own " << compass.Gyro().size() << " " << (compass.Heading() == compass.Heading()) << " "
            << min(2, 1) << max(2, 1) << stopped << std::endl;
  return 0;
}
