# Interface health, code 59. Load of a computer.
#
# Generated from interfaces/059_health.toml by codegen; do not edit.

::playhouse::wire::interface health 59 {
    # Processor load. (player_health_cpu_t)
    #   idle: Idle time (in %).
    #   system: Time in the operating system (in %).
    #   user: Time in programs (in %).
    struct Cpu {
        idle float32
        system float32
        user float32
    } {
        if {[string length $body] - $at < 12} {cut $body $at {4 4 4}}
        binary scan $body @${at}RRR idle system user
        incr at 12
        return [dict create idle $idle system $system user $user]
    } {
        append out [put float32 [dict get $value idle]]
        append out [put float32 [dict get $value system]]
        append out [put float32 [dict get $value user]]
        return $out
    }

    # Usage of a type of memory. (player_health_memory_t)
    #   total: in byte.
    #   used: in byte.
    #   free: in byte.
    struct Memory {
        total int64
        used int64
        free int64
    } {
        if {[string length $body] - $at < 24} {cut $body $at {8 8 8}}
        binary scan $body @${at}WWW total used free
        incr at 24
        return [dict create total $total used $used free $free]
    } {
        append out [put int64 [dict get $value total]]
        append out [put int64 [dict get $value used]]
        append out [put int64 [dict get $value free]]
        return $out
    }

    # Load of processor and memory. (player_health_data_t)
    struct Data {
        cpu_usage health.Cpu
        mem health.Memory
        swap health.Memory
    } {
        if {[string length $body] - $at < 60} {cut $body $at {4 4 4 8 8 8 8 8 8}}
        binary scan $body @${at}RRRWWWWWW cpu_usage.idle cpu_usage.system cpu_usage.user mem.total \
            mem.used mem.free swap.total swap.used swap.free
        incr at 60
        return [dict create \
            cpu_usage [dict create idle ${cpu_usage.idle} system ${cpu_usage.system} user ${cpu_usage.user}] \
            mem [dict create total ${mem.total} used ${mem.used} free ${mem.free}] \
            swap [dict create total ${swap.total} used ${swap.used} free ${swap.free}]]
    } {
        append out [Cpu.write [dict get $value cpu_usage]]
        append out [Memory.write [dict get $value mem]]
        append out [Memory.write [dict get $value swap]]
        return $out
    }

    # Load of processor and memory.
    message health.data.state DATA 1 health.Data
}
