// Generated from interfaces/014_bumper.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface bumper, code 14. Contact switches. */
public final class BumperMessages {
  /** The interface's code. */
  public static final int CODE = 14;

  /**
   * Which bumpers are pressed. (player_bumper_data_t)
   *
   * @param bumpers One per bumper: 0 free, else pressed.
   */
  public record Data(byte[] bumpers) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("bumper.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long bumpersCount = in.uint32();
      byte[] bumpers = in.bytes(in.length("bumpers", bumpersCount, 1));
      return new Data(bumpers);
    }

    @Override
    public void write(Writer out) {
      out.length("bumpers", bumpers.length, 33554392);
      out.length("bumpers", bumpers.length, 33554392);
      out.bytes(bumpers);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && Arrays.equals(bumpers, that.bumpers);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(bumpers);
    }
  }

  /**
   * One bumper. (player_bumper_define_t)
   *
   * @param pose Of the bumper's centre (in m, m, m, rad, rad, rad, frame X_RS).
   * @param length In m.
   * @param radius Radius of curvature; 0 if it is straight (in m).
   */
  public record Define(CommonMessages.Pose3d pose, float length, float radius) implements Struct {
    /** Every number 0, every list empty. */
    public Define() {
      this(new CommonMessages.Pose3d(), 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Define decode(byte[] body) {
      return Reader.decode("bumper.Define", body, Define::read);
    }

    static Define read(Reader in) {
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      float length = in.float32();
      float radius = in.float32();
      return new Define(pose, length, radius);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
      out.float32(length);
      out.float32(radius);
    }
  }

  /**
   * Poses of the bumpers. (player_bumper_geom_t)
   *
   * @param bumperDef Bumper def.
   */
  public record Geom(List<Define> bumperDef) implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("bumper.Geom", body, Geom::read);
    }

    static Geom read(Reader in) {
      long bumperDefCount = in.uint32();
      List<Define> bumperDef = in.structs(in.length("bumper_def", bumperDefCount, 56), Define::read);
      return new Geom(bumperDef);
    }

    @Override
    public void write(Writer out) {
      out.length("bumper_def", bumperDef.size(), 599185);
      out.length("bumper_def", bumperDef.size(), 599185);
      out.structs(bumperDef);
    }
  }

  /** Which bumpers are pressed. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(14, Kind.DATA, 1, "bumper.data.state", Data::decode);

  /** Poses of the bumpers, sent on change. */
  public static final MessageType<Geom> DATA_GEOM =
      new MessageType<>(14, Kind.DATA, 2, "bumper.data.geom", Geom::decode);

  /** Requests the poses of the bumpers. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(14, Kind.REQ, 1, "bumper.req.get_geom", Geom::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, DATA_GEOM, REQ_GET_GEOM);

  private BumperMessages() {}
}
