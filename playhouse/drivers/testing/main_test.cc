// The main() of these tests, which are the program of plug-ins in processes of their own as well.

#include <gtest/gtest.h>

#include "playhouse/drivers/isolated/isolated_main.h"

int main(int argc, char** argv) {
  if (playhouse::drivers::is_isolated_plugin(argc, argv)) return playhouse::drivers::run_isolated_plugin();
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
