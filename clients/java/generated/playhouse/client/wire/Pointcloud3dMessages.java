// Generated from interfaces/061_pointcloud3d.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface pointcloud3d, code 61. Points in space with colors. */
public final class Pointcloud3dMessages {
  /** The interface's code. */
  public static final int CODE = 61;

  /**
   * One point. (player_pointcloud3d_element_t)
   *
   * @param point In m, frame p_SP.
   * @param color Color.
   */
  public record Element(CommonMessages.Point3d point, CommonMessages.Color color) implements Struct {
    /** Every number 0, every list empty. */
    public Element() {
      this(new CommonMessages.Point3d(), new CommonMessages.Color());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Element decode(byte[] body) {
      return Reader.decode("pointcloud3d.Element", body, Element::read);
    }

    static Element read(Reader in) {
      CommonMessages.Point3d point = CommonMessages.Point3d.read(in);
      CommonMessages.Color color = CommonMessages.Color.read(in);
      return new Element(point, color);
    }

    @Override
    public void write(Writer out) {
      point.write(out);
      color.write(out);
    }
  }

  /**
   * One cloud. (player_pointcloud3d_data_t)
   *
   * @param points Points.
   */
  public record Data(List<Element> points) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("pointcloud3d.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long pointsCount = in.uint32();
      List<Element> points = in.structs(in.length("points", pointsCount, 40), Element::read);
      return new Data(points);
    }

    @Override
    public void write(Writer out) {
      out.length("points", points.size(), 838859);
      out.length("points", points.size(), 838859);
      out.structs(points);
    }
  }

  /** One cloud. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(61, Kind.DATA, 1, "pointcloud3d.data.state", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE);

  private Pointcloud3dMessages() {}
}
