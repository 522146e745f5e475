// Generated from interfaces/042_map.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface map, code 42. Grid and vector maps. */
public final class MapMessages {
  /** The interface's code. */
  public static final int CODE = 42;

  /**
   * Size, scale and origin of the map. (player_map_info_t)
   *
   * @param scale Cell size (in m/pixel).
   * @param width In px.
   * @param height In px.
   * @param origin Of the lower left corner of cell (0, 0) (in m, m, rad, frame X_WM).
   */
  public record Info(float scale, long width, long height, CommonMessages.Pose2d origin) implements Struct {
    /** Every number 0, every list empty. */
    public Info() {
      this(0f, 0L, 0L, new CommonMessages.Pose2d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Info decode(byte[] body) {
      return Reader.decode("map.Info", body, Info::read);
    }

    static Info read(Reader in) {
      float scale = in.float32();
      long width = in.uint32();
      long height = in.uint32();
      CommonMessages.Pose2d origin = CommonMessages.Pose2d.read(in);
      return new Info(scale, width, height, origin);
    }

    @Override
    public void write(Writer out) {
      out.float32(scale);
      out.uint32(width);
      out.uint32(height);
      origin.write(out);
    }
  }

  /**
   * A rectangle of cells. (player_map_data_t)
   *
   * @param col First column, from the left (in px).
   * @param row First row, from the bottom (in px).
   * @param width In px.
   * @param height In px.
   * @param dataRange Value of a cell that is certainly occupied; its negative: certainly free, 0: unknown.
   * @param data Rows, concatenated; compressed with zlib in an answer, empty in a request.
   */
  public record Data(
      long col, long row, long width, long height, int dataRange, byte[] data)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0L, 0L, 0L, 0L, 0, new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("map.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long col = in.uint32();
      long row = in.uint32();
      long width = in.uint32();
      long height = in.uint32();
      long dataCount = in.uint32();
      int dataRange = in.int8();
      byte[] data = in.bytes(in.length("data", dataCount, 1));
      return new Data(col, row, width, height, dataRange, data);
    }

    @Override
    public void write(Writer out) {
      out.uint32(col);
      out.uint32(row);
      out.uint32(width);
      out.uint32(height);
      out.length("data", data.length, 33554392);
      out.int8(dataRange);
      out.length("data", data.length, 33554392);
      out.bytes(data);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && col == that.col && row == that.row && width == that.width
          && height == that.height && dataRange == that.dataRange && Arrays.equals(data, that.data);
    }

    @Override
    public int hashCode() {
      return Objects.hash(col, row, width, height, dataRange, Arrays.hashCode(data));
    }
  }

  /**
   * The map as line segments, and its extent. (player_map_data_vector_t)
   *
   * @param minx In m.
   * @param maxx In m.
   * @param miny In m.
   * @param maxy In m.
   * @param segments One per line (in m, frame p_MP).
   */
  public record DataVector(
      float minx, float maxx, float miny, float maxy, List<CommonMessages.Segment> segments)
      implements Struct {
    /** Every number 0, every list empty. */
    public DataVector() {
      this(0f, 0f, 0f, 0f, List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataVector decode(byte[] body) {
      return Reader.decode("map.DataVector", body, DataVector::read);
    }

    static DataVector read(Reader in) {
      float minx = in.float32();
      float maxx = in.float32();
      float miny = in.float32();
      float maxy = in.float32();
      long segmentsCount = in.uint32();
      List<CommonMessages.Segment> segments = in.structs(in.length("segments", segmentsCount, 32),
          CommonMessages.Segment::read);
      return new DataVector(minx, maxx, miny, maxy, segments);
    }

    @Override
    public void write(Writer out) {
      out.float32(minx);
      out.float32(maxx);
      out.float32(miny);
      out.float32(maxy);
      out.length("segments", segments.size(), 1048574);
      out.length("segments", segments.size(), 1048574);
      out.structs(segments);
    }
  }

  /** Size and scale of the map, sent on change. */
  public static final MessageType<Info> DATA_INFO =
      new MessageType<>(42, Kind.DATA, 1, "map.data.info", Info::decode);

  /** Requests the size and scale of the map. */
  public static final MessageType<Info> REQ_GET_INFO =
      new MessageType<>(42, Kind.REQ, 1, "map.req.get_info", Info::decode);

  /** Requests a rectangle of cells; the answer's cells are compressed with zlib. */
  public static final MessageType<Data> REQ_GET_DATA =
      new MessageType<>(42, Kind.REQ, 2, "map.req.get_data", Data::decode);

  /** Requests the map as lines. */
  public static final MessageType<DataVector> REQ_GET_VECTOR =
      new MessageType<>(42, Kind.REQ, 3, "map.req.get_vector", DataVector::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_INFO, REQ_GET_INFO, REQ_GET_DATA, REQ_GET_VECTOR);

  private MapMessages() {}
}
