#include "models.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "device.h"
#include "fail.h"
#include "playhouse/c/generated/simulation.h"

enum { FIELDS = 5 };

void ph_models_free(ph_models *models) {
  ph_arena_free(&models->arena);
  free(models->items);
  free(models->parents);
  free(models->slots);
  *models = (ph_models){.count = 0};
}

/** Ends the text at the first of a character and returns what is behind it; NULL if there is none. */
static char *cut(char *text, char at) {
  char *found = strchr(text, at);
  if (found == NULL) return NULL;
  *found = '\0';
  return found + 1;
}

/** A whole number in digits alone, at most `most`; false if the word is not one. */
static bool number_of(const char *word, uint64_t most, uint64_t *number) {
  if (*word == '\0') return false;
  for (*number = 0; *word != '\0'; ++word) {
    if (*word < '0' || *word > '9' || *number > (most - (uint64_t)(*word - '0')) / 10) return false;
    *number = 10 * *number + (uint64_t)(*word - '0');
  }
  return true;
}

/** Replaces the escapes of TAB, end of line and backslash. */
static const char *unescape(char *field) {
  char *to = field;
  for (const char *from = field; *from != '\0'; ++from) {
    if (from[0] == '\\' && (from[1] == '\\' || from[1] == 't' || from[1] == 'n')) {
      ++from;
      *to++ = *from == 't' ? '\t' : *from == 'n' ? '\n' : '\\';
    } else {
      *to++ = *from;
    }
  }
  *to = '\0';
  return field;
}

/** PORT:INTERFACE:INDEX; the address keeps the text of `word`, whose interface and index are its name. */
static ph_status parse_device(char *word, const char *model, ph_arena *arena, ph_address *address,
                              ph_error *error) {
  uint64_t port = 0, index = 0;
  char *copy = ph_arena_copy(arena, word, strlen(word));
  if (copy == NULL) return ph_fail_no_memory(error);
  char *name = cut(copy, ':');
  char *interface_name = name != NULL ? ph_arena_copy(arena, name, strlen(name)) : NULL;
  char *last = interface_name != NULL ? cut(interface_name, ':') : NULL;
  if (last == NULL || !number_of(copy, UINT16_MAX, &port) || !number_of(last, INT32_MAX, &index)) {
    return ph_fail(error, PH_WIRE_ERROR, "'%s' in the list of models is not PORT:INTERFACE:INDEX", word);
  }
  *address = (ph_address){name, (uint16_t)port, interface_name, (int)index, model};
  return PH_OK;
}

/** Words between blanks; `words` NULL counts them only. */
static size_t split_words(char *text, char **words) {
  size_t count = 0;
  for (char *at = text; *at != '\0';) {
    const size_t blanks = strspn(at, " \r\f\v");
    const size_t length = strcspn(at + blanks, " \r\f\v");
    if (length == 0) break;
    if (words != NULL) words[count] = at + blanks;
    ++count;
    at += blanks + length;
    if (words != NULL && *at != '\0') *at++ = '\0';
  }
  return count;
}

static ph_status parse_devices(char *field, ph_model *model, ph_arena *arena, ph_error *error) {
  const size_t count = split_words(field, NULL);
  if (count == 0) return PH_OK;
  char **words = ph_arena_take(arena, count, sizeof *words);
  ph_address *devices = ph_arena_take(arena, count, sizeof *devices);
  if (words == NULL || devices == NULL) return ph_fail_no_memory(error);
  split_words(field, words);
  for (size_t i = 0; i < count; ++i) PH_TRY(parse_device(words[i], model->name, arena, &devices[i], error));
  model->devices = devices;
  model->device_count = count;
  return PH_OK;
}

/** Ends the fields of a line; returns their number, of which the first five are kept. */
static size_t split_fields(char *line, char *fields[FIELDS]) {
  size_t count = 0;
  for (char *at = line; at != NULL; ++count) {
    char *next = cut(at, '\t');
    if (count < FIELDS) fields[count] = at;
    at = next;
  }
  return count;
}

// --- names

static size_t hash_of(const char *name) {
  size_t hash = 5381;
  for (; *name != '\0'; ++name) hash = 33 * hash + (unsigned char)*name;
  return hash;
}

/** The slot of a name, or the free one where it belongs. */
static size_t *slot_of(const ph_models *models, const char *name) {
  size_t at = hash_of(name);
  for (;; ++at) {
    size_t *slot = &models->slots[at & (models->slot_count - 1)];
    if (*slot == 0 || strcmp(models->items[*slot - 1].name, name) == 0) return slot;
  }
}

/** Makes room for the name of one more model; false without memory. */
static bool grow_slots(ph_models *models) {
  if (models->slot_count > 2 * (models->count + 1)) return true;
  size_t *old = models->slots;
  const size_t wanted = models->slot_count == 0 ? 64 : 4 * models->slot_count;
  size_t *slots = calloc(wanted, sizeof *slots);
  if (slots == NULL) return false;
  models->slots = slots;
  models->slot_count = wanted;
  for (size_t i = 0; i < models->count; ++i) *slot_of(models, models->items[i].name) = i + 1;
  free(old);
  return true;
}

size_t ph_models_find(const ph_models *models, const char *name) {
  const size_t slot = models->slot_count > 0 ? *slot_of(models, name) : 0;
  return slot > 0 ? slot - 1 : models->count;
}

static bool add_model(ph_models *models, const ph_model *model) {
  if (!ph_grow(&models->items, models->count, &models->capacity, sizeof *model) ||
      !ph_grow(&models->parents, models->count, &models->parent_capacity, sizeof *models->parents) ||
      !grow_slots(models)) {
    return false;
  }
  // Parents come before children; of equal names the last one so far is meant. Without one it is its own
  // parent.
  const bool is_top = model->parent[0] == '\0';
  models->parents[models->count] = is_top ? models->count : ph_models_find(models, model->parent);
  models->items[models->count] = *model;
  *slot_of(models, model->name) = ++models->count;
  return true;
}

static ph_status parse_line(ph_models *models, char *line, ph_error *error) {
  char *fields[FIELDS];
  char *whole = ph_arena_copy(&models->arena, line, strlen(line));
  if (whole == NULL) return ph_fail_no_memory(error);
  const size_t count = split_fields(whole, fields);
  if (count != FIELDS) {
    return ph_fail(error, PH_WIRE_ERROR, "a line of the list of models has %zu fields instead of 5: '%s'",
                   count, line);
  }
  ph_model model = {.id = 0};
  if (!number_of(fields[0], UINT64_MAX, &model.id)) {
    return ph_fail(error, PH_WIRE_ERROR, "'%s' in the list of models is not an id", fields[0]);
  }
  model.name = unescape(fields[1]);
  model.type = unescape(fields[2]);
  model.parent = unescape(fields[3]);
  PH_TRY(parse_devices(fields[4], &model, &models->arena, error));
  return add_model(models, &model) ? PH_OK : ph_fail_no_memory(error);
}

ph_status ph_models_parse(ph_models *models, char *lines, ph_error *error) {
  for (char *line = lines; line != NULL;) {
    char *next = cut(line, '\n');
    if (*line != '\0') PH_TRY(parse_line(models, line, error));
    line = next;
  }
  return PH_OK;
}

bool ph_models_within(const ph_models *models, size_t model, size_t ancestor) {
  while (model > ancestor && models->parents[model] != model) model = models->parents[model];
  return model == ancestor;
}

/** Adds the models from place `*index` on; `*index` is then the next place, 0 at the end. */
static ph_status ask_page(ph_models *models, ph_device *simulator, uint32_t *index, ph_error *error) {
  const ph_simulation_property_req question = {
      .name = "", .name_count = 1, .prop = "models", .prop_count = sizeof "models", .index = *index};
  ph_value *answer = NULL;
  PH_TRY(ph_device_request(simulator, PH_SIMULATION_REQ_GET_PROPERTY, &question, PH_OWN_TIMEOUT, &answer,
                           error));
  ph_status status = PH_OK;
  uint32_t following = *index;
  if (answer != NULL) {
    const ph_simulation_property_req *told = answer->data;
    char *lines = ph_copy_text(told->value);
    status = lines != NULL ? ph_models_parse(models, lines, error) : ph_fail_no_memory(error);
    following = told->index;
    free(lines);
  }
  ph_value_free(answer);
  if (status == PH_OK && following != 0 && following <= *index) {
    return ph_fail(error, PH_WIRE_ERROR, "the list of models goes on at %lu after %lu",
                   (unsigned long)following, (unsigned long)*index);
  }
  *index = following;
  return status;
}

ph_status ph_models_ask(ph_models *models, ph_device *simulator, ph_error *error) {
  uint32_t index = 0;
  do {
    PH_TRY(ask_page(models, simulator, &index, error));
  } while (index != 0);
  return PH_OK;
}
