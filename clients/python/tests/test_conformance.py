"""C++ and Python see the same values in every recorded message."""

import json
import math
import os
import struct
import subprocess
import unittest
from base64 import b64decode
from dataclasses import fields, is_dataclass
from typing import Any

import recordings
from playhouse_client.errors import WireError
from playhouse_client.generated import find_message


def same(python: Any, cpp: Any) -> bool:
    """Whether C++'s JSON says what Python's value says."""
    if is_dataclass(python):
        names = [f.name for f in fields(python)]
        return list(cpp) == names and all(same(getattr(python, name), cpp[name]) for name in names)
    if isinstance(python, bytes):
        return same_bytes(python, cpp)
    if isinstance(python, list):
        return len(python) == len(cpp) and all(same(p, c) for p, c in zip(python, cpp))
    if isinstance(python, float):
        return cpp is None if not math.isfinite(python) else python == cpp or same_float32(python, cpp)
    return bool(python == cpp)


def same_bytes(python: bytes, cpp: Any) -> bool:
    """Text shows up to its NUL, bytes as numbers (signed ones too), and many bytes in base64."""
    if isinstance(cpp, str):
        return python.split(b"\0", 1)[0].decode("utf-8") == cpp
    if isinstance(cpp, dict):
        return b64decode(cpp["base64"]) == python
    return list(python) == [number & 255 for number in cpp]


def same_float32(python: float, cpp: float) -> bool:
    """C++ prints the fewest digits that mean this float32."""
    packed = struct.pack(">f", python)
    return packed == struct.pack(">f", cpp) and struct.unpack(">f", packed) == (python,)


@recordings.needed
@unittest.skipUnless("PLAYHOUSE_CLIENT_DUMP" in os.environ, "run by ctest, which names the C++ program")
class Conformance(unittest.TestCase):
    def test_both_languages_decode_every_recorded_message_alike(self) -> None:
        count = 0
        for stream in recordings.streams():
            command = [os.environ["PLAYHOUSE_CLIENT_DUMP"], str(recordings.FOLDER / stream.name)]
            lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
            messages = list(stream.messages())
            self.assertEqual(len(lines), len(messages), stream.name)
            for line, (header, body) in zip(lines, messages):
                cpp = json.loads(line)
                row = find_message(header.interface, header.kind, header.subtype)
                self.assertEqual(cpp["name"], row.name if row else "")
                value = None
                if row and row.payload and body:
                    try:
                        value = row.payload.decode(body)
                    except WireError:
                        pass  # C++ says null
                self.assertTrue(same(value, cpp["value"]), f"{stream.name}: {value} / {cpp}")
                count += 1
        self.assertGreater(count, 2000)


if __name__ == "__main__":
    unittest.main()
