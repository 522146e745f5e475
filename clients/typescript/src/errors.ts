/** Base of every error of this package. */
export class PlayerError extends Error {
  override get name(): string {
    return this.constructor.name;
  }
}

/** The server is unreachable, has disconnected, or sent bytes that violate the protocol. */
export class ConnectionLost extends PlayerError {}

/** The server closed the connection in order, after sending all data: the run has ended. */
export class RunEnded extends ConnectionLost {}

/** No answer, or no data, before the time-out. The connection remains usable. */
export class RequestTimeout extends PlayerError {}

/** The server answered NACK, or has no device or model of that name. */
export class RequestRefused extends PlayerError {
  /** `body` is the undecoded body of a NACK. */
  constructor(text: string, readonly body: Uint8Array = new Uint8Array()) {
    super(text);
  }
}

/** A value was read before the first data of the device; Device.nextData() waits for them. */
export class NoData extends PlayerError {}

/** A device was used after close() of the device or of its client. */
export class DeviceClosed extends PlayerError {}

/** A device was used that the server has retired: its model was removed. */
export class DeviceGone extends PlayerError {}

/** An invalid argument, such as a speed that is not a number or an unknown interface. Nothing was sent. */
export class InvalidValue extends PlayerError {}

/** Bytes that do not decode as the message of their header, or a value outside the range of its field. */
export class WireError extends PlayerError {}
