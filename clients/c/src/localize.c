#include "playhouse/c/localize.h"

#include <stdlib.h>

#include "playhouse/c/generated/localize.h"
#include "proxy.h"

struct ph_localize {
  ph_device device;
  void *hypotheses, *particles;
};

static void release(ph_device *device) {
  free(((ph_localize *)device)->hypotheses);
  free(((ph_localize *)device)->particles);
}

const ph_class ph_localize_class = {
    .interface_name = "localize", .size = sizeof(ph_localize), .release = release};
PH_DEFINE_PROXY(localize)

ph_covariance ph_covariance_of_deviations(double x, double y, double a) {
  return (ph_covariance){.xx = x * x, .yy = y * y, .aa = a * a};
}

static ph_hypothesis hypothesis_of(const ph_localize_hypoth *from) {
  const double *cov = from->cov;
  return (ph_hypothesis){
      ph_pose_of(from->mean), {cov[0], cov[1], cov[2], cov[3], cov[4], cov[5]}, from->alpha};
}

static ph_status newest(ph_localize *place, const ph_localize_data **data, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&place->device, PH_LOCALIZE_DATA_HYPOTHS, &value, error));
  *data = value->data;
  return PH_OK;
}

ph_status ph_localize_hypotheses(ph_localize *place, const ph_hypothesis **hypotheses, size_t *count,
                                 ph_error *error) {
  const ph_localize_data *data = NULL;
  PH_TRY(newest(place, &data, error));
  ph_hypothesis *made = ph_list_new(&place->hypotheses, data->hypoths_count, sizeof *made);
  if (made == NULL) return ph_fail_no_memory(error);
  for (uint32_t i = 0; i < data->hypoths_count; ++i) made[i] = hypothesis_of(&data->hypoths[i]);
  *hypotheses = made;
  *count = data->hypoths_count;
  return PH_OK;
}

ph_status ph_localize_pose(ph_localize *place, ph_pose *pose, ph_error *error) {
  const ph_localize_data *data = NULL;
  PH_TRY(newest(place, &data, error));
  if (data->hypoths_count == 0) {
    return ph_fail(error, PH_NO_DATA, "%s: %s has no hypothesis",
                   ph_session_peer(ph_device_session(&place->device)), place->device.name);
  }
  *pose = ph_pose_of(data->hypoths[0].mean);
  return PH_OK;
}

ph_status ph_localize_set_estimate(ph_localize *place, ph_pose pose, ph_covariance covariance,
                                   ph_error *error) {
  const ph_device *device = &place->device;
  PH_TRY(ph_insist_on_pose(device, pose, error));
  PH_INSIST_ON_FINITE(device, error, {"xx", covariance.xx}, {"yy", covariance.yy}, {"aa", covariance.aa},
                      {"xy", covariance.xy}, {"ya", covariance.ya}, {"xa", covariance.xa});
  const ph_localize_set_pose body = {
      ph_wire_pose(pose),
      {covariance.xx, covariance.yy, covariance.aa, covariance.xy, covariance.ya, covariance.xa}};
  return ph_device_tell(&place->device, PH_LOCALIZE_REQ_SET_POSE, &body, error);
}

ph_status ph_localize_particles(ph_localize *place, const ph_particle **particles, size_t *count,
                                ph_error *error) {
  ph_value *answer = NULL;
  PH_TRY(ph_device_ask(&place->device, PH_LOCALIZE_REQ_GET_PARTICLES, NULL, &answer, error));
  const ph_localize_get_particles *told = answer->data;
  ph_particle *made = ph_list_new(&place->particles, told->particles_count, sizeof *made);
  for (uint32_t i = 0; made != NULL && i < told->particles_count; ++i) {
    made[i] = (ph_particle){ph_pose_of(told->particles[i].pose), told->particles[i].alpha};
  }
  if (made != NULL) {
    *particles = made;
    *count = told->particles_count;
  }
  ph_value_free(answer);
  return made != NULL ? PH_OK : ph_fail_no_memory(error);
}
