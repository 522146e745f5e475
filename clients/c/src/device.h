/** Devices inside this library. */
#ifndef PLAYHOUSE_C_SRC_DEVICE_H
#define PLAYHOUSE_C_SRC_DEVICE_H

#include "memory.h"
#include "playhouse/c/device.h"
#include "session.h"
#include "text.h"

/** What a proxy adds to a device. A proxy's type has a ph_device as its first member; it begins as zeros.
 * Every function may be NULL. */
typedef struct ph_class {
  const char *interface_name;
  size_t size; /**< of the proxy's type */
  /** Requests constant data; called after opening. A refusal is no error. */
  ph_status (*prepare)(ph_device *device, ph_error *error);
  /** Takes note of data from ph_client_read(), before the callback. */
  void (*take)(ph_device *device, const ph_value *value);
  /** Drops what the proxy keeps of data: the run that they are of is over. */
  void (*forget)(ph_device *device);
  /** Called before closing, while the server can be reached. */
  void (*before_close)(ph_device *device);
  /** Releases what the proxy has. */
  void (*release)(ph_device *device);
} ph_class;

enum { PH_GONE_BYTES = 128 };

struct ph_device {
  const ph_class *class_of;
  ph_client *client;
  ph_device *newer; /**< of all devices of the client */
  ph_device *same;  /**< the next open one at this address */
  uint16_t code, index;
  ph_access access;
  char name[PH_NAME_BYTES];
  char *driver;
  double timestamp;
  bool fresh, open, to_free;
  char gone[PH_GONE_BYTES]; /**< why requests are refused; "": they are not */
  ph_value **latest;        /**< the newest of each subtype that came */
  size_t latest_count, latest_capacity;
  ph_on_data callback;
  void *context;
  ph_value *text_answer; /**< of ph_device_get_string() */
};

/** Opens a device, as the proxy of its interface if there is one. */
ph_device *ph_device_new(ph_client *client, const char *interface_name, int index, ph_access access,
                         ph_error *error);
/** Releases the memory of a closed device that no list has any more. */
void ph_device_release(ph_device *device);
/** Receives data from ph_client_read(). */
ph_status ph_device_take(ph_device *device, const ph_value *value, ph_error *error);
/** Whether data are earlier than the last of their kind: the simulated time went back. */
bool ph_device_goes_back(const ph_device *device, const ph_value *value);
/** Drops all data, as before the first: the run that they are of is over. */
void ph_device_forget_data(ph_device *device);
/** Marks the device as retired by the server, whose own port number is `port`. */
void ph_device_retire(ph_device *device, uint32_t port);

ph_session *ph_device_session(const ph_device *device);
ph_status ph_device_insist_on_open(const ph_device *device, ph_error *error);

/** A number with the name that errors give it. */
typedef struct ph_named {
  const char *name;
  double value;
} ph_named;

/** PH_INVALID_VALUE if one of the numbers is not finite. */
ph_status ph_insist_on_finite(const ph_device *device, const ph_named *values, size_t count, ph_error *error);
/** The same of `...`: {"vx", vx}, {"va", va}. */
#define PH_INSIST_ON_FINITE(DEVICE, ERROR, ...)                       \
  PH_TRY(ph_insist_on_finite(DEVICE, (const ph_named[]){__VA_ARGS__}, \
                             sizeof((const ph_named[]){__VA_ARGS__}) / sizeof(ph_named), ERROR))
/** Rounds to the wire's precision. PH_WIRE_ERROR if the number is too large for it. */
ph_status ph_to_float(const ph_device *device, double value, float *rounded, ph_error *error);

/** The newest data of a message; PH_NO_DATA before the first. */
ph_status ph_device_stamped(const ph_device *device, const ph_message_type *message, const ph_value **value,
                            ph_error *error);
/** ph_device_request() with the client's own time-out for an answer that must have a body, `*answer`. */
ph_status ph_device_ask(ph_device *device, const ph_message_type *message, const void *payload,
                        ph_value **answer, ph_error *error);
/** The same for one without. */
ph_status ph_device_tell(ph_device *device, const ph_message_type *message, const void *payload,
                         ph_error *error);

#endif /* PLAYHOUSE_C_SRC_DEVICE_H */
