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

    def socket_of(self, host, port=0):
        made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        made.bind((host, port))
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

    def test_what_has_come_is_taken_at_once_however_much_it_is(self):
        group = self.group()
        group.open_device(LASER, 0)
        for number in range(1, 101):
            self.say(number)
        self.assertEqual(self.heard(group, 1), [1])
        self.assertEqual([each.header.sequence for each in group.arrived()], list(range(2, 101)))
        self.say(101)
        self.assertEqual(self.heard(group, 1), [101])

    def test_what_came_before_a_device_was_opened_is_not_of_it(self):
        group = self.group()
        self.say(1)
        self.say(2)
        group.open_device(LASER, 0)
        self.say(3)
        self.assertEqual(self.heard(group, 1), [3])

    def test_a_device_opened_again_has_neither_old_data_nor_a_loss(self):
        group = self.group()
        group.open_device(LASER, 0)
        for number in (1, 2, 3):
            self.say(number)
        self.assertEqual(self.heard(group, 1), [1])
        group.close_device(LASER, 0)
        self.say(4)
        group.open_device(LASER, 0)
        self.say(2)  # overtaken
        self.say(9)
        self.assertEqual(self.heard(group, 1), [9])
        self.assertEqual(group.lost_count, 0)

    def test_opening_it_twice_loses_nothing(self):
        group = self.group()
        group.open_device(LASER, 0)
        self.say(1)
        group.open_device(LASER, 0)
        self.assertEqual(self.heard(group, 1), [1])

    def test_a_sender_at_another_address_is_another_whether_or_not_the_server_tells_its_own(self):
        port = self.sender.getsockname()[1]
        other = self.socket_of("127.0.0.2", port)
        for sender in ("127.0.0.1:", ""):
            with self.subTest(sender):
                self.place = f"{ADDRESS}:{self.port} from {sender}{port}"
                group = self.group()
                group.open_device(LASER, 0)
                if sender:
                    self.say(1 << 30, sender=other)
                self.say(1)
                self.say(2 + (1 << 30), sender=other)
                self.say(2)
                self.assertEqual(self.heard(group, 2), [1, 2])
                self.assertEqual(group.lost_count, 0)

    def test_numbers_far_off_count_when_they_go_on(self):
        group = self.group()
        group.open_device(LASER, 0)
        forged = 10 + (1 << 30)
        for number in (10, forged, 11, forged, forged + 1, 12, 13, 14):
            self.say(number)
        self.assertEqual(self.heard(group, 5), [10, 11, forged + 1, 13, 14])

    def test_a_long_silence_is_a_loss(self):
        group = self.group()
        group.open_device(LASER, 0)
        for number in (1, 5000):
            self.say(number)
        self.assertEqual(self.heard(group, 2), [1, 5000])
        self.assertEqual(group.lost_count, 4998)

    def test_the_data_that_came_before_the_end_are_left(self):
        group = self.group()
        group.open_device(LASER, 0)
        self.say(1)
        group.close()
        self.assertEqual([each.header.sequence for each in group.waiting], [1])

    def test_what_strangers_send_keeps_nobody_beyond_the_deadline(self):
        group = self.group()
        stranger, receive, looks = self.socket_of("127.0.0.1"), group._receive, []

        def receive_as_more_comes():
            looks.append(1)
            self.assertLess(len(looks), 100)
            receive()
            self.say(1, sender=stranger)
            return True

        self.say(1, sender=stranger)
        group._receive = receive_as_more_comes
        self.assertIsNone(group.next(0.0))
        group._receive = receive

    def test_a_sender_without_an_end_does_not_hold_up_who_takes_what_has_come(self):
        group = self.group()
        real, datagrams = group._socket, []

        class Endless:
            def recvfrom(self, _size):
                datagrams.append(1)
                assert len(datagrams) < 100000
                return b"x", ("127.0.0.1", 7)

        group._socket = Endless()
        self.assertEqual(group.arrived(), [])
        group._socket = real

    def test_a_port_that_another_program_has_is_told(self):
        taken = self.socket_of("0.0.0.0")
        with self.assertRaises(OSError):
            Group(f"{ADDRESS}:{taken.getsockname()[1]} from 7", SERVED, self.here)

    def test_a_place_that_is_none_is_said(self):
        for place in ("", "nonsense", "239.255.0.1:6680", "239.255.0.1:x from 7", "239.255.0.1:70000 from 7", "239.255.0.1:-1 from 7",
                      "239.255.0.1:0 from 7", "239.255.0.1:6680 from 70000", "239.255.0.1:6680 from nobody:7", "10.0.0.1:6680 from 7",
                      "localhost:6680 from 7", "239.255.0.1\0:6680 from 7", "ff02::1:6680 from 7"):
            with self.subTest(place), self.assertRaises(WireError):
                Group(place, SERVED, self.here)


if __name__ == "__main__":
    unittest.main()
