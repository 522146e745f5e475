"""A server of a few lines for one client: a script says what it answers."""

import socket
import struct
import threading
from typing import Callable, List, Optional

import package  # noqa: F401
from playhouse_client.connection import Message
from playhouse_client.wire import HEADER_BYTES, Header, Kind, MessageType, Struct

BANNER = b"Player v.3.1.1".ljust(32, b"\0")


class Peer:
    """The server's end of the connection, for scripts."""

    def __init__(self, connection: socket.socket) -> None:
        self.socket = connection
        self.received: List[bytes] = []

    def receive(self) -> Optional[Message]:
        """The client's next message, None at its end."""
        header = self._exactly(HEADER_BYTES)
        if header is None:
            return None
        decoded = Header.decode(header)
        body = self._exactly(decoded.size)
        if body is None:
            return None
        self.received.append(header + body)
        return Message(decoded, body)

    def send(self, data: bytes) -> None:
        self.socket.sendall(data)

    def answer(
        self, request: Message, kind: Kind = Kind.ACK, body: bytes = b"", sequence: Optional[int] = None
    ) -> None:
        h = request.header
        self.say(h.interface, h.index, kind, h.subtype, body, h.sequence if sequence is None else sequence)

    def data(self, message: MessageType, value: Struct, index: int = 0, timestamp: float = 1.0) -> None:
        self.say(message.interface, index, message.kind, message.subtype, value.encode(), timestamp=timestamp)

    def synch(self, lost: Optional[int] = None) -> None:
        body = b"" if lost is None else struct.pack(">I", lost)
        self.say(1, 0, Kind.SYNCH, 1 if lost is None else 2, body)

    def say(
        self,
        interface: int,
        index: int,
        kind: int,
        subtype: int,
        body: bytes,
        sequence: int = 0,
        timestamp: float = 1.0,
    ) -> None:
        self.send(Header(interface, index, kind, subtype, timestamp, sequence, len(body)).encode() + body)

    def finish(self) -> None:
        """Ends the server's side, and waits for the client to end its own. Closing at once answers what the client still
        sends with a reset, which may arrive before the client has read the end."""
        self.socket.shutdown(socket.SHUT_WR)
        while self.socket.recv(4096):
            pass

    def serve(self, rounds: Callable[["Peer", Message], None]) -> None:
        """Acknowledges what every client asks (modes, opening, closing) and leaves the rest to `rounds`."""
        while True:
            message = self.receive()
            if message is None:
                return
            if message.header.interface == 1 and message.header.subtype in (3, 5):
                self.answer(message, body=message.body if message.header.subtype == 3 else b"")
            else:
                rounds(self, message)

    def _exactly(self, size: int) -> Optional[bytes]:
        data = b""
        while len(data) < size:
            chunk = self.socket.recv(size - len(data))
            if not chunk:
                return None
            data += chunk
        return data


class FakeServer:
    """Serves one client on a free port in a thread of its own; a `with` block waits for the script to end."""

    def __init__(self, script: Callable[[Peer], None], banner: bytes = BANNER) -> None:
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = self._listener.getsockname()[1]
        self.address = f"127.0.0.1:{self.port}"
        self.peer: Optional[Peer] = None
        self.failure: Optional[BaseException] = None
        self._script = script
        self._banner = banner
        self._thread = threading.Thread(target=self._run, daemon=True)

    def __enter__(self) -> "FakeServer":
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        self._thread.join(10)
        self._listener.close()
        if self.failure and error[0] is None:
            raise self.failure

    def _run(self) -> None:
        self._listener.settimeout(10)
        try:
            connection = self._listener.accept()[0]
        except OSError:
            return  # nobody came
        connection.settimeout(10)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        with connection:
            self.peer = Peer(connection)
            try:
                self.peer.send(self._banner)
                self._script(self.peer)
            except ConnectionError:
                pass  # the client has seen enough
            except Exception as failure:  # shown in the thread of the test
                self.failure = failure
