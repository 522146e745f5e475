/** The client inside this library. */
#ifndef PLAYHOUSE_C_SRC_CLIENT_H
#define PLAYHOUSE_C_SRC_CLIENT_H

#include "device.h"
#include "models.h"
#include "robot.h"

struct ph_client {
  ph_session session;
  ph_mode mode;
  bool reading;
  ph_device *
      *open; /**< the first open device of each address, in order of opening; `same` leads to the others */
  size_t open_count, open_capacity;
  size_t cursor;     /**< where the last address was found */
  ph_device *newest; /**< of all devices, closed ones included */
  ph_models models;  /**< as of the last query */
  ph_robot **robots; /**< every one that was given out */
  size_t robot_count, robot_capacity;
  ph_robot **listed; /**< by ph_client_robots() */
  size_t listed_capacity;
  ph_arena entries_arena; /**< of ph_client_devices() */
};

/** Adds an open device to the client's lists. */
bool ph_client_add(ph_client *client, ph_device *device);
/** Removes a closed device from the list of open ones. */
void ph_client_forget(ph_client *client, ph_device *device);
/** In push mode, delivers data that have arrived to the devices, without waiting for more. */
ph_status ph_client_deliver_pushed(ph_client *client, ph_error *error);
/** Drops all data received so far: the run that they are of is over. */
void ph_client_forget_run(ph_client *client);

#endif /* PLAYHOUSE_C_SRC_CLIENT_H */
