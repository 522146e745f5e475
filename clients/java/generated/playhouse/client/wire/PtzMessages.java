// Generated from interfaces/008_ptz.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface ptz, code 8. A camera mount that pans, tilts and zooms. */
public final class PtzMessages {
  /** The interface's code. */
  public static final int CODE = 8;

  // Values of ReqControlMode.mode.
  public static final int VELOCITY_CONTROL = 0;
  public static final int POSITION_CONTROL = 1;

  /**
   * Direction of the mount. (player_ptz_data_t)
   *
   * @param pan Positive to the left (in rad).
   * @param tilt Positive upwards (in rad).
   * @param zoom Field of view (in rad).
   * @param panspeed Positive to the left (in rad/s).
   * @param tiltspeed Positive upwards (in rad/s).
   * @param status Driver-specific.
   */
  public record Data(
      float pan, float tilt, float zoom, float panspeed, float tiltspeed, long status)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0f, 0f, 0f, 0f, 0f, 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("ptz.Data", body, Data::read);
    }

    static Data read(Reader in) {
      float pan = in.float32();
      float tilt = in.float32();
      float zoom = in.float32();
      float panspeed = in.float32();
      float tiltspeed = in.float32();
      long status = in.uint32();
      return new Data(pan, tilt, zoom, panspeed, tiltspeed, status);
    }

    @Override
    public void write(Writer out) {
      out.float32(pan);
      out.float32(tilt);
      out.float32(zoom);
      out.float32(panspeed);
      out.float32(tiltspeed);
      out.uint32(status);
    }
  }

  /**
   * Commanded direction or velocity of the mount. (player_ptz_cmd_t)
   *
   * @param pan Positive to the left (in rad).
   * @param tilt Positive upwards (in rad).
   * @param zoom Field of view (in rad).
   * @param panspeed Used by velocity control (in rad/s).
   * @param tiltspeed Used by velocity control (in rad/s).
   */
  public record Cmd(float pan, float tilt, float zoom, float panspeed, float tiltspeed) implements Struct {
    /** Every number 0, every list empty. */
    public Cmd() {
      this(0f, 0f, 0f, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Cmd decode(byte[] body) {
      return Reader.decode("ptz.Cmd", body, Cmd::read);
    }

    static Cmd read(Reader in) {
      float pan = in.float32();
      float tilt = in.float32();
      float zoom = in.float32();
      float panspeed = in.float32();
      float tiltspeed = in.float32();
      return new Cmd(pan, tilt, zoom, panspeed, tiltspeed);
    }

    @Override
    public void write(Writer out) {
      out.float32(pan);
      out.float32(tilt);
      out.float32(zoom);
      out.float32(panspeed);
      out.float32(tiltspeed);
    }
  }

  /**
   * The mount's status. (player_ptz_req_status_t)
   *
   * @param status Driver-specific.
   */
  public record ReqStatus(long status) implements Struct {
    /** Every number 0, every list empty. */
    public ReqStatus() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static ReqStatus decode(byte[] body) {
      return Reader.decode("ptz.ReqStatus", body, ReqStatus::read);
    }

    static ReqStatus read(Reader in) {
      long status = in.uint32();
      return new ReqStatus(status);
    }

    @Override
    public void write(Writer out) {
      out.uint32(status);
    }
  }

  /**
   * The mount's size and pose. (player_ptz_geom_t)
   *
   * @param pos Pose of the mount on the robot (in m, m, m, rad, rad, rad, frame X_RS).
   * @param size Bounding box of the mount (in m, m, m).
   */
  public record Geom(CommonMessages.Pose3d pos, CommonMessages.Bbox3d size) implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Bbox3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("ptz.Geom", body, Geom::read);
    }

    static Geom read(Reader in) {
      CommonMessages.Pose3d pos = CommonMessages.Pose3d.read(in);
      CommonMessages.Bbox3d size = CommonMessages.Bbox3d.read(in);
      return new Geom(pos, size);
    }

    @Override
    public void write(Writer out) {
      pos.write(out);
      size.write(out);
    }
  }

  /**
   * Driver-specific words. (player_ptz_req_generic_t)
   *
   * @param config Driver-specific.
   */
  public record ReqGeneric(long[] config) implements Struct {
    /** Every number 0, every list empty. */
    public ReqGeneric() {
      this(new long[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static ReqGeneric decode(byte[] body) {
      return Reader.decode("ptz.ReqGeneric", body, ReqGeneric::read);
    }

    static ReqGeneric read(Reader in) {
      long configCount = in.uint32();
      long[] config = in.uint32s(in.length("config", configCount, 4));
      return new ReqGeneric(config);
    }

    @Override
    public void write(Writer out) {
      out.length("config", config.length, 8388598);
      out.length("config", config.length, 8388598);
      out.uint32s(config);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof ReqGeneric that && Arrays.equals(config, that.config);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(config);
    }
  }

  /**
   * A control mode. (player_ptz_req_control_mode_t)
   *
   * @param mode Velocity or position.
   */
  public record ReqControlMode(long mode) implements Struct {
    /** Every number 0, every list empty. */
    public ReqControlMode() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static ReqControlMode decode(byte[] body) {
      return Reader.decode("ptz.ReqControlMode", body, ReqControlMode::read);
    }

    static ReqControlMode read(Reader in) {
      long mode = in.uint32();
      return new ReqControlMode(mode);
    }

    @Override
    public void write(Writer out) {
      out.uint32(mode);
    }
  }

  /** Exchanges driver-specific words with the mount. */
  public static final MessageType<ReqGeneric> REQ_GENERIC =
      new MessageType<>(8, Kind.REQ, 1, "ptz.req.generic", ReqGeneric::decode);

  /** Selects between velocity and position control. */
  public static final MessageType<ReqControlMode> REQ_CONTROL_MODE =
      new MessageType<>(8, Kind.REQ, 2, "ptz.req.control_mode", ReqControlMode::decode);

  /** Requests size and pose. */
  public static final MessageType<Geom> REQ_GEOM =
      new MessageType<>(8, Kind.REQ, 4, "ptz.req.geom", Geom::decode);

  /** Requests the mount's status. */
  public static final MessageType<ReqStatus> REQ_STATUS =
      new MessageType<>(8, Kind.REQ, 5, "ptz.req.status", ReqStatus::decode);

  /** Direction of the mount. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(8, Kind.DATA, 1, "ptz.data.state", Data::decode);

  /** Size and pose, sent on change. */
  public static final MessageType<Geom> DATA_GEOM =
      new MessageType<>(8, Kind.DATA, 2, "ptz.data.geom", Geom::decode);

  /** Commanded direction of the mount. */
  public static final MessageType<Cmd> CMD_STATE =
      new MessageType<>(8, Kind.CMD, 1, "ptz.cmd.state", Cmd::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_GENERIC, REQ_CONTROL_MODE, REQ_GEOM, REQ_STATUS, DATA_STATE, DATA_GEOM, CMD_STATE);

  private PtzMessages() {}
}
