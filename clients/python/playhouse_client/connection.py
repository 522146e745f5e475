"""One TCP connection to a Player server: banner, framing, deadlines. It knows no message but the header."""

import socket
import time
from typing import NamedTuple, Optional

from .errors import ConnectionLost, RequestTimeout
from .wire import HEADER_BYTES, MAX_BODY_BYTES, Header

BANNER_BYTES = 32
_CHUNK = 65536


class Message(NamedTuple):
    """A header and the bytes that followed it, not decoded."""

    header: Header
    body: bytes


class Connection:
    """Sends and receives whole messages. A time-out leaves half-read bytes in place, so reading can go on."""

    def __init__(self, host: str, port: int, timeout: float) -> None:
        self.peer = f"{host}:{port}"
        self.port = port
        self._bytes = bytearray()
        self._socket: Optional[socket.socket] = None
        try:
            self._socket = socket.create_connection((host, port), timeout)
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.banner = self._read_banner(time.monotonic() + timeout)
        except (OSError, RequestTimeout) as error:
            self._drop()
            reason = "nothing heard from it" if isinstance(error, RequestTimeout) else error
            raise ConnectionLost(f"{self.peer}: cannot connect: {reason}") from error
        except ConnectionLost:
            self._drop()
            raise

    @property
    def alive(self) -> bool:
        return self._socket is not None

    def send(self, header: Header, body: bytes) -> None:
        if len(body) > MAX_BODY_BYTES:
            raise ValueError(f"a message of {len(body)} bytes is over the wire's limit of {MAX_BODY_BYTES}")
        if self._socket is None:
            raise ConnectionLost(f"{self.peer}: the connection is closed")
        try:
            self._socket.sendall(header.encode() + body)
        except OSError as error:  # what was sent in part cannot be continued
            self._drop()
            raise ConnectionLost(f"{self.peer}: the server is gone: {error}") from error

    def receive(self, deadline: Optional[float]) -> Message:
        """The next message; `deadline` on time.monotonic()'s clock, None waits for ever."""
        self._need(HEADER_BYTES, deadline)
        header = Header.decode(self._bytes[:HEADER_BYTES])
        if header.size > MAX_BODY_BYTES:
            self._drop()
            raise ConnectionLost(f"{self.peer}: a header announces {header.size} bytes, over the limit")
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

    def close(self, patience: float) -> None:
        """Says goodbye and waits up to `patience` seconds for the server to have read everything.

        Closing with unread data makes TCP throw away what is still on its way: a last stop command, perhaps.
        """
        if self._socket is None:
            return
        deadline = time.monotonic() + patience
        try:
            self._socket.shutdown(socket.SHUT_WR)
            while time.monotonic() < deadline:
                self._wait_until(deadline)
                if not self._socket.recv(_CHUNK):
                    break
        except OSError:
            pass  # it was going away anyhow
        self._drop()

    def _read_banner(self, deadline: float) -> str:
        self._need(BANNER_BYTES, deadline)
        banner = bytes(self._bytes[:BANNER_BYTES])
        del self._bytes[:BANNER_BYTES]
        if not banner.startswith(b"Player v."):
            raise ConnectionLost(f"{self.peer}: not a Player server (it says {banner!r})")
        return banner.rstrip(b"\0").decode("ascii", "replace")

    def _need(self, count: int, deadline: Optional[float]) -> None:
        while len(self._bytes) < count:
            if self._socket is None:
                raise ConnectionLost(f"{self.peer}: the connection is closed")
            try:
                self._wait_until(deadline)
                chunk = self._socket.recv(_CHUNK)
            except socket.timeout as error:
                raise RequestTimeout(f"{self.peer}: no message in time") from error
            except OSError as error:
                self._drop()
                raise ConnectionLost(f"{self.peer}: the server is gone: {error}") from error
            if not chunk:
                self._drop()
                raise ConnectionLost(f"{self.peer}: the server closed the connection")
            self._bytes += chunk

    def _wait_until(self, deadline: Optional[float]) -> None:
        """Arms the next recv; a deadline that has passed still takes what has already arrived."""
        assert self._socket is not None
        self._socket.settimeout(None if deadline is None else max(deadline - time.monotonic(), 1e-4))

    def _drop(self) -> None:
        if self._socket is not None:
            self._socket.close()
            self._socket = None
