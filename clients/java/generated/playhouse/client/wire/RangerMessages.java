// Generated from interfaces/062_ranger.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;

/** Interface ranger, code 62. Range finders of any type: lasers, sonars, infrared, single or in arrays. */
public final class RangerMessages {
  /** The interface's code. */
  public static final int CODE = 62;

  /**
   * Angles, ranges and rate. (player_ranger_config_t)
   *
   * @param minAngle Of the first beam, counter-clockwise from x (in rad).
   * @param maxAngle Of the last beam (in rad).
   * @param angularRes Angle between neighbouring beams (in rad).
   * @param minRange Minimum range (in m).
   * @param maxRange Maximum range, and reported range of a beam without a hit (in m).
   * @param rangeRes Range resolution (in m).
   * @param frequency Scans per second (in Hz).
   */
  public record Config(
      double minAngle, double maxAngle, double angularRes, double minRange, double maxRange, double rangeRes,
      double frequency)
      implements Struct {
    /** Every number 0, every list empty. */
    public Config() {
      this(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Config decode(byte[] body) {
      return Reader.decode("ranger.Config", body, Config::read);
    }

    static Config read(Reader in) {
      double minAngle = in.float64();
      double maxAngle = in.float64();
      double angularRes = in.float64();
      double minRange = in.float64();
      double maxRange = in.float64();
      double rangeRes = in.float64();
      double frequency = in.float64();
      return new Config(minAngle, maxAngle, angularRes, minRange, maxRange, rangeRes, frequency);
    }

    @Override
    public void write(Writer out) {
      out.float64(minAngle);
      out.float64(maxAngle);
      out.float64(angularRes);
      out.float64(minRange);
      out.float64(maxRange);
      out.float64(rangeRes);
      out.float64(frequency);
    }
  }

  /**
   * Size and pose of the device and its elements. (player_ranger_geom_t)
   *
   * @param pose Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
   * @param size Bounding box of the device (in m, m, m).
   * @param elementPoses One per element; x points along its beam, or along the middle of its scan (in m, m,
   *     m, rad, rad, rad, frame X_SE).
   * @param elementSizes One per element (in m, m, m).
   */
  public record Geom(
      CommonMessages.Pose3d pose, CommonMessages.Bbox3d size, List<CommonMessages.Pose3d> elementPoses,
      List<CommonMessages.Bbox3d> elementSizes)
      implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Bbox3d(), List.of(), List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("ranger.Geom", body, Geom::read);
    }

    static Geom read(Reader in) {
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      CommonMessages.Bbox3d size = CommonMessages.Bbox3d.read(in);
      long elementPosesCount = in.uint32();
      List<CommonMessages.Pose3d> elementPoses = in.structs(in.length("element_poses", elementPosesCount, 48),
          CommonMessages.Pose3d::read);
      long elementSizesCount = in.uint32();
      List<CommonMessages.Bbox3d> elementSizes = in.structs(in.length("element_sizes", elementSizesCount, 24),
          CommonMessages.Bbox3d::read);
      return new Geom(pose, size, elementPoses, elementSizes);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
      size.write(out);
      out.length("element_poses", elementPoses.size(), 699049);
      out.length("element_poses", elementPoses.size(), 699049);
      out.structs(elementPoses);
      out.length("element_sizes", elementSizes.size(), 1398099);
      out.length("element_sizes", elementSizes.size(), 1398099);
      out.structs(elementSizes);
    }
  }

  /**
   * Ranges. (player_ranger_data_range_t)
   *
   * @param ranges Beam by beam from right to left, element by element (in m).
   */
  public record DataRange(double[] ranges) implements Struct {
    /** Every number 0, every list empty. */
    public DataRange() {
      this(new double[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataRange decode(byte[] body) {
      return Reader.decode("ranger.DataRange", body, DataRange::read);
    }

    static DataRange read(Reader in) {
      long rangesCount = in.uint32();
      double[] ranges = in.float64s(in.length("ranges", rangesCount, 8));
      return new DataRange(ranges);
    }

    @Override
    public void write(Writer out) {
      out.length("ranges", ranges.length, 4194299);
      out.length("ranges", ranges.length, 4194299);
      out.float64s(ranges);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof DataRange that && Arrays.equals(ranges, that.ranges);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(ranges);
    }
  }

  /**
   * Ranges with geometry and configuration. (player_ranger_data_rangestamped_t)
   *
   * @param data Data.
   * @param haveGeom 1 if `geom` is valid.
   * @param geom Geom.
   * @param haveConfig 1 if `config` is valid.
   * @param config Config.
   */
  public record DataRangestamped(
      DataRange data, int haveGeom, Geom geom, int haveConfig, Config config)
      implements Struct {
    /** Every number 0, every list empty. */
    public DataRangestamped() {
      this(new DataRange(), 0, new Geom(), 0, new Config());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataRangestamped decode(byte[] body) {
      return Reader.decode("ranger.DataRangestamped", body, DataRangestamped::read);
    }

    static DataRangestamped read(Reader in) {
      DataRange data = DataRange.read(in);
      int haveGeom = in.uint8();
      Geom geom = Geom.read(in);
      int haveConfig = in.uint8();
      Config config = Config.read(in);
      return new DataRangestamped(data, haveGeom, geom, haveConfig, config);
    }

    @Override
    public void write(Writer out) {
      data.write(out);
      out.uint8(haveGeom);
      geom.write(out);
      out.uint8(haveConfig);
      config.write(out);
    }
  }

  /**
   * Intensities. (player_ranger_data_intns_t)
   *
   * @param intensities In the order of the ranges; driver-specific scale.
   */
  public record DataIntns(double[] intensities) implements Struct {
    /** Every number 0, every list empty. */
    public DataIntns() {
      this(new double[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataIntns decode(byte[] body) {
      return Reader.decode("ranger.DataIntns", body, DataIntns::read);
    }

    static DataIntns read(Reader in) {
      long intensitiesCount = in.uint32();
      double[] intensities = in.float64s(in.length("intensities", intensitiesCount, 8));
      return new DataIntns(intensities);
    }

    @Override
    public void write(Writer out) {
      out.length("intensities", intensities.length, 4194299);
      out.length("intensities", intensities.length, 4194299);
      out.float64s(intensities);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof DataIntns that && Arrays.equals(intensities, that.intensities);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(intensities);
    }
  }

  /**
   * Intensities with geometry and configuration. (player_ranger_data_intnsstamped_t)
   *
   * @param data Data.
   * @param haveGeom 1 if `geom` is valid.
   * @param geom Geom.
   * @param haveConfig 1 if `config` is valid.
   * @param config Config.
   */
  public record DataIntnsstamped(
      DataIntns data, int haveGeom, Geom geom, int haveConfig, Config config)
      implements Struct {
    /** Every number 0, every list empty. */
    public DataIntnsstamped() {
      this(new DataIntns(), 0, new Geom(), 0, new Config());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataIntnsstamped decode(byte[] body) {
      return Reader.decode("ranger.DataIntnsstamped", body, DataIntnsstamped::read);
    }

    static DataIntnsstamped read(Reader in) {
      DataIntns data = DataIntns.read(in);
      int haveGeom = in.uint8();
      Geom geom = Geom.read(in);
      int haveConfig = in.uint8();
      Config config = Config.read(in);
      return new DataIntnsstamped(data, haveGeom, geom, haveConfig, config);
    }

    @Override
    public void write(Writer out) {
      data.write(out);
      out.uint8(haveGeom);
      geom.write(out);
      out.uint8(haveConfig);
      config.write(out);
    }
  }

  /**
   * The device's switch. (player_ranger_power_config_t)
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
      return Reader.decode("ranger.PowerConfig", body, PowerConfig::read);
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

  /**
   * The switch of intensities. (player_ranger_intns_config_t)
   *
   * @param state 1: on, 0: off.
   */
  public record IntnsConfig(int state) implements Struct {
    /** Every number 0, every list empty. */
    public IntnsConfig() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static IntnsConfig decode(byte[] body) {
      return Reader.decode("ranger.IntnsConfig", body, IntnsConfig::read);
    }

    static IntnsConfig read(Reader in) {
      int state = in.uint8();
      return new IntnsConfig(state);
    }

    @Override
    public void write(Writer out) {
      out.uint8(state);
    }
  }

  /** Ranges. */
  public static final MessageType<DataRange> DATA_RANGE =
      new MessageType<>(62, Kind.DATA, 1, "ranger.data.range", DataRange::decode);

  /** Ranges with the geometry and configuration of the measurement. */
  public static final MessageType<DataRangestamped> DATA_RANGESTAMPED =
      new MessageType<>(62, Kind.DATA, 2, "ranger.data.rangestamped", DataRangestamped::decode);

  /** Intensities. */
  public static final MessageType<DataIntns> DATA_INTNS =
      new MessageType<>(62, Kind.DATA, 3, "ranger.data.intns", DataIntns::decode);

  /** Intensities with the geometry and configuration of the measurement. */
  public static final MessageType<DataIntnsstamped> DATA_INTNSSTAMPED =
      new MessageType<>(62, Kind.DATA, 4, "ranger.data.intnsstamped", DataIntnsstamped::decode);

  /** Size and pose, sent on change. */
  public static final MessageType<Geom> DATA_GEOM =
      new MessageType<>(62, Kind.DATA, 5, "ranger.data.geom", Geom::decode);

  /** Requests size and pose. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(62, Kind.REQ, 1, "ranger.req.get_geom", Geom::decode);

  /** Switches the device on or off. */
  public static final MessageType<PowerConfig> REQ_POWER =
      new MessageType<>(62, Kind.REQ, 2, "ranger.req.power", PowerConfig::decode);

  /** Switches intensities on or off. */
  public static final MessageType<IntnsConfig> REQ_INTNS =
      new MessageType<>(62, Kind.REQ, 3, "ranger.req.intns", IntnsConfig::decode);

  /** Sets angles, ranges and rate; the answer has the values in effect. */
  public static final MessageType<Config> REQ_SET_CONFIG =
      new MessageType<>(62, Kind.REQ, 4, "ranger.req.set_config", Config::decode);

  /** Requests angles, ranges and rate. */
  public static final MessageType<Config> REQ_GET_CONFIG =
      new MessageType<>(62, Kind.REQ, 5, "ranger.req.get_config", Config::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_RANGE, DATA_RANGESTAMPED, DATA_INTNS, DATA_INTNSSTAMPED, DATA_GEOM, REQ_GET_GEOM, REQ_POWER,
      REQ_INTNS, REQ_SET_CONFIG, REQ_GET_CONFIG);

  private RangerMessages() {}
}
