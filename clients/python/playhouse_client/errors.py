"""Errors of this package, all derived from PlayerError."""


class PlayerError(Exception):
    """Base of every error this package raises."""


class ConnectionLost(PlayerError):
    """The server is unreachable, has disconnected, or sent bytes that violate the protocol."""


class RunEnded(ConnectionLost):
    """The server closed the connection in order, after sending all data: the run has ended."""


class RequestTimeout(PlayerError):
    """No answer, or no data, before the timeout. The connection remains usable."""


class RequestRefused(PlayerError):
    """The server answered NACK, or has no device or model of that name. `body` is the undecoded body of a NACK."""

    def __init__(self, text: str, body: bytes = b"") -> None:
        super().__init__(text)
        self.body = body


class GoalRefused(RequestRefused):
    """A driver does not drive to a goal; the text ends with its reason."""


class NoData(PlayerError):
    """A value was read before the first data of the device; Device.next_data() waits for them."""


class DeviceClosed(PlayerError):
    """A device was used after close() of the device or of its client."""


class DeviceGone(PlayerError):
    """A device was used that the server has retired: its model was removed."""


class InvalidValue(PlayerError, ValueError):
    """An invalid argument, such as a speed that is not a number or an unknown interface. Nothing was sent."""


class WireError(PlayerError):
    """Bytes that do not decode as the message of their header, or a value outside the range of its field."""
