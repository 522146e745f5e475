/** One connection to a Player server, by TCP, a Unix socket or UDP: banner, framing, deadlines. It interprets
 * headers only.
 *
 * Deadlines are times of ph_now(). A time-out keeps partially read bytes, so reading can continue. If the
 * server disconnects, messages it had sent can still be received; then every call fails with the reason. */
#ifndef PLAYHOUSE_C_CONNECTION_H
#define PLAYHOUSE_C_CONNECTION_H

#include <stdbool.h>

#include "playhouse/c/wire.h"

enum { PH_BANNER_BYTES = 32, PH_FAULT_BYTES = 256 };

typedef struct ph_connection {
  char *peer; /**< HOST:PORT */
  uint16_t port;
  double timeout;        /**< s, of connecting and sending */
  int fd;                /**< -1: closed */
  bool datagrams;        /**< UDP: data are numbered, and those overtaken by newer ones are dropped */
  uint64_t lost_count;   /**< of data messages on their way, by UDP */
  uint32_t newest_data;  /**< its number; 0: none yet */
  uint32_t last_command; /**< its number, by UDP */
  bool has_heard;        /**< a message, by UDP */
  ph_buffer in;
  size_t start;               /**< of what is not yet received, in `in` */
  bool ended;                 /**< by the server, in order */
  char fault[PH_FAULT_BYTES]; /**< why nothing can be sent; "": it can */
  char banner[PH_BANNER_BYTES + 1];
} ph_connection;

/** Seconds of a clock that is never set. */
double ph_now(void);
/** Checks a time-out: 0 or more, infinity included. */
ph_status ph_check_seconds(double timeout, ph_error *error);

/** What a host begins with that is reached by datagrams. */
#define PH_UDP "udp:"

/** `host` is a name, a numeric address, "/FOLDER" for the Unix socket FOLDER/port, or "udp:HOST".
 * `connection` is to be closed by ph_connection_free() even if this fails. */
ph_status ph_connection_open(ph_connection *connection, const char *host, uint16_t port, double timeout,
                             ph_error *error);
bool ph_connection_alive(const ph_connection *connection);
/** Sends a complete message; one over UDP may be lost. Numbers commands of UDP, in `bytes`. */
ph_status ph_connection_send(ph_connection *connection, uint8_t *bytes, size_t size, ph_error *error);
/** The next message. The body is valid until the next call. */
ph_status ph_connection_receive(ph_connection *connection, double deadline, ph_header *header,
                                const uint8_t **body, ph_error *error);
/** Whether a complete message is here, so that receiving does not wait. */
bool ph_connection_buffered(const ph_connection *connection);
/** Shuts down sending and waits up to `timeout` seconds until the server has read everything: closing with
 * unread data makes TCP discard data in transit, such as a last stop command. */
void ph_connection_close(ph_connection *connection, double timeout);
void ph_connection_free(ph_connection *connection);

#endif /* PLAYHOUSE_C_CONNECTION_H */
