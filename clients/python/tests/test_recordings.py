"""Every recorded message decodes, and encodes to the bytes it came from."""

import unittest

import recordings
from playhouse_client.errors import WireError
from playhouse_client.generated import find_message
from playhouse_client.wire import Header

# Messages that were recorded on purpose to be wrong: stream, what they claim to be.
WRONG = [("04_raw_errors.c2s", "position2d.cmd.vel"), ("04_raw_errors.c2s", "position2d.req.set_odom")]


class Recordings(unittest.TestCase):
    def test_headers_come_out_as_they_went_in(self) -> None:
        for stream in recordings.streams():
            for header, _ in stream.messages():
                self.assertEqual(Header.decode(header.encode()), header)

    def test_bodies_come_out_as_they_went_in(self) -> None:
        count, wrong = 0, []
        for stream in recordings.streams():
            for header, body in stream.messages():
                row = find_message(header.interface, header.kind, header.subtype)
                if row is None or row.payload is None or not body:
                    continue
                try:
                    again = row.payload.decode(body).encode()
                except WireError:
                    wrong.append((stream.name, row.name))
                    continue
                self.assertEqual(again.hex(), body.hex(), f"{row.name} in {stream.name}")
                count += 1
        self.assertEqual(wrong, WRONG)
        self.assertGreater(count, 2000)


if __name__ == "__main__":
    unittest.main()
