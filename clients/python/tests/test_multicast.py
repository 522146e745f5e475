"""What a client makes of a server's group: when its data count, and for whom."""

import socket
import ssl
import unittest

import package  # noqa: F401
from fake_server import FakeServer, Peer
from playhouse_client import Access, Client, InvalidValue, RunEnded, connect
from playhouse_client.connection import Message
from playhouse_client.generated import common, player, position2d
from playhouse_client.wire import Header, Kind, c_string

ADDRESS = "239.255.66.66"
WHEELS = position2d.CODE


class Multicast(unittest.TestCase):
    def setUp(self) -> None:
        self.sender = self.socket_of()
        self.sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
        taken = self.socket_of()  # until the group has it: no other test's
        self.port = taken.getsockname()[1]
        self.number = 0
        self.server = FakeServer(lambda peer: peer.serve(self.answer)).__enter__()
        self.addCleanup(self.server.__exit__, None)
        self.client = connect(self.server.address, multicast=True)
        self.addCleanup(self.client.close)

    def socket_of(self) -> socket.socket:
        made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        made.bind(("127.0.0.1", 0))
        self.addCleanup(made.close)
        return made

    def answer(self, peer: Peer, message: Message) -> None:
        """Grants what has to do with the group, and nothing else."""
        is_for_server = message.header.interface == player.CODE
        if is_for_server and message.header.subtype == common.REQ_GET_STRPROP.subtype:
            place = f"{ADDRESS}:{self.port} from 127.0.0.1:{self.sender.getsockname()[1]}"
            peer.answer(message, body=common.StrpropReq(c_string("multicast"), c_string(place)).encode())
        elif is_for_server and message.header.subtype == common.REQ_SET_INTPROP.subtype:
            peer.answer(message)
        elif is_for_server and message.header.subtype == common.REQ_GET_INTPROP.subtype:
            peer.answer(message, body=common.IntpropReq(c_string("lost"), 0).encode())
        else:
            peer.answer(message, Kind.NACK)

    def drive_to(self, x: float, missing: int = 0) -> None:
        """Data of position2d:0 by multicast, after so many that go astray."""
        self.number += 1 + missing
        body = position2d.Data(pos=common.Pose2d(x, 0.0, 0.0)).encode()
        head = Header(WHEELS, 0, Kind.DATA, position2d.DATA_STATE.subtype, self.number, self.number, len(body), 0, self.server.port)
        self.sender.sendto(head.encode() + body, (ADDRESS, self.port))

    def retire(self) -> None:
        assert self.server.peer is not None
        notice = player.DeviceReq(common.Devaddr(0, self.server.port, WHEELS, 0), ord("e"))
        self.server.peer.say(player.CODE, 0, Kind.ACK, player.REQ_DEV.subtype, notice.encode())

    def test_the_last_data_come_before_the_end(self) -> None:
        wheels = self.client.position2d()
        self.drive_to(1.0)
        self.drive_to(2.0)
        assert self.server.peer is not None
        self.server.peer.socket.shutdown(socket.SHUT_WR)
        seen = 0
        with self.assertRaises(RunEnded):
            while True:
                seen += self.client.read()
        self.assertEqual((seen, wheels.pose.x), (2, 2.0))

    def test_what_has_arrived_is_delivered_without_waiting(self) -> None:
        wheels = self.client.position2d()
        self.drive_to(1.0)
        self.client.deliver_pushed()  # at the end of a step
        self.assertEqual(wheels.pose.x, 1.0)

    def test_data_from_before_a_device_was_opened_are_not_its(self) -> None:
        self.drive_to(1.0)
        wheels = self.client.position2d()
        self.drive_to(2.0)
        self.assertEqual(self.client.read(), 1)
        self.assertEqual(wheels.pose.x, 2.0)
        wheels.close()
        self.drive_to(3.0)
        with self.client.position2d() as again:
            self.client.deliver_pushed()
            self.assertFalse(again.has_data)
        self.assertEqual(self.client.lost_count(), 0)

    def test_data_that_wait_are_not_of_the_next_to_open_a_device(self) -> None:
        wheels = self.client.position2d()
        self.drive_to(1.0)
        self.client.lost_count()  # takes them in
        wheels.close()
        with self.client.position2d() as again:
            self.client.deliver_pushed()
            self.assertFalse(again.has_data)

    def test_a_retired_device_gets_its_last_data_and_none_of_another_at_its_address(self) -> None:
        gone = self.client.position2d()
        self.drive_to(1.0)
        self.retire()
        self.assertEqual(self.client.read(), 1)
        self.assertTrue(gone.gone)
        self.assertEqual(gone.pose.x, 1.0)
        self.drive_to(2.0)
        self.client.deliver_pushed()
        self.assertEqual(gone.pose.x, 1.0)
        following = self.client.position2d()
        self.drive_to(3.0, missing=7)
        self.assertEqual(self.client.read(), 1)
        self.assertEqual((gone.pose.x, following.pose.x), (1.0, 3.0))
        self.assertEqual(self.client.lost_count(), 0)

    def test_a_device_that_is_opened_as_another_is_retired_there_gets_its_data(self) -> None:
        self.client.position2d()
        self.drive_to(1.0)
        self.retire()
        following = self.client.position2d()
        self.drive_to(2.0)
        self.assertEqual(self.client.read(), 1)
        self.assertEqual(following.pose.x, 2.0)

    def test_a_device_opened_for_writing_alone_gets_none_until_another_reads(self) -> None:
        writing = self.client.position2d(access=Access.WRITE)
        self.drive_to(1.0)
        self.client.deliver_pushed()
        self.assertFalse(writing.has_data)
        reading = self.client.position2d(access=Access.READ)
        self.drive_to(2.0)
        self.assertEqual(self.client.read(), 1)
        self.assertEqual(reading.pose.x, 2.0)


class Encrypted(unittest.TestCase):
    def test_multicast_does_not_go_with_tls(self) -> None:
        with self.assertRaises(InvalidValue):
            Client("127.0.0.1", 1, tls=ssl.create_default_context(), multicast=True)


if __name__ == "__main__":
    unittest.main()
