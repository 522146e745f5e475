#ifndef PLAYHOUSE_C_CHARGING_H
#define PLAYHOUSE_C_CHARGING_H

#ifdef __cplusplus
extern "C" {
#endif

/** Whether a battery is being charged; unknown if the server does not report it. */
typedef enum ph_charging {
  PH_CHARGING_UNKNOWN,
  PH_CHARGING_IMPOSSIBLE,
  PH_CHARGING_NO,
  PH_CHARGING_YES
} ph_charging;

#ifdef __cplusplus
}
#endif

#endif /* PLAYHOUSE_C_CHARGING_H */
