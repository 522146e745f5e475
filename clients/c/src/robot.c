#include "robot.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "client.h"
#include "fail.h"

struct ph_robot {
  ph_client *client;
  uint32_t port;
  ph_arena arena;
  ph_model *models;
  size_t model_count;
  ph_address *devices;
  ph_device **opened; /**< of each address */
  size_t *order;      /**< places of the opened addresses, in order of opening */
  size_t device_count, opened_count;
};

// --- making

static char *copy(ph_arena *arena, const char *text) {
  return ph_arena_copy(arena, text, strlen(text));
}

static bool copy_address(ph_arena *arena, const ph_address *from, const char *model, ph_address *to) {
  *to = (ph_address){copy(arena, from->name), from->port, copy(arena, from->interface_name), from->index,
                     model};
  return to->name != NULL && to->interface_name != NULL;
}

/** Adds a model with its devices at the end of the robot's lists, which have room. */
static bool add_model(ph_robot *robot, const ph_model *from) {
  ph_arena *arena = &robot->arena;
  ph_model *to = &robot->models[robot->model_count++];
  *to = (ph_model){copy(arena, from->name),   copy(arena, from->type),
                   copy(arena, from->parent), robot->devices + robot->device_count,
                   from->device_count,        from->id};
  bool done = to->name != NULL && to->type != NULL && to->parent != NULL;
  for (size_t i = 0; i < from->device_count && done; ++i) {
    done = copy_address(arena, &from->devices[i], to->name, &robot->devices[robot->device_count++]);
  }
  return done;
}

static bool fill(ph_robot *robot, const ph_models *models, size_t top) {
  size_t model_count = 0, device_count = 0;
  for (size_t i = top; i < models->count; ++i) {
    if (!ph_models_within(models, i, top)) continue;
    ++model_count;
    device_count += models->items[i].device_count;
  }
  robot->models = ph_arena_take(&robot->arena, model_count, sizeof *robot->models);
  robot->devices = ph_arena_take(&robot->arena, device_count + 1, sizeof *robot->devices);
  robot->opened = ph_arena_take(&robot->arena, device_count + 1, sizeof *robot->opened);
  robot->order = ph_arena_take(&robot->arena, device_count + 1, sizeof *robot->order);
  bool done =
      robot->models != NULL && robot->devices != NULL && robot->opened != NULL && robot->order != NULL;
  for (size_t i = top; i < models->count && done; ++i) {
    if (ph_models_within(models, i, top)) done = add_model(robot, &models->items[i]);
  }
  return done;
}

ph_robot *ph_robot_new(ph_client *client, const ph_models *models, size_t top, uint32_t port) {
  ph_robot *robot = calloc(1, sizeof *robot);
  if (robot == NULL) return NULL;
  robot->client = client;
  robot->port = port;
  if (fill(robot, models, top)) return robot;
  ph_robot_free(robot);
  return NULL;
}

void ph_robot_free(ph_robot *robot) {
  ph_arena_free(&robot->arena);
  free(robot);
}

static bool same_address(const ph_address *a, const ph_address *b) {
  return a->port == b->port && strcmp(a->name, b->name) == 0 && strcmp(a->model, b->model) == 0;
}

bool ph_robot_is(const ph_robot *robot, const ph_models *models, size_t top) {
  if (strcmp(robot->models[0].name, models->items[top].name) != 0) return false;
  size_t at = 0;
  for (size_t i = top; i < models->count; ++i) {
    if (!ph_models_within(models, i, top)) continue;
    for (size_t j = 0; j < models->items[i].device_count; ++j, ++at) {
      if (at == robot->device_count || !same_address(&robot->devices[at], &models->items[i].devices[j]))
        return false;
    }
  }
  return at == robot->device_count;
}

// --- what it tells

const char *ph_robot_name(const ph_robot *robot) {
  return robot->models[0].name;
}
const char *ph_robot_type(const ph_robot *robot) {
  return robot->models[0].type;
}

const ph_model *ph_robot_models(const ph_robot *robot, size_t *count) {
  *count = robot->model_count;
  return robot->models;
}

const ph_address *ph_robot_devices(const ph_robot *robot, size_t *count) {
  *count = robot->device_count;
  return robot->devices;
}

// --- its devices

/** The place of the robot's device of an interface at index `nth` of those on this connection, or the number
 * of all devices; `count` gets the number of those on this connection. A connection reaches the devices of
 * its own port only. */
static size_t find(const ph_robot *robot, const char *interface_name, size_t nth, size_t *count) {
  size_t found = robot->device_count;
  *count = 0;
  for (size_t i = 0; i < robot->device_count; ++i) {
    const ph_address *each = &robot->devices[i];
    if (each->port != robot->port || strcmp(each->interface_name, interface_name) != 0) continue;
    if ((*count)++ == nth) found = i;
  }
  return found;
}

size_t ph_robot_count(const ph_robot *robot, const char *interface_name) {
  size_t count = 0;
  find(robot, interface_name, 0, &count);
  return count;
}

enum { LIST_BYTES = 700 };

/** Appends to a text as much as fits; returns its length. */
static size_t append(char text[LIST_BYTES], size_t length, const char *separator, const char *name,
                     unsigned port) {
  if (length >= LIST_BYTES - 1) return length;
  const size_t room = LIST_BYTES - length;
  const int more = port != 0 ? snprintf(text + length, room, "%s%s at port %u", separator, name, port)
                             : snprintf(text + length, room, "%s%s", separator, name);
  return more < 0 ? length : length + (size_t)more;
}

/** Other ports with devices of this interface, or else the existing devices. */
static void tell_elsewhere(const ph_robot *robot, const char *interface_name, const char *what,
                           ph_error *error) {
  char others[LIST_BYTES] = "", all[LIST_BYTES] = "";
  size_t others_length = 0, all_length = 0;
  for (size_t i = 0; i < robot->device_count; ++i) {
    const ph_address *each = &robot->devices[i];
    all_length = append(all, all_length, i > 0 ? ", " : "", each->name, 0);
    if (strcmp(each->interface_name, interface_name) != 0 || each->port == robot->port) continue;
    others_length = append(others, others_length, others_length > 0 ? ", " : "", each->name, each->port);
  }
  if (others_length > 0) {
    ph_fail(error, PH_REQUEST_REFUSED, "robot \"%s\" has no %s at port %lu, but %s: connect there",
            ph_robot_name(robot), what, (unsigned long)robot->port, others);
  } else {
    ph_fail(error, PH_REQUEST_REFUSED, "robot \"%s\" has no %s (it has %s)", ph_robot_name(robot), what,
            all_length > 0 ? all : "no devices");
  }
}

static ph_device *open_at(ph_robot *robot, size_t at, ph_error *error) {
  if (robot->opened[at] != NULL && ph_device_is_open(robot->opened[at])) return robot->opened[at];
  ph_device *device = ph_device_open(robot->client, robot->devices[at].interface_name,
                                     robot->devices[at].index, PH_ACCESS_ALL, error);
  if (device == NULL) return NULL;
  if (robot->opened[at] == NULL) robot->order[robot->opened_count++] = at;
  robot->opened[at] = device;
  return device;
}

ph_device *ph_robot_device(ph_robot *robot, const char *interface_name, size_t nth, ph_error *error) {
  size_t count = 0;
  const size_t at = find(robot, interface_name, nth, &count);
  if (at < robot->device_count) return open_at(robot, at, error);
  char what[PH_NAME_BYTES + 32];
  if (nth > 0) {
    snprintf(what, sizeof what, "%.40s number %zu", interface_name, nth);
  } else {
    snprintf(what, sizeof what, "%.40s", interface_name);
  }
  tell_elsewhere(robot, interface_name, what, error);
  return NULL;
}

static void forget_at(ph_robot *robot, size_t place) {
  robot->opened[robot->order[place]] = NULL;
  --robot->opened_count;
  memmove(robot->order + place, robot->order + place + 1,
          (robot->opened_count - place) * sizeof *robot->order);
}

void ph_robot_forget(ph_robot *robot, const ph_device *device) {
  for (size_t i = 0; i < robot->opened_count; ++i) {
    if (robot->opened[robot->order[i]] != device) continue;
    forget_at(robot, i);
    return;
  }
}

ph_status ph_robot_close(ph_robot *robot, ph_error *error) {
  ph_status first = PH_OK;
  while (robot->opened_count > 0) {
    ph_device *device = robot->opened[robot->order[robot->opened_count - 1]];
    forget_at(robot, robot->opened_count - 1);
    const ph_status status = ph_device_close(device, first == PH_OK ? error : NULL);
    if (first == PH_OK) first = status;
  }
  return first;
}
