"""What can go wrong between a program and its server; all are PlayerError."""


class PlayerError(Exception):
    """Base of every error this package raises."""


class ConnectionLost(PlayerError):
    """The server could not be reached, is gone, or sent bytes that are not Player's."""


class RunEnded(ConnectionLost):
    """The server closed the connection behind all that it had to say: the run is over."""


class RequestTimeout(PlayerError):
    """No answer, or no data, within the time allowed. The connection is still good."""


class RequestRefused(PlayerError):
    """The server answered NACK, or has no device or model of that name. `body` is what came with a NACK, undecoded."""

    def __init__(self, text: str, body: bytes = b"") -> None:
        super().__init__(text)
        self.body = body


class NoData(PlayerError):
    """A device was asked for a value before its first data; Device.next_data() waits for them."""


class DeviceClosed(PlayerError):
    """A device was used after close(), or after its client's."""


class DeviceGone(PlayerError):
    """A device was used that the server has retired: what it belonged to is no more."""


class InvalidValue(PlayerError, ValueError):
    """An argument that means nothing: a speed that is no number, an interface that does not exist. Nothing was sent."""


class WireError(PlayerError):
    """Bytes that do not decode as the message they claim to be, or a value that does not fit the wire."""
