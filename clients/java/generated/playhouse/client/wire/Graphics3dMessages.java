// Generated from interfaces/058_graphics3d.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface graphics3d, code 58. Draws 3D shapes for display. */
public final class Graphics3dMessages {
  /** The interface's code. */
  public static final int CODE = 58;

  // Values of CmdDraw.draw_mode: primitives made from the points.
  public static final int DRAW_POINTS = 0;
  public static final int DRAW_LINES = 1;
  public static final int DRAW_LINE_STRIP = 2;
  public static final int DRAW_LINE_LOOP = 3;
  public static final int DRAW_TRIANGLES = 4;
  public static final int DRAW_TRIANGLE_STRIP = 5;
  public static final int DRAW_TRIANGLE_FAN = 6;
  public static final int DRAW_QUADS = 7;
  public static final int DRAW_QUAD_STRIP = 8;
  public static final int DRAW_POLYGON = 9;

  /**
   * Points, lines or faces. (player_graphics3d_cmd_draw_t)
   *
   * @param drawMode Draw mode.
   * @param points In m, frame p_SP.
   * @param color Color.
   */
  public record CmdDraw(
      long drawMode, List<CommonMessages.Point3d> points, CommonMessages.Color color)
      implements Struct {
    /** Every number 0, every list empty. */
    public CmdDraw() {
      this(0L, List.of(), new CommonMessages.Color());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdDraw decode(byte[] body) {
      return Reader.decode("graphics3d.CmdDraw", body, CmdDraw::read);
    }

    static CmdDraw read(Reader in) {
      long drawMode = in.uint32();
      long pointsCount = in.uint32();
      List<CommonMessages.Point3d> points = in.structs(in.length("points", pointsCount, 24),
          CommonMessages.Point3d::read);
      CommonMessages.Color color = CommonMessages.Color.read(in);
      return new CmdDraw(drawMode, points, color);
    }

    @Override
    public void write(Writer out) {
      out.uint32(drawMode);
      out.length("points", points.size(), 1398099);
      out.length("points", points.size(), 1398099);
      out.structs(points);
      color.write(out);
    }
  }

  /**
   * A translation of the coordinate frame. (player_graphics3d_cmd_translate_t)
   *
   * @param x In m.
   * @param y In m.
   * @param z In m.
   */
  public record CmdTranslate(double x, double y, double z) implements Struct {
    /** Every number 0, every list empty. */
    public CmdTranslate() {
      this(0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdTranslate decode(byte[] body) {
      return Reader.decode("graphics3d.CmdTranslate", body, CmdTranslate::read);
    }

    static CmdTranslate read(Reader in) {
      double x = in.float64();
      double y = in.float64();
      double z = in.float64();
      return new CmdTranslate(x, y, z);
    }

    @Override
    public void write(Writer out) {
      out.float64(x);
      out.float64(y);
      out.float64(z);
    }
  }

  /**
   * A rotation of the coordinate frame. (player_graphics3d_cmd_rotate_t)
   *
   * @param a Angle about the vector (x, y, z) (in rad).
   * @param x X.
   * @param y Y.
   * @param z Z.
   */
  public record CmdRotate(double a, double x, double y, double z) implements Struct {
    /** Every number 0, every list empty. */
    public CmdRotate() {
      this(0.0, 0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdRotate decode(byte[] body) {
      return Reader.decode("graphics3d.CmdRotate", body, CmdRotate::read);
    }

    static CmdRotate read(Reader in) {
      double a = in.float64();
      double x = in.float64();
      double y = in.float64();
      double z = in.float64();
      return new CmdRotate(a, x, y, z);
    }

    @Override
    public void write(Writer out) {
      out.float64(a);
      out.float64(x);
      out.float64(y);
      out.float64(z);
    }
  }

  /** Removes all drawn shapes. */
  public static final MessageType<Nothing> CMD_CLEAR =
      new MessageType<>(58, Kind.CMD, 1, "graphics3d.cmd.clear", null);

  /** Draws points, lines or faces. */
  public static final MessageType<CmdDraw> CMD_DRAW =
      new MessageType<>(58, Kind.CMD, 2, "graphics3d.cmd.draw", CmdDraw::decode);

  /** Translates the coordinate frame of subsequent drawing. */
  public static final MessageType<CmdTranslate> CMD_TRANSLATE =
      new MessageType<>(58, Kind.CMD, 3, "graphics3d.cmd.translate", CmdTranslate::decode);

  /** Rotates the coordinate frame of subsequent drawing. */
  public static final MessageType<CmdRotate> CMD_ROTATE =
      new MessageType<>(58, Kind.CMD, 4, "graphics3d.cmd.rotate", CmdRotate::decode);

  /** Pushes the current coordinate frame. */
  public static final MessageType<Nothing> CMD_PUSH =
      new MessageType<>(58, Kind.CMD, 5, "graphics3d.cmd.push", null);

  /** Pops the pushed coordinate frame. */
  public static final MessageType<Nothing> CMD_POP =
      new MessageType<>(58, Kind.CMD, 6, "graphics3d.cmd.pop", null);

  static final List<MessageType<?>> MESSAGES = List.of(
      CMD_CLEAR, CMD_DRAW, CMD_TRANSLATE, CMD_ROTATE, CMD_PUSH, CMD_POP);

  private Graphics3dMessages() {}
}
