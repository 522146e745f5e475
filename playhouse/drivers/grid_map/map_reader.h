#pragma once

/// Reads the whole map of a device, tile by tile, for drivers that localize or plan.

#include <cstddef>
#include <functional>

#include "playhouse/base/result.h"
#include "playhouse/device/client.h"
#include "playhouse/drivers/grid_map/grid_map.h"

namespace playhouse::drivers {

/// Requests the map of device number `device` of the client and calls `read` once, on any
/// thread, maybe before it returns. Fails with what is wrong if the device refuses a request,
/// answers with another size than asked for, or has no cells or too many. A cell is occupied
/// or free if its value is beyond half of `data_range`.
void read_map(device::DeviceClient& client, std::size_t device, std::function<void(Result<GridMap>)> read);

}  // namespace playhouse::drivers
