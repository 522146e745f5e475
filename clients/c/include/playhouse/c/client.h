/** A connection to a Player server, and requests to the server itself.
 *
 * Ownership: a client owns its devices and robots. ph_client_free() closes and releases all of them; a
 * device may be released earlier by ph_device_free(). Whatever a function returns a `const` pointer to
 * belongs to the object that was asked, until the time that the function names.
 *
 * Threads: one per client with its devices and robots; different clients do not share anything. */
#ifndef PLAYHOUSE_C_CLIENT_H
#define PLAYHOUSE_C_CLIENT_H

#include <stdbool.h>

#include "playhouse/c/value.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ph_client ph_client;
typedef struct ph_robot ph_robot;

/** As a time-out: the client's own. Other time-outs are seconds from 0 on, INFINITY included. */
#define PH_OWN_TIMEOUT (-1.0)
#define PH_DEFAULT_HOST "127.0.0.1"
enum { PH_DEFAULT_PORT = 6665 };

/** Delivery of data: immediately (push), or in rounds requested by the client (pull). */
typedef enum ph_mode { PH_MODE_PUSH = 1, PH_MODE_PULL = 2 } ph_mode;

/** Handling of a message for this client while an older one of the same type is queued. */
typedef enum ph_rule { PH_RULE_ACCEPT = 0, PH_RULE_REPLACE = 1, PH_RULE_IGNORE = 2 } ph_rule;

/** `timeout` (s) applies to connecting, to every request, and to every read without a time-out of its own.
 * `token` is that of a guest, for a run with --guests; NULL or "": none. */
typedef struct ph_options {
  ph_mode mode;
  double timeout;
  const char *token;
} ph_options;
#define PH_DEFAULT_OPTIONS \
  { PH_MODE_PULL, 5.0, NULL }

/** Which messages a rule is for; -1 matches any. */
typedef struct ph_rule_scope {
  int interface_code, index, kind, subtype;
} ph_rule_scope;
#define PH_EVERY_MESSAGE \
  { -1, -1, -1, -1 }

/** One entry of the server's device list. `interface_name` is a number if it has no known name; `model` is
 * the full name of the model behind the device and `robot` that of its top-level model, both "" if the server
 * does not report them. */
typedef struct ph_device_entry {
  const char *name; /**< INTERFACE:INDEX */
  const char *interface_name;
  int index;
  const char *driver;
  const char *model;
  const char *robot;
} ph_device_entry;

/** Address of a device: port of its server, interface and index, with the full name of its model. */
typedef struct ph_address {
  const char *name; /**< INTERFACE:INDEX */
  uint16_t port;
  const char *interface_name;
  int index;
  const char *model;
} ph_address;

/** One model of the world: full name, type ("position", independent of macros), name of its parent ("" for a
 * top-level model), own devices, and id, which is unique in the run. */
typedef struct ph_model {
  const char *name;
  const char *type;
  const char *parent;
  const ph_address *devices;
  size_t device_count;
  uint64_t id;
} ph_model;

/** Connects to "host", "host:port", ":port" or "[::1]:port"; the defaults, also for NULL, are 127.0.0.1 and
 * 6665. "udp:" in front of any of them is UDP; "/FOLDER" or "/FOLDER:port" is the Unix socket FOLDER/port.
 * `options` NULL: PH_DEFAULT_OPTIONS. End with ph_client_free(). PH_REQUEST_REFUSED: a wrong token. */
ph_client *ph_connect(const char *address, const ph_options *options, ph_error *error);

/** Closes all devices in reverse order of opening, a moving base being stopped first, and waits until the
 * server has read everything, a second at most. Devices and robots remain as closed ones. A second call has
 * no effect. */
void ph_client_close(ph_client *client);
/** Closes and releases the client with its devices and robots; NULL has no effect. Not from a callback. */
void ph_client_free(ph_client *client);

/** The server's greeting, for instance "Player v.3.1". */
const char *ph_client_banner(const ph_client *client);
/** HOST:PORT of the server, as errors name it. */
const char *ph_client_peer(const ph_client *client);
bool ph_client_connected(const ph_client *client);
ph_mode ph_client_mode(const ph_client *client);

/** Data messages dropped because they were not read in time, here or in the server. */
uint64_t ph_client_overflow_count(const ph_client *client);
/** Messages without a recipient, and invalid messages. */
uint64_t ph_client_skipped_count(const ph_client *client);
/** Queries the number of data messages lost on the way to this client, in any mode: the server's count plus
 * those not read here in time, and by UDP those that went astray. PH_REQUEST_REFUSED: the server does not report it. */
ph_status ph_client_lost_count(ph_client *client, uint64_t *count, ph_error *error);

/** The undecoded body of the last NACK; `size` is 0 before. Valid until the next request. */
const void *ph_client_refusal(const ph_client *client, size_t *size);

ph_status ph_client_set_mode(ph_client *client, ph_mode mode, ph_error *error);
/** Sets the server's rule for messages queued for this client. `scope` NULL: every message. */
ph_status ph_client_set_replace_rule(ph_client *client, ph_rule rule, const ph_rule_scope *scope,
                                     ph_error *error);

/** Waits for data and delivers them to the devices; `count`, which may be NULL, gets the number of messages.
 *
 * In pull mode this is one round: everything the server has queued for this client. In push mode it is what
 * has arrived, at least one message, or none if a device was retired before (ph_device_gone()).
 * PH_REQUEST_TIMEOUT: no data; the next read continues to wait. If the server disconnects, data it had sent
 * are delivered first; the next read is PH_CONNECTION_LOST or PH_RUN_ENDED. */
ph_status ph_client_read(ph_client *client, double timeout, size_t *count, ph_error *error);

/** The devices of the server, in its own order, with the driver and the model behind each. Valid until the
 * next call. */
ph_status ph_client_devices(ph_client *client, const ph_device_entry **devices, size_t *count,
                            ph_error *error);

/** All models in the simulated world now, with their devices, parents before children. Valid until the next
 * call of a function that lists devices, models or robots. PH_REQUEST_REFUSED: the server does not report
 * models (not every simulator does, and no real robot). */
ph_status ph_client_models(ph_client *client, const ph_model **models, size_t *count, ph_error *error);

/** The robot, or any other model, of this name, with the devices of all its descendants. It is looked up in
 * the last list of models or robots, and if it is not there, in a new list. The same name gives the same
 * robot while its devices are the same; of several models with one name it is the last. It belongs to the
 * client. PH_REQUEST_REFUSED if there is none, and as ph_client_models(). */
ph_robot *ph_client_robot(ph_client *client, const char *name, ph_error *error);

/** The top-level models with devices on this connection, of their own or of descendants, in the order of the
 * world file. The list is valid until the next call; the robots belong to the client. Errors as
 * ph_client_models(). */
ph_status ph_client_robots(ph_client *client, ph_robot *const **robots, size_t *count, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_CLIENT_H */
