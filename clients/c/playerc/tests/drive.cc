// As programs of libplayerc++ are: drive PORT drives ahead until something is near, and tries what fails.
#include <libplayerc++/playerc++.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char *argv[]) {
  using namespace PlayerCc;
  PlayerClient robot(PlayerCc::PLAYER_HOSTNAME, argc > 1 ? std::atoi(argv[1]) : PlayerCc::PLAYER_PORTNUM);
  Position2dProxy pp(&robot, 0);
  LaserProxy lp(&robot, 0);
  RangerProxy rp(&robot, 0);
  SonarProxy sp(&robot, 0);
  SimulationProxy sim(&robot);
  std::cout << robot << std::endl;

  pp.SetMotorEnable(true);
  do {
    robot.Read();
    pp.SetSpeed(limit(0.2 * (lp.GetCount() > 0 ? lp.GetMinLeft() : 0), 0.0, 0.4), 0);
  } while (lp.GetCount() == 0 || sp.GetCount() == 0 || pp.GetXPos() < 1);
  std::cout << pp << std::endl;
  std::cout << lp.GetCount() << " " << rp.GetRangeCount() << " " << sp.GetCount() << " ranges" << std::endl;

  double x, y, a;
  sim.GetPose2d("r0", x, y, a);
  std::cout << "where it is: " << (x - pp.GetXPos() < 0.2 ? "as its odometry says" : "elsewhere")
            << std::endl;
  std::cout << sp[99] << " " << limit(0.9, 0.1, 0.3) << " " << dtor(90) << std::endl;
  try {
    rp.GetRange(181);
  } catch (PlayerError &e) {
    std::cout << e << std::endl;
  }
  try {
    SonarProxy none(&robot, 9);
  } catch (PlayerError &e) {
    std::cout << e << std::endl;
  }
  return 0;
}
