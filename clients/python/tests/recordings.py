"""The recorded sessions of original clients and servers: where they are and what messages they hold."""

from typing import Iterator, List, NamedTuple

import package
from playhouse_client.connection import BANNER_BYTES, Message
from playhouse_client.wire import HEADER_BYTES, Header

FOLDER = package.ROOT / "tests" / "reference" / "player" / "captures"


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
    assert len(found) == 38, f"{len(found)} recorded streams in {FOLDER}"
    return found
