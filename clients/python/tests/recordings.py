"""The recorded sessions of original clients and servers: where they are and what messages they hold."""

import pathlib
import unittest
from typing import Iterator, List, NamedTuple

import package  # noqa: F401
from playhouse_client.connection import BANNER_BYTES, Message
from playhouse_client.wire import HEADER_BYTES, Header

REFERENCE = pathlib.Path(__file__).resolve().parents[4] / "shared"
FOLDER = REFERENCE / "player" / "captures"
needed = unittest.skipUnless(REFERENCE.is_dir(), f"there is no reference material at {REFERENCE}")


class Stream(NamedTuple):
    """One direction of one recorded connection."""

    name: str
    data: bytes

    def messages(self) -> Iterator[Message]:
        at = BANNER_BYTES if self.name.endswith(".s2c") else 0
        while at + HEADER_BYTES <= len(self.data):
            header = Header.decode(self.data[at : at + HEADER_BYTES])
            end = at + HEADER_BYTES + header.size
            if end > len(self.data):
                return
            yield Message(header, self.data[at + HEADER_BYTES : end])
            at = end


def stream(name: str) -> Stream:
    return Stream(name, (FOLDER / name).read_bytes())


def streams() -> List[Stream]:
    found = [stream(path.name) for path in sorted(FOLDER.glob("*.?2?"))]
    assert found, f"no recorded sessions in {FOLDER}"
    return found
