"""Laws of the encoding: round trips, and hostile bytes that raise WireError and nothing else."""

import random
import struct
import unittest
from dataclasses import fields
from typing import Iterator, Type

import package  # noqa: F401
from playhouse_client.errors import WireError
from playhouse_client.generated import common, find_message, map, player, position2d
from playhouse_client import generated
from playhouse_client.wire import Header, Kind, Reader, Struct, c_string, text


def payloads() -> Iterator[Type[Struct]]:
    modules = [common] + [getattr(generated, name) for name in generated.INTERFACES.values()]
    for module in modules:
        for value in vars(module).values():
            if isinstance(value, type) and issubclass(value, Struct) and value.__module__ == module.__name__:
                yield value


def words(rng: random.Random, count: int) -> bytes:
    """Words as bodies have them: mostly small numbers, so that lengths are often believable."""
    return b"".join(struct.pack(">I", rng.choice([0, 1, 2, 3, rng.randrange(2**32)])) for _ in range(count))


class Wire(unittest.TestCase):
    def test_what_decodes_encodes_to_bytes_that_mean_the_same(self) -> None:
        rng = random.Random(1)
        for kind in payloads():
            decoded = 0
            for _ in range(200):
                try:
                    value = kind.decode(words(rng, rng.randrange(1, 60)))
                except WireError:
                    continue
                decoded += 1
                body = value.encode()
                self.assertEqual(kind.decode(body).encode(), body)
            self.assertGreater(decoded, 0, kind)

    def test_a_body_that_is_cut_short_raises(self) -> None:
        for kind in payloads():
            body = kind().encode()
            for size in range(len(body)):
                with self.assertRaises(WireError, msg=f"{kind} cut to {size} bytes"):
                    kind.decode(body[:size])

    def test_bytes_after_the_end_are_ignored(self) -> None:
        body = position2d.CmdCar(1.0, 2.0).encode()
        self.assertEqual(position2d.CmdCar.decode(body + b"more"), position2d.CmdCar(1.0, 2.0))

    def test_a_huge_length_raises_before_anything_is_allocated(self) -> None:
        body = struct.pack(">II", 0xFFFFFFFF, 0xFFFFFFFF)
        with self.assertRaisesRegex(WireError, "devices has a length of 4294967295, over its limit of 4096"):
            player.DeviceDevlist.decode(body)
        with self.assertRaisesRegex(WireError, "key claims 4294967295 elements, but 0 bytes are left"):
            common.IntpropReq.decode(body)

    def test_the_second_length_counts_and_may_not_exceed_the_first(self) -> None:
        self.assertEqual(common.IntpropReq.decode(struct.pack(">II4si", 8, 4, b"abcd", 5)).key, b"abcd")
        fault = "common.IntpropReq: byte 8: key has a length of 4, over its limit of 3"
        with self.assertRaisesRegex(WireError, fault):
            common.IntpropReq.decode(struct.pack(">II4si", 3, 4, b"abcd", 5))

    def test_a_count_may_travel_apart_from_its_list(self) -> None:
        value = map.Data(col=1, row=2, width=3, height=4, data_range=-1, data=b"\1\xff")
        self.assertEqual(value.encode(), struct.pack(">IIIIIiI2sxx", 1, 2, 3, 4, 2, -1, 2, b"\1\xff"))
        self.assertEqual(map.Data.decode(value.encode()), value)

    def test_a_number_that_does_not_fit_its_field_raises(self) -> None:
        with self.assertRaisesRegex(WireError, "256 is outside"):
            player.DeviceDatamodeReq(256).encode()
        with self.assertRaises(WireError):
            common.IntpropReq(b"x\0", 2**31).encode()
        with self.assertRaisesRegex(WireError, "driver_name has 65 elements"):
            player.DeviceReq(driver_name=b"x" * 65).encode()

    def test_narrow_numbers_keep_their_low_bits(self) -> None:
        reader = Reader(struct.pack(">IIii", 0x101, 0x12345, 200, -200))
        self.assertEqual([reader.number(code) for code in "BHbb"], [1, 0x2345, -56, 56])
        header = struct.pack(">6Id2I", 0, 0, 0x10004, 0x10001, 0x101, 0x102, 0.0, 0, 0)
        self.assertEqual(Header.decode(header)[:4], (4, 1, 1, 2))

    def test_strings_carry_their_nul(self) -> None:
        self.assertEqual(c_string("r0"), b"r0\0")
        self.assertEqual(text(b"r0\0junk"), "r0")
        self.assertEqual(text(b"r0"), "r0")

    def test_answers_share_the_row_of_their_request(self) -> None:
        self.assertIs(find_message(4, Kind.ACK, 1), position2d.REQ_GET_GEOM)
        self.assertIs(find_message(999, Kind.NACK, 255), common.REQ_CAPABILITIES)
        self.assertIsNone(find_message(4, Kind.DATA, 99))

    def test_every_field_has_a_default(self) -> None:
        for kind in payloads():
            self.assertEqual(len(fields(kind())), len(fields(kind)))


if __name__ == "__main__":
    unittest.main()
