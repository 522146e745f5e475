"""A restarted run is that of a fresh start also for programs that look at their devices before they wait."""

import sys
import unittest

from house import ROOT, HouseTest

sys.path.insert(0, str(ROOT / "clients/python"))
from playhouse_client import Mode, NoData, connect  # noqa: E402

WORLD = """
interval_sim 100
define scanner ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 31 noise [0.01 0.01 0] ) )
define robot position( size [0.4 0.4 0.2] localization "odom" scanner( pose [0 0 0 0] ) )
model( name "walls" size [12 12 1] boundary 1 noblocks 1 )
robot( name "r0" pose [3 0 0 0] )
"""


class Driver:
    """Drives by what its devices say, which it looks at before each step."""

    def __init__(self, client):
        self.client = client
        self.world, self.base, self.laser = client.simulation(0), client.position2d(0), client.laser(0)

    def run(self, ticks):
        """Returns where the run ends."""
        for _ in range(ticks):
            room = min(self.laser.ranges) if self.laser.has_data else 0.0
            self.base.drive(0.5 if room > 1.0 else 0.0, 0.0 if room > 1.0 else 0.7)
            self.world.step()
            if self.client.mode == Mode.PULL:
                self.client.read()
        return self.world.pose("r0"), self.base.pose, tuple(self.laser.ranges)


class Reset(HouseTest):
    def ends_of(self, mode, *runs):
        """Where runs of so many ticks end, each of them after a reset."""
        with self.run_house("--lock-step", "--seed", 5, world=self.world(WORLD)) as house, \
                connect(f":{house.port()}", mode=mode, timeout=60) as client:
            driver = Driver(client)
            ends = []
            for ticks in runs:
                driver.world.reset(5)
                ends.append(driver.run(ticks))
            return ends

    def test_the_same_program_and_seed_end_at_one_place_alone_and_after_another_run(self):
        for mode in Mode:
            with self.subTest(mode=mode):
                alone, = self.ends_of(mode, 12)
                other, after = self.ends_of(mode, 20, 12)
                self.assertEqual(after, alone)
                self.assertNotEqual(other, alone)

    def test_devices_have_no_data_until_the_new_run_measures(self):
        with self.run_house("--lock-step", "--seed", 5, world=self.world(WORLD)) as house, \
                connect(f":{house.port()}", mode=Mode.PUSH, timeout=60) as client:
            driver = Driver(client)
            driver.run(3)
            driver.world.reset(5)
            for device in (driver.base, driver.laser):
                self.assertEqual((device.has_data, device.fresh, device.timestamp), (False, False, 0.0))
                with self.assertRaises(NoData):
                    device.scan() if device is driver.laser else device.pose
            driver.world.step()
            self.assertEqual((driver.base.timestamp, driver.laser.timestamp), (0.1, 0.1))


    def test_what_the_old_run_left_in_the_server_is_gone(self):
        with self.run_house("--lock-step", "--seed", 5, world=self.world(WORLD)) as house, \
                connect(f":{house.port()}", mode=Mode.PULL, timeout=60) as client:
            driver = Driver(client)
            driver.world.step(5)  # of which nothing is read
            driver.world.reset(5)
            driver.world.step()
            client.read()
            self.assertEqual((driver.base.timestamp, driver.laser.timestamp), (0.1, 0.1))
            self.assertEqual(client.lost_count(), 0)


if __name__ == "__main__":
    unittest.main()
