#include "playhouse/c/simulation.h"

#include <string.h>

#include "client.h"
#include "playhouse/c/generated/simulation.h"
#include "proxy.h"

enum { MOST_TICKS = 1 << 20 };

struct ph_simulation {
  ph_device device;
  ph_value *spawned; /**< the answer of the last ph_simulation_spawn() */
};

static void release(ph_device *device) {
  ph_value_free(((ph_simulation *)device)->spawned);
}

const ph_class ph_simulation_class = {
    .interface_name = "simulation", .size = sizeof(ph_simulation), .release = release};
PH_DEFINE_PROXY(simulation)

static const char *peer_of(const ph_simulation *simulation) {
  return ph_session_peer(ph_device_session(&simulation->device));
}

// --- models

/** A request about a model; the value in `answer` is NULL if it has no body. */
static ph_status of_model(ph_simulation *simulation, const char *name, const ph_message_type *message,
                          const void *body, ph_value **answer, ph_error *error) {
  const ph_status status =
      ph_device_request(&simulation->device, message, body, PH_OWN_TIMEOUT, answer, error);
  if (status != PH_REQUEST_REFUSED) return status;
  return ph_fail(error, status, "%s: %s of model \"%s\" was refused", peer_of(simulation), message->name,
                 name);
}

/** The same for an answer that must have a body. */
static ph_status ask_model(ph_simulation *simulation, const char *name, const ph_message_type *message,
                           const void *body, ph_value **answer, ph_error *error) {
  PH_TRY(of_model(simulation, name, message, body, answer, error));
  return *answer != NULL ? PH_OK : ph_fail(error, PH_WIRE_ERROR, "an answer came without its contents");
}

ph_status ph_simulation_pose(ph_simulation *simulation, const char *name, ph_pose *pose, ph_error *error) {
  const ph_simulation_pose2d_req body = {.name = name, .name_count = ph_text_count(name)};
  ph_value *answer = NULL;
  PH_TRY(ask_model(simulation, name, PH_SIMULATION_REQ_GET_POSE2D, &body, &answer, error));
  *pose = ph_pose_of(((const ph_simulation_pose2d_req *)answer->data)->pose);
  ph_value_free(answer);
  return PH_OK;
}

ph_status ph_simulation_set_pose(ph_simulation *simulation, const char *name, ph_pose pose, ph_error *error) {
  PH_TRY(ph_insist_on_pose(&simulation->device, pose, error));
  const ph_simulation_pose2d_req body = {name, ph_text_count(name), ph_wire_pose(pose)};
  return of_model(simulation, name, PH_SIMULATION_REQ_SET_POSE2D, &body, NULL, error);
}

ph_status ph_simulation_pose3d(ph_simulation *simulation, const char *name, ph_pose3d *pose,
                               ph_error *error) {
  const ph_simulation_pose3d_req body = {.name = name, .name_count = ph_text_count(name)};
  ph_value *answer = NULL;
  PH_TRY(ask_model(simulation, name, PH_SIMULATION_REQ_GET_POSE3D, &body, &answer, error));
  *pose = ph_pose3d_of(((const ph_simulation_pose3d_req *)answer->data)->pose);
  ph_value_free(answer);
  return PH_OK;
}

ph_status ph_simulation_set_pose3d(ph_simulation *simulation, const char *name, ph_pose3d pose,
                                   ph_error *error) {
  PH_TRY(ph_insist_on_pose3d(&simulation->device, pose, error));
  const ph_simulation_pose3d_req body = {
      .name = name, .name_count = ph_text_count(name), .pose = ph_wire_pose3d(pose)};
  return of_model(simulation, name, PH_SIMULATION_REQ_SET_POSE3D, &body, NULL, error);
}

// --- the world

/** The end of the text of a NACK, or why there is none. */
static ph_status refuse(ph_simulation *simulation, const char *prop, ph_error *error) {
  size_t size = 0;
  const void *body = ph_client_refusal(simulation->device.client, &size);
  ph_arena arena = {NULL};
  ph_simulation_property_req told = {.value = "the server does not do that"};
  ph_status status = PH_OK;
  if (size > 0) status = ph_simulation_property_req_decode(&told, body, size, &arena, error);
  if (status == PH_OK && strcmp(told.value, "the run has ended") == 0) {
    status = ph_fail(error, PH_RUN_ENDED, "%s: %s", peer_of(simulation), told.value);
  } else if (status == PH_OK) {
    status =
        ph_fail(error, PH_REQUEST_REFUSED, "%s: %s was refused: %s", peer_of(simulation), prop, told.value);
  }
  ph_arena_free(&arena);
  return status;
}

/** Sets a property of the world, which does something. `answer` may be NULL. */
static ph_status of_world(ph_simulation *simulation, const char *prop, const void *value, size_t size,
                          const char *name, double timeout, ph_value **answer, ph_error *error) {
  const ph_simulation_property_req body = {.name = name,
                                           .name_count = ph_text_count(name),
                                           .prop = prop,
                                           .prop_count = ph_text_count(prop),
                                           .value = value,
                                           .value_count = (uint32_t)size};
  const ph_status status =
      ph_device_request(&simulation->device, PH_SIMULATION_REQ_SET_PROPERTY, &body, timeout, answer, error);
  return status == PH_REQUEST_REFUSED ? refuse(simulation, prop, error) : status;
}

/** The bytes of a number, the lowest first. */
static void store_low_first(uint64_t value, size_t size, uint8_t *bytes) {
  for (size_t i = 0; i < size; ++i) bytes[i] = (uint8_t)(value >> 8 * i);
}

static ph_status command(ph_simulation *simulation, const ph_message_type *message, ph_error *error) {
  return ph_device_command(&simulation->device, message, NULL, error);
}

ph_status ph_simulation_pause(ph_simulation *simulation, ph_error *error) {
  return command(simulation, PH_SIMULATION_CMD_PAUSE, error);
}

ph_status ph_simulation_save(ph_simulation *simulation, ph_error *error) {
  return command(simulation, PH_SIMULATION_CMD_SAVE, error);
}

ph_status ph_simulation_reset(ph_simulation *simulation, ph_error *error) {
  return command(simulation, PH_SIMULATION_CMD_RESET, error);
}

ph_status ph_simulation_restart(ph_simulation *simulation, uint64_t seed, ph_error *error) {
  uint8_t value[8];
  store_low_first(seed, sizeof value, value);
  PH_TRY(of_world(simulation, "reset", value, sizeof value, "", PH_OWN_TIMEOUT, NULL, error));
  ph_client_forget_run(simulation->device.client);
  return PH_OK;
}

ph_status ph_simulation_join(ph_simulation *simulation, const char *name, ph_error *error) {
  return of_world(simulation, "join", name, strlen(name) + 1, "", PH_OWN_TIMEOUT, NULL, error);
}

ph_status ph_simulation_step(ph_simulation *simulation, int64_t ticks, double timeout, ph_error *error) {
  if (ticks < 1 || ticks > MOST_TICKS) {
    return ph_fail(error, PH_INVALID_VALUE, "%s: ticks is %lld, not a whole number from 1 to %d",
                   simulation->device.name, (long long)ticks, (int)MOST_TICKS);
  }
  uint8_t value[4];
  store_low_first((uint64_t)ticks, sizeof value, value);
  PH_TRY(of_world(simulation, "step", value, sizeof value, "", timeout, NULL, error));
  return ph_client_deliver_pushed(simulation->device.client, error);
}

ph_status ph_simulation_spawn(ph_simulation *simulation, const char *like, ph_pose pose, const char *name,
                              const char **spawned, ph_error *error) {
  PH_TRY(ph_insist_on_pose(&simulation->device, pose, error));
  const double numbers[3] = {pose.x, pose.y, pose.a};
  ph_buffer value = {NULL, 0, 0};
  bool whole = true;
  for (size_t i = 0; i < 3; ++i) {
    uint64_t bits = 0;
    uint8_t bytes[8];
    memcpy(&bits, &numbers[i], sizeof bits);
    store_low_first(bits, sizeof bytes, bytes);
    whole = whole && ph_buffer_append(&value, bytes, sizeof bytes);
  }
  if (name != NULL && name[0] != '\0') whole = whole && ph_buffer_append(&value, name, strlen(name) + 1);
  ph_value *answer = NULL;
  ph_status status =
      whole ? of_world(simulation, "spawn", value.bytes, value.size, like, PH_OWN_TIMEOUT, &answer, error)
            : ph_fail_no_memory(error);
  ph_buffer_free(&value);
  if (status != PH_OK) return status;
  ph_value_free(simulation->spawned);
  simulation->spawned = answer;
  if (spawned != NULL)
    *spawned = answer != NULL ? ((const ph_simulation_property_req *)answer->data)->value : "";
  return PH_OK;
}

ph_status ph_simulation_remove(ph_simulation *simulation, const char *name, ph_error *error) {
  return of_world(simulation, "remove", NULL, 0, name, PH_OWN_TIMEOUT, NULL, error);
}
