/** A robot by its name in the world file, with its devices and those of its descendants; from
 * ph_client_robot() and ph_client_robots(). It belongs to the client. Each proxy has a function for robots,
 * for instance ph_robot_laser(). */
#ifndef PLAYHOUSE_C_ROBOT_H
#define PLAYHOUSE_C_ROBOT_H

#include "playhouse/c/device.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Name and type as in the world file. */
const char *ph_robot_name(const ph_robot *robot);
const char *ph_robot_type(const ph_robot *robot);
/** The model itself and its descendants; valid as long as the client. */
const ph_model *ph_robot_models(const ph_robot *robot, size_t *count);
/** The addresses of all their devices; valid as long as the client. */
const ph_address *ph_robot_devices(const ph_robot *robot, size_t *count);

/** The number of devices of an interface that the robot has on this connection. */
size_t ph_robot_count(const ph_robot *robot, const char *interface_name);
/** The robot's device of an interface at index `nth`, from 0; opened on first use, and again after it was
 * closed. PH_REQUEST_REFUSED if the robot has none, with what it has. */
ph_device *ph_robot_device(ph_robot *robot, const char *interface_name, size_t nth, ph_error *error);
/** Closes devices opened here, in reverse order of opening; a moving base is stopped first. They reopen on
 * use. The first error is returned when all are closed. */
ph_status ph_robot_close(ph_robot *robot, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_ROBOT_H */
