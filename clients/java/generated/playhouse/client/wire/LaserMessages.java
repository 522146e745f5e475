// Generated from interfaces/006_laser.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface laser, code 6. A scanning range finder. New drivers use the ranger interface. */
public final class LaserMessages {
  /** The interface's code. */
  public static final int CODE = 6;

  // Largest number of filter parameters.
  public static final int MAX_FILTER_PARAMS = 8;

  // Values of SetFilterConfig.filter_type.
  public static final int FILTER_MEDIAN = 1;
  public static final int FILTER_EDGE = 2;
  public static final int FILTER_RANGE = 3;
  public static final int FILTER_MEAN = 4;

  /**
   * One scan at equal angles. (player_laser_data_t)
   *
   * @param minAngle Of the first beam, counter-clockwise from x (in rad).
   * @param maxAngle Of the last beam (in rad).
   * @param resolution Angle between neighbouring beams (in rad).
   * @param maxRange Reported range of a beam without a hit (in m).
   * @param ranges From right to left (in m).
   * @param intensity Intensity of the echo per beam; empty if the device has none.
   * @param id Increases from scan to scan, by one or more.
   */
  public record Data(
      float minAngle, float maxAngle, float resolution, float maxRange, float[] ranges, byte[] intensity, long
      id)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0f, 0f, 0f, 0f, new float[0], new byte[0], 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("laser.Data", body, Data::read);
    }

    static Data read(Reader in) {
      float minAngle = in.float32();
      float maxAngle = in.float32();
      float resolution = in.float32();
      float maxRange = in.float32();
      long rangesCount = in.uint32();
      float[] ranges = in.float32s(in.length("ranges", rangesCount, 4));
      long intensityCount = in.uint32();
      byte[] intensity = in.bytes(in.length("intensity", intensityCount, 1));
      long id = in.uint32();
      return new Data(minAngle, maxAngle, resolution, maxRange, ranges, intensity, id);
    }

    @Override
    public void write(Writer out) {
      out.float32(minAngle);
      out.float32(maxAngle);
      out.float32(resolution);
      out.float32(maxRange);
      out.length("ranges", ranges.length, 8388598);
      out.length("ranges", ranges.length, 8388598);
      out.float32s(ranges);
      out.length("intensity", intensity.length, 33554392);
      out.length("intensity", intensity.length, 33554392);
      out.bytes(intensity);
      out.uint32(id);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && Float.compare(minAngle, that.minAngle) == 0
          && Float.compare(maxAngle, that.maxAngle) == 0 && Float.compare(resolution, that.resolution) == 0
          && Float.compare(maxRange, that.maxRange) == 0 && Arrays.equals(ranges, that.ranges)
          && Arrays.equals(intensity, that.intensity) && id == that.id;
    }

    @Override
    public int hashCode() {
      return Objects.hash(minAngle, maxAngle, resolution, maxRange, id, Arrays.hashCode(ranges),
          Arrays.hashCode(intensity));
    }
  }

  /**
   * One scan and the pose at which it was measured. (player_laser_data_scanpose_t)
   *
   * @param scan Scan.
   * @param pose Of the robot at the time of the scan (in m, m, rad, frame X_OR).
   */
  public record DataScanpose(Data scan, CommonMessages.Pose2d pose) implements Struct {
    /** Every number 0, every list empty. */
    public DataScanpose() {
      this(new Data(), new CommonMessages.Pose2d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataScanpose decode(byte[] body) {
      return Reader.decode("laser.DataScanpose", body, DataScanpose::read);
    }

    static DataScanpose read(Reader in) {
      Data scan = Data.read(in);
      CommonMessages.Pose2d pose = CommonMessages.Pose2d.read(in);
      return new DataScanpose(scan, pose);
    }

    @Override
    public void write(Writer out) {
      scan.write(out);
      pose.write(out);
    }
  }

  /**
   * One scan with an angle per beam. (player_laser_data_scanangle_t)
   *
   * @param maxRange Reported range of a beam without a hit (in m).
   * @param ranges One per beam (in m).
   * @param angles One per beam, counter-clockwise from x (in rad).
   * @param intensity Intensity of the echo per beam; empty if the device has none.
   * @param id Increases from scan to scan, by one or more.
   */
  public record DataScanangle(
      float maxRange, float[] ranges, float[] angles, byte[] intensity, long id)
      implements Struct {
    /** Every number 0, every list empty. */
    public DataScanangle() {
      this(0f, new float[0], new float[0], new byte[0], 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DataScanangle decode(byte[] body) {
      return Reader.decode("laser.DataScanangle", body, DataScanangle::read);
    }

    static DataScanangle read(Reader in) {
      float maxRange = in.float32();
      long rangesCount = in.uint32();
      float[] ranges = in.float32s(in.length("ranges", rangesCount, 4));
      long anglesCount = in.uint32();
      float[] angles = in.float32s(in.length("angles", anglesCount, 4));
      long intensityCount = in.uint32();
      byte[] intensity = in.bytes(in.length("intensity", intensityCount, 1));
      long id = in.uint32();
      return new DataScanangle(maxRange, ranges, angles, intensity, id);
    }

    @Override
    public void write(Writer out) {
      out.float32(maxRange);
      out.length("ranges", ranges.length, 8388598);
      out.length("ranges", ranges.length, 8388598);
      out.float32s(ranges);
      out.length("angles", angles.length, 8388598);
      out.length("angles", angles.length, 8388598);
      out.float32s(angles);
      out.length("intensity", intensity.length, 33554392);
      out.length("intensity", intensity.length, 33554392);
      out.bytes(intensity);
      out.uint32(id);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof DataScanangle that && Float.compare(maxRange, that.maxRange) == 0
          && Arrays.equals(ranges, that.ranges) && Arrays.equals(angles, that.angles)
          && Arrays.equals(intensity, that.intensity) && id == that.id;
    }

    @Override
    public int hashCode() {
      return Objects.hash(maxRange, id, Arrays.hashCode(ranges), Arrays.hashCode(angles),
          Arrays.hashCode(intensity));
    }
  }

  /**
   * The device's size and pose. (player_laser_geom_t)
   *
   * @param pose Pose of the device on the robot (in m, m, m, rad, rad, rad, frame X_RS).
   * @param size Bounding box of the device (in m, m, m).
   */
  public record Geom(CommonMessages.Pose3d pose, CommonMessages.Bbox3d size) implements Struct {
    /** Every number 0, every list empty. */
    public Geom() {
      this(new CommonMessages.Pose3d(), new CommonMessages.Bbox3d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Geom decode(byte[] body) {
      return Reader.decode("laser.Geom", body, Geom::read);
    }

    static Geom read(Reader in) {
      CommonMessages.Pose3d pose = CommonMessages.Pose3d.read(in);
      CommonMessages.Bbox3d size = CommonMessages.Bbox3d.read(in);
      return new Geom(pose, size);
    }

    @Override
    public void write(Writer out) {
      pose.write(out);
      size.write(out);
    }
  }

  /**
   * Angles, resolution and rate. (player_laser_config_t)
   *
   * @param minAngle Of the first beam (in rad).
   * @param maxAngle Of the last beam (in rad).
   * @param resolution Angle between neighbouring beams (in rad).
   * @param maxRange Maximum range (in m).
   * @param rangeRes Range resolution (in m).
   * @param intensity 1: send intensities, too.
   * @param scanningFrequency Scans per second (in Hz).
   */
  public record Config(
      float minAngle, float maxAngle, float resolution, float maxRange, float rangeRes, int intensity, float
      scanningFrequency)
      implements Struct {
    /** Every number 0, every list empty. */
    public Config() {
      this(0f, 0f, 0f, 0f, 0f, 0, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Config decode(byte[] body) {
      return Reader.decode("laser.Config", body, Config::read);
    }

    static Config read(Reader in) {
      float minAngle = in.float32();
      float maxAngle = in.float32();
      float resolution = in.float32();
      float maxRange = in.float32();
      float rangeRes = in.float32();
      int intensity = in.uint8();
      float scanningFrequency = in.float32();
      return new Config(minAngle, maxAngle, resolution, maxRange, rangeRes, intensity, scanningFrequency);
    }

    @Override
    public void write(Writer out) {
      out.float32(minAngle);
      out.float32(maxAngle);
      out.float32(resolution);
      out.float32(maxRange);
      out.float32(rangeRes);
      out.uint8(intensity);
      out.float32(scanningFrequency);
    }
  }

  /**
   * The device's switch. (player_laser_power_config_t)
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
      return Reader.decode("laser.PowerConfig", body, PowerConfig::read);
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
   * A serial number. (player_laser_get_id_config_t)
   *
   * @param serialNumber 0 in the request.
   */
  public record GetIdConfig(long serialNumber) implements Struct {
    /** Every number 0, every list empty. */
    public GetIdConfig() {
      this(0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static GetIdConfig decode(byte[] body) {
      return Reader.decode("laser.GetIdConfig", body, GetIdConfig::read);
    }

    static GetIdConfig read(Reader in) {
      long serialNumber = in.uint32();
      return new GetIdConfig(serialNumber);
    }

    @Override
    public void write(Writer out) {
      out.uint32(serialNumber);
    }
  }

  /**
   * A filter. (player_laser_set_filter_config_t)
   *
   * @param filterType Type of filter.
   * @param parameters Filter-specific.
   */
  public record SetFilterConfig(int filterType, float[] parameters) implements Struct {
    /** Every number 0, every list empty. */
    public SetFilterConfig() {
      this(0, new float[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static SetFilterConfig decode(byte[] body) {
      return Reader.decode("laser.SetFilterConfig", body, SetFilterConfig::read);
    }

    static SetFilterConfig read(Reader in) {
      int filterType = in.uint8();
      in.uint32();
      float[] parameters = in.float32s(in.length("parameters", 8, 4));
      return new SetFilterConfig(filterType, parameters);
    }

    @Override
    public void write(Writer out) {
      out.uint8(filterType);
      out.length("parameters", parameters.length, 8);
      out.length("parameters", parameters.length, 8);
      out.float32s(parameters);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof SetFilterConfig that && filterType == that.filterType
          && Arrays.equals(parameters, that.parameters);
    }

    @Override
    public int hashCode() {
      return Objects.hash(filterType, Arrays.hashCode(parameters));
    }
  }

  /** One scan at equal angles. */
  public static final MessageType<Data> DATA_SCAN =
      new MessageType<>(6, Kind.DATA, 1, "laser.data.scan", Data::decode);

  /** One scan and the pose at which it was measured. */
  public static final MessageType<DataScanpose> DATA_SCANPOSE =
      new MessageType<>(6, Kind.DATA, 2, "laser.data.scanpose", DataScanpose::decode);

  /** One scan with an angle per beam. */
  public static final MessageType<DataScanangle> DATA_SCANANGLE =
      new MessageType<>(6, Kind.DATA, 3, "laser.data.scanangle", DataScanangle::decode);

  /** Requests the device's size and pose. */
  public static final MessageType<Geom> REQ_GET_GEOM =
      new MessageType<>(6, Kind.REQ, 1, "laser.req.get_geom", Geom::decode);

  /** Sets angles, resolution and rate; the answer has the values in effect. */
  public static final MessageType<Config> REQ_SET_CONFIG =
      new MessageType<>(6, Kind.REQ, 2, "laser.req.set_config", Config::decode);

  /** Requests angles, resolution and rate. */
  public static final MessageType<Config> REQ_GET_CONFIG =
      new MessageType<>(6, Kind.REQ, 3, "laser.req.get_config", Config::decode);

  /** Switches the device on or off. */
  public static final MessageType<PowerConfig> REQ_POWER =
      new MessageType<>(6, Kind.REQ, 4, "laser.req.power", PowerConfig::decode);

  /** Requests the serial number. */
  public static final MessageType<GetIdConfig> REQ_GET_ID =
      new MessageType<>(6, Kind.REQ, 5, "laser.req.get_id", GetIdConfig::decode);

  /** Selects a filter for the ranges. */
  public static final MessageType<SetFilterConfig> REQ_SET_FILTER =
      new MessageType<>(6, Kind.REQ, 6, "laser.req.set_filter", SetFilterConfig::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_SCAN, DATA_SCANPOSE, DATA_SCANANGLE, REQ_GET_GEOM, REQ_SET_CONFIG, REQ_GET_CONFIG, REQ_POWER,
      REQ_GET_ID, REQ_SET_FILTER);

  private LaserMessages() {}
}
