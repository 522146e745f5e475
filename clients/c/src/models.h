/** The simulator's list of models and their devices: lines of text in a property of interface simulation. */
#ifndef PLAYHOUSE_C_MODELS_H
#define PLAYHOUSE_C_MODELS_H

#include "playhouse/c/simulation.h"

/** Begin with zeros; ph_models_free() ends it. */
typedef struct ph_models {
  ph_arena arena;
  ph_model *items;
  size_t *parents; /**< the place of each model's parent; its own for a top-level model */
  size_t count, capacity, parent_capacity;
  size_t *slots;     /**< places of the last model of each name, from 1, by the hash of the name; 0: free */
  size_t slot_count; /**< a power of 2, more than twice as many as models */
} ph_models;

void ph_models_free(ph_models *models);
/** Adds the models of one answer, one per line: id, name, type, parent and devices, separated by TABs.
 * `lines` is overwritten. */
ph_status ph_models_parse(ph_models *models, char *lines, ph_error *error);
/** All models of a simulation device's world. */
ph_status ph_models_ask(ph_models *models, ph_device *simulator, ph_error *error);
/** The place of the last model of a name, or the number of models. */
size_t ph_models_find(const ph_models *models, const char *name);
/** Whether a model is `ancestor` itself or a descendant. */
bool ph_models_within(const ph_models *models, size_t model, size_t ancestor);

#endif /* PLAYHOUSE_C_MODELS_H */
