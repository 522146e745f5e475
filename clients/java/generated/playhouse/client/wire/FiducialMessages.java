// Generated from interfaces/010_fiducial.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface fiducial, code 10. Detects markers and reports their ids and poses. */
public final class FiducialMessages {
  /** The interface's code. */
  public static final int CODE = 10;

  /**
   * One marker in view. (player_fiducial_item_t)
   *
   * @param id Id of the marker; -1 if it cannot be identified, from simulated finders 0.
   * @param pose Pose of the marker (in m, m, m, rad, rad, rad, frame X_ST).
   * @param upose Standard deviation of each component of the pose; 0 if unknown (in m, m, m, rad, rad, rad,
   *     frame X_ST).
   */
  public record Item(int id, CommonMessages.Pose3d pose, CommonMessages.Pose3d upose) implements Struct {
    /** Every number 0, every list empty. */
    public Item() {
      this(0, new CommonMessages.Pose3d(), new CommonMessages.Pose3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Item decode(byte[] body) {
      return Reader.decode("fiducial.Item", body, Item::read);
    }

    static Item read(Reader in) {
      int id = in.int32();
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      CommonMessages.Pose3d upose = CommonMessages.Pose3d.read(in);
      return new Item(id, pose, upose);
    }

    @Override
    public void write(Writer out) {
      out.int32(id);
      pose.write(out);
      upose.write(out);
    }
  }

  /**
   * The markers in view. (player_fiducial_data_t)
   *
   * @param fiducials Fiducials.
   */
  public record Data(List<Item> fiducials) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("fiducial.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long fiducialsCount = in.uint32();
      List<Item> fiducials = in.structs(in.length("fiducials", fiducialsCount, 100), Item::read);
      return new Data(fiducials);
    }

    @Override
    public void write(Writer out) {
      out.length("fiducials", fiducials.size(), 335543);
      out.length("fiducials", fiducials.size(), 335543);
      out.structs(fiducials);
    }
  }

  /**
   * Size and pose. (player_fiducial_geom_t)
   *
   * @param pose Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
   * @param size Bounding box of the device (in m, m, m).
   * @param fiducialSize Of the markers; 0 if unknown (in m, m).
   */
  public record Geom(
      CommonMessages.Pose3d pose, CommonMessages.Bbox3d size, CommonMessages.Bbox2d fiducialSize)
      implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Bbox3d(), new CommonMessages.Bbox2d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("fiducial.Geom", body, Geom::read);
    }

    static Geom read(Reader in) {
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      CommonMessages.Bbox3d size = CommonMessages.Bbox3d.read(in);
      CommonMessages.Bbox2d fiducialSize = CommonMessages.Bbox2d.read(in);
      return new Geom(pose, size, fiducialSize);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
      size.write(out);
      fiducialSize.write(out);
    }
  }

  /**
   * Range and field of view. (player_fiducial_fov_t)
   *
   * @param minRange In m.
   * @param maxRange In m.
   * @param viewAngle From the first to the last direction (in rad).
   */
  public record Fov(float minRange, float maxRange, float viewAngle) implements Struct {
    /** Every number 0, every list empty. */
    public Fov() {
      this(0f, 0f, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Fov decode(byte[] body) {
      return Reader.decode("fiducial.Fov", body, Fov::read);
    }

    static Fov read(Reader in) {
      float minRange = in.float32();
      float maxRange = in.float32();
      float viewAngle = in.float32();
      return new Fov(minRange, maxRange, viewAngle);
    }

    @Override
    public void write(Writer out) {
      out.float32(minRange);
      out.float32(maxRange);
      out.float32(viewAngle);
    }
  }

  /**
   * A marker id. (player_fiducial_id_t)
   *
   * @param id Id.
   */
  public record Id(long id) implements Struct {
    /** Every number 0, every list empty. */
    public Id() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Id decode(byte[] body) {
      return Reader.decode("fiducial.Id", body, Id::read);
    }

    static Id read(Reader in) {
      long id = in.uint32();
      return new Id(id);
    }

    @Override
    public void write(Writer out) {
      out.uint32(id);
    }
  }

  /** The markers in view. */
  public static final MessageType<Data> DATA_SCAN =
      new MessageType<>(10, Kind.DATA, 1, "fiducial.data.scan", Data::decode);

  /** Requests the device's size and pose and the markers' size. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(10, Kind.REQ, 1, "fiducial.req.get_geom", Geom::decode);

  /** Requests the range and the field of view. */
  public static final MessageType<Fov> REQ_GET_FOV =
      new MessageType<>(10, Kind.REQ, 2, "fiducial.req.get_fov", Fov::decode);

  /** Sets the range and the field of view; the answer has the values in effect. */
  public static final MessageType<Fov> REQ_SET_FOV =
      new MessageType<>(10, Kind.REQ, 3, "fiducial.req.set_fov", Fov::decode);

  /** Requests the robot's own marker id. */
  public static final MessageType<Id> REQ_GET_ID =
      new MessageType<>(10, Kind.REQ, 7, "fiducial.req.get_id", Id::decode);

  /** Sets the robot's own marker id. */
  public static final MessageType<Id> REQ_SET_ID =
      new MessageType<>(10, Kind.REQ, 8, "fiducial.req.set_id", Id::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_SCAN, REQ_GET_GEOM, REQ_GET_FOV, REQ_SET_FOV, REQ_GET_ID, REQ_SET_ID);

  private FiducialMessages() {}
}
