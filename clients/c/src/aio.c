#include "playhouse/c/aio.h"

#include "playhouse/c/generated/aio.h"
#include "proxy.h"

struct ph_aio {
  ph_device device;
};

const ph_class ph_aio_class = {.interface_name = "aio", .size = sizeof(ph_aio)};
PH_DEFINE_PROXY(aio)

ph_status ph_aio_voltages(ph_aio *aio, const float **voltages, size_t *count, ph_error *error) {
  const ph_value *value = NULL;
  PH_TRY(ph_device_stamped(&aio->device, PH_AIO_DATA_STATE, &value, error));
  const ph_aio_data *data = value->data;
  *voltages = data->voltages;
  *count = data->voltages_count;
  return PH_OK;
}

ph_status ph_aio_set(ph_aio *aio, uint32_t output, double voltage, ph_error *error) {
  PH_INSIST_ON_FINITE(&aio->device, error, {"voltage", voltage});
  ph_aio_cmd command = {.id = output};
  PH_TRY(ph_to_float(&aio->device, voltage, &command.voltage, error));
  return ph_device_command(&aio->device, PH_AIO_CMD_STATE, &command, error);
}
