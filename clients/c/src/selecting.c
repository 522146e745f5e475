/** Devices whose data are of one of several messages, as an inertial unit. */
#include <ctype.h>

#include "playhouse/c/generated/imu.h"
#include "proxy.h"

ph_status ph_select(ph_device *device, const ph_message_type *datatype, ph_error *error) {
  const ph_imu_datatype_config body = {datatype->subtype};
  return ph_device_tell(device, PH_IMU_REQ_SET_DATATYPE, &body, error);
}

ph_status ph_selected(const ph_device *device, const ph_message_type *message, const ph_value **value,
                      ph_error *error) {
  const ph_status status = ph_device_stamped(device, message, value, error);
  if (status == PH_OK || error == NULL || !ph_device_has_data(device)) return status;
  char constant[32] = "";
  for (size_t i = 0; message->name[i] != '\0' && i + 1 < sizeof constant; ++i)
    constant[i] = message->name[i] == '.' ? '_' : (char)toupper((unsigned char)message->name[i]);
  return ph_fail(error, status, "%s; ph_imu_send(unit, PH_%s) selects it", error->text, constant);
}

ph_status ph_newest_of(const ph_device *device, const ph_message_type *const *messages, size_t count,
                       const ph_value **value, ph_error *error) {
  const ph_value *found = NULL;
  for (size_t i = 0; i < count; ++i) {
    const ph_value *each = ph_device_latest(device, messages[i]);
    if (each != NULL && (found == NULL || each->timestamp > found->timestamp)) found = each;
  }
  *value = found;
  return found != NULL ? PH_OK : ph_selected(device, messages[0], value, error);
}
