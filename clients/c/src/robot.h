/** Robots inside this library. */
#ifndef PLAYHOUSE_C_SRC_ROBOT_H
#define PLAYHOUSE_C_SRC_ROBOT_H

#include "models.h"
#include "playhouse/c/robot.h"

/** The robot of a model in the list, with copies of what it needs; NULL without memory. `port` is that of the
 * connected server, as reported by the server. */
ph_robot *ph_robot_new(ph_client *client, const ph_models *models, size_t top, uint32_t port);
void ph_robot_free(ph_robot *robot);
/** Whether the robot has the name and the devices of a model in the list. */
bool ph_robot_is(const ph_robot *robot, const ph_models *models, size_t top);
/** Called before a device is released. */
void ph_robot_forget(ph_robot *robot, const ph_device *device);

#endif /* PLAYHOUSE_C_SRC_ROBOT_H */
