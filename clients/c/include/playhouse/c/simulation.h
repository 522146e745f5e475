#ifndef PLAYHOUSE_C_SIMULATION_H
#define PLAYHOUSE_C_SIMULATION_H

#include "playhouse/c/proxy.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The simulator itself. Poses of models, by name, are relative to the parent, or to the world for a
 * top-level model. PH_REQUEST_REFUSED if there is no model of that name. */
PH_PROXY(simulation)

ph_status ph_simulation_pose(ph_simulation *simulation, const char *name, ph_pose *pose, ph_error *error);
ph_status ph_simulation_set_pose(ph_simulation *simulation, const char *name, ph_pose pose, ph_error *error);
ph_status ph_simulation_pose3d(ph_simulation *simulation, const char *name, ph_pose3d *pose, ph_error *error);
ph_status ph_simulation_set_pose3d(ph_simulation *simulation, const char *name, ph_pose3d pose,
                                   ph_error *error);
/** Pauses or resumes the clock. */
ph_status ph_simulation_pause(ph_simulation *simulation, ph_error *error);
/** Saves the current world to the file of `playhouse run --save-world`; has no effect without it. */
ph_status ph_simulation_save(ph_simulation *simulation, ph_error *error);
/** Moves everything back to its pose in the world file, while time continues. */
ph_status ph_simulation_reset(ph_simulation *simulation, ph_error *error);
/** Restarts the run with a seed: at tick 0, with the initial models and their ids. Devices have no data until
 * new ones arrive; what they gave out of older ones is no longer valid. That requires lock-step, else the
 * server refuses: PH_REQUEST_REFUSED. */
ph_status ph_simulation_restart(ph_simulation *simulation, uint64_t seed, ph_error *error);
/** Joins a lock-step run as a member of this name until the connection is closed: ticks wait for its steps.
 * Open devices first. PH_REQUEST_REFUSED with the reason. */
ph_status ph_simulation_join(ph_simulation *simulation, const char *name, ph_error *error);
/** Runs this number of ticks, 1 to 2^20, and waits until they are done, in lock-step until all members have
 * requested them: at most `timeout` seconds, INFINITY: no limit. In push mode all data of the ticks have then
 * been delivered to the devices; in pull mode they are queued for ph_client_read(). Without lock-step a
 * running world refuses: ph_simulation_pause() first. PH_RUN_ENDED if the run has ended. */
ph_status ph_simulation_step(ph_simulation *simulation, int64_t ticks, double timeout, ph_error *error);
/** Spawns a robot like the model `like` at a pose in the world (m, m, rad), under a name, or one that the
 * server chooses if it is NULL or "". `spawned`, which may be NULL, gets its name; valid until the next call
 * for this device. */
ph_status ph_simulation_spawn(ph_simulation *simulation, const char *like, ph_pose pose, const char *name,
                              const char **spawned, ph_error *error);
/** Removes a top-level model from the world, with its descendants. */
ph_status ph_simulation_remove(ph_simulation *simulation, const char *name, ph_error *error);

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_SIMULATION_H */
