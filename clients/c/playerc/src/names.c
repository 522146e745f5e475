#include <string.h>

#include "libplayerinterface/interface_util.h"
#include "playhouse/c/wire.h"

const char *lookup_interface_name(unsigned int start, int code) {
  (void)start;
  return code >= 0 && code <= UINT16_MAX ? ph_interface_name((uint16_t)code) : NULL;
}

const char *interf_to_str(uint16_t code) {
  const char *name = ph_interface_name(code);
  return name != NULL ? name : "unknown";
}

uint16_t str_to_interf(const char *name) {
  const uint16_t code = ph_interface_code(name);
  return code != 0 ? code : 0xFFFF;
}

const char *msgtype_to_str(uint8_t type) {
  static const char *const names[] = {[PH_KIND_DATA] = "data",   [PH_KIND_CMD] = "command",
                                      [PH_KIND_REQ] = "request", [PH_KIND_ACK] = "acknowledgment",
                                      [PH_KIND_SYNCH] = "sync",  [PH_KIND_NACK] = "negative acknowledgement"};
  return type < sizeof names / sizeof *names && names[type] != NULL ? names[type] : "unknown";
}
