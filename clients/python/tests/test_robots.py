"""Robots by name, from a server of a few lines that lists its models."""

import unittest
from typing import Callable, Dict, List

import package  # noqa: F401
from fake_server import FakeServer, Peer
from playhouse_client import DeviceAddress, InvalidValue, Model, RequestRefused, WireError, connect
from playhouse_client.connection import Message
from playhouse_client.generated import common, player, ranger, simulation
from playhouse_client.models import families, parse_models
from playhouse_client.wire import Kind, c_string, text

HOUSE = [
    "0\tr0\tposition\t\t{port}:position2d:0",
    "1\tr0.ranger:0\tranger\tr0\t{port}:ranger:0 {port}:sonar:0",
    "2\twall\tmodel\t\t",
    "3\tguest\tposition\t\t{port}:position2d:12",
    "4\tguest.ranger:0\tranger\tguest\t{port}:ranger:20 {port}:laser:12",
    "5\tguest.arm\tmodel\tguest\t",
    "6\tguest.arm.eye\tfiducial\tguest.arm\t{port}:fiducial:3",
    "7\tguest.ranger:1\tranger\tguest\t{port}:ranger:21 {port}:laser:30",
    "8\tnext\tposition\t\t9999:position2d:0",
]


def lister(pages: Dict[int, bytes], following: Dict[int, int]) -> Callable[[Peer], None]:
    """Answers questions for models from an index with a page and the index that follows."""

    def answer(peer: Peer, message: Message) -> None:
        if message.header.interface != 31:
            peer.answer(message, Kind.NACK)
            return
        asked = simulation.PropertyReq.decode(message.body)
        assert (text(asked.name), text(asked.prop)) == ("", "models")
        body = simulation.PropertyReq(asked.name, asked.prop, following[asked.index], pages[asked.index])
        peer.answer(message, body=body.encode())

    return lambda peer: peer.serve(answer)


def house(peer: Peer) -> None:
    """All of HOUSE, three models at a time."""
    port = peer.socket.getsockname()[1]
    lines = [line.format(port=port) + "\n" for line in HOUSE]
    pages = {at: "".join(lines[at : at + 3]).encode() for at in range(0, len(lines), 3)}
    lister(pages, {0: 3, 3: 6, 6: 0})(peer)


def opened(server: FakeServer) -> List[str]:
    """The devices that were opened (+) and closed (-), simulation aside."""
    assert server.peer is not None
    found = []
    for message in server.peer.received:
        if message[11] == 1 and message[19] == Kind.REQ and message[23] == player.REQ_DEV.subtype:
            request = player.DeviceReq.decode(message[40:])
            if request.addr.interf != simulation.CODE:
                sign = "-" if request.access == player.CLOSE_MODE else "+"
                found.append(f"{sign}{request.addr.interf}:{request.addr.index}")
    return found


NAME = "a\tb\\n\n"


class Lines(unittest.TestCase):
    def test_a_line_is_a_model_with_its_devices(self) -> None:
        self.assertEqual(
            parse_models("4\ta\\tb\\\\n\\n\tranger\tr 0\t6665:ranger:1 1:laser:2\n"),
            [Model(NAME, "ranger", "r 0", [DeviceAddress(6665, "ranger", 1, NAME), DeviceAddress(1, "laser", 2, NAME)], 4)],
        )

    def test_lines_that_make_no_sense_are_an_error(self) -> None:
        for line in ("x\n", "x\ta\tb\tc\t\n", "0\ta\tb\tc\td\te\n", "0\ta\tb\tc\tlaser:0\n", "0\ta\tb\tc\t1:laser:\n"):
            with self.assertRaisesRegex(WireError, "list of models"):
                parse_models(line)

    def test_what_a_model_carries_is_found_at_any_depth(self) -> None:
        models = parse_models("\n".join(HOUSE[:8]).format(port=1))
        self.assertEqual(
            [model.name for model in families(models)[3]],
            ["guest", "guest.ranger:0", "guest.arm", "guest.arm.eye", "guest.ranger:1"],
        )


class Robots(unittest.TestCase):
    def test_a_robot_has_the_devices_of_all_it_carries(self) -> None:
        with FakeServer(house) as server, connect(server.address) as client:
            guest = client.robot("guest")
            self.assertEqual(
                [address.name for address in guest.devices],
                ["position2d:12", "ranger:20", "laser:12", "fiducial:3", "ranger:21", "laser:30"],
            )
            self.assertEqual(guest.name, "guest")
            self.assertEqual(guest.position2d.name, "position2d:12")
            self.assertEqual((guest.laser.name, guest.fiducial.name), ("laser:12", "fiducial:3"))
            self.assertEqual([ranger.name for ranger in guest.rangers], ["ranger:20", "ranger:21"])
            self.assertEqual(guest.sonars, [])
            self.assertIs(guest.device("ranger", 1), guest.rangers[1])

    def test_robots_are_the_models_at_the_top_with_devices_here(self) -> None:
        with FakeServer(house) as server, connect(server.address) as client:
            self.assertEqual([robot.name for robot in client.robots()], ["r0", "guest"])
            self.assertEqual(client.robots()[1].type, "position")
            self.assertIs(client.robots()[1], client.robot("guest"))

    def test_the_last_of_equal_names_is_meant(self) -> None:
        page = b"0\tr\tposition\t\t1:position2d:0\n1\tr.l\tranger\tr\t1:laser:0\n2\tr\tposition\t\t1:position2d:1\n"
        with FakeServer(lister({0: page}, {0: 0})) as server, connect(server.address) as client:
            self.assertEqual([address.name for address in client.robot("r").devices], ["position2d:1"])

    def test_devices_are_listed_with_their_models(self) -> None:
        def answer(peer: Peer, message: Message) -> None:
            if message.header.interface == 31:
                body = simulation.PropertyReq(b"\0", b"models\0", 0, page(peer).encode()).encode()
                peer.answer(message, body=body)
            elif message.header.subtype == player.REQ_DEVLIST.subtype:
                port = peer.socket.getsockname()[1]
                places = [(31, 0), (4, 12), (ranger.CODE, 20), (6, 77)]
                listed = [common.Devaddr(0, port, code, index) for code, index in places]
                peer.answer(message, body=player.DeviceDevlist(listed).encode())
            else:
                peer.answer(message, Kind.NACK)

        def page(peer: Peer) -> str:
            return "".join(line.format(port=peer.socket.getsockname()[1]) + "\n" for line in HOUSE)

        with FakeServer(lambda peer: peer.serve(answer)) as server, connect(server.address) as client:
            told = [(entry.name, entry.model, entry.robot) for entry in client.devices()]
        self.assertEqual(
            told,
            [
                ("simulation:0", "", ""), ("position2d:12", "guest", "guest"),
                ("ranger:20", "guest.ranger:0", "guest"), ("laser:77", "", ""),
            ],
        )

    def test_devices_are_opened_once_and_the_models_asked_for_once(self) -> None:
        with FakeServer(house) as server:
            with connect(server.address) as client:
                for _ in range(3):
                    client.robot("guest").position2d.stop()
                self.assertIs(client.robot("guest").laser, client.robot("guest").lasers[0])
                client.robot("r0")
        assert server.peer is not None
        self.assertEqual(opened(server), ["+4:12", "+6:12", "+6:30", "-6:30", "-6:12", "-4:12"])
        self.assertEqual(len([m for m in server.peer.received if m[11] == 31]), 3)

    def test_a_robot_that_came_later_is_found(self) -> None:
        lists = [b"0\tr0\tposition\t\t1:position2d:0\n", b"0\tr0\tposition\t\t1:position2d:0\n1\tr1\tposition\t\t1:position2d:1\n"]

        def answer(peer: Peer, message: Message) -> None:
            page = lists.pop(0) if len(lists) > 1 else lists[0]
            peer.answer(message, body=simulation.PropertyReq(b"\0", b"models\0", 0, page).encode())

        with FakeServer(lambda peer: peer.serve(answer)) as server, connect(server.address) as client:
            first = client.robot("r0")
            self.assertEqual(client.robot("r1").devices[0].name, "position2d:1")
            self.assertIs(client.robot("r0"), first)
            self.assertEqual([model.name for model in client.models()], ["r0", "r1"])

    def test_leaving_a_robots_block_stops_and_closes_it_and_it_opens_again(self) -> None:
        with FakeServer(house) as server, connect(server.address) as client:
            with client.robot("guest") as guest:
                base = guest.position2d
                base.drive(0.1)
            self.assertFalse(base.is_open)
            assert server.peer is not None
            self.assertEqual([m[19] for m in server.peer.received[-3:]], [Kind.CMD, Kind.CMD, Kind.REQ])
            self.assertTrue(guest.position2d.is_open)

    def test_a_name_that_is_not_there_gets_the_nearest_one(self) -> None:
        with FakeServer(house) as server, connect(server.address) as client:
            with self.assertRaisesRegex(RequestRefused, r'there is no robot "gest" at \S+ \(did you mean "guest"\?\)'):
                client.robot("gest")
            with self.assertRaisesRegex(RequestRefused, r'there is no robot "R0" at \S+ \(did you mean "r0"\?\)'):
                client.robot("R0")
            with self.assertRaisesRegex(RequestRefused, r'there is no robot "xyzzy" at \S+$'):
                client.robot("xyzzy")
            wrong = r'there is no interface "lazer" \(did you mean "laser"\?\)'
            with self.assertRaisesRegex(InvalidValue, wrong):
                client.robot("guest").device("lazer")

    def test_a_device_that_a_robot_lacks_is_told_with_what_it_has(self) -> None:
        with FakeServer(house) as server, connect(server.address) as client:
            with self.assertRaisesRegex(RequestRefused, r'robot "r0" has no laser \(it has position2d:0, ranger:0, son'):
                client.robot("r0").laser
            with self.assertRaisesRegex(RequestRefused, 'robot "r0" has no sonar number 1'):
                client.robot("r0").device("sonar", 1)
            with self.assertRaisesRegex(RequestRefused, r'robot "wall" has no laser \(it has no devices\)'):
                client.robot("wall").laser
            with self.assertRaisesRegex(RequestRefused, "but position2d:0 at port 9999: connect there"):
                client.robot("next").position2d

    def test_a_server_that_does_not_list_models_is_told(self) -> None:
        def refuse(peer: Peer) -> None:
            peer.serve(lambda peer, message: peer.answer(message, Kind.NACK))

        with FakeServer(refuse) as server, connect(server.address) as client:
            for ask in (client.robots, lambda: client.robot("r0")):
                with self.assertRaisesRegex(RequestRefused, "does not tell the names of models; open devices by number"):
                    ask()

    def test_a_list_that_goes_round_in_circles_is_an_error(self) -> None:
        page = b"0\tr0\tposition\t\t\n"
        with FakeServer(lister({0: page, 1: page}, {0: 1, 1: 1})) as server, connect(server.address) as client:
            with self.assertRaisesRegex(WireError, "goes on at 1 after 1"):
                client.robots()


if __name__ == "__main__":
    unittest.main()
