"""Projects of somebody else that use the C++ client library, as docs/clients.md shows: as a part of their build, and
installed. Neither needs the libraries that the program is made with."""

import os
import subprocess
import unittest

from house import ROOT, HouseTest

CLIENT = ROOT / "clients" / "cpp"

PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(outside LANGUAGES CXX)
add_subdirectory({client} playhouse EXCLUDE_FROM_ALL)
add_executable(my_robot my_robot.cc)
target_link_libraries(my_robot PRIVATE playhouse::client)
"""

INSTALLED = """
cmake_minimum_required(VERSION 3.25)
project(outside LANGUAGES CXX)
find_package(playhouse_client 0.2 REQUIRED)
add_executable(my_robot my_robot.cc)
target_link_libraries(my_robot PRIVATE playhouse::client)
add_executable(my_small_robot my_robot.cc)
target_link_libraries(my_small_robot PRIVATE playhouse::client_shared)
"""

# Three things that our own flags warn of, and C++20, which comes with the library.
WARNED = """
#include "playhouse_client/client.h"

struct Pair { int first, second; };

int narrowed(double value, int unused) {
  const Pair pair = {.first = 1};
  int result = value * 2.5;
  return result + pair.first;
}

int main() {
  auto client = playhouse::client::Client::connect("127.0.0.1:6665");
  return client ? narrowed(1.5, 2) : 1;
}
"""

# Drives robot r0 and says where it is, once it moves.
PROGRAM = """
#include <cstdio>
#include "playhouse_client/robot.h"
#include "playhouse_client/client.h"

using namespace playhouse::client;

int fail(const playhouse::Error& error) {
  std::fprintf(stderr, "%s\\n", error.line().c_str());
  return 1;
}

int main(int, char** argv) {
  auto client = Client::connect(argv[1]);
  if (!client) return fail(client.error());
  auto robot = client->robot("r0");
  if (!robot) return fail(robot.error());
  auto base = robot->position2d();
  if (!base) return fail(base.error());
  if (base->state()) return 2;  // no data came yet
  if (auto driven = base->drive(0.5, 0); !driven) return fail(driven.error());
  for (;;) {
    if (auto read = client->read(); !read) return fail(read.error());
    const auto state = base->state();
    if (!state || state->pose.x < 0.1) continue;
    std::printf("%s %s\\n", robot->name().c_str(), base->device().name().c_str());
    return 0;
  }
}
"""


class OutsideProject(HouseTest):
    def check(self, *command, **more):
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, cwd=self.folder, **more)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def configure(self, source, build, *options):
        """Where none of the program's libraries can be found."""
        hidden = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON"
                  for name in ("fmt", "spdlog", "Boost", "ZLIB", "PNG", "TBB", "CLI11", "GTest", "Threads")]
        self.check("cmake", "-G", "Ninja", "-Wno-dev", *hidden, *options, "-S", source, "-B", build)

    def test_keeps_its_own_choice_of_warnings(self):
        self.write("CMakeLists.txt", PROJECT.format(client=CLIENT))
        self.write("my_robot.cc", WARNED)
        self.configure(".", "build", "-DPLAYHOUSE_WERROR=ON")
        # Its own file alone: the next test builds the libraries.
        told = self.check("ninja", "-C", "build", "CMakeFiles/my_robot.dir/my_robot.cc.o")
        self.assertNotIn("warning", told)

    def test_finds_the_installed_library_and_drives_a_robot_by_name(self):
        # Without the optimiser, which costs this test a minute and tells it nothing.
        self.configure(CLIENT, "client", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0")
        self.check("ninja", "-C", "client")
        self.check("cmake", "--install", "client", "--prefix", "prefix")
        self.write("CMakeLists.txt", INSTALLED)
        self.write("my_robot.cc", PROGRAM)
        self.configure(".", "build", f"-DCMAKE_PREFIX_PATH={self.folder}/prefix")
        self.check("ninja", "-C", "build")
        with self.run_house() as house:
            for robot in ("my_robot", "my_small_robot"):
                with self.subTest(robot):
                    told = self.check(os.path.join(self.folder, "build", robot), f"127.0.0.1:{house.port()}", timeout=60)
                    self.assertEqual(told, "r0 position2d:0\n")
        self.assertIn("prefix/lib/libplayhouse_client.so.0.2", self.check("ldd", "build/my_small_robot"))


if __name__ == "__main__":
    unittest.main()
