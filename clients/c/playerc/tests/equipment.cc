// As programs of libplayerc++ are: equipment PORT reads made-up devices and tells what it has of each.
#include <libplayerc++/playerc++.h>

#include <cstdlib>
#include <cstring>
#include <iostream>

using namespace PlayerCc;

static int changed = 0;

static void on_change(playerc_blackboard_t *, player_blackboard_entry_t entry) {
  if (entry.key != NULL) ++changed;
}

static std::string start_of(const char *text) {
  return std::string(text, std::min<size_t>(6, std::strlen(text)));
}

int main(int argc, char *argv[]) {
  PlayerClient robot("localhost", argc > 1 ? std::atoi(argv[1]) : 6665);
  Position1dProxy lift(&robot, 0);
  LimbProxy arm(&robot, 0);
  RFIDProxy tags(&robot, 0);
  WSNProxy node(&robot, 0);
  WiFiProxy radio(&robot, 0);
  HealthProxy health(&robot, 0);
  LogProxy log(&robot, 0);
  BlackBoardProxy board(&robot, 0);
  AudioProxy audio(&robot, 0);
  VectorMapProxy map(&robot, 0);
  Graphics3dProxy drawing(&robot, 0);
  StereoProxy eyes(&robot, 0);
  Pointcloud3dProxy cloud(&robot, 0);
  CameraProxy camera(&robot, 0);
  LaserProxy laser(&robot, 0);
  CoopObjectProxy mote(&robot, 0);
  board.SetEventHandler(on_change);
  while (!lift.IsValid() || !arm.IsValid() || !tags.IsValid() || !node.IsValid() || !radio.IsValid() ||
         !health.IsValid() || !audio.IsValid() || !eyes.IsValid() || !cloud.IsValid() || !camera.IsValid() ||
         mote.GetSensorNumber() == 0 || mote.GetAlarmNumber() == 0 || mote.GetUserDataNumber() == 0 ||
         changed == 0)
    robot.Read();

  lift.SetMotorEnable(true);
  lift.GoTo(0.5, 0.1);
  lift.SetSpeed(0.1);
  lift.ResetOdometry();
  lift.RequestGeom();
  std::cout << "lift "
            << lift.IsLimitMin() + 2 * lift.IsLimitCen() + 4 * lift.IsLimitMax() + 8 * lift.IsOverCurrent() +
                   16 * lift.IsTrajComplete() + 32 * lift.IsEnabled() - (lift.GetStatus() & 63)
            << std::endl;
  arm.RequestGeometry();
  arm.SetPowerConfig(true);
  arm.SetPose(1, 0, 0, 0, 1, 0, 0, 0, 1);
  arm.VectorMove(0, 0, 1, 0.1f);
  arm.MoveHome();
  std::cout << "tags " << (tags.GetTagsCount() > 0 && tags[0].guid_count > 0) << std::endl;
  node.SetDevState(1, 2, 3, 1);
  node.DataFreq(1, 2, 3);
  std::cout << "node " << (node.GetNodeDataPacket().light == node.GetNodeDataPacket().light) << std::endl;
  std::cout << "radio " << start_of(radio.GetLinkESSID(0)) << " " << (radio.GetLinkFreq(0) > 0) << " "
            << (radio.GetLink(radio.GetLinkCount() - 1) != NULL) << std::endl;
  std::cout << "health "
            << (health.GetMemUsed() + health.GetMemFree() <= health.GetMemTotal() &&
                health.GetPercMemUsed() > 0 && health.GetPercMemUsed() <= 100)
            << std::endl;
  log.SetFilename("run.log");
  log.QueryState();
  log.SetState(1);
  log.Rewind();
  player_blackboard_entry_t *entry = board.GetEntry("speed", "");
  std::cout << "board " << (entry != NULL) << std::endl;
  board.SetEntry(*entry);
  player_blackboard_entry_t_free(entry);
  player_blackboard_entry_t_free(board.SubscribeToKey("speed"));
  board.UnsubscribeFromKey("speed");
  audio.GetMixerDetails();
  audio.GetMixerLevels();
  audio.SetWavStremRec(false);
  std::cout << "audio " << start_of(audio.GetMixerDetails(0).name) << " " << (audio.GetChannelCount() > 1)
            << std::endl;
  map.GetMapInfo();
  map.GetLayerData(0);
  std::cout << "map " << (map.GetLayerNames().size() == static_cast<size_t>(map.GetLayerCount())) << " "
            << (map.GetFeatureCount(0) > 0 && map.GetFeatureDataCount(0, 0) > 0) << std::endl;
  player_point_3d_t line[2] = {{0, 0, 0}, {1, 0, 0}};
  drawing.Color(255, 0, 0, 0);
  drawing.Draw(PLAYER_DRAW_LINES, line, 2);
  drawing.Clear();
  eyes.DecompressLeft();
  std::cout << "eyes " << eyes.GetLeftWidth() << "x" << eyes.GetRightHeight() << " "
            << eyes.GetDisparityImageSize() << " " << (eyes.GetCount() > 0) << std::endl;
  std::cout << "cloud " << (cloud.GetCount() > 0) << std::endl;
  camera.Decompress();
  std::cout << "camera " << camera.GetCompression() << std::endl;
  laser.Configure(-1.5, 1.5, 50, 10, true, 25);
  playerc_laser_t *own = playerc_laser_create(robot.mClient, 0);
  double low, high, step, range_step, rate;
  unsigned char intensity;
  playerc_laser_subscribe(own, PLAYER_OPEN_MODE);
  playerc_laser_get_config(own, &low, &high, &step, &range_step, &intensity, &rate);
  std::cout << "laser " << low << " " << high << " " << rtod(step) << " " << range_step << " "
            << static_cast<int>(intensity) << " " << rate << std::endl;
  playerc_laser_unsubscribe(own);
  playerc_laser_destroy(own);
  mote.SendCommand(1, 2, 3);
  mote.SendRequest(1, 2, 3);
  unsigned char bytes[2] = {1, 2};
  mote.SendData(1, 2, 3, 2, bytes);
  mote.SendData(1, 2, player_pose2d_t(), 1);
  std::cout << "mote " << (mote.MessageType() != PLAYER_COOPOBJECT_MSG_NONE) << " "
            << (mote.GetAllUserData() != NULL && mote.GetSensorType(0) <= PLAYER_COOPOBJECT_OPTSWITCH)
            << std::endl;
  try {
    radio.GetLink(99);
  } catch (PlayerError &e) {
    std::cout << e << std::endl;
  }
  return 0;
}
