/** Interface wifi, code 23. State of wireless network links. Generated from interfaces/023_wifi.toml by
 * codegen; do not edit. */
#ifndef PLAYHOUSE_C_GENERATED_WIFI_H
#define PLAYHOUSE_C_GENERATED_WIFI_H

#include "playhouse/c/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PH_WIFI_CODE 23

/** Values of Data.qual_type: unit of link quality. */
enum {
  PH_WIFI_QUAL_DBM = 1,
  PH_WIFI_QUAL_REL = 2,
  PH_WIFI_QUAL_UNKNOWN = 3,
};

/** Values of Data.mode and Link.mode. */
enum {
  PH_WIFI_MODE_UNKNOWN = 0,
  PH_WIFI_MODE_AUTO = 1,
  PH_WIFI_MODE_ADHOC = 2,
  PH_WIFI_MODE_INFRA = 3,
  PH_WIFI_MODE_MASTER = 4,
  PH_WIFI_MODE_REPEAT = 5,
  PH_WIFI_MODE_SECOND = 6,
};

/** One link. (player_wifi_link_t) */
typedef struct ph_wifi_link {
  /** Hardware address, as a string. At most 32. */
  const uint8_t *mac;
  uint32_t mac_count;
  /** Network address, as a string. At most 32. */
  const uint8_t *ip;
  uint32_t ip_count;
  /** Name of the network, as a string. At most 32. */
  const uint8_t *essid;
  uint32_t essid_count;
  /** Role in the network. */
  uint32_t mode;
  /** In MHz. */
  uint32_t freq;
  /** 0: open, else encrypted. */
  uint32_t encrypt;
  /** Quality, up to Data.maxqual. */
  uint32_t qual;
  /** Signal, up to Data.maxlevel (signed). */
  int32_t level;
  /** Noise, up to Data.maxnoise (signed). */
  int32_t noise;
} ph_wifi_link;
PH_CODEC(ph_wifi_link)

/** Every link and the state of the card. (player_wifi_data_t) */
typedef struct ph_wifi_data {
  const ph_wifi_link *links;
  uint32_t links_count;
  /** Estimated throughput of the card (in bit/s). */
  uint32_t throughput;
  /** Configured bit rate of the card (in bit/s). */
  uint32_t bitrate;
  /** Role in the network. */
  uint32_t mode;
  /** Unit of quality, level and noise. */
  uint32_t qual_type;
  /** Maximum reported quality. */
  uint32_t maxqual;
  /** Maximum reported signal level (signed). */
  int32_t maxlevel;
  /** Maximum reported noise level (signed). */
  int32_t maxnoise;
  /** Hardware address of the access point, as a string. */
  char ap[32];
} ph_wifi_data;
PH_CODEC(ph_wifi_data)

/** The card's own address. (player_wifi_mac_req_t) */
typedef struct ph_wifi_mac_req {
  /** Hardware address, as a string. At most 32. */
  const uint8_t *mac;
  uint32_t mac_count;
} ph_wifi_mac_req;
PH_CODEC(ph_wifi_mac_req)

/** The address of a station. (player_wifi_iwspy_addr_req_t) */
typedef struct ph_wifi_iwspy_addr_req {
  /** Hardware address, as a string. */
  char address[32];
} ph_wifi_iwspy_addr_req;
PH_CODEC(ph_wifi_iwspy_addr_req)

/** The messages, each under its name below. */
extern const ph_message_type ph_wifi_messages[5];
/** Every link and the state of the card. */
#define PH_WIFI_DATA_STATE (&ph_wifi_messages[0])
/** Requests the card's own address. */
#define PH_WIFI_REQ_MAC (&ph_wifi_messages[1])
/** Starts monitoring the links to an address. */
#define PH_WIFI_REQ_IWSPY_ADD (&ph_wifi_messages[2])
/** Stops monitoring the links to an address. */
#define PH_WIFI_REQ_IWSPY_DEL (&ph_wifi_messages[3])
/** Sends a packet to an address to measure its link. */
#define PH_WIFI_REQ_IWSPY_PING (&ph_wifi_messages[4])

#ifdef __cplusplus
}
#endif

#endif  /* PLAYHOUSE_C_GENERATED_WIFI_H */
