"""A project of somebody else that takes this source tree in as a part, as docs/clients.md shows."""

import subprocess
import unittest

from house import ROOT, HouseTest

PROJECT = """
cmake_minimum_required(VERSION 3.25)
project(outside LANGUAGES CXX)
add_subdirectory({root} playhouse EXCLUDE_FROM_ALL)
add_executable(my_robot my_robot.cc)
target_link_libraries(my_robot PRIVATE playhouse_client)
"""

# Three things that our own flags warn of, and C++20, which comes with the library.
PROGRAM = """
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


class OutsideProject(HouseTest):
    def check(self, *command):
        done = subprocess.run(command, capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_keeps_its_own_choice_of_warnings(self):
        self.write("CMakeLists.txt", PROJECT.format(root=ROOT))
        self.write("my_robot.cc", PROGRAM)
        self.check("cmake", "-G", "Ninja", "-Wno-dev", "-DPLAYHOUSE_WERROR=ON", "-B", "build", ".")
        # Its own file alone: the libraries are built by every other test, and take minutes.
        told = self.check("ninja", "-C", "build", "CMakeFiles/my_robot.dir/my_robot.cc.o")
        self.assertNotIn("warning", told)


if __name__ == "__main__":
    unittest.main()
