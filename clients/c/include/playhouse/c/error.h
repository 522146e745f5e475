/** Errors: the one convention of this library.
 *
 * A function that can fail takes a `ph_error *` as its last argument and returns a ph_status, PH_OK (0) if
 * it did its work, or a pointer, NULL if it did not. On failure the error has the same status and a text of
 * one line; on success it is left as it is. NULL is a valid argument: the caller then gets the status only.
 * Values are returned through pointers, which are left as they are on failure. No function ends the program,
 * and none but the callbacks that a program installs calls back into it. */
#ifndef PLAYHOUSE_C_ERROR_H
#define PLAYHOUSE_C_ERROR_H

#ifdef __cplusplus
extern "C" {
#endif

typedef enum ph_status {
  PH_OK = 0,
  /** The server is unreachable, has disconnected, or sent bytes that violate the protocol. */
  PH_CONNECTION_LOST,
  /** The server closed the connection: the run has ended, or the server was killed, which TCP does not tell apart. */
  PH_RUN_ENDED,
  /** No answer, or no data, before the time-out. The connection remains usable. */
  PH_REQUEST_TIMEOUT,
  /** The server answered NACK, or has no device or model of that name. */
  PH_REQUEST_REFUSED,
  /** A value was read before the first data of the device. */
  PH_NO_DATA,
  /** A device was used after it, or its client, was closed. */
  PH_DEVICE_CLOSED,
  /** A device was used that the server has retired: its model was removed. */
  PH_DEVICE_GONE,
  /** An invalid argument, such as a speed that is not a number or an unknown interface. Nothing was sent. */
  PH_INVALID_VALUE,
  /** Bytes that do not decode as the message of their header, or a value outside the range of its field. */
  PH_WIRE_ERROR,
  /** A call in the wrong place: ph_client_read() from a callback that it runs itself. */
  PH_MISUSED,
  /** The system has no memory for the request or for its answer. */
  PH_NO_MEMORY
} ph_status;

enum { PH_ERROR_BYTES = 1024 };

/** What went wrong; needs no release. The text is one line of UTF-8, cut off where it does not fit. */
typedef struct ph_error {
  ph_status status;
  char text[PH_ERROR_BYTES];
} ph_error;

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_ERROR_H */
