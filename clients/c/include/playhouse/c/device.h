/** An open device of any interface. The proxies of specific interfaces (playhouse/c/position2d.h and so on)
 * are devices as well: ph_position2d_device() gives the device of a ph_position2d. */
#ifndef PLAYHOUSE_C_DEVICE_H
#define PLAYHOUSE_C_DEVICE_H

#include "playhouse/c/client.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ph_device ph_device;

/** Access to a device. The server drops commands over a device opened for reading only. */
typedef enum ph_access { PH_ACCESS_ALL = 1, PH_ACCESS_READ = 'r', PH_ACCESS_WRITE = 'w' } ph_access;

/** Called within ph_client_read() with all data of a device. The value belongs to the device: ph_value_keep()
 * keeps it. A callback may send requests and commands and open, close and free devices, but not read. */
typedef void (*ph_on_data)(void *context, const ph_value *value);

/** Opens a device of any interface, for instance "gripper". It belongs to the client. */
ph_device *ph_device_open(ph_client *client, const char *interface_name, int index, ph_access access,
                          ph_error *error);
/** Closes the device; a base that moves is stopped first. The device remains as a closed one, with its last
 * data. A second call has no effect. */
ph_status ph_device_close(ph_device *device, ph_error *error);
/** Closes and releases the device; NULL has no effect. From a callback, it is released when the read ends. */
void ph_device_free(ph_device *device);

/** INTERFACE:INDEX, for instance "position2d:0". */
const char *ph_device_name(const ph_device *device);
uint16_t ph_device_interface(const ph_device *device);
int ph_device_index(const ph_device *device);
ph_access ph_device_access(const ph_device *device);
/** The name of the driver behind the device. */
const char *ph_device_driver(const ph_device *device);
ph_client *ph_device_client(const ph_device *device);
/** False after closing of the device or of its client. */
bool ph_device_is_open(const ph_device *device);
/** Whether a read has received the notice that the server retired the device. From then on its use is
 * PH_DEVICE_GONE, its last data remain, and closing it sends nothing. Before, the server refuses requests and
 * drops commands. */
bool ph_device_gone(const ph_device *device);

/** The server's time in s at the last data, 0 before the first. */
double ph_device_timestamp(const ph_device *device);
/** Whether any data have arrived since this device was opened. */
bool ph_device_has_data(const ph_device *device);
/** Whether data have arrived since the last ph_device_next_data() or ph_device_take_fresh(). */
bool ph_device_fresh(const ph_device *device);
/** The same, and they are no longer fresh. */
bool ph_device_take_fresh(ph_device *device);
/** Waits for data newer than those of the last call, reading meanwhile. PH_REQUEST_TIMEOUT after `timeout`
 * (s). */
ph_status ph_device_next_data(ph_device *device, double timeout, ph_error *error);

/** The newest value of a data message, NULL before the first. It belongs to the device until its next data, a
 * read of the client, or the release of the device; ph_value_keep() keeps it. */
const ph_value *ph_device_latest(const ph_device *device, const ph_message_type *message);
/** Sets the callback for the data of this device; NULL: none. */
void ph_device_on_data(ph_device *device, ph_on_data callback, void *context);

/** Sends a request and waits for the answer, at most `timeout` (s). `payload` is of the type of
 * message->payload, NULL for none. `answer`, which may be NULL, gets a value for the caller to release by
 * ph_value_free(), or NULL if the answer has no body. PH_REQUEST_REFUSED: NACK; PH_REQUEST_TIMEOUT: none. */
ph_status ph_device_request(ph_device *device, const ph_message_type *message, const void *payload,
                            double timeout, ph_value **answer, ph_error *error);
/** Sends a command; commands have no answer. */
ph_status ph_device_command(ph_device *device, const ph_message_type *message, const void *payload,
                            ph_error *error);

/** A property by its key, as bool, int, double or text. PH_REQUEST_REFUSED if there is none. A text is valid
 * until the next call for this device. */
ph_status ph_device_get_bool(ph_device *device, const char *key, bool *value, ph_error *error);
ph_status ph_device_get_int(ph_device *device, const char *key, int32_t *value, ph_error *error);
ph_status ph_device_get_double(ph_device *device, const char *key, double *value, ph_error *error);
ph_status ph_device_get_string(ph_device *device, const char *key, const char **value, ph_error *error);
/** Why the driver of a position2d or planner does not drive to the goal that it was given last, as its log says;
 * "" if it does, has arrived, has not planned yet, or gives no reasons. Valid as ph_device_get_string()'s. */
ph_status ph_device_why_refused(ph_device *device, const char **why, ph_error *error);
ph_status ph_device_set_bool(ph_device *device, const char *key, bool value, ph_error *error);
ph_status ph_device_set_int(ph_device *device, const char *key, int32_t value, ph_error *error);
ph_status ph_device_set_double(ph_device *device, const char *key, double value, ph_error *error);
ph_status ph_device_set_string(ph_device *device, const char *key, const char *value, ph_error *error);

/** Whether the driver reports that it supports a message. Many drivers never do. */
ph_status ph_device_has_capability(ph_device *device, const ph_message_type *message, bool *has,
                                   ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_DEVICE_H */
