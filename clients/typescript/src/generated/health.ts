/**
 * Interface health, code 59. Load of a computer.
 *
 * Generated from interfaces/059_health.toml by codegen; do not edit.
 */

import { Codec, Kind, MessageType } from '../wire.js';

export const CODE = 59;

/** Processor load. (player_health_cpu_t) */
export interface Cpu {
  /** Idle time (in %). */
  idle: number;
  /** Time in the operating system (in %). */
  system: number;
  /** Time in programs (in %). */
  user: number;
}

export const Cpu: Codec<Cpu> = new Codec<Cpu>('health.Cpu', {
  zero: () => ({ idle: 0, system: 0, user: 0 }),
  write(to, value) {
    to.float32(value.idle);
    to.float32(value.system);
    to.float32(value.user);
  },
  read(from) {
    const idle = from.float32();
    const system = from.float32();
    const user = from.float32();
    return { idle, system, user };
  },
});

/** Usage of a type of memory. (player_health_memory_t) */
export interface Memory {
  /** In byte. */
  total: bigint;
  /** In byte. */
  used: bigint;
  /** In byte. */
  free: bigint;
}

export const Memory: Codec<Memory> = new Codec<Memory>('health.Memory', {
  zero: () => ({ total: 0n, used: 0n, free: 0n }),
  write(to, value) {
    to.int64(value.total);
    to.int64(value.used);
    to.int64(value.free);
  },
  read(from) {
    const total = from.int64();
    const used = from.int64();
    const free = from.int64();
    return { total, used, free };
  },
});

/** Load of processor and memory. (player_health_data_t) */
export interface Data {
  cpuUsage: Cpu;
  mem: Memory;
  swap: Memory;
}

export const Data: Codec<Data> = new Codec<Data>('health.Data', {
  zero: () => ({ cpuUsage: Cpu.make(), mem: Memory.make(), swap: Memory.make() }),
  write(to, value) {
    Cpu.write(to, value.cpuUsage);
    Memory.write(to, value.mem);
    Memory.write(to, value.swap);
  },
  read(from) {
    const cpuUsage = Cpu.read(from);
    const mem = Memory.read(from);
    const swap = Memory.read(from);
    return { cpuUsage, mem, swap };
  },
});

/** Load of processor and memory. */
export const DATA_STATE: MessageType<Data> = new MessageType(59, Kind.DATA, 1, 'health.data.state', Data);
