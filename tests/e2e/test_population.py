"""Robots that come and go in a running program, under Player clients and viewers."""

import os
import unittest

from house import ACK, HEAP_REPORT, LASER, PLAYER, POSITION2D, Client, House, HouseTest, wait_until
from viewer import Viewer

ROBOT = 1   # of the list of what can be added: the wall is the first
HISTORY_SECONDS = 600   # base/limits.h


class Population(HouseTest):
    def start(self, *arguments, **more) -> House:
        house = House("run", self.world(), "--port", 0, "--web", 0, *arguments, **more)
        self.addCleanup(house.__exit__)
        return house

    def viewer(self, house: House) -> Viewer:
        viewer = Viewer(int(house.wait_for_line(r"^web page: http://127\.0\.0\.1:(\d+)/").group(1)))
        self.addCleanup(viewer.close)
        return viewer

    def client(self, house: House) -> Client:
        client = Client(house.port())
        self.addCleanup(client.close)
        return client

    def devices_until(self, client: Client, done) -> list[tuple[int, int]]:
        """Devices are made known by another thread than the one that the viewer hears."""
        return wait_until(lambda: devices if done(devices := client.devices()) else [], "so many devices")

    def test_a_robot_that_comes_has_devices_and_drives_and_one_that_goes_is_told_of(self):
        house = self.start()
        viewer, client = self.viewer(house), self.client(house)
        at_first = client.devices()
        self.assertEqual(viewer.scene["addable"][ROBOT], "robot")
        viewer.send(do="add", robot=ROBOT, x=-2, y=4, a=0)
        viewer.turn_until(lambda: viewer.came)
        robot = viewer.models[viewer.came[0]]
        self.assertEqual((robot["name"], robot["devices"]), ("r0~2", ["position2d:2", "position3d:2", "speech:2", "speech_recognition:2"]))
        of_one = (len(at_first) - 3) // 2   # of two robots; the world and the program itself have three
        devices = self.devices_until(client, lambda devices: len(devices) == len(at_first) + of_one)
        self.assertEqual([d for d in devices if d not in at_first][0], (POSITION2D, 2))

        self.assertEqual(client.open(POSITION2D, 2).type, ACK)
        self.assertEqual(client.open(LASER, 2).type, ACK)
        client.drive(2, 0.4)
        client.next_data(LASER, 2)
        while client.pose("r0~2")[0] < -1.5:
            client.next_data(POSITION2D, 2)

        viewer.send(do="remove", model=robot["id"])
        viewer.turn_until(lambda: robot["id"] not in viewer.models)
        self.devices_until(client, lambda devices: devices == at_first)
        told = [m for m in client.data if m.interf == PLAYER]
        self.assertEqual(len(told), 2, "of each device that was open")

        viewer.send(do="copy", model=robot["id"], x=0, y=4, a=0)   # has gone: nothing happens
        viewer.send(do="add", robot=ROBOT, x=-2, y=4, a=0)
        viewer.turn_until(lambda: len(viewer.came) == 2)
        self.assertEqual(viewer.models[viewer.came[1]]["devices"], ["position2d:3", "position3d:3", "speech:3", "speech_recognition:3"], "an index is not used again")
        self.assertEqual(viewer.notices, [])

    def churn(self, robots: int, viewers: list[Viewer], reader: Client):
        """Adds robots by the first viewer and removes each as it comes, while `reader` goes on reading."""
        viewer, waiting = viewers[0], set()
        asked = 0
        begun = len(viewer.came)
        while len(viewer.came) < begun + robots or waiting:
            for _ in range(min(20, robots - asked)):
                viewer.send(do="add", robot=ROBOT, x=asked % 40 - 20, y=asked % 37 + 5, a=1)
                asked += 1
            for each in viewers:
                each.turn()
            for id in [id for id in viewer.came[begun:] if id in viewer.models and id not in waiting]:
                viewer.send(do="remove", model=id)
                waiting.add(id)
            waiting -= {id for id in waiting if id not in viewer.models}
            reader.next_data(LASER, 0)

    def test_a_thousand_robots_come_and_go_under_clients_and_viewers_and_nothing_is_left(self):
        house = self.start("--fast")
        viewers = [self.viewer(house) for _ in range(3)]
        reader, player = self.client(house), self.client(house)
        at_first = player.devices()
        tops_at_first = viewers[0].tops()
        reader.open(POSITION2D, 0)
        reader.open(LASER, 0)
        self.churn(1000, viewers, reader)
        self.devices_until(player, lambda devices: devices == at_first)
        for viewer in viewers:
            viewer.turn_until(lambda: len(viewer.tops()) == len(tops_at_first))
            self.assertEqual(viewer.tops(), tops_at_first)
            self.assertEqual(viewer.notices, [])
        self.assertEqual(len(viewers[0].came), 1000)
        reader.next_data(POSITION2D, 0)
        self.assertEqual(house.end(), 128 + 15, house.log())

    def test_robots_that_went_leave_no_memory_behind(self):
        # The address sanitizer keeps freed memory back for a while: the program as users have it.
        house = self.start("--fast", program=self.release(), env={**os.environ, "LD_PRELOAD": HEAP_REPORT})
        player = self.client(house)
        at_first = player.devices()

        def memory_after(robots: int) -> int:
            with self.viewer(house) as viewer, self.client(house) as reader:
                reader.open(LASER, 0)
                self.churn(robots, [viewer], reader)
            self.devices_until(player, lambda devices: devices == at_first)
            gone = player.request(PLAYER, 0, 1).time
            wait_until(lambda: player.request(PLAYER, 0, 1).time >= gone + HISTORY_SECONDS,
                       "dropped: the last keyframe with these robots")
            return house.heap_in_use()

        before = memory_after(500)
        # A robot with its devices is 10 KB at least: what stays of 2000 would be 20 MB.
        self.assertLess(memory_after(2000) - before, 2_000_000, "bytes")


if __name__ == "__main__":
    unittest.main()
