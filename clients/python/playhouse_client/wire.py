"""Encoding and decoding of Player's variant of XDR and of its message header; base of the generated classes.

Everything is big-endian and a multiple of four bytes. A list is encoded as its count in the count field, and again
as a length before its elements; the rules are in docs/wire.md.
"""

import enum
import struct
from dataclasses import dataclass
from typing import Any, Callable, List, NamedTuple, Optional, Sequence, Type, TypeVar

from .errors import WireError

HEADER_BYTES = 40
MAX_BODY_BYTES = 33554432 - HEADER_BYTES

_HEADER = struct.Struct(">6Id2I")


class Kind(enum.IntEnum):
    """Type of a message: the header's `type`."""

    DATA = 1
    CMD = 2
    REQ = 3
    ACK = 4
    SYNCH = 5
    NACK = 6


class Header(NamedTuple):
    """The 40 bytes before every body. `size` is the body's length in bytes, `timestamp` is in seconds."""

    interface: int
    index: int
    kind: int
    subtype: int
    timestamp: float = 0.0
    sequence: int = 0
    size: int = 0
    host: int = 0
    robot: int = 0

    def encode(self) -> bytes:
        return _HEADER.pack(
            self.host, self.robot, self.interface, self.index, self.kind, self.subtype,
            self.timestamp, self.sequence, self.size,
        )

    @staticmethod
    def decode(data: bytes) -> "Header":
        """Reads 40 bytes; narrow fields keep their low bits only, as in every Player receiver."""
        host, robot, interface, index, kind, subtype, timestamp, sequence, size = _HEADER.unpack(data)
        return Header(
            interface & 0xFFFF, index & 0xFFFF, kind & 0xFF, subtype & 0xFF,
            timestamp, sequence, size, host, robot,
        )


class Message(NamedTuple):
    """A header and the undecoded body."""

    header: Header
    body: bytes


def is_newer(number: int, newest: int) -> bool:
    """Of the numbers of messages, which wrap (RFC 1982)."""
    return 0 < (number - newest) & 0xFFFFFFFF < 1 << 31


def loss_before(number: int, newest: int) -> int:
    """How many there were between the newest and this one, which is newer."""
    return ((number - newest) & 0xFFFFFFFF) - 1


class Reader:
    """Reads values from a body, front to back. Allocations are bounded by the size of the body."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0

    def number(self, code: str) -> Any:
        """One number: B b H h I i (four bytes each), q or d (eight), f (four), as in the struct module."""
        wire, size, narrow = _NUMBERS[code]
        value = struct.unpack_from(wire, self._data, self._take(size))[0]
        return narrow(value) if narrow else value

    def numbers(self, code: str, count: int) -> List[Any]:
        wire, size, narrow = _NUMBERS[code]
        values = struct.unpack_from(f">{count}{wire[1]}", self._data, self._take(size * count))
        return [narrow(value) for value in values] if narrow else list(values)

    def opaque(self, count: int) -> bytes:
        """`count` raw bytes and the zero padding of the last word."""
        at = self._take(count + -count % 4)
        return bytes(self._data[at : at + count])

    def length(self, name: str, limit: int, least: int) -> int:
        """The length before the elements of a list: at most `limit`, each element at least `least` bytes."""
        count: int = self.number("I")
        left = len(self._data) - self._at
        if count > limit:
            raise WireError(f"byte {self._at}: {name} has a length of {count}, over its limit of {limit}")
        if count * least > left:
            raise WireError(f"byte {self._at}: {name} claims {count} elements, but {left} bytes are left")
        return count

    def _take(self, size: int) -> int:
        at = self._at
        if size > len(self._data) - at:
            raise WireError(f"byte {at}: {size} bytes expected, {len(self._data) - at} are left")
        self._at = at + size
        return at


class Writer:
    """Appends values to a body. A value outside the range of its field raises WireError."""

    def __init__(self) -> None:
        self._data = bytearray()

    def number(self, code: str, value: Any) -> None:
        low, high = _RANGES.get(code, (None, None))
        if low is not None and not low <= value <= high:
            raise WireError(f"{value} is outside [{low}, {high}]")
        self._pack(_NUMBERS[code][0], value)

    def numbers(self, code: str, values: Sequence[Any]) -> None:
        low, high = _RANGES.get(code, (None, None))
        if low is not None and values and not (low <= min(values) and max(values) <= high):
            raise WireError(f"a number is outside [{low}, {high}]")
        self._pack(f">{len(values)}{_NUMBERS[code][0][1]}", *values)

    def length(self, name: str, count: int, limit: int) -> None:
        """A count or length word before a list of at most `limit` elements."""
        if count > limit:
            raise WireError(f"{name} has {count} elements, over its limit of {limit}")
        self.number("I", count)

    def exactly(self, name: str, count: int, wanted: int) -> None:
        """Checks a list of fixed length, which is encoded without a length word."""
        if count != wanted:
            raise WireError(f"{name} has {count} elements instead of {wanted}")

    def opaque(self, data: bytes) -> None:
        """Raw bytes, zero-padded to a multiple of four."""
        self._data += data
        self._data += bytes(-len(data) % 4)

    def fixed(self, name: str, data: bytes, size: int) -> None:
        """Exactly `size` bytes: `data`, zero-padded."""
        if len(data) > size:
            raise WireError(f"{name} has {len(data)} bytes, over its {size}")
        self.opaque(data + bytes(size - len(data)))

    def bytes(self) -> bytes:
        return bytes(self._data)

    def _pack(self, format: str, *values: Any) -> None:
        try:
            self._data += struct.pack(format, *values)
        except (struct.error, OverflowError) as error:
            raise WireError(str(error)) from error


def _low(bits: int) -> Callable[[int], int]:
    return lambda value: value & ((1 << bits) - 1)


def _low_signed(bits: int) -> Callable[[int], int]:
    half = 1 << (bits - 1)
    return lambda value: ((value + half) & (2 * half - 1)) - half


# code: wire format, bytes, conversion by a receiver
_NUMBERS = {
    "B": (">I", 4, _low(8)),
    "b": (">i", 4, _low_signed(8)),
    "H": (">I", 4, _low(16)),
    "h": (">i", 4, _low_signed(16)),
    "I": (">I", 4, None),
    "i": (">i", 4, None),
    "q": (">q", 8, None),
    "f": (">f", 4, None),
    "d": (">d", 8, None),
}
_RANGES = {"B": (0, 255), "b": (-128, 127), "H": (0, 65535), "h": (-32768, 32767)}

S = TypeVar("S", bound="Struct")


class Struct:
    """Base of the generated classes; fields are in wire order."""

    def encode(self) -> bytes:
        writer = Writer()
        self.write(writer)
        return writer.bytes()

    @classmethod
    def decode(cls: Type[S], data: bytes) -> S:
        """Decodes `data`; trailing bytes are ignored. Raises WireError."""
        try:
            return cls.read(Reader(data))
        except WireError as error:
            raise WireError(f"{cls.__module__.rpartition('.')[2]}.{cls.__name__}: {error}") from None

    def write(self, writer: Writer) -> None:
        raise NotImplementedError

    @classmethod
    def read(cls: Type[S], reader: Reader) -> S:
        raise NotImplementedError


@dataclass(frozen=True)
class MessageType:
    """One message type of one interface, as PLAYER_POSITION2D_CMD_VEL; without `payload` it has no body."""

    interface: int
    kind: Kind
    subtype: int
    name: str
    payload: Optional[Type[Struct]] = None


def text(data: bytes) -> str:
    """The text of a string field, up to the first NUL."""
    return data.split(b"\0", 1)[0].decode("utf-8", "replace")


def c_string(value: str) -> bytes:
    """Encodes text as a string field, NUL-terminated and without a NUL inside."""
    try:
        encoded = value.encode("utf-8")
    except UnicodeEncodeError as error:
        raise WireError(f"{value!r} cannot be sent as UTF-8: {error.reason}") from None
    if b"\0" in encoded:
        raise WireError(f"{value!r} has a NUL in it, where receivers would end it")
    return encoded + b"\0"
