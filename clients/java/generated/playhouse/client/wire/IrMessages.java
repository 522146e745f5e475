// Generated from interfaces/022_ir.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface ir, code 22. An array of infrared range finders. New drivers use the ranger interface. */
public final class IrMessages {
  /** The interface's code. */
  public static final int CODE = 22;

  /**
   * Measurements of the sensors. (player_ir_data_t)
   *
   * @param voltages One per sensor, as measured (in V).
   * @param ranges One per sensor, computed from the voltage (in m).
   */
  public record Data(float[] voltages, float[] ranges) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new float[0], new float[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("ir.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long voltagesCount = in.uint32();
      float[] voltages = in.float32s(in.length("voltages", voltagesCount, 4));
      long rangesCount = in.uint32();
      float[] ranges = in.float32s(in.length("ranges", rangesCount, 4));
      return new Data(voltages, ranges);
    }

    @Override
    public void write(Writer out) {
      out.length("voltages", voltages.length, 8388598);
      out.length("voltages", voltages.length, 8388598);
      out.float32s(voltages);
      out.length("ranges", ranges.length, 8388598);
      out.length("ranges", ranges.length, 8388598);
      out.float32s(ranges);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && Arrays.equals(voltages, that.voltages)
          && Arrays.equals(ranges, that.ranges);
    }

    @Override
    public int hashCode() {
      return Objects.hash(Arrays.hashCode(voltages), Arrays.hashCode(ranges));
    }
  }

  /**
   * Poses of the sensors. (player_ir_pose_t)
   *
   * @param poses One per sensor; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS).
   */
  public record Pose(List<CommonMessages.Pose3d> poses) implements Struct {
    /** Every number 0, every list empty. */
    public Pose() {
      this(List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Pose decode(byte[] body) {
      return Reader.decode("ir.Pose", body, Pose::read);
    }

    static Pose read(Reader in) {
      long posesCount = in.uint32();
      List<CommonMessages.Pose3d> poses = in.structs(in.length("poses", posesCount, 48),
          CommonMessages.Pose3d::read);
      return new Pose(poses);
    }

    @Override
    public void write(Writer out) {
      out.length("poses", poses.size(), 699049);
      out.length("poses", poses.size(), 699049);
      out.structs(poses);
    }
  }

  /**
   * The sensors' switch. (player_ir_power_req_t)
   *
   * @param state 1: on, 0: off.
   */
  public record PowerReq(int state) implements Struct {
    /** Every number 0, every list empty. */
    public PowerReq() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PowerReq decode(byte[] body) {
      return Reader.decode("ir.PowerReq", body, PowerReq::read);
    }

    static PowerReq read(Reader in) {
      int state = in.uint8();
      return new PowerReq(state);
    }

    @Override
    public void write(Writer out) {
      out.uint8(state);
    }
  }

  /** Requests the poses of the sensors. */
  public static final MessageType<Pose> REQ_POSE =
      new MessageType<>(22, Kind.REQ, 1, "ir.req.pose", Pose::decode);

  /** Switches the sensors on or off. */
  public static final MessageType<PowerReq> REQ_POWER =
      new MessageType<>(22, Kind.REQ, 2, "ir.req.power", PowerReq::decode);

  /** Voltages and ranges. */
  public static final MessageType<Data> DATA_RANGES =
      new MessageType<>(22, Kind.DATA, 1, "ir.data.ranges", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_POSE, REQ_POWER, DATA_RANGES);

  private IrMessages() {}
}
