/** Interface rfid, code 56. Reads and writes radio tags. Generated from interfaces/056_rfid.toml by
 * codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_RFID_H
#define PLAYHOUSE_C_GENERATED_RFID_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_RFID_CODE 56

/** One tag. (player_rfid_tag_t) */
typedef struct ph_rfid_tag {
  /** Type of tag. */
  uint32_t type;
  /** Id of the tag, as bytes. */
  const char *guid;
  uint32_t guid_count;
} ph_rfid_tag;
PH_CODEC(ph_rfid_tag)

/** Tags in range. (player_rfid_data_t) */
typedef struct ph_rfid_data {
  const ph_rfid_tag *tags;
  uint32_t tags_count;
} ph_rfid_data;
PH_CODEC(ph_rfid_data)

/** The messages, each under its name below. */
extern const ph_message_type ph_rfid_messages[5];
/** Tags in range. */
#define PH_RFID_DATA_TAGS (&ph_rfid_messages[0])
/** Switches the reader on or off. */
#define PH_RFID_REQ_POWER (&ph_rfid_messages[1])
/** Reads a tag. */
#define PH_RFID_REQ_READTAG (&ph_rfid_messages[2])
/** Writes a tag. */
#define PH_RFID_REQ_WRITETAG (&ph_rfid_messages[3])
/** Locks a tag against writing. */
#define PH_RFID_REQ_LOCKTAG (&ph_rfid_messages[4])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_RFID_H */
