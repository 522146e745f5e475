// As programs of libplayerc++ are: signals PORT counts calls of functions that it has connected to a laser.
#include <libplayerc++/playerc++.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <stdexcept>

using namespace PlayerCc;

static int calls = 0;

static void count_call() {
  ++calls;
}

template <typename T>
void look(T proxy, int *seen) {
  if (proxy->IsFresh()) ++*seen;
  proxy->NotFresh();
}

int main(int argc, char *argv[]) {
  PlayerClient robot("localhost", argc > 1 ? std::atoi(argv[1]) : 6665);
  LaserProxy laser(&robot, 0);
  PowerProxy *power = new PowerProxy(&robot, 0);
  ClientProxy::connection_t first, second, third;
  int seen = 0, alone = 0;
  first = laser.ConnectReadSignal(&count_call);
  second = laser.ConnectReadSignal(std::bind(&look<LaserProxy *>, &laser, &seen));
  third = laser.ConnectReadSignal([&] {  // disconnects itself, and a proxy goes
    ++alone;
    laser.DisconnectReadSignal(third);
    delete power;
  });
  double before = laser.GetDataTime();
  int scans = 0;
  while (scans < 5) {
    robot.Read();
    if (laser.GetDataTime() != before) ++scans;
    before = laser.GetDataTime();
  }
  std::cout << calls << " " << seen << " " << alone << " " << third.connected() << std::endl;
  laser.DisconnectReadSignal(first);
  for (before = laser.GetDataTime(); laser.GetDataTime() == before;) robot.Read();
  std::cout << calls << " " << seen << std::endl;

  PowerProxy *doomed = new PowerProxy(&robot, 0);
  int late = 0;
  doomed->ConnectReadSignal([&] {
    delete doomed;
    doomed = NULL;
  });
  const ClientProxy::connection_t next = doomed->ConnectReadSignal([&] { ++late; });
  while (doomed != NULL) robot.Read();
  std::cout << "destroyed " << late << " " << next.connected() << std::endl;

  std::atomic<int> in_thread(0);
  laser.ConnectReadSignal([&] { ++in_thread; });
  robot.StartThread();
  while (in_thread < 3) std::this_thread::yield();
  robot.StopThread();
  std::cout << "in a thread" << std::endl;

  std::atomic<bool> stopped(false), thrown(false);
  const ClientProxy::connection_t stops = laser.ConnectReadSignal([&] {
    stops.disconnect();
    robot.StopThread();
    stopped = true;
  });
  robot.StartThread();
  while (!stopped) std::this_thread::yield();
  const ClientProxy::connection_t throws = laser.ConnectReadSignal([&] {
    throws.disconnect();
    thrown = true;
    throw std::runtime_error("no idea");
  });
  while (!thrown) robot.StartThread();
  for (const int before_it = in_thread; in_thread < before_it + 3;) robot.StartThread();
  std::cout << "again after each" << std::endl;
  std::string line;
  std::getline(std::cin, line);  // until the run has ended
  robot.StopThread();
  std::cout << "over" << std::endl;
  return 0;
}
