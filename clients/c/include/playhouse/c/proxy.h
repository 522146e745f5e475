/** What every proxy has. A proxy is a device of one interface with functions in SI units and radians: x
 * forward, y left, z up, angles counter-clockwise.
 *
 * Reading a device's data never waits: it gives the data of the last ph_client_read(), and is PH_NO_DATA
 * before the first data of the device. Lists of a value belong to the device until its next data, the next
 * call of the same function, or its release. */
#ifndef PLAYHOUSE_C_PROXY_H
#define PLAYHOUSE_C_PROXY_H

#include "playhouse/c/robot.h"
#include "playhouse/c/values.h"

/** Declares for a proxy, here for PH_PROXY(laser):
 *
 * - ph_laser, the type; it belongs to the client
 * - ph_laser_open(): opens laser:INDEX
 * - ph_robot_laser(): the robot's laser at index `nth`, as ph_robot_device()
 * - ph_laser_device(): the laser as a device of any interface
 * - ph_laser_of(): the device as a laser; PH_INVALID_VALUE if it is of another interface
 * - ph_laser_next_data(): ph_device_next_data()
 * - ph_laser_close(), ph_laser_free(): ph_device_close(), ph_device_free() */
#define PH_PROXY(NAME)                                                                          \
  typedef struct ph_##NAME ph_##NAME;                                                           \
  ph_##NAME *ph_##NAME##_open(ph_client *client, int index, ph_access access, ph_error *error); \
  ph_##NAME *ph_robot_##NAME(ph_robot *robot, size_t nth, ph_error *error);                     \
  ph_device *ph_##NAME##_device(ph_##NAME *proxy);                                              \
  ph_##NAME *ph_##NAME##_of(ph_device *device, ph_error *error);                                \
  ph_status ph_##NAME##_next_data(ph_##NAME *proxy, double timeout, ph_error *error);           \
  ph_status ph_##NAME##_close(ph_##NAME *proxy, ph_error *error);                               \
  void ph_##NAME##_free(ph_##NAME *proxy);

#endif /* PLAYHOUSE_C_PROXY_H */
