"""One connection to a Player server, by TCP, a Unix socket or UDP: banner, framing, deadlines. It interprets headers
only."""

import socket
import ssl
import time
from typing import List, Optional

from .errors import ConnectionLost, InvalidValue, RequestTimeout, RunEnded, WireError
from .group import Group
from .wire import HEADER_BYTES, MAX_BODY_BYTES, Header, Kind, Message, is_newer, loss_before

BANNER_BYTES = 32
UDP = "udp:"  # what a host begins with that is reached by datagrams
_CHUNK = 65536
_DATAGRAM_BYTES = 65507  # of one, at most
_HELLO_SECONDS = 1.0  # a session by UDP is begun again without a banner for so long
_LONGEST_WAIT = 1e9  # seconds; sockets reject much larger timeouts


def checked_seconds(timeout: float) -> float:
    """Checks a timeout: 0 or more, infinity included."""
    if not timeout >= 0.0:  # also rejects nan
        raise InvalidValue(f"invalid time-out of {timeout} s: 0 or more is valid")
    return timeout


class Connection:
    """Sends and receives complete messages. A timeout keeps partially read bytes, so reading can continue.

    Deadlines are times of time.monotonic(). If the server disconnects, messages it had sent can still be received;
    then every call raises the reason.
    """

    def __init__(self, host: str, port: int, timeout: float, tls: Optional[ssl.SSLContext] = None) -> None:
        """`host`: also "/FOLDER", for the Unix socket FOLDER/port, or "udp:HOST". `tls`: whom to trust, for a server with --tls-cert."""
        self.datagrams = host.startswith(UDP)
        self.lost_count = 0  # of data messages on their way, by UDP
        self._newest = 0  # number of the last data message
        self._commands = 0  # number of the last command
        self._has_heard = False  # a message, by UDP
        self.peer = f"{host}:{port}"
        self.port = port
        self._timeout = min(checked_seconds(timeout), _LONGEST_WAIT)
        self._bytes = bytearray()
        self._socket: Optional[socket.socket] = None
        self._fault = ""  # why nothing can be sent
        self._ended = False  # by the server, in order
        self.group: Optional[Group] = None  # whose data come by multicast
        try:
            deadline = time.monotonic() + self._timeout
            if self.datagrams:
                self._begin_session(host[len(UDP):], port, deadline)
            else:
                self._socket = self._connected(host, port)
            if tls is not None:
                self._socket = tls.wrap_socket(self._socket, server_hostname=host)
            self.banner = self._read_banner(deadline)
        except (OSError, ValueError, OverflowError, RequestTimeout) as error:  # ValueError: of an invalid host name
            is_clear = tls is None and not self.datagrams and not host.startswith("/")
            silent = "no banner in time" + ("; the server may speak TLS (docs/security.md)" if is_clear else "")
            reason = silent if isinstance(error, RequestTimeout) else error
            raise self._drop(f"cannot connect: {reason}") from error

    def _connected(self, host: str, port: int) -> socket.socket:
        if host.startswith("/"):
            unix = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            unix.settimeout(self._timeout)
            unix.connect(f"{host}/{port}")
            return unix
        tcp = socket.create_connection((host, port), self._timeout)
        tcp.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return tcp

    @property
    def alive(self) -> bool:
        return self._socket is not None and not self._fault

    def send(self, header: Header, body: bytes) -> None:
        if len(body) > MAX_BODY_BYTES:
            raise WireError(f"a message of {len(body)} bytes is over the wire's limit of {MAX_BODY_BYTES}")
        if self.datagrams and HEADER_BYTES + len(body) > _DATAGRAM_BYTES:
            raise WireError(f"a message of {HEADER_BYTES + len(body)} bytes is over the {_DATAGRAM_BYTES} of a datagram; TCP carries it")
        if self._socket is None or self._fault:
            raise self._lost()
        try:
            self._socket.settimeout(self._timeout)
            self._socket.sendall(self._numbered(header).encode() + body)
        except OSError as error:  # a partially sent message cannot be continued
            self._fault = f"the server is gone: {error}"
            raise self._lost() from error

    def _numbered(self, header: Header) -> Header:
        """By UDP a server drops a command that a newer one has overtaken."""
        if not self.datagrams or header.kind != Kind.CMD:
            return header
        self._commands = self._commands % 0xFFFFFFFF + 1
        return header._replace(sequence=self._commands)

    def receive(self, deadline: float) -> Message:
        """The next message. Raises RequestTimeout."""
        while True:
            shared = self._shared(deadline)
            if shared is not None:
                return shared
            try:
                message = self._receive(deadline)
            except ConnectionLost:  # what the group had by then comes first
                if self.group is None or not self.group.waiting:
                    raise
                return self.group.waiting.popleft()
            if not self.datagrams or message.header.kind != Kind.DATA or self._is_next(message.header.sequence):
                return message

    def hear(self, place: str, port: int) -> None:
        """Takes data of the server's group as well, which is at `place`; `port` is that of its devices."""
        if self._socket is None:
            raise self._lost()
        self.group = Group(place, port, self._socket)

    def expect_device(self, interface: int, index: int) -> None:
        """Its data by multicast are for this client from now on, if they are not yet."""
        if self.group is not None:
            self.group.open_device(interface, index)

    def forget_device(self, interface: int, index: int) -> None:
        if self.group is not None:
            self.group.close_device(interface, index)

    def arrived(self) -> List[Message]:
        """Takes the data of the group that have come, without waiting."""
        return self.group.arrived() if self.group is not None else []

    def _shared(self, deadline: float) -> Optional[Message]:
        """The next data of the group, if they come before anything of the connection."""
        if self.group is None or self._has_whole():
            return None
        if self._socket is None:
            return self.group.waiting.popleft() if self.group.waiting else None
        return self.group.next(0.0 if self._fault else deadline)

    def _is_next(self, number: int) -> bool:
        """False: a newer data message has overtaken it. Counts those between the newest and this one as lost."""
        if not is_newer(number, self._newest):
            return False
        self.lost_count += loss_before(number, self._newest)
        self._newest = number
        return True

    def _receive(self, deadline: float) -> Message:
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
        """Whether a complete message is buffered, so that receive() returns without waiting."""
        return self._has_whole() or (self.group is not None and bool(self.group.waiting))

    def _has_whole(self) -> bool:
        if len(self._bytes) < HEADER_BYTES:
            return False
        header = Header.decode(self._bytes[:HEADER_BYTES])
        return header.size > MAX_BODY_BYTES or len(self._bytes) >= HEADER_BYTES + header.size

    def close(self, timeout: float) -> None:
        """Shuts down sending and waits up to `timeout` seconds until the server has read everything.

        Closing with unread data makes TCP discard data in transit, such as a last stop command.
        """
        if self._socket is None:
            return
        deadline = time.monotonic() + timeout
        try:
            if self.datagrams:
                return
            self._socket.shutdown(socket.SHUT_WR)
            while time.monotonic() < deadline:
                self._wait_until(deadline)
                if not self._socket.recv(_CHUNK):
                    break
        except OSError:
            pass  # already disconnecting
        finally:
            self._drop("the connection is closed")

    def _begin_session(self, host: str, port: int, deadline: float) -> None:
        """By UDP: an empty datagram to each address in turn, again until something is heard."""
        addresses = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)
        refused: Optional[OSError] = None
        while not self._bytes and time.monotonic() < deadline:
            refusals = 0
            for family, kind, protocol, _, address in addresses:
                if self._socket is not None:
                    self._socket.close()
                self._socket = socket.socket(family, kind, protocol)
                try:
                    self._socket.connect(address)
                    self._socket.send(b"")
                    self._socket.settimeout(max(1e-4, min(deadline - time.monotonic(), _HELLO_SECONDS)))
                    self._bytes += self._socket.recv(_CHUNK)
                    break
                except socket.timeout:
                    pass
                except OSError as error:  # nobody has the port there
                    refused, refusals = error, refusals + 1
            if refused is not None and refusals == len(addresses):
                raise refused

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
            if self.datagrams and self._is_banner_again(chunk):
                continue
            if not chunk:
                self._ended = not self._fault
                raise self._drop("the run ended: the server closed the connection")
            self._bytes += chunk

    def _is_banner_again(self, datagram: bytes) -> bool:
        """The first one was late; or, once something else was heard, the server knows nothing of this session."""
        again = len(datagram) == BANNER_BYTES and hasattr(self, "banner")
        if again and self._has_heard:
            raise self._drop("the server has begun another session: it was started again, or heard nothing for too long")
        self._has_heard = self._has_heard or (hasattr(self, "banner") and len(datagram) >= HEADER_BYTES)
        return again

    def _wait_until(self, deadline: float) -> None:
        """Sets the timeout of the next recv; after the deadline, data that have arrived are still read."""
        assert self._socket is not None
        left = min(max(deadline - time.monotonic(), 1e-4), _LONGEST_WAIT)
        self._socket.settimeout(0.0 if self._fault else left)  # after a send error no new data are expected

    def _lost(self) -> ConnectionLost:
        return (RunEnded if self._ended else ConnectionLost)(f"{self.peer}: {self._fault}")

    def _drop(self, fault: str) -> ConnectionLost:
        """Closes the connection and returns the error to raise, with the first reason found."""
        self._fault = self._fault or fault
        if self.group is not None:
            self.group.close()
        if self._socket is not None:
            self._socket.close()
            self._socket = None
        return self._lost()
