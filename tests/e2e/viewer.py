"""A viewer, as a page is one: a WebSocket that takes in the scene, who comes and goes, and acknowledges packets. It does not
decode packets; web/src and playhouse/replicate have tests for that. Standard library only."""

from __future__ import annotations

import base64
import json
import os
import socket
import struct

from house import PATIENCE

TEXT, BINARY, CLOSE = 1, 2, 8


class Viewer:
    def __init__(self, port: int, token: str = "", source: str = "127.0.0.1", more: str = ""):
        """`more`: lines of the request."""
        self.socket = socket.create_connection(("127.0.0.1", port), PATIENCE, (source, 0))
        self.socket.settimeout(PATIENCE)
        self.buffer = b""
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET /live{token and '?token=' + token} HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                             f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n{more}\r\n").encode())
        while b"\r\n\r\n" not in self.buffer:
            self.buffer += self.socket.recv(65536)
        head, self.buffer = self.buffer.split(b"\r\n\r\n", 1)
        assert head.startswith(b"HTTP/1.1 101"), head
        self.notices: list[str] = []
        self.people: list[dict] = []    # of the last list of them
        code, payload = self._receive()
        if code == CLOSE:
            self.close()
            raise ConnectionError(payload[2:].decode())
        self.scene = json.loads(payload)
        self.models = {model["id"]: model for model in self.scene["models"]}
        self.came: list[int] = []   # tops, in the order in which they came

    def tops(self) -> list[int]:
        return [id for id, model in self.models.items() if "parent" not in model]

    def send(self, **command):
        data = json.dumps(command).encode()
        length = bytes([0x80 | len(data)]) if len(data) < 126 else bytes([0x80 | 126]) + struct.pack(">H", len(data))
        self.socket.sendall(bytes([0x80 | TEXT]) + length + b"\0\0\0\0" + data)

    def turn(self):
        """Takes in what comes up to the next packet, and acknowledges that."""
        while True:
            code, payload = self._receive()
            if code == CLOSE:
                raise ConnectionError(payload)
            if code == BINARY:
                return self.send(do="ack", frame=_varint(payload[2:]))
            message = json.loads(payload)
            self.people = message.get("people", self.people)
            if "notice" in message:
                self.notices.append(message["notice"])
                continue
            if "gone" not in message:
                continue
            for id in message["gone"]:
                del self.models[id]
            for model in message["models"]:
                assert model["id"] not in self.models, model
                self.models[model["id"]] = model
                if "parent" not in model:
                    self.came.append(model["id"])

    def turn_until(self, done):
        while not done():
            self.turn()

    def close(self):
        self.socket.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _take(self, size: int) -> bytes:
        while len(self.buffer) < size:
            more = self.socket.recv(65536)
            if not more:
                raise ConnectionError("the program closed the connection")
            self.buffer += more
        taken, self.buffer = self.buffer[:size], self.buffer[size:]
        return taken

    def _receive(self) -> tuple[int, bytes]:
        first, length = self._take(2)
        if length == 126:
            length = struct.unpack(">H", self._take(2))[0]
        elif length == 127:
            length = struct.unpack(">Q", self._take(8))[0]
        return first & 15, self._take(length)


def _varint(data: bytes) -> int:
    value = shift = 0
    for byte in data:
        value |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            break
    return value
