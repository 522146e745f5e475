// Generated from interfaces/059_health.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface health, code 59. Load of a computer. */
public final class HealthMessages {
  /** The interface's code. */
  public static final int CODE = 59;

  /**
   * Processor load. (player_health_cpu_t)
   *
   * @param idle Idle time (in %).
   * @param system Time in the operating system (in %).
   * @param user Time in programs (in %).
   */
  public record Cpu(float idle, float system, float user) implements Struct {
    /** Every number 0, every list empty. */
    public Cpu() {
      this(0f, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cpu decode(byte[] body) {
      return Reader.decode("health.Cpu", body, Cpu::read);
    }

    static Cpu read(Reader in) {
      float idle = in.float32();
      float system = in.float32();
      float user = in.float32();
      return new Cpu(idle, system, user);
    }

    @Override
    public void write(Writer out) {
      out.float32(idle);
      out.float32(system);
      out.float32(user);
    }
  }

  /**
   * Usage of a type of memory. (player_health_memory_t)
   *
   * @param total In byte.
   * @param used In byte.
   * @param free In byte.
   */
  public record Memory(long total, long used, long free) implements Struct {
    /** Every number 0, every list empty. */
    public Memory() {
      this(0L, 0L, 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Memory decode(byte[] body) {
      return Reader.decode("health.Memory", body, Memory::read);
    }

    static Memory read(Reader in) {
      long total = in.int64();
      long used = in.int64();
      long free = in.int64();
      return new Memory(total, used, free);
    }

    @Override
    public void write(Writer out) {
      out.int64(total);
      out.int64(used);
      out.int64(free);
    }
  }

  /**
   * Load of processor and memory. (player_health_data_t)
   *
   * @param cpuUsage Cpu usage.
   * @param mem Mem.
   * @param swap Swap.
   */
  public record Data(Cpu cpuUsage, Memory mem, Memory swap) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new Cpu(), new Memory(), new Memory());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("health.Data", body, Data::read);
    }

    static Data read(Reader in) {
      Cpu cpuUsage = Cpu.read(in);
      Memory mem = Memory.read(in);
      Memory swap = Memory.read(in);
      return new Data(cpuUsage, mem, swap);
    }

    @Override
    public void write(Writer out) {
      cpuUsage.write(out);
      mem.write(out);
      swap.write(out);
    }
  }

  /** Load of processor and memory. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(59, Kind.DATA, 1, "health.data.state", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE);

  private HealthMessages() {}
}
