// Generated from interfaces/005_sonar.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface sonar, code 5. An array of sonars. New drivers use the ranger interface. */
public final class SonarMessages {
  /** The interface's code. */
  public static final int CODE = 5;

  /**
   * One range per sonar. (player_sonar_data_t)
   *
   * @param ranges Range of the nearest echo, in the order of the geometry (in m).
   */
  public record Data(float[] ranges) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new float[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("sonar.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long rangesCount = in.uint32();
      float[] ranges = in.float32s(in.length("ranges", rangesCount, 4));
      return new Data(ranges);
    }

    @Override
    public void write(Writer out) {
      out.length("ranges", ranges.length, 8388598);
      out.length("ranges", ranges.length, 8388598);
      out.float32s(ranges);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && Arrays.equals(ranges, that.ranges);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(ranges);
    }
  }

  /**
   * Poses of the sonars. (player_sonar_geom_t)
   *
   * @param poses One per sonar; x points along its beam (in m, m, m, rad, rad, rad, frame X_RS).
   */
  public record Geom(List<CommonMessages.Pose3d> poses) implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("sonar.Geom", body, Geom::read);
    }

    static Geom read(Reader in) {
      long posesCount = in.uint32();
      List<CommonMessages.Pose3d> poses = in.structs(in.length("poses", posesCount, 48),
          CommonMessages.Pose3d::read);
      return new Geom(poses);
    }

    @Override
    public void write(Writer out) {
      out.length("poses", poses.size(), 699049);
      out.length("poses", poses.size(), 699049);
      out.structs(poses);
    }
  }

  /**
   * The sonars' switch. (player_sonar_power_config_t)
   *
   * @param state 1: on, 0: off.
   */
  public record PowerConfig(int state) implements Struct {
    /** Every number 0, every list empty. */
    public PowerConfig() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static PowerConfig decode(byte[] body) {
      return Reader.decode("sonar.PowerConfig", body, PowerConfig::read);
    }

    static PowerConfig read(Reader in) {
      int state = in.uint8();
      return new PowerConfig(state);
    }

    @Override
    public void write(Writer out) {
      out.uint8(state);
    }
  }

  /** Requests the poses of the sonars. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(5, Kind.REQ, 1, "sonar.req.get_geom", Geom::decode);

  /** Switches the sonars on or off. */
  public static final MessageType<PowerConfig> REQ_POWER =
      new MessageType<>(5, Kind.REQ, 2, "sonar.req.power", PowerConfig::decode);

  /** One range per sonar. */
  public static final MessageType<Data> DATA_RANGES =
      new MessageType<>(5, Kind.DATA, 1, "sonar.data.ranges", Data::decode);

  /** Poses of the sonars, sent on change. */
  public static final MessageType<Geom> DATA_GEOM =
      new MessageType<>(5, Kind.DATA, 2, "sonar.data.geom", Geom::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_GET_GEOM, REQ_POWER, DATA_RANGES, DATA_GEOM);

  private SonarMessages() {}
}
