// Generated from interfaces/055_graphics2d.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface graphics2d, code 55. Draws 2D shapes for display. */
public final class Graphics2dMessages {
  /** The interface's code. */
  public static final int CODE = 55;

  /**
   * Points. (player_graphics2d_cmd_points_t)
   *
   * @param points In m, frame p_SP.
   * @param color Color.
   */
  public record CmdPoints(List<CommonMessages.Point2d> points, CommonMessages.Color color) implements Struct {
    /** Every number 0, every list empty. */
    public CmdPoints() {
      this(List.of(), new CommonMessages.Color());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdPoints decode(byte[] body) {
      return Reader.decode("graphics2d.CmdPoints", body, CmdPoints::read);
    }

    static CmdPoints read(Reader in) {
      long pointsCount = in.uint32();
      List<CommonMessages.Point2d> points = in.structs(in.length("points", pointsCount, 16),
          CommonMessages.Point2d::read);
      CommonMessages.Color color = CommonMessages.Color.read(in);
      return new CmdPoints(points, color);
    }

    @Override
    public void write(Writer out) {
      out.length("points", points.size(), 2097149);
      out.length("points", points.size(), 2097149);
      out.structs(points);
      color.write(out);
    }
  }

  /**
   * A line through points. (player_graphics2d_cmd_polyline_t)
   *
   * @param points In m, frame p_SP.
   * @param color Color.
   */
  public record CmdPolyline(
      List<CommonMessages.Point2d> points, CommonMessages.Color color)
      implements Struct {
    /** Every number 0, every list empty. */
    public CmdPolyline() {
      this(List.of(), new CommonMessages.Color());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdPolyline decode(byte[] body) {
      return Reader.decode("graphics2d.CmdPolyline", body, CmdPolyline::read);
    }

    static CmdPolyline read(Reader in) {
      long pointsCount = in.uint32();
      List<CommonMessages.Point2d> points = in.structs(in.length("points", pointsCount, 16),
          CommonMessages.Point2d::read);
      CommonMessages.Color color = CommonMessages.Color.read(in);
      return new CmdPolyline(points, color);
    }

    @Override
    public void write(Writer out) {
      out.length("points", points.size(), 2097149);
      out.length("points", points.size(), 2097149);
      out.structs(points);
      color.write(out);
    }
  }

  /**
   * A polygon. (player_graphics2d_cmd_polygon_t)
   *
   * @param points Vertices (in m, frame p_SP).
   * @param color Outline color.
   * @param fillColor Fill color.
   * @param filled 1: filled.
   */
  public record CmdPolygon(
      List<CommonMessages.Point2d> points, CommonMessages.Color color, CommonMessages.Color fillColor, int
      filled)
      implements Struct {
    /** Every number 0, every list empty. */
    public CmdPolygon() {
      this(List.of(), new CommonMessages.Color(), new CommonMessages.Color(), 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdPolygon decode(byte[] body) {
      return Reader.decode("graphics2d.CmdPolygon", body, CmdPolygon::read);
    }

    static CmdPolygon read(Reader in) {
      long pointsCount = in.uint32();
      List<CommonMessages.Point2d> points = in.structs(in.length("points", pointsCount, 16),
          CommonMessages.Point2d::read);
      CommonMessages.Color color = CommonMessages.Color.read(in);
      CommonMessages.Color fillColor = CommonMessages.Color.read(in);
      int filled = in.uint8();
      return new CmdPolygon(points, color, fillColor, filled);
    }

    @Override
    public void write(Writer out) {
      out.length("points", points.size(), 2097149);
      out.length("points", points.size(), 2097149);
      out.structs(points);
      color.write(out);
      fillColor.write(out);
      out.uint8(filled);
    }
  }

  /**
   * Lines, each between two points. (player_graphics2d_cmd_multiline_t)
   *
   * @param points Start and end of each line, alternating (in m, frame p_SP).
   * @param color Color.
   */
  public record CmdMultiline(
      List<CommonMessages.Point2d> points, CommonMessages.Color color)
      implements Struct {
    /** Every number 0, every list empty. */
    public CmdMultiline() {
      this(List.of(), new CommonMessages.Color());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CmdMultiline decode(byte[] body) {
      return Reader.decode("graphics2d.CmdMultiline", body, CmdMultiline::read);
    }

    static CmdMultiline read(Reader in) {
      long pointsCount = in.uint32();
      List<CommonMessages.Point2d> points = in.structs(in.length("points", pointsCount, 16),
          CommonMessages.Point2d::read);
      CommonMessages.Color color = CommonMessages.Color.read(in);
      return new CmdMultiline(points, color);
    }

    @Override
    public void write(Writer out) {
      out.length("points", points.size(), 2097149);
      out.length("points", points.size(), 2097149);
      out.structs(points);
      color.write(out);
    }
  }

  /** Removes all drawn shapes. */
  public static final MessageType<Nothing> CMD_CLEAR =
      new MessageType<>(55, Kind.CMD, 1, "graphics2d.cmd.clear", null);

  /** Draws points. */
  public static final MessageType<CmdPoints> CMD_POINTS =
      new MessageType<>(55, Kind.CMD, 2, "graphics2d.cmd.points", CmdPoints::decode);

  /** Draws a line through points. */
  public static final MessageType<CmdPolyline> CMD_POLYLINE =
      new MessageType<>(55, Kind.CMD, 3, "graphics2d.cmd.polyline", CmdPolyline::decode);

  /** Draws a polygon. */
  public static final MessageType<CmdPolygon> CMD_POLYGON =
      new MessageType<>(55, Kind.CMD, 4, "graphics2d.cmd.polygon", CmdPolygon::decode);

  /** Draws a line for each pair of points. */
  public static final MessageType<CmdMultiline> CMD_MULTILINE =
      new MessageType<>(55, Kind.CMD, 5, "graphics2d.cmd.multiline", CmdMultiline::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      CMD_CLEAR, CMD_POINTS, CMD_POLYLINE, CMD_POLYGON, CMD_MULTILINE);

  private Graphics2dMessages() {}
}
