/** One session with a server: matches answers to requests, queues data, and tracks rounds of data. */
#ifndef PLAYHOUSE_C_SESSION_H
#define PLAYHOUSE_C_SESSION_H

#include "connection.h"
#include "playhouse/c/generated/common.h"

/** A received message that waits for ph_client_read(). */
typedef struct ph_message {
  struct ph_message *next;
  ph_header header;
  uint8_t body[];
} ph_message;

/** What an answer is matched by. */
typedef struct ph_key {
  uint16_t code, index;
  uint8_t subtype;
} ph_key;

/** An answer; its body is valid until the next call on the session. */
typedef struct ph_answer {
  ph_header header;
  const uint8_t *body;
} ph_answer;

typedef struct ph_session {
  ph_connection connection;
  double timeout; /**< s */
  ph_message *oldest, *newest;
  size_t waiting_count;
  bool round_open, round_refused;
  bool round_waits; /**< it ended during a request: its data are queued */
  bool told;        /**< a device was retired */
  void (*retire)(void *context, const ph_common_devaddr *address);
  void *context;
  uint64_t overflow_count;
  uint64_t unread_count; /**< those of them lost here */
  uint64_t skipped_count;
  uint32_t server_port; /**< as the server reports it; 0 before */
  ph_key *abandoned;    /**< requests that timed out and may still be answered */
  size_t abandoned_count, abandoned_capacity;
  uint32_t sequence;
  ph_buffer out;
  ph_buffer refusal; /**< the body of the last NACK */
} ph_session;

/** `retire` is called with the address of a device that the server has retired. End with ph_session_free()
 * even if this fails. */
ph_status ph_session_open(ph_session *session, const char *host, uint16_t port, double timeout,
                          ph_error *error);
void ph_session_free(ph_session *session);

/** The time-out of a caller, or the session's own for PH_OWN_TIMEOUT. */
ph_status ph_session_seconds(const ph_session *session, double timeout, double *seconds, ph_error *error);
/** HOST:PORT of the server. */
const char *ph_session_peer(const ph_session *session);
/** The server's port as reported in its answers; the connected port may be that of a forwarder. */
uint32_t ph_session_server_port(const ph_session *session);

/** Sends a message; `payload` is of the type of message->payload, NULL for none. */
ph_status ph_session_send(ph_session *session, uint16_t code, uint16_t index, const ph_message_type *message,
                          const void *payload, ph_error *error);
/** Sends and waits for the ACK, at most `seconds`. `answer` may be NULL. */
ph_status ph_session_request(ph_session *session, uint16_t code, uint16_t index,
                             const ph_message_type *message, const void *payload, double seconds,
                             ph_answer *answer, ph_error *error);

/** Requests a round of data, unless one is open or has ended with its data queued; it ends with the SYNCH
 * that clears round_open, or is refused. */
ph_status ph_session_begin_round(ph_session *session, ph_error *error);
/** Receives one message outside a request and dispatches it. */
ph_status ph_session_sort_next(ph_session *session, double deadline, ph_error *error);
/** The oldest queued message, which the caller frees; NULL if none waits. */
ph_message *ph_session_next_waiting(ph_session *session);
/** Drops queued data of a retired device, so that they are not delivered to a new device at its address. */
void ph_session_drop_waiting(ph_session *session, uint16_t code, uint16_t index);
/** Drops all queued data. */
void ph_session_drop_all_waiting(ph_session *session);

#endif /* PLAYHOUSE_C_SESSION_H */
