/** Numbers as the wire has them. */
#ifndef PLAYHOUSE_C_BIG_ENDIAN_H
#define PLAYHOUSE_C_BIG_ENDIAN_H

#include <stdint.h>

static inline uint32_t ph_load32(const uint8_t *at) {
  return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

static inline uint64_t ph_load64(const uint8_t *at) {
  return (uint64_t)ph_load32(at) << 32 | ph_load32(at + 4);
}

static inline void ph_store32(uint8_t *at, uint32_t value) {
  at[0] = (uint8_t)(value >> 24);
  at[1] = (uint8_t)(value >> 16);
  at[2] = (uint8_t)(value >> 8);
  at[3] = (uint8_t)value;
}

static inline void ph_store64(uint8_t *at, uint64_t value) {
  ph_store32(at, (uint32_t)(value >> 32));
  ph_store32(at + 4, (uint32_t)value);
}

#endif /* PLAYHOUSE_C_BIG_ENDIAN_H */
