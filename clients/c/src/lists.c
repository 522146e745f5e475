/** What a client lists: devices, models and robots. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "client.h"
#include "fail.h"
#include "playhouse/c/generated/player.h"
#include "playhouse/c/generated/simulation.h"

// --- models

/** Asks for all models anew. */
static ph_status ask_models(ph_client *client, ph_error *error) {
  ph_error why;
  ph_models asked = {.count = 0};
  ph_simulation *simulator = ph_simulation_open(client, 0, PH_ACCESS_ALL, &why);
  ph_status status =
      simulator != NULL ? ph_models_ask(&asked, ph_simulation_device(simulator), &why) : why.status;
  ph_simulation_free(simulator);
  if (status == PH_OK) {
    ph_models_free(&client->models);
    client->models = asked;
    return PH_OK;
  }
  ph_models_free(&asked);
  if (status != PH_REQUEST_REFUSED) return ph_fail_as(error, &why);
  return ph_fail(error, status, "%s: this server does not tell the names of models; open devices by number",
                 ph_client_peer(client));
}

ph_status ph_client_models(ph_client *client, const ph_model **models, size_t *count, ph_error *error) {
  PH_TRY(ask_models(client, error));
  *models = client->models.items;
  *count = client->models.count;
  return PH_OK;
}

// --- robots

/** The one that was given out before while its devices are the same, or a new one. */
static ph_robot *robot_of(ph_client *client, size_t top, ph_error *error) {
  for (size_t i = 0; i < client->robot_count; ++i) {
    if (ph_robot_is(client->robots[i], &client->models, top)) return client->robots[i];
  }
  ph_robot *made = NULL;
  if (ph_grow(&client->robots, client->robot_count, &client->robot_capacity, sizeof made)) {
    made = ph_robot_new(client, &client->models, top, ph_session_server_port(&client->session));
  }
  if (made == NULL) {
    ph_fail_no_memory(error);
  } else {
    client->robots[client->robot_count++] = made;
  }
  return made;
}

static void refuse_robot(ph_client *client, const char *name, ph_error *error) {
  const ph_models *models = &client->models;
  const char **known = calloc(models->count + 1, sizeof *known);
  char near[PH_NEAR_BYTES] = "";
  for (size_t i = 0; i < models->count && known != NULL; ++i) known[i] = models->items[i].name;
  if (known != NULL) ph_did_you_mean(name, known, models->count, near);
  free(known);
  ph_fail(error, PH_REQUEST_REFUSED, "there is no robot \"%s\" at %s%s", name, ph_client_peer(client), near);
}

ph_robot *ph_client_robot(ph_client *client, const char *name, ph_error *error) {
  size_t at = ph_models_find(&client->models, name);
  if (at == client->models.count) {
    if (ask_models(client, error) != PH_OK) return NULL;
    at = ph_models_find(&client->models, name);
  }
  if (at < client->models.count) return robot_of(client, at, error);
  refuse_robot(client, name, error);
  return NULL;
}

static bool is_top(const ph_models *models, size_t at) {
  return models->items[at].parent[0] == '\0';
}

static bool is_here(const ph_client *client, const ph_robot *robot) {
  size_t count = 0;
  const ph_address *devices = ph_robot_devices(robot, &count);
  for (size_t i = 0; i < count; ++i) {
    if (devices[i].port == ph_session_server_port(&client->session)) return true;
  }
  return false;
}

ph_status ph_client_robots(ph_client *client, ph_robot *const **robots, size_t *count, ph_error *error) {
  PH_TRY(ask_models(client, error));
  size_t found = 0;
  for (size_t i = 0; i < client->models.count; ++i) {
    if (!is_top(&client->models, i)) continue;
    ph_robot *robot = robot_of(client, i, error);
    if (robot == NULL) return PH_NO_MEMORY;
    if (!is_here(client, robot)) continue;
    if (!ph_grow(&client->listed, found, &client->listed_capacity, sizeof robot))
      return ph_fail_no_memory(error);
    client->listed[found++] = robot;
  }
  *robots = client->listed;
  *count = found;
  return PH_OK;
}

// --- devices

/** The driver behind a device; "" if the server does not tell. */
static ph_status ask_driver(ph_client *client, const ph_common_devaddr *address, const char **driver,
                            ph_error *error) {
  const ph_player_device_driverinfo question = {.addr = {0, 0, address->interf, address->index}};
  ph_session *session = &client->session;
  ph_answer answer;
  ph_error why;
  const ph_status status = ph_session_request(session, PH_PLAYER_CODE, 0, PH_PLAYER_REQ_DRIVERINFO, &question,
                                              session->timeout, &answer, &why);
  *driver = "";
  if (status == PH_REQUEST_REFUSED) return PH_OK;
  if (status != PH_OK) return ph_fail_as(error, &why);
  ph_player_device_driverinfo told;
  const ph_status decoded = ph_player_device_driverinfo_decode(&told, answer.body, answer.header.size,
                                                               &client->entries_arena, NULL);
  if (decoded == PH_OK) *driver = told.driver_name;
  return PH_OK;
}

/** The last model with a device, as a place in the list, or their number. */
static size_t find_owner(const ph_models *models, const ph_common_devaddr *address,
                         const char *interface_name) {
  for (size_t i = models->count; i > 0; --i) {
    const ph_model *model = &models->items[i - 1];
    for (size_t j = 0; j < model->device_count; ++j) {
      const ph_address *each = &model->devices[j];
      if (each->index == address->index && each->port == address->robot &&
          strcmp(each->interface_name, interface_name) == 0) {
        return i - 1;
      }
    }
  }
  return models->count;
}

static void set_owner(const ph_models *models, const ph_common_devaddr *address, ph_device_entry *entry) {
  size_t at = find_owner(models, address, entry->interface_name);
  entry->model = entry->robot = "";
  if (at == models->count) return;
  const char *model = models->items[at].name;
  while (models->parents[at] != at) at = models->parents[at];
  if (!is_top(models, at)) return;
  entry->model = model;
  entry->robot = models->items[at].name;
}

static ph_status describe(ph_client *client, const ph_common_devaddr *address, const ph_models *owners,
                          ph_device_entry *entry, ph_error *error) {
  char name[PH_NAME_BYTES];
  ph_device_text(address->interf, address->index, name);
  entry->name = ph_arena_copy(&client->entries_arena, name, strlen(name));
  char *interface_name = ph_arena_copy(&client->entries_arena, name, (size_t)(strrchr(name, ':') - name));
  if (entry->name == NULL || interface_name == NULL) return ph_fail_no_memory(error);
  entry->interface_name = interface_name;
  entry->index = address->index;
  PH_TRY(ask_driver(client, address, &entry->driver, error));
  set_owner(owners, address, entry);
  return PH_OK;
}

/** The models behind devices: none without a simulation or if the server does not report them. */
static ph_status find_owners(ph_client *client, const ph_player_device_devlist *listed, ph_error *error) {
  bool simulated = false;
  for (uint32_t i = 0; i < listed->devices_count; ++i) {
    simulated = simulated || listed->devices[i].interf == PH_SIMULATION_CODE;
  }
  ph_error why;
  const ph_status status = simulated ? ask_models(client, &why) : PH_REQUEST_REFUSED;
  return status == PH_OK || status == PH_REQUEST_REFUSED ? status : ph_fail_as(error, &why);
}

ph_status ph_client_devices(ph_client *client, const ph_device_entry **devices, size_t *count,
                            ph_error *error) {
  static const ph_models none = {.count = 0};
  ph_session *session = &client->session;
  ph_answer answer;
  ph_player_device_devlist listed;
  ph_arena_free(&client->entries_arena);
  PH_TRY(ph_session_request(session, PH_PLAYER_CODE, 0, PH_PLAYER_REQ_DEVLIST, NULL, session->timeout,
                            &answer, error));
  PH_TRY(ph_player_device_devlist_decode(&listed, answer.body, answer.header.size, &client->entries_arena,
                                         error));
  const ph_status owned = find_owners(client, &listed, error);
  if (owned != PH_OK && owned != PH_REQUEST_REFUSED) return owned;
  const ph_models *owners = owned == PH_OK ? &client->models : &none;
  ph_device_entry *entries =
      ph_arena_take(&client->entries_arena, (size_t)listed.devices_count + 1, sizeof *entries);
  if (entries == NULL) return ph_fail_no_memory(error);
  for (uint32_t i = 0; i < listed.devices_count; ++i) {
    PH_TRY(describe(client, &listed.devices[i], owners, &entries[i], error));
  }
  *devices = entries;
  *count = listed.devices_count;
  return PH_OK;
}
