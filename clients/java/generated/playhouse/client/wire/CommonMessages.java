// Generated from interfaces/000_common.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** What every interface shares. Types shared by several interfaces, and requests to any device. */
public final class CommonMessages {
  // Limits shared by all implementations of the protocol.
  public static final int MAX_MESSAGE_SIZE = 8388608;
  public static final int MAX_DRIVER_STRING_LEN = 64;
  public static final int MAX_DEVICES = 4096;
  public static final int MSGQUEUE_DEFAULT_MAXLEN = 1024;
  public static final int IDENT_STRLEN = 32;
  public static final int KEYLEN = 32;

  /**
   * Address of a device. (player_devaddr_t)
   *
   * @param host Host of the device's server; receivers compare only interf and index.
   * @param robot TCP port of the device's server: its name space.
   * @param interf Interface code.
   * @param index Index of the device within its interface.
   */
  public record Devaddr(long host, long robot, int interf, int index) implements Struct {
    /** Every number 0, every list empty. */
    public Devaddr() {
      this(0L, 0L, 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Devaddr decode(byte[] body) {
      return Reader.decode("common.Devaddr", body, Devaddr::read);
    }

    static Devaddr read(Reader in) {
      long host = in.uint32();
      long robot = in.uint32();
      int interf = in.uint16();
      int index = in.uint16();
      return new Devaddr(host, robot, interf, index);
    }

    @Override
    public void write(Writer out) {
      out.uint32(host);
      out.uint32(robot);
      out.uint16(interf);
      out.uint16(index);
    }
  }

  /**
   * A point or vector in the plane. (player_point_2d_t)
   *
   * @param px In m.
   * @param py In m.
   */
  public record Point2d(double px, double py) implements Struct {
    /** Every number 0, every list empty. */
    public Point2d() {
      this(0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Point2d decode(byte[] body) {
      return Reader.decode("common.Point2d", body, Point2d::read);
    }

    static Point2d read(Reader in) {
      double px = in.float64();
      double py = in.float64();
      return new Point2d(px, py);
    }

    @Override
    public void write(Writer out) {
      out.float64(px);
      out.float64(py);
    }
  }

  /**
   * A point or vector in space. (player_point_3d_t)
   *
   * @param px In m.
   * @param py In m.
   * @param pz In m.
   */
  public record Point3d(double px, double py, double pz) implements Struct {
    /** Every number 0, every list empty. */
    public Point3d() {
      this(0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Point3d decode(byte[] body) {
      return Reader.decode("common.Point3d", body, Point3d::read);
    }

    static Point3d read(Reader in) {
      double px = in.float64();
      double py = in.float64();
      double pz = in.float64();
      return new Point3d(px, py, pz);
    }

    @Override
    public void write(Writer out) {
      out.float64(px);
      out.float64(py);
      out.float64(pz);
    }
  }

  /**
   * An orientation in space: rotations about z (yaw), then y (pitch), then x (roll).
   * (player_orientation_3d_t)
   *
   * @param proll About x (in rad).
   * @param ppitch About y (in rad).
   * @param pyaw About z (in rad).
   */
  public record Orientation3d(double proll, double ppitch, double pyaw) implements Struct {
    /** Every number 0, every list empty. */
    public Orientation3d() {
      this(0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Orientation3d decode(byte[] body) {
      return Reader.decode("common.Orientation3d", body, Orientation3d::read);
    }

    static Orientation3d read(Reader in) {
      double proll = in.float64();
      double ppitch = in.float64();
      double pyaw = in.float64();
      return new Orientation3d(proll, ppitch, pyaw);
    }

    @Override
    public void write(Writer out) {
      out.float64(proll);
      out.float64(ppitch);
      out.float64(pyaw);
    }
  }

  /**
   * A pose in the plane, or, if the message says so, a velocity with the same three components.
   * (player_pose2d_t)
   *
   * @param px In m.
   * @param py In m.
   * @param pa Heading, counter-clockwise from x (in rad).
   */
  public record Pose2d(double px, double py, double pa) implements Struct {
    /** Every number 0, every list empty. */
    public Pose2d() {
      this(0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Pose2d decode(byte[] body) {
      return Reader.decode("common.Pose2d", body, Pose2d::read);
    }

    static Pose2d read(Reader in) {
      double px = in.float64();
      double py = in.float64();
      double pa = in.float64();
      return new Pose2d(px, py, pa);
    }

    @Override
    public void write(Writer out) {
      out.float64(px);
      out.float64(py);
      out.float64(pa);
    }
  }

  /**
   * A pose in space, or, if the message says so, a velocity or acceleration with the same six components.
   * (player_pose3d_t)
   *
   * @param px In m.
   * @param py In m.
   * @param pz In m.
   * @param proll About x (in rad).
   * @param ppitch About y (in rad).
   * @param pyaw About z (in rad).
   */
  public record Pose3d(
      double px, double py, double pz, double proll, double ppitch, double pyaw)
      implements Struct {
    /** Every number 0, every list empty. */
    public Pose3d() {
      this(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Pose3d decode(byte[] body) {
      return Reader.decode("common.Pose3d", body, Pose3d::read);
    }

    static Pose3d read(Reader in) {
      double px = in.float64();
      double py = in.float64();
      double pz = in.float64();
      double proll = in.float64();
      double ppitch = in.float64();
      double pyaw = in.float64();
      return new Pose3d(px, py, pz, proll, ppitch, pyaw);
    }

    @Override
    public void write(Writer out) {
      out.float64(px);
      out.float64(py);
      out.float64(pz);
      out.float64(proll);
      out.float64(ppitch);
      out.float64(pyaw);
    }
  }

  /**
   * Size of a bounding rectangle. (player_bbox2d_t)
   *
   * @param sw Width, along y (in m).
   * @param sl Length, along x (in m).
   */
  public record Bbox2d(double sw, double sl) implements Struct {
    /** Every number 0, every list empty. */
    public Bbox2d() {
      this(0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Bbox2d decode(byte[] body) {
      return Reader.decode("common.Bbox2d", body, Bbox2d::read);
    }

    static Bbox2d read(Reader in) {
      double sw = in.float64();
      double sl = in.float64();
      return new Bbox2d(sw, sl);
    }

    @Override
    public void write(Writer out) {
      out.float64(sw);
      out.float64(sl);
    }
  }

  /**
   * Size of a bounding box. (player_bbox3d_t)
   *
   * @param sw Width, along y (in m).
   * @param sl Length, along x (in m).
   * @param sh Height, along z (in m).
   */
  public record Bbox3d(double sw, double sl, double sh) implements Struct {
    /** Every number 0, every list empty. */
    public Bbox3d() {
      this(0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Bbox3d decode(byte[] body) {
      return Reader.decode("common.Bbox3d", body, Bbox3d::read);
    }

    static Bbox3d read(Reader in) {
      double sw = in.float64();
      double sl = in.float64();
      double sh = in.float64();
      return new Bbox3d(sw, sl, sh);
    }

    @Override
    public void write(Writer out) {
      out.float64(sw);
      out.float64(sl);
      out.float64(sh);
    }
  }

  /**
   * One entry of a blackboard: a value under a key in a group. (player_blackboard_entry_t)
   *
   * @param key Name of the entry within its group.
   * @param group Name of the group, a namespace of keys.
   * @param type Category of `data`: simple values or types of other interfaces.
   * @param subtype Exact type of `data`; of simple values: string, integer or floating-point number.
   * @param data Bytes of the value, opaque to the blackboard.
   * @param timestampSec Time at which the value was set: whole seconds (in s).
   * @param timestampUsec Time at which the value was set: microseconds of the second (in us).
   */
  public record BlackboardEntry(
      byte[] key, byte[] group, int type, int subtype, byte[] data, long timestampSec, long timestampUsec)
      implements Struct {
    /** Every number 0, every list empty. */
    public BlackboardEntry() {
      this(new byte[0], new byte[0], 0, 0, new byte[0], 0L, 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static BlackboardEntry decode(byte[] body) {
      return Reader.decode("common.BlackboardEntry", body, BlackboardEntry::read);
    }

    static BlackboardEntry read(Reader in) {
      long keyCount = in.uint32();
      byte[] key = in.bytes(in.length("key", keyCount, 1));
      long groupCount = in.uint32();
      byte[] group = in.bytes(in.length("group", groupCount, 1));
      int type = in.uint16();
      int subtype = in.uint16();
      long dataCount = in.uint32();
      byte[] data = in.bytes(in.length("data", dataCount, 1));
      long timestampSec = in.uint32();
      long timestampUsec = in.uint32();
      return new BlackboardEntry(key, group, type, subtype, data, timestampSec, timestampUsec);
    }

    @Override
    public void write(Writer out) {
      out.length("key", key.length, 33554392);
      out.length("key", key.length, 33554392);
      out.bytes(key);
      out.length("group", group.length, 33554392);
      out.length("group", group.length, 33554392);
      out.bytes(group);
      out.uint16(type);
      out.uint16(subtype);
      out.length("data", data.length, 33554392);
      out.length("data", data.length, 33554392);
      out.bytes(data);
      out.uint32(timestampSec);
      out.uint32(timestampUsec);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof BlackboardEntry that && Arrays.equals(key, that.key)
          && Arrays.equals(group, that.group) && type == that.type && subtype == that.subtype
          && Arrays.equals(data, that.data) && timestampSec == that.timestampSec
          && timestampUsec == that.timestampUsec;
    }

    @Override
    public int hashCode() {
      return Objects.hash(type, subtype, timestampSec, timestampUsec, Arrays.hashCode(key),
          Arrays.hashCode(group), Arrays.hashCode(data));
    }
  }

  /**
   * A line segment. (player_segment_t)
   *
   * @param x0 x of the start (in m).
   * @param y0 y of the start (in m).
   * @param x1 x of the end (in m).
   * @param y1 y of the end (in m).
   */
  public record Segment(double x0, double y0, double x1, double y1) implements Struct {
    /** Every number 0, every list empty. */
    public Segment() {
      this(0.0, 0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Segment decode(byte[] body) {
      return Reader.decode("common.Segment", body, Segment::read);
    }

    static Segment read(Reader in) {
      double x0 = in.float64();
      double y0 = in.float64();
      double x1 = in.float64();
      double y1 = in.float64();
      return new Segment(x0, y0, x1, y1);
    }

    @Override
    public void write(Writer out) {
      out.float64(x0);
      out.float64(y0);
      out.float64(x1);
      out.float64(y1);
    }
  }

  /**
   * An axis-aligned rectangle, given by two corners. (player_extent2d_t)
   *
   * @param x0 Smallest x (in m).
   * @param y0 Smallest y (in m).
   * @param x1 Largest x (in m).
   * @param y1 Largest y (in m).
   */
  public record Extent2d(double x0, double y0, double x1, double y1) implements Struct {
    /** Every number 0, every list empty. */
    public Extent2d() {
      this(0.0, 0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Extent2d decode(byte[] body) {
      return Reader.decode("common.Extent2d", body, Extent2d::read);
    }

    static Extent2d read(Reader in) {
      double x0 = in.float64();
      double y0 = in.float64();
      double x1 = in.float64();
      double y1 = in.float64();
      return new Extent2d(x0, y0, x1, y1);
    }

    @Override
    public void write(Writer out) {
      out.float64(x0);
      out.float64(y0);
      out.float64(x1);
      out.float64(y1);
    }
  }

  /**
   * A color with opacity, each component from 0 to 255. (player_color_t)
   *
   * @param alpha 255 is opaque, 0 invisible.
   * @param red Red.
   * @param green Green.
   * @param blue Blue.
   */
  public record Color(int alpha, int red, int green, int blue) implements Struct {
    /** Every number 0, every list empty. */
    public Color() {
      this(0, 0, 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Color decode(byte[] body) {
      return Reader.decode("common.Color", body, Color::read);
    }

    static Color read(Reader in) {
      int alpha = in.uint8();
      int red = in.uint8();
      int green = in.uint8();
      int blue = in.uint8();
      return new Color(alpha, red, green, blue);
    }

    @Override
    public void write(Writer out) {
      out.uint8(alpha);
      out.uint8(red);
      out.uint8(green);
      out.uint8(blue);
    }
  }

  /**
   * A switch. (player_bool_t)
   *
   * @param state 0: off, else on.
   */
  public record Bool(int state) implements Struct {
    /** Every number 0, every list empty. */
    public Bool() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Bool decode(byte[] body) {
      return Reader.decode("common.Bool", body, Bool::read);
    }

    static Bool read(Reader in) {
      int state = in.uint8();
      return new Bool(state);
    }

    @Override
    public void write(Writer out) {
      out.uint8(state);
    }
  }

  /**
   * One integer. (player_uint32_t)
   *
   * @param value Value.
   */
  public record Uint32(long value) implements Struct {
    /** Every number 0, every list empty. */
    public Uint32() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Uint32 decode(byte[] body) {
      return Reader.decode("common.Uint32", body, Uint32::read);
    }

    static Uint32 read(Reader in) {
      long value = in.uint32();
      return new Uint32(value);
    }

    @Override
    public void write(Writer out) {
      out.uint32(value);
    }
  }

  /**
   * The queried message. (player_capabilities_req_t)
   *
   * @param type Type of the message, as in a header.
   * @param subtype Subtype of the message, as in a header.
   */
  public record CapabilitiesReq(long type, long subtype) implements Struct {
    /** Every number 0, every list empty. */
    public CapabilitiesReq() {
      this(0L, 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static CapabilitiesReq decode(byte[] body) {
      return Reader.decode("common.CapabilitiesReq", body, CapabilitiesReq::read);
    }

    static CapabilitiesReq read(Reader in) {
      long type = in.uint32();
      long subtype = in.uint32();
      return new CapabilitiesReq(type, subtype);
    }

    @Override
    public void write(Writer out) {
      out.uint32(type);
      out.uint32(subtype);
    }
  }

  /**
   * A named switch. (player_boolprop_req_t)
   *
   * @param key Name of the property, NUL-terminated.
   * @param value 0 false, else true; ignored in a request.
   */
  public record BoolpropReq(byte[] key, int value) implements Struct {
    /** Every number 0, every list empty. */
    public BoolpropReq() {
      this(new byte[0], 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static BoolpropReq decode(byte[] body) {
      return Reader.decode("common.BoolpropReq", body, BoolpropReq::read);
    }

    static BoolpropReq read(Reader in) {
      long keyCount = in.uint32();
      byte[] key = in.bytes(in.length("key", keyCount, 1));
      int value = in.int8();
      return new BoolpropReq(key, value);
    }

    @Override
    public void write(Writer out) {
      out.length("key", key.length, 33554392);
      out.length("key", key.length, 33554392);
      out.bytes(key);
      out.int8(value);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof BoolpropReq that && Arrays.equals(key, that.key) && value == that.value;
    }

    @Override
    public int hashCode() {
      return Objects.hash(value, Arrays.hashCode(key));
    }
  }

  /**
   * A named integer. (player_intprop_req_t)
   *
   * @param key Name of the property, NUL-terminated.
   * @param value Ignored in a question.
   */
  public record IntpropReq(byte[] key, int value) implements Struct {
    /** Every number 0, every list empty. */
    public IntpropReq() {
      this(new byte[0], 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static IntpropReq decode(byte[] body) {
      return Reader.decode("common.IntpropReq", body, IntpropReq::read);
    }

    static IntpropReq read(Reader in) {
      long keyCount = in.uint32();
      byte[] key = in.bytes(in.length("key", keyCount, 1));
      int value = in.int32();
      return new IntpropReq(key, value);
    }

    @Override
    public void write(Writer out) {
      out.length("key", key.length, 33554392);
      out.length("key", key.length, 33554392);
      out.bytes(key);
      out.int32(value);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof IntpropReq that && Arrays.equals(key, that.key) && value == that.value;
    }

    @Override
    public int hashCode() {
      return Objects.hash(value, Arrays.hashCode(key));
    }
  }

  /**
   * A named number. (player_dblprop_req_t)
   *
   * @param key Name of the property, NUL-terminated.
   * @param value In the driver's unit for the property; ignored in a request.
   */
  public record DblpropReq(byte[] key, double value) implements Struct {
    /** Every number 0, every list empty. */
    public DblpropReq() {
      this(new byte[0], 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DblpropReq decode(byte[] body) {
      return Reader.decode("common.DblpropReq", body, DblpropReq::read);
    }

    static DblpropReq read(Reader in) {
      long keyCount = in.uint32();
      byte[] key = in.bytes(in.length("key", keyCount, 1));
      double value = in.float64();
      return new DblpropReq(key, value);
    }

    @Override
    public void write(Writer out) {
      out.length("key", key.length, 33554392);
      out.length("key", key.length, 33554392);
      out.bytes(key);
      out.float64(value);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof DblpropReq that && Arrays.equals(key, that.key)
          && Double.compare(value, that.value) == 0;
    }

    @Override
    public int hashCode() {
      return Objects.hash(value, Arrays.hashCode(key));
    }
  }

  /**
   * A named string. (player_strprop_req_t)
   *
   * @param key Name of the property, NUL-terminated.
   * @param value NUL-terminated; ignored in a request.
   */
  public record StrpropReq(byte[] key, byte[] value) implements Struct {
    /** Every number 0, every list empty. */
    public StrpropReq() {
      this(new byte[0], new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static StrpropReq decode(byte[] body) {
      return Reader.decode("common.StrpropReq", body, StrpropReq::read);
    }

    static StrpropReq read(Reader in) {
      long keyCount = in.uint32();
      byte[] key = in.bytes(in.length("key", keyCount, 1));
      long valueCount = in.uint32();
      byte[] value = in.bytes(in.length("value", valueCount, 1));
      return new StrpropReq(key, value);
    }

    @Override
    public void write(Writer out) {
      out.length("key", key.length, 33554392);
      out.length("key", key.length, 33554392);
      out.bytes(key);
      out.length("value", value.length, 33554392);
      out.length("value", value.length, 33554392);
      out.bytes(value);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof StrpropReq that && Arrays.equals(key, that.key)
          && Arrays.equals(value, that.value);
    }

    @Override
    public int hashCode() {
      return Objects.hash(Arrays.hashCode(key), Arrays.hashCode(value));
    }
  }

  /** Queries whether the device supports a message: an empty ACK means yes, NACK no. */
  public static final MessageType<CapabilitiesReq> REQ_CAPABILITIES =
      new MessageType<>(0, Kind.REQ, 255, "universal.req.capabilities", CapabilitiesReq::decode);

  /** Reads a named integer of the driver; the answer repeats the key. */
  public static final MessageType<IntpropReq> REQ_GET_INTPROP =
      new MessageType<>(0, Kind.REQ, 254, "universal.req.get_intprop", IntpropReq::decode);

  /** Changes a named integer of the driver. */
  public static final MessageType<IntpropReq> REQ_SET_INTPROP =
      new MessageType<>(0, Kind.REQ, 253, "universal.req.set_intprop", IntpropReq::decode);

  /** Reads a named number of the driver; the answer repeats the key. */
  public static final MessageType<DblpropReq> REQ_GET_DBLPROP =
      new MessageType<>(0, Kind.REQ, 252, "universal.req.get_dblprop", DblpropReq::decode);

  /** Changes a named number of the driver. */
  public static final MessageType<DblpropReq> REQ_SET_DBLPROP =
      new MessageType<>(0, Kind.REQ, 251, "universal.req.set_dblprop", DblpropReq::decode);

  /** Reads a named string of the driver; the answer repeats the key. */
  public static final MessageType<StrpropReq> REQ_GET_STRPROP =
      new MessageType<>(0, Kind.REQ, 250, "universal.req.get_strprop", StrpropReq::decode);

  /** Changes a named string of the driver. */
  public static final MessageType<StrpropReq> REQ_SET_STRPROP =
      new MessageType<>(0, Kind.REQ, 249, "universal.req.set_strprop", StrpropReq::decode);

  /** Reads a named switch of the driver; the answer repeats the key. */
  public static final MessageType<BoolpropReq> REQ_GET_BOOLPROP =
      new MessageType<>(0, Kind.REQ, 248, "universal.req.get_boolprop", BoolpropReq::decode);

  /** Changes a named switch of the driver. */
  public static final MessageType<BoolpropReq> REQ_SET_BOOLPROP =
      new MessageType<>(0, Kind.REQ, 247, "universal.req.set_boolprop", BoolpropReq::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_CAPABILITIES, REQ_GET_INTPROP, REQ_SET_INTPROP, REQ_GET_DBLPROP, REQ_SET_DBLPROP, REQ_GET_STRPROP,
      REQ_SET_STRPROP, REQ_GET_BOOLPROP, REQ_SET_BOOLPROP);

  private CommonMessages() {}
}
