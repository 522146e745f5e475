#include "playhouse/c/bumper.h"

#include <stdlib.h>

#include "playhouse/c/generated/bumper.h"
#include "proxy.h"

struct ph_bumper {
  ph_device device;
  void *faces;
};

static void release(ph_device *device) {
  free(((ph_bumper *)device)->faces);
}

const ph_class ph_bumper_class = {.interface_name = "bumper", .size = sizeof(ph_bumper), .release = release};
PH_DEFINE_PROXY(bumper)

ph_status ph_bumper_pressed(ph_bumper *bumper, const uint8_t **pressed, size_t *count, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&bumper->device, PH_BUMPER_DATA_STATE, &value, error));
  const ph_bumper_data *data = value->data;
  *pressed = data->bumpers;
  *count = data->bumpers_count;
  return PH_OK;
}

ph_status ph_bumper_faces(ph_bumper *bumper, const ph_face **faces, size_t *count, ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&bumper->device, PH_BUMPER_REQ_GET_GEOM, NULL, &answer, error));
  const ph_bumper_geom *geom = answer->data;
  ph_face *made = ph_list_new(&bumper->faces, geom->bumper_def_count, sizeof *made);
  for (uint32_t i = 0; made != NULL && i < geom->bumper_def_count; ++i) {
    const ph_bumper_define *from = &geom->bumper_def[i];
    made[i] = (ph_face){ph_pose3d_of(from->pose), (double)from->length, (double)from->radius};
  }
  if (made != NULL) {
    *faces = made;
    *count = geom->bumper_def_count;
  }
  ph_value_free(answer);
  return made != NULL ? PH_OK : ph_fail_no_memory(error);
}
