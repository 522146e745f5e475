"""Every language sees the same values in every recorded message, and encodes them to the same bytes."""

import json
import math
import struct
import subprocess
import unittest
from base64 import b64decode
from dataclasses import fields, is_dataclass
from typing import Any

import languages
import recordings
from playhouse_client.errors import WireError
from playhouse_client.generated import find_message


def same(python: Any, other: Any) -> bool:
    """Whether another language's JSON says what Python's value says."""
    if is_dataclass(python):
        names = [f.name for f in fields(python)]
        return list(other) == names and all(same(getattr(python, name), other[name]) for name in names)
    if isinstance(python, bytes):
        return same_bytes(python, other)
    if isinstance(python, list):
        return len(python) == len(other) and all(same(p, c) for p, c in zip(python, other))
    if isinstance(python, float):
        return other is None if not math.isfinite(python) else python == other or same_float32(python, other)
    return bool(python == other)


def same_bytes(python: bytes, other: Any) -> bool:
    """Text shows up to its NUL, bytes as numbers (signed ones too), and many bytes in base64."""
    if isinstance(other, str):
        return python.split(b"\0", 1)[0].decode("utf-8") == other
    if isinstance(other, dict):
        return b64decode(other["base64"]) == python
    return list(python) == [number & 255 for number in other]


def same_float32(python: float, other: float) -> bool:
    """Others print the fewest digits that mean this float32."""
    packed = struct.pack(">f", python)
    return packed == struct.pack(">f", other) and struct.unpack(">f", packed) == (python,)


@languages.needed
class Conformance(unittest.TestCase):
    def test_all_languages_decode_every_recorded_message_alike(self) -> None:
        for language, program in languages.programs("dump").items():
            with self.subTest(language):
                count = sum(self.check(program, stream) for stream in recordings.streams())
                self.assertGreater(count, 2000)

    def check(self, program: str, stream: recordings.Stream) -> int:
        """How many messages the stream has."""
        command = [program, str(recordings.FOLDER / stream.name)]
        lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
        messages = list(stream.messages())
        self.assertEqual(len(lines), len(messages), stream.name)
        for line, (header, body) in zip(lines, messages):
            other = json.loads(line)
            row = find_message(header.interface, header.kind, header.subtype)
            self.assertEqual(other["name"], row.name if row else "")
            value = None
            if row and row.payload and body:
                try:
                    value = row.payload.decode(body)
                except WireError:
                    pass  # the others say null
            self.assertTrue(same(value, other["value"]), f"{stream.name}: {value} / {other}")
            self.assertEqual(other["again"], value.encode().hex() if value else "")
        return len(messages)


if __name__ == "__main__":
    unittest.main()
