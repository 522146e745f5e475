"""One TCP connection to a Player server: banner, framing, deadlines. It knows no message but the header."""

import socket
import time
from typing import NamedTuple, Optional

from .errors import ConnectionLost, InvalidValue, RequestTimeout, RunEnded, WireError
from .wire import HEADER_BYTES, MAX_BODY_BYTES, Header

BANNER_BYTES = 32
_CHUNK = 65536
_LONGEST_WAIT = 1e9  # seconds; what sockets take for a time-out ends somewhere beyond


class Message(NamedTuple):
    """A header and the bytes that followed it, not decoded."""

    header: Header
    body: bytes


def checked_seconds(timeout: float) -> float:
    """A time-out, if it is one: 0 or more, infinity included."""
    if not timeout >= 0.0:  # nan as well
        raise InvalidValue(f"a time-out of {timeout} s")
    return timeout


class Connection:
    """Sends and receives whole messages. A time-out leaves half-read bytes in place, so reading can go on.

    Deadlines are on time.monotonic()'s clock. When the server goes, what it had sent can still be received; then
    every call tells why it went.
    """

    def __init__(self, host: str, port: int, timeout: float) -> None:
        self.peer = f"{host}:{port}"
        self.port = port
        self._timeout = min(checked_seconds(timeout), _LONGEST_WAIT)
        self._bytes = bytearray()
        self._socket: Optional[socket.socket] = None
        self._fault = ""  # why nothing can be sent any more
        self._ended = False  # by the server, in order
        try:
            self._socket = socket.create_connection((host, port), self._timeout)
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.banner = self._read_banner(time.monotonic() + self._timeout)
        except (OSError, ValueError, OverflowError, RequestTimeout) as error:  # ValueError: of a host that is no name
            reason = "no banner in time" if isinstance(error, RequestTimeout) else error
            raise self._drop(f"cannot connect: {reason}") from error

    @property
    def alive(self) -> bool:
        return self._socket is not None and not self._fault

    def send(self, header: Header, body: bytes) -> None:
        if len(body) > MAX_BODY_BYTES:
            raise WireError(f"a message of {len(body)} bytes is over the wire's limit of {MAX_BODY_BYTES}")
        if self._socket is None or self._fault:
            raise self._lost()
        try:
            self._socket.settimeout(self._timeout)
            self._socket.sendall(header.encode() + body)
        except OSError as error:  # what was sent in part cannot be continued
            self._fault = f"the server is gone: {error}"
            raise self._lost() from error

    def receive(self, deadline: float) -> Message:
        """The next message. Raises RequestTimeout."""
        self._need(HEADER_BYTES, deadline)
        header = Header.decode(self._bytes[:HEADER_BYTES])
        if header.size > MAX_BODY_BYTES:
            raise self._drop(f"a header announces {header.size} bytes, over the limit")
        end = HEADER_BYTES + header.size
        self._need(end, deadline)
        body = bytes(self._bytes[HEADER_BYTES:end])
        del self._bytes[:end]
        return Message(header, body)

    def buffered(self) -> bool:
        """Whether a whole message is here already, so that receive() returns without waiting."""
        if len(self._bytes) < HEADER_BYTES:
            return False
        header = Header.decode(self._bytes[:HEADER_BYTES])
        return header.size > MAX_BODY_BYTES or len(self._bytes) >= HEADER_BYTES + header.size

    def close(self, timeout: float) -> None:
        """Ends sending and waits up to `timeout` seconds until the server has read everything.

        Closing with unread data makes TCP throw away what is still on its way: a last stop command, perhaps.
        """
        if self._socket is None:
            return
        deadline = time.monotonic() + timeout
        try:
            self._socket.shutdown(socket.SHUT_WR)
            while time.monotonic() < deadline:
                self._wait_until(deadline)
                if not self._socket.recv(_CHUNK):
                    break
        except OSError:
            pass  # it was going away anyhow
        self._drop("the connection is closed")

    def _read_banner(self, deadline: float) -> str:
        self._need(BANNER_BYTES, deadline)
        banner = bytes(self._bytes[:BANNER_BYTES])
        del self._bytes[:BANNER_BYTES]
        if not banner.startswith(b"Player v."):
            raise self._drop(f"not a Player server (it says {banner!r})")
        return banner.rstrip(b"\0").decode("ascii", "replace")

    def _need(self, count: int, deadline: float) -> None:
        while len(self._bytes) < count:
            if self._socket is None:
                raise self._lost()
            try:
                self._wait_until(deadline)
                chunk = self._socket.recv(_CHUNK)
            except socket.timeout as error:
                raise RequestTimeout(f"{self.peer}: no message in time") from error
            except OSError as error:
                raise self._drop(f"the server is gone: {error}") from error
            if not chunk:
                self._ended = not self._fault
                raise self._drop("the run ended: the server closed the connection")
            self._bytes += chunk

    def _wait_until(self, deadline: float) -> None:
        """Arms the next recv; a deadline that has passed still takes what has already arrived."""
        assert self._socket is not None
        left = min(max(deadline - time.monotonic(), 1e-4), _LONGEST_WAIT)
        self._socket.settimeout(0.0 if self._fault else left)  # one that cannot be sent to will say nothing new

    def _lost(self) -> ConnectionLost:
        return (RunEnded if self._ended else ConnectionLost)(f"{self.peer}: {self._fault}")

    def _drop(self, fault: str) -> ConnectionLost:
        """Ends the connection, for the first reason that was found; the error to raise."""
        self._fault = self._fault or fault
        if self._socket is not None:
            self._socket.close()
            self._socket = None
        return self._lost()
