"""Observers by UDP: `run --observers` and `observe`, over real sockets and a network that loses what it likes."""

import json
import random
import re
import select
import socket
import threading
import unittest

from house import ACK, CMD, PATIENCE, SIMULATION, SPEECH, Client, House, HouseTest, text

SAY = 1

WORLD = """
interval_sim 50
define robot position( size [0.4 0.4 0.2] )
model( name "wall" pose [3 0 0 0] size [0.2 10 1] )
robot( name "r0" pose [0 0 0 0] model( name "mast" pose [0.1 0 0 0] size [0.1 0.1 0.1] ) )
robot( name "r1" pose [0 -3 0 90] )
"""


class LossyProxy:
    """A UDP port that passes what it gets to the program and back, but for a share that it loses, doubles or holds back."""

    def __init__(self, port: int, loss: float, seed: int = 1):
        self.loss, self.lost, self.passed = loss, 0, 0
        self._chance = random.Random(seed)
        self._front = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._front.bind(("127.0.0.1", 0))
        self._back = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._back.connect(("127.0.0.1", port))
        self.port = self._front.getsockname()[1]
        self._client, self._held = None, []
        self._stop, self._stopped = socket.socketpair()
        self._thread = threading.Thread(target=self._carry, daemon=True)
        self._thread.start()

    def _carry(self):
        while True:
            ready = select.select([self._front, self._back, self._stopped], [], [])[0]
            if self._stopped in ready:
                return
            for end in ready:
                try:
                    datagram, peer = end.recvfrom(2048)
                except ConnectionError:  # the program has ended
                    continue
                if end is self._front:
                    self._client = peer
                self._pass(datagram, end is self._front)

    def _pass(self, datagram: bytes, to_program: bool):
        chance = self._chance.random
        if chance() < self.loss:
            self.lost += 1
            return
        self._held.append((datagram, to_program))
        if chance() < 0.1:
            self._held.append((datagram, to_program))   # doubled
        if chance() < 0.3 and len(self._held) < 4:
            return                                      # overtaken by the next
        self._chance.shuffle(self._held)
        for held, there in self._held:
            self.passed += 1
            try:
                if there:
                    self._back.send(held)
                else:
                    self._front.sendto(held, self._client)
            except ConnectionError:
                pass
        self._held.clear()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._stop.close()
        self._thread.join()
        for end in (self._front, self._back, self._stopped):
            end.close()


class Observe(HouseTest):
    def run_world(self, *arguments) -> House:
        house = House("run", self.world(WORLD), "--port", 0, "--headless", "--observers", 0, *arguments)
        self.addCleanup(house.__exit__)
        self.observers = int(house.wait_for_line(r"^observers: 127\.0\.0\.1:(\d+)$").group(1))
        return house

    def observe(self, *arguments, port=None) -> House:
        observer = House("observe", f"127.0.0.1:{port or self.observers}", *arguments)
        self.addCleanup(observer.__exit__)
        return observer

    def lines(self, observer: House) -> list:
        self.assertEqual(observer.wait(), 0, observer.log())
        return [json.loads(line) for line in observer.output().splitlines()]

    def client(self, house: House) -> Client:
        client = Client(house.port())
        self.addCleanup(client.close)
        return client

    def test_everybody_who_stands_for_themselves_is_told_once_where_nothing_moves(self):
        self.run_world()
        *models, figures = self.lines(self.observe("--seconds", 0.5, "--stats"))
        self.assertEqual([(model["name"], model["pose"]) for model in models],
                         [("wall", [3, 0, 0, 0]), ("r0", [0, 0, 0, 0]), ("r1", [0, -3, 0, 1.5708])])
        self.assertEqual(set(models[0]), {"time", "id", "name", "pose", "says"})
        self.assertEqual(figures["budget"], 64000)
        self.assertRegex(figures["build"], r"^\d+\.\d+\.\d+ \(.+\)$")
        self.assertGreater(figures["packets"], 0)
        self.assertLess(figures["bytes_per_second"], 64000)

    def test_over_a_network_that_loses_a_third_an_observer_comes_to_hold_the_same_world(self):
        house = self.run_world()
        client = self.client(house)
        self.assertEqual(client.open(4, 0).type, ACK)
        self.assertEqual(client.open(SIMULATION, 0).type, ACK)
        self.assertEqual(client.open(SPEECH, 1).type, ACK)
        with LossyProxy(self.observers, 0.33) as proxy:
            observer = self.observe("--name", "r0", "--name", "r1", "--name", "r0.mast", "--stats", port=proxy.port)
            seen = Seen(observer)
            seen.wait_for(lambda by: len(by) == 3)
            client.drive(0, 1.0)
            client.send(SPEECH, 1, CMD, SAY, text("over here"))
            seen.wait_for(lambda by: by["r0"]["pose"][0] > 0.3 and by["r1"]["says"] == "over here")
            client.drive(0, 0.0)
            seen.wait_for(lambda by: abs(by["r0"]["pose"][0] - client.pose("r0")[0]) <= 0.0011)
            self.assertAlmostEqual(seen.by["r0.mast"]["pose"][0] - seen.by["r0"]["pose"][0], 0.1, 2)
            self.assertEqual(observer.end(2), 130)      # Ctrl-C
            seen.join()
            self.assertGreater(proxy.lost, 5)
        self.assertGreater(seen.figures["lost"], 0)
        house.wait_for_line("observers: 127.0.0.1:[0-9]+ left: (left|nothing was heard)")   # a goodbye may be lost, too

    def test_names_rates_and_budgets_are_kept(self):
        self.run_world("--observer-bytes", 10000)
        *models, figures = self.lines(self.observe("--name", "r1", "--rate", 20, "--seconds", 1, "--stats",
                                                   "--bytes-per-second", 5000))
        self.assertEqual({model["name"] for model in models}, {"r1"})
        self.assertLess(len(models), 25)
        self.assertGreater(len(models), 5)
        self.assertEqual(figures["budget"], 5000)
        self.assertEqual([model["name"] for model in self.lines(self.observe("--rate", 2, "--seconds", 0.4))],
                         ["wall", "r0", "r1"])
        *_, figures = self.lines(self.observe("--seconds", 0.2, "--stats", "--bytes-per-second", 50000))
        self.assertEqual(figures["budget"], 10000)

    def test_a_name_that_nobody_has_is_told_with_the_nearest(self):
        self.run_world()
        observer = self.observe("--name", "r3", "--seconds", 0.2)
        self.assertEqual(self.lines(observer), [])
        self.assertIn('nobody here is called "r3" (did you mean "r', observer.log())

    def test_guests_alone_are_let_in(self):
        guests = self.write("guests.txt", "observer blue-chair-7 Bob\n")
        house = self.run_world("--guests", guests)
        house.wait_for_line(r"^  Bob \(observer\): --token blue-chair-7$")
        stranger = self.observe("--seconds", 1)
        self.assertEqual(stranger.wait(), 1)
        self.assertIn("--token with the token that you were given is needed", stranger.log())
        self.assertEqual(len(self.lines(self.observe("--token", "blue-chair-7", "--seconds", 0.2))), 3)
        house.wait_for_line("observes as observer Bob")

    def test_the_end_of_the_run_is_told(self):
        house = self.run_world()
        observer = self.observe("--name", "r0")
        house.wait_for_line("observes as")
        house.end()
        self.assertEqual(observer.wait(), 1)
        self.assertIn("the run has ended", observer.log())

    def test_a_port_that_is_taken_and_words_that_are_wrong_are_told(self):
        house = self.run_world()
        second = House("run", self.world(WORLD), "--port", 0, "--headless", "--observers", self.observers)
        self.addCleanup(second.__exit__)
        self.assertEqual(second.wait(), 1)
        self.assertIn("cannot listen for datagrams: Address already in use; --observers takes another port", second.log())
        for arguments, told in {("--view", "1,2"): "X,Y,RADIUS in metres is valid",
                                ("--rate", "0"): "a number above 0 is valid",
                                ("--bytes-per-second", "10"): "a whole number from 4000 to"}.items():
            observer = self.observe(*arguments)
            self.assertEqual(observer.wait(), 2)
            self.assertRegex(observer.log(), re.escape(told))
        self.assertIsNone(house.process.poll())


class Seen:
    """What an observer prints, as it comes: the newest line of each name."""

    def __init__(self, observer: House):
        self.by, self.figures = {}, None
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._read, args=(observer.process.stdout,), daemon=True)
        self._thread.start()

    def _read(self, stream):
        for line in stream:
            told = json.loads(line)
            with self._changed:
                if "name" in told:
                    self.by[told["name"]] = told
                if "lost" in told:
                    self.figures = told
                self._changed.notify_all()

    def wait_for(self, holds):
        with self._changed:
            if not self._changed.wait_for(lambda: holds(self.by), PATIENCE):
                raise AssertionError(f"never so: {self.by}")

    def join(self):
        self._thread.join()


if __name__ == "__main__":
    unittest.main()
