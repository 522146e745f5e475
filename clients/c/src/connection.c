#define _POSIX_C_SOURCE 200809L

#include "connection.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#include "fail.h"
#include "memory.h"
#include "text.h"

enum { CHUNK = 65536, DATAGRAM_BYTES = 65507, REASON_BYTES = 128, SEQUENCE_AT = 32 /**< in a header */ };

/** s; a session by UDP is begun again without a banner for so long. */
static const double kHelloSeconds = 1.0;

double ph_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

ph_status ph_check_seconds(double timeout, ph_error *error) {
  if (timeout >= 0.0) return PH_OK;  // nan is not
  char text[PH_NUMBER_BYTES];
  return ph_fail(error, PH_INVALID_VALUE, "invalid time-out of %s s: 0 or more is valid",
                 ph_number_text(timeout, text));
}

/** Whether the socket is ready before the deadline; one in the past still looks once. */
static bool wait_for(int fd, short events, double deadline) {
  for (;;) {
    const double left = ceil(1e3 * (deadline - ph_now()));
    const int patience = left <= 0.0 ? 0 : left < INT_MAX ? (int)left : INT_MAX;
    struct pollfd entry = {fd, events, 0};
    const int ready = poll(&entry, 1, patience);
    if (ready > 0 || (ready < 0 && errno != EINTR))
      return true;  // the next call on the socket tells the error
    if (ready == 0 && patience < INT_MAX) return false;
  }
}

static ph_status lost(const ph_connection *connection, ph_error *error) {
  return ph_fail(error, connection->ended ? PH_RUN_ENDED : PH_CONNECTION_LOST, "%s: %s", connection->peer,
                 connection->fault);
}

static void set_fault(ph_connection *connection, const char *fault, const char *reason) {
  if (connection->fault[0] == '\0')
    snprintf(connection->fault, sizeof connection->fault, "%s%s", fault, reason);
}

/** Closes the connection and fails with the first reason that was found. */
static ph_status drop(ph_connection *connection, const char *fault, const char *reason, ph_error *error) {
  set_fault(connection, fault, reason);
  if (connection->fd >= 0) close(connection->fd);
  connection->fd = -1;
  return lost(connection, error);
}

static const char *system_text(int code, char text[REASON_BYTES]) {
  if (strerror_r(code, text, REASON_BYTES) != 0) snprintf(text, REASON_BYTES, "error %d", code);
  return text;
}

// --- connecting

/** 0, or the reason as in errno. */
static int connect_within(int fd, const struct addrinfo *address, double deadline) {
  if (connect(fd, address->ai_addr, address->ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS && errno != EINTR) return errno;
  if (!wait_for(fd, POLLOUT, deadline)) return ETIMEDOUT;
  int fault = 0;
  socklen_t size = sizeof fault;
  return getsockopt(fd, SOL_SOCKET, SO_ERROR, &fault, &size) == 0 ? fault : errno;
}

/** A connected socket that does not block, or -1 with the reason in `fault`. */
static int connect_to(const struct addrinfo *address, double deadline, int *fault) {
  const int fd = socket(address->ai_family, address->ai_socktype, address->ai_protocol);
  *fault = fd < 0 ? errno : 0;
  if (fd < 0) return -1;
  const int on = 1;
  if (fcntl(fd, F_SETFL, O_NONBLOCK) < 0 || fcntl(fd, F_SETFD, FD_CLOEXEC) < 0) *fault = errno;
  if (*fault == 0) *fault = connect_within(fd, address, deadline);
  if (*fault == 0) setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  if (*fault == 0) return fd;
  close(fd);
  return -1;
}

/** Connecting a Unix socket does not wait. */
static ph_status connect_unix(ph_connection *connection, const char *folder, ph_error *error) {
  struct sockaddr_un address = {.sun_family = AF_UNIX};
  const int length =
      snprintf(address.sun_path, sizeof address.sun_path, "%s/%u", folder, (unsigned)connection->port);
  if (length < 0 || (size_t)length >= sizeof address.sun_path)
    return drop(connection, "cannot connect: ", "the path is too long", error);
  char text[REASON_BYTES];
  connection->fd = socket(AF_UNIX, SOCK_STREAM, 0);
  if (connection->fd < 0 || fcntl(connection->fd, F_SETFL, O_NONBLOCK) < 0 ||
      fcntl(connection->fd, F_SETFD, FD_CLOEXEC) < 0 ||
      connect(connection->fd, (const struct sockaddr *)&address, sizeof address) < 0)
    return drop(connection, "cannot connect: ", system_text(errno, text), error);
  return PH_OK;
}

/** By UDP: an empty datagram, again until something is there to be received. If nobody has the port, the
 * socket is closed, with the reason in `fault`. */
static void begin_session(ph_connection *connection, double deadline, int *fault) {
  uint8_t first;
  do {
    const double patience = ph_now() + kHelloSeconds;
    if (send(connection->fd, "", 0, MSG_NOSIGNAL) < 0) break;
    wait_for(connection->fd, POLLIN, patience < deadline ? patience : deadline);
    if (recv(connection->fd, &first, sizeof first, MSG_PEEK) >= 0) return;
  } while ((errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) && ph_now() < deadline);
  if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) return;  // no banner in time
  *fault = errno;
  close(connection->fd);
  connection->fd = -1;
}

static ph_status connect_socket(ph_connection *connection, const char *host, double deadline,
                                ph_error *error) {
  if (host[0] == '/') return connect_unix(connection, host, error);
  struct addrinfo hints = {0}, *found = NULL;
  connection->datagrams = strncmp(host, PH_UDP, strlen(PH_UDP)) == 0;
  if (connection->datagrams) host += strlen(PH_UDP);
  hints.ai_socktype = connection->datagrams ? SOCK_DGRAM : SOCK_STREAM;
  char service[8], text[REASON_BYTES];
  snprintf(service, sizeof service, "%u", (unsigned)connection->port);
  const int unresolved = getaddrinfo(host, service, &hints, &found);
  if (unresolved != 0) return drop(connection, "cannot connect: ", gai_strerror(unresolved), error);
  int fault = EADDRNOTAVAIL;
  for (const struct addrinfo *each = found; each != NULL && connection->fd < 0; each = each->ai_next) {
    connection->fd = connect_to(each, deadline, &fault);
    if (connection->fd >= 0 && connection->datagrams) begin_session(connection, deadline, &fault);
  }
  freeaddrinfo(found);
  if (connection->fd >= 0) return PH_OK;
  return drop(connection, "cannot connect: ", system_text(fault, text), error);
}

static ph_status need(ph_connection *connection, size_t count, double deadline, ph_error *error);

/** A banner as it is told in an error: what cannot be printed as dots. */
static ph_status refuse_banner(ph_connection *connection, ph_error *error) {
  char shown[PH_BANNER_BYTES + 3] = "'";
  size_t length = 1;
  for (const char *from = connection->banner; *from != '\0'; ++from) {
    shown[length++] = *from >= ' ' && *from <= '~' ? *from : '.';
  }
  snprintf(shown + length, sizeof shown - length, "'");
  char fault[PH_FAULT_BYTES];
  snprintf(fault, sizeof fault, "not a Player server (it says %s)", shown);
  return drop(connection, fault, "", error);
}

static ph_status read_banner(ph_connection *connection, double deadline, ph_error *error) {
  const ph_status status = need(connection, PH_BANNER_BYTES, deadline, error);
  if (status == PH_REQUEST_TIMEOUT) return drop(connection, "cannot connect: ", "no banner in time", error);
  if (status != PH_OK) return status;
  memcpy(connection->banner, connection->in.bytes + connection->start, PH_BANNER_BYTES);
  connection->start += PH_BANNER_BYTES;
  return strncmp(connection->banner, "Player v.", 9) == 0 ? PH_OK : refuse_banner(connection, error);
}

ph_status ph_connection_open(ph_connection *connection, const char *host, uint16_t port, double timeout,
                             ph_error *error) {
  *connection = (ph_connection){.port = port, .timeout = timeout, .fd = -1};
  const size_t size = strlen(host) + sizeof ":65535";
  connection->peer = malloc(size);
  if (connection->peer == NULL) return ph_fail_no_memory(error);
  snprintf(connection->peer, size, "%s:%u", host, (unsigned)port);
  PH_TRY(ph_check_seconds(timeout, error));
  const double deadline = ph_now() + timeout;
  PH_TRY(connect_socket(connection, host, deadline, error));
  return read_banner(connection, deadline, error);
}

// --- sending and receiving

bool ph_connection_alive(const ph_connection *connection) {
  return connection->fd >= 0 && connection->fault[0] == '\0';
}

/** By UDP a server drops a command that a newer one has overtaken. */
static void number_command(ph_connection *connection, uint8_t *header) {
  if (ph_header_decode(header).kind != PH_KIND_CMD) return;
  if (++connection->last_command == 0) connection->last_command = 1;
  for (int i = 0; i < 4; ++i) header[SEQUENCE_AT + i] = (uint8_t)(connection->last_command >> (24 - 8 * i));
}

ph_status ph_connection_send(ph_connection *connection, uint8_t *bytes, size_t size, ph_error *error) {
  if (!ph_connection_alive(connection)) return lost(connection, error);
  if (connection->datagrams && size > DATAGRAM_BYTES) {
    return ph_fail(error, PH_WIRE_ERROR, "a message of %zu bytes is over the %d of a datagram; TCP carries it",
                   size, DATAGRAM_BYTES);
  }
  if (connection->datagrams) number_command(connection, bytes);
  const double deadline = ph_now() + connection->timeout;
  while (size > 0) {
    const ssize_t sent = send(connection->fd, bytes, size, MSG_NOSIGNAL);
    if (sent >= 0) {
      bytes += sent;
      size -= (size_t)sent;
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (wait_for(connection->fd, POLLOUT, deadline)) continue;
      set_fault(connection, "the server is gone: ", "timed out");
      return lost(connection, error);
    } else if (errno != EINTR) {  // a partially sent message cannot be continued
      char text[REASON_BYTES];
      set_fault(connection, "the server is gone: ", system_text(errno, text));
      return lost(connection, error);
    }
  }
  return PH_OK;
}

/** Makes room for more bytes; moves those that wait to the front, once in a chunk. */
static bool make_room(ph_connection *connection) {
  ph_buffer *in = &connection->in;
  if (connection->start > 0) {
    memmove(in->bytes, in->bytes + connection->start, in->size - connection->start);
    in->size -= connection->start;
    connection->start = 0;
  }
  return ph_buffer_reserve(in, CHUNK);
}

/** By UDP: the banner a second time, as the first one was late; or, once something else was heard, because the
 * server knows nothing of this session. */
static bool is_banner_again(ph_connection *connection, size_t size) {
  if (!connection->datagrams || connection->banner[0] == '\0') return false;
  if (size >= PH_HEADER_BYTES) connection->has_heard = true;
  return size == PH_BANNER_BYTES;
}

/** Receives until `count` bytes are there. */
static ph_status need(ph_connection *connection, size_t count, double deadline, ph_error *error) {
  ph_buffer *in = &connection->in;
  while (in->size - connection->start < count) {
    if (connection->fd < 0) return lost(connection, error);
    if (!make_room(connection)) return ph_fail_no_memory(error);
    const ssize_t got = recv(connection->fd, in->bytes + in->size, in->capacity - in->size, 0);
    if (got > 0 && is_banner_again(connection, (size_t)got)) {
      if (!connection->has_heard) continue;
      return drop(connection, "the server has begun another session: ",
                  "it was started again, or heard nothing for too long", error);
    }
    if (got > 0) {
      in->size += (size_t)got;
    } else if (got == 0) {
      connection->ended = connection->fault[0] == '\0';
      return drop(connection, "the run ended: the server closed the connection", "", error);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      // After an error of sending no new data are expected.
      if (connection->fault[0] != '\0') return drop(connection, "", "", error);
      if (wait_for(connection->fd, POLLIN, deadline)) continue;
      return ph_fail(error, PH_REQUEST_TIMEOUT, "%s: no message in time", connection->peer);
    } else if (errno != EINTR) {
      char text[REASON_BYTES];
      return drop(connection, "the server is gone: ", system_text(errno, text), error);
    }
  }
  return PH_OK;
}

static ph_status receive_any(ph_connection *connection, double deadline, ph_header *header,
                             const uint8_t **body, ph_error *error) {
  PH_TRY(need(connection, PH_HEADER_BYTES, deadline, error));
  *header = ph_header_decode(connection->in.bytes + connection->start);
  if (header->size > PH_MAX_BODY_BYTES) {
    char fault[PH_FAULT_BYTES];
    snprintf(fault, sizeof fault, "a header announces %lu bytes, over the limit",
             (unsigned long)header->size);
    return drop(connection, fault, "", error);
  }
  const size_t end = (size_t)PH_HEADER_BYTES + header->size;
  PH_TRY(need(connection, end, deadline, error));
  *body = connection->in.bytes + connection->start + PH_HEADER_BYTES;
  connection->start += end;
  return PH_OK;
}

/** False: a newer data message has overtaken it. Those between the newest and this one count as lost. */
static bool is_next(ph_connection *connection, uint32_t number) {
  const uint32_t ahead = number - connection->newest_data;
  if (ahead == 0 || ahead >= UINT32_C(1) << 31) return false;
  connection->lost_count += ahead - 1;
  connection->newest_data = number;
  return true;
}

ph_status ph_connection_receive(ph_connection *connection, double deadline, ph_header *header,
                                const uint8_t **body, ph_error *error) {
  for (;;) {
    PH_TRY(receive_any(connection, deadline, header, body, error));
    if (!connection->datagrams || header->kind != PH_KIND_DATA || is_next(connection, header->sequence))
      return PH_OK;
  }
}

bool ph_connection_buffered(const ph_connection *connection) {
  const size_t here = connection->in.size - connection->start;
  if (here < PH_HEADER_BYTES) return false;
  const uint32_t size = ph_header_decode(connection->in.bytes + connection->start).size;
  return size > PH_MAX_BODY_BYTES || here - PH_HEADER_BYTES >= size;
}

void ph_connection_close(ph_connection *connection, double timeout) {
  if (connection->fd < 0) return;
  const double deadline = ph_now() + timeout;
  uint8_t rest[4096];
  if (!connection->datagrams && shutdown(connection->fd, SHUT_WR) == 0) {
    while (ph_now() < deadline && wait_for(connection->fd, POLLIN, deadline)) {
      const ssize_t got = recv(connection->fd, rest, sizeof rest, 0);
      if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) break;
    }
  }
  drop(connection, "the connection is closed", "", NULL);
}

void ph_connection_free(ph_connection *connection) {
  drop(connection, "the connection is closed", "", NULL);
  ph_buffer_free(&connection->in);
  free(connection->peer);
  connection->peer = NULL;
}
