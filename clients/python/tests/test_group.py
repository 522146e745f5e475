"""Data by multicast on this machine's loopback interface, as a server sends them."""

import math
import socket
import unittest

import package  # noqa: F401
from playhouse_client.errors import WireError
from playhouse_client.group import Group
from playhouse_client.wire import Header, Kind

ADDRESS = "239.255.66.65"
SERVED = 6665
LASER, SONAR = 6, 5


class Groups(unittest.TestCase):
    def setUp(self):
        self.here, self.there = socket.socketpair()
        self.sender = self.socket_of("127.0.0.1")
        taken = self.socket_of("127.0.0.1")  # until the group has it: no other test's
        self.port = taken.getsockname()[1]
        self.place = f"{ADDRESS}:{self.port} from {self.sender.getsockname()[1]}"
        for each in (self.here, self.there):
            self.addCleanup(each.close)

    def socket_of(self, host):
        made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        made.bind((host, 0))
        self.addCleanup(made.close)
        return made

    def group(self) -> Group:
        group = Group(self.place, SERVED, self.here)
        self.addCleanup(group.close)
        return group

    def say(self, number, interface=LASER, sender=None, body=b"scan", **header):
        head = Header(interface, 0, Kind.DATA, 1, 1.0, number, **{"size": len(body), "robot": SERVED, **header})
        (sender or self.sender).sendto(head.encode() + body, (ADDRESS, self.port))

    def heard(self, group, count):
        return [group.next(math.inf).header.sequence for _ in range(count)]

    def test_two_readers_of_one_datagram(self):
        one, two = self.group(), self.group()
        for each in (one, two):
            each.open_device(LASER, 0)
        self.say(1)
        for each in (one, two):
            self.assertEqual(each.next(math.inf).body, b"scan")

    def test_those_missing_are_counted_and_those_overtaken_are_dropped(self):
        group = self.group()
        group.open_device(LASER, 0)
        for number in (7, 8, 11, 9, 11, 12):
            self.say(number)
        self.assertEqual(self.heard(group, 4), [7, 8, 11, 12])
        self.assertEqual(group.lost_count, 2)

    def test_numbers_wrap(self):
        group = self.group()
        group.open_device(LASER, 0)
        for number in (0xFFFFFFFE, 0xFFFFFFFF, 1):
            self.say(number)
        self.assertEqual(self.heard(group, 3), [0xFFFFFFFE, 0xFFFFFFFF, 1])
        self.assertEqual(group.lost_count, 1)

    def test_each_device_is_counted_by_itself_and_others_not_at_all(self):
        group = self.group()
        group.open_device(LASER, 0)
        self.say(1)
        self.say(1, SONAR)
        self.say(5, SONAR)
        self.say(2)
        self.assertEqual(self.heard(group, 2), [1, 2])
        group.open_device(SONAR, 0)
        self.say(9, SONAR)
        group.close_device(LASER, 0)
        self.say(7)
        self.say(10, SONAR)
        self.assertEqual(self.heard(group, 2), [9, 10])
        self.assertEqual(group.lost_count, 0)

    def test_datagrams_of_others_and_what_is_no_message_are_left_out(self):
        group = self.group()
        group.open_device(LASER, 0)
        self.say(1, sender=self.socket_of("127.0.0.1"))
        self.say(2, robot=6666)
        self.say(3, size=5)
        self.sender.sendto(b"x", (ADDRESS, self.port))
        self.sender.sendto(b"", (ADDRESS, self.port))
        self.say(4)
        self.assertEqual(self.heard(group, 1), [4])

    def test_what_the_connection_has_is_told_and_so_is_the_end_of_patience(self):
        group = self.group()
        self.assertIsNone(group.next(0.0))
        self.there.send(b"x")
        self.assertIsNone(group.next(math.inf))

    def test_what_has_come_is_forgotten_however_much_it_is(self):
        group = self.group()
        group.open_device(LASER, 0)
        for number in range(1, 101):
            self.say(number)
        self.assertEqual(self.heard(group, 1), [1])
        group.forget()
        self.say(101)
        self.assertEqual(self.heard(group, 1), [101])

    def test_a_port_that_another_program_has_is_told(self):
        taken = self.socket_of("0.0.0.0")
        with self.assertRaises(OSError):
            Group(f"{ADDRESS}:{taken.getsockname()[1]} from 7", SERVED, self.here)

    def test_a_place_that_is_none_is_said(self):
        for place in ("", "nonsense", "239.255.0.1:6680", "239.255.0.1:x from 7"):
            with self.assertRaises((WireError, OSError)):
                Group(place, SERVED, self.here)


if __name__ == "__main__":
    unittest.main()
