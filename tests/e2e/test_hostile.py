"""Clients that stall, flood, vanish or talk nonsense, against a running world. The program must go on serving the
others, answer every request once, and end cleanly: the sanitizers of the dev build look for the rest."""

import random
import resource
import signal
import socket
import struct
import unittest
from pathlib import Path

from house import (ACK, CMD, DATA, LASER, NACK, PATIENCE, PLAYER, POSITION2D, PROGRAM, RANGER, REQ, SIMULATION, SONAR,
                   Client, House, HouseTest, finish, frame, text)

DEVICES = [(SIMULATION, 0), (POSITION2D, 0), (RANGER, 0), (LASER, 0), (RANGER, 1), (SONAR, 0), (POSITION2D, 1)]
GET_GEOM = frame(POSITION2D, 0, REQ, 1)


def open_frame(interf, index, access=1) -> bytes:
    return frame(PLAYER, 0, REQ, 3, struct.pack(">IIIIIII", 0, 0, interf, index, access, 0, 0))


def velocity_of(state) -> float:
    return struct.unpack(">d", state.body[24:32])[0]


def reset(client: Client):
    """Closes so that the server sees a reset."""
    client.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    client.close()


class Hostile(HouseTest):
    def setUp(self):
        super().setUp()
        self.house = self.enterContext(self.run_house())
        self.port = self.house.port()
        self.witness = self.client()
        self.witness.open(POSITION2D, 0)

    def tearDown(self):
        self.assert_served()
        self.assertEqual(self.house.end(), 128 + signal.SIGTERM, self.house.log())

    def client(self) -> Client:
        client = Client(self.port)
        self.addCleanup(client.close)
        return client

    def assert_served(self):
        self.witness.data.clear()
        self.assertEqual(self.witness.request(POSITION2D, 0, 1).type, ACK)
        self.witness.next_data(POSITION2D, 0)

    def test_half_a_header_may_take_its_time(self):
        slow = self.client()
        slow.socket.sendall(GET_GEOM[:20])
        for _ in range(3):
            self.assert_served()
        slow.socket.sendall(GET_GEOM[20:])
        self.assertEqual(slow.receive().type, ACK)

    def test_an_announced_body_that_never_comes_holds_up_nobody(self):
        slow = self.client()
        slow.socket.sendall(frame(POSITION2D, 0, CMD, 1, bytes(28))[:-1])
        self.assert_served()
        slow.close()

    def test_a_client_that_asks_without_reading_holds_up_itself(self):
        flooder = self.client()
        flooder.socket.setblocking(False)
        flood, sent, refused = GET_GEOM * 1000, 0, 0
        while refused < 10:
            try:
                sent += flooder.socket.send(flood[sent % 40:])      # goes on where the last one was cut
            except BlockingIOError:
                self.assert_served()
                refused += 1
        self.assertGreater(sent, 40 * 1024, "more than the server is willing to owe")
        flooder.socket.settimeout(PATIENCE)
        for _ in range(sent // 40):
            self.assertEqual(flooder.receive().type, ACK)
        if sent % 40:
            flooder.socket.sendall(GET_GEOM[sent % 40:])
            self.assertEqual(flooder.receive().type, ACK)

    def test_more_requests_in_one_go_than_a_client_may_be_owed_are_all_answered(self):
        client = self.client()
        client.socket.sendall(GET_GEOM * 1600)      # 1024 may be owed; one read takes all of them
        for _ in range(1600):
            self.assertEqual(client.receive().type, ACK)

    def test_a_flooder_that_vanishes_leaves_nothing_behind(self):
        flooder = self.client()
        flooder.socket.setblocking(False)
        flood, sent, refused = (GET_GEOM + frame(PLAYER, 0, REQ, 1)) * 1000, 0, 0
        while refused < 5:      # in a row: it is owed too much
            try:
                sent += flooder.socket.send(flood[sent % 80:])
                refused = 0
            except BlockingIOError:
                self.assert_served()
                refused += 1
        reset(flooder)
        self.assert_served()

    def test_who_shuts_down_its_sending_half_gets_its_answers_and_then_the_end(self):
        for _ in range(20):
            with Client(self.port) as client:
                client.send(SIMULATION, 0, REQ, 1, text("r0") + bytes(24))      # answered by the tick
                client.socket.shutdown(socket.SHUT_WR)
                answer = client.receive()
                self.assertEqual((answer.type, answer.subtype), (ACK, 1))
                self.assertRaises(ConnectionError, client.receive)

    def test_a_command_counts_although_its_client_goes_at_once(self):
        for number, go in enumerate([Client.close, reset] * 5):
            speed = 0.05 + number / 100
            client = Client(self.port)
            client.drive(0, speed)
            go(client)
            while abs(velocity_of(self.witness.next_data(POSITION2D, 0)) - speed) > 1e-9:
                pass

    def test_requests_and_commands_need_no_open(self):
        client = self.client()
        for interf, index in DEVICES[1:]:
            self.assertEqual(client.request(interf, index, 1).type, ACK, interf)
        client.drive(0, 0.25)
        while velocity_of(self.witness.next_data(POSITION2D, 0)) != 0.25:
            pass
        self.assertEqual(client.data, [])

    def test_two_hundred_clients_come_and_go_at_random(self):
        draw = random.Random(1)
        clients = []
        for _ in range(700):
            clients.append(self.visitor(draw))
            while len(clients) > draw.randint(150, 220):
                self.leave(draw, clients.pop(draw.randrange(len(clients))))
        self.assert_served()
        for client in clients:
            self.leave(draw, client)
        self.assertEqual(len(self.client().devices()), 19)

    def visitor(self, draw) -> Client:
        client = Client(self.port)
        said = b"".join(open_frame(*draw.choice(DEVICES), draw.choice([1, ord("r"), ord("w"), 2]))
                        for _ in range(draw.randint(0, 4)))
        if draw.random() < 0.5:
            said += frame(PLAYER, 0, REQ, 5, struct.pack(">I", 2)) + frame(PLAYER, 0, REQ, 4)
        said += frame(POSITION2D, 1, CMD, 1, struct.pack(">dddI", draw.uniform(-1, 1), 0, draw.uniform(-1, 1), 1))
        said += frame(SIMULATION, 0, REQ, 3, text("r1") + bytes(56))
        client.socket.sendall(said[:draw.choice([len(said), draw.randint(0, len(said))])])
        return client

    def leave(self, draw, client: Client):
        draw.choice([Client.close, reset, lambda c: c.socket.shutdown(socket.SHUT_WR)])(client)
        client.close()

    def test_numbers_beyond_all_measure_are_no_end_of_the_world(self):
        client = self.client()
        for interf, index in DEVICES:
            client.open(interf, index)
        for number in (4e9, 1e18, 1e300, -1.7e308, float("inf"), float("nan")):
            three = struct.pack(">ddd", number, -number, number)
            self.assertIn(client.request(SIMULATION, 0, 2, text("r0") + three).type, (ACK, NACK))
            self.assertIn(client.request(SIMULATION, 0, 4, text("r1") + three * 2 + bytes(8)).type, (ACK, NACK))
            self.assertIn(client.request(POSITION2D, 1, 5, three).type, (ACK, NACK))     # SET_ODOM
            for subtype, body in ((1, three + bytes(4)), (2, three * 2 + bytes(4)), (3, three[:16]), (4, three[:16])):
                client.send(POSITION2D, 0, CMD, subtype, body)
                client.send(POSITION2D, 1, CMD, subtype, body)
                self.witness.next_data(POSITION2D, 0)
        client.send(SIMULATION, 0, CMD, 2)                                               # RESET
        self.assertEqual(client.pose("r0"), (0, 0, 0))

    def test_nonsense_of_every_kind_is_answered_once_if_it_asks_and_never_otherwise(self):
        draw = random.Random(2)
        client = self.client()
        for interf, index in DEVICES:
            for subtype in [*range(0, 12), *range(246, 256)]:
                for kind in (REQ, CMD, DATA, 0, 5, 7):
                    if (interf, kind, subtype) == (SIMULATION, CMD, 1):
                        continue                                                         # PAUSE, a sensible word
                    size = draw.choice([0, 1, 4, 8, 23, 24, 28, 40, 200])
                    body = draw.choice([bytes(size), b"\xff" * size, draw.randbytes(size)])
                    client.send(interf, index, kind, subtype, body)
        client.send(SIMULATION, 0, REQ, 1, text("r0") + bytes(24), seq=99)                # behind all the others
        answers = []
        while not answers or answers[-1].seq != 99:
            answers.append(client.receive())
        self.assertEqual(len([a for a in answers if a.type in (ACK, NACK)]), len(DEVICES) * 22 + 1)


def shell_limited(limit: str, *arguments, program=PROGRAM) -> House:
    """The program under a limit of the shell's `ulimit`."""
    return House("-c", f'ulimit {limit} && exec "$0" "$@"', program, *arguments, program="sh")


class Memory(HouseTest):
    """A system that gives too little."""

    def test_where_it_ends_is_one_line_and_no_crash(self):
        program, ends = self.release(), set()
        for megabytes in range(60, 260, 5):     # of address space: sanitizers need more than there is
            end = finish(f"--as={megabytes * 1_000_000}", program, "run", self.world(), "--fast", "--port", 0, "--headless",
                         "--duration", 0.1, program="prlimit")
            if end.returncode == 127:
                continue    # the loader has no room for libraries
            self.assertIn(end.returncode, (0, 1, 2), f"{megabytes} MB: {end.stderr}")
            if end.returncode:
                self.assertRegex(end.stderr, "error: out of .*memory|error: .* too much memory")
            ends.add(end.returncode)
        self.assertIn(0, ends)
        self.assertIn(1, ends, "never too little: the range has to begin lower")


class Crowds(HouseTest):
    """Many clients at once."""

    def setUp(self):
        super().setUp()
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        self.assertGreater(hard, 8500, "this test needs descriptors: raise the hard limit (ulimit -Hn)")
        resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
        self.addCleanup(resource.setrlimit, resource.RLIMIT_NOFILE, (soft, hard))

    def crowd(self, port: int, count: int) -> list[Client]:
        clients = []
        for _ in range(count):
            clients.append(Client(port))
            self.addCleanup(clients[-1].close)
        return clients

    def many_devices(self, robots: int = 200) -> Path:
        return self.world("interval_sim 100\ndefine robot position( size [0.4 0.4 0.2] ranger( sensor( samples 1 ) ) )\n"
                          + "\n".join(f'robot( name "r{i}" pose [{i} 0 0 0] )' for i in range(robots)))

    def test_clients_that_ask_for_much_and_leave_hold_up_neither_the_others_nor_the_end(self):
        with self.run_house(world=self.many_devices()) as house:
            witness = Client(house.port())
            self.addCleanup(witness.close)
            for client in self.crowd(house.port(), 300):
                client.socket.setblocking(False)
                client.socket.send(frame(PLAYER, 0, REQ, 1) * 3000)
                client.close()
            self.assertEqual(len(witness.devices()), 1003)
            for client in self.crowd(house.port(), 300):
                client.socket.setblocking(False)
                client.socket.send(frame(PLAYER, 0, REQ, 1) * 3000)
            self.assertEqual(house.end(), 128 + signal.SIGTERM, house.log())

    def test_answers_that_nobody_reads_do_not_fill_the_memory(self):
        # A program with sanitizers needs more address space than this limit.
        with shell_limited("-v 500000", "run", self.many_devices(), "--port", 0, "--headless",
                           program=self.release()) as house:
            witness = Client(house.port())
            self.addCleanup(witness.close)
            for client in self.crowd(house.port(), 600):
                client.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
                client.socket.setblocking(False)
                client.socket.send(frame(PLAYER, 0, REQ, 1) * 3000)
            self.assertEqual(len(witness.devices()), 1003)
            house.wait_for_line("closed: what all clients have not read takes")
            self.assertEqual(len(witness.devices()), 1003)
            self.assertEqual(house.end(), 128 + signal.SIGTERM, house.log())

    def test_as_many_clients_as_it_says_are_served_although_the_shell_allows_fewer_descriptors_at_first(self):
        with shell_limited("-S -n 1024 && ulimit -H -n 4000", "run", self.world(), "--port", 0, "--headless") as house:
            fit = int(house.wait_for_line(r"(\d+) Player clients at most: the limit on open files is 4000").group(1))
            self.assertGreater(fit, 3000)
            clients = self.crowd(house.port(), fit)
            for client in clients:
                client.socket.sendall(GET_GEOM)
            for client in clients:
                self.assertEqual(client.receive().type, ACK)
            with socket.create_connection(("127.0.0.1", house.port()), PATIENCE) as refused:
                self.assertEqual(refused.recv(1), b"", "one more than the limit")
            self.assertEqual(house.end(), 128 + signal.SIGTERM, house.log())


if __name__ == "__main__":
    unittest.main()
