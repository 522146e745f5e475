#include "playhouse_client/selecting.h"

#include "done.h"
#include "playhouse/wire/generated/imu.h"

namespace playhouse::client {

Result<void> Selecting::send(std::uint8_t datatype) {
  return done(device_.request(wire::imu::kReqSetDatatype, wire::imu::DatatypeConfig{datatype}));
}

}  // namespace playhouse::client
