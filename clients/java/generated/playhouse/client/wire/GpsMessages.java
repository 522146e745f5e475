// Generated from interfaces/013_gps.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface gps, code 13. A satellite receiver. */
public final class GpsMessages {
  /** The interface's code. */
  public static final int CODE = 13;

  /**
   * A fix. (player_gps_data_t)
   *
   * @param timeSec Time of the fix since 1970: whole seconds (in s).
   * @param timeUsec Time of the fix: microseconds of the second (in us).
   * @param latitude Positive north, WGS84 (in 1e-7 deg).
   * @param longitude Positive east, WGS84 (in 1e-7 deg).
   * @param altitude Above the ellipsoid (in mm).
   * @param speed Over ground (in m/s).
   * @param course Direction of travel, clockwise from north (in rad).
   * @param utmE UTM easting (in m).
   * @param utmN UTM northing (in m).
   * @param quality 0: no fix, 1: plain, 2: differential.
   * @param numSats Satellites used.
   * @param hdop Horizontal dilution of precision (in 0.1).
   * @param vdop Vertical dilution of precision (in 0.1).
   * @param errHorz Expected horizontal error (in m).
   * @param errVert Expected vertical error (in m).
   */
  public record Data(
      long timeSec, long timeUsec, int latitude, int longitude, int altitude, double speed, double course,
      double utmE, double utmN, long quality, long numSats, long hdop, long vdop, double errHorz, double
      errVert)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0L, 0L, 0, 0, 0, 0.0, 0.0, 0.0, 0.0, 0L, 0L, 0L, 0L, 0.0, 0.0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("gps.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long timeSec = in.uint32();
      long timeUsec = in.uint32();
      int latitude = in.int32();
      int longitude = in.int32();
      int altitude = in.int32();
      double speed = in.float64();
      double course = in.float64();
      double utmE = in.float64();
      double utmN = in.float64();
      long quality = in.uint32();
      long numSats = in.uint32();
      long hdop = in.uint32();
      long vdop = in.uint32();
      double errHorz = in.float64();
      double errVert = in.float64();
      return new Data(timeSec, timeUsec, latitude, longitude, altitude, speed, course, utmE, utmN, quality,
          numSats, hdop, vdop, errHorz, errVert);
    }

    @Override
    public void write(Writer out) {
      out.uint32(timeSec);
      out.uint32(timeUsec);
      out.int32(latitude);
      out.int32(longitude);
      out.int32(altitude);
      out.float64(speed);
      out.float64(course);
      out.float64(utmE);
      out.float64(utmN);
      out.uint32(quality);
      out.uint32(numSats);
      out.uint32(hdop);
      out.uint32(vdop);
      out.float64(errHorz);
      out.float64(errVert);
    }
  }

  /** The newest fix. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(13, Kind.DATA, 1, "gps.data.state", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE);

  private GpsMessages() {}
}
