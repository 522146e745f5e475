// Generated from interfaces/065_stereo.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface stereo, code 65. A pair of cameras, their disparity and the points in space. */
public final class StereoMessages {
  /** The interface's code. */
  public static final int CODE = 65;

  /**
   * One point. (player_pointcloud3d_stereo_element_t)
   *
   * @param px In m, frame p_SP.
   * @param py In m, frame p_SP.
   * @param pz In m, frame p_SP.
   * @param red Red.
   * @param green Green.
   * @param blue Blue.
   */
  public record Pointcloud3dStereoElement(
      float px, float py, float pz, int red, int green, int blue)
      implements Struct {
    /** Every number 0, every list empty. */
    public Pointcloud3dStereoElement() {
      this(0f, 0f, 0f, 0, 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Pointcloud3dStereoElement decode(byte[] body) {
      return Reader.decode("stereo.Pointcloud3dStereoElement", body, Pointcloud3dStereoElement::read);
    }

    static Pointcloud3dStereoElement read(Reader in) {
      float px = in.float32();
      float py = in.float32();
      float pz = in.float32();
      int red = in.uint8();
      int green = in.uint8();
      int blue = in.uint8();
      return new Pointcloud3dStereoElement(px, py, pz, red, green, blue);
    }

    @Override
    public void write(Writer out) {
      out.float32(px);
      out.float32(py);
      out.float32(pz);
      out.uint8(red);
      out.uint8(green);
      out.uint8(blue);
    }
  }

  /**
   * A pair of images, and the results computed from it. (player_stereo_data_t)
   *
   * @param leftChannel Image of the left camera.
   * @param rightChannel Image of the right camera.
   * @param disparity Disparity, as an image.
   * @param points Points in space.
   * @param mode Driver-specific.
   */
  public record Data(
      CameraMessages.Data leftChannel, CameraMessages.Data rightChannel, CameraMessages.Data disparity,
      List<Pointcloud3dStereoElement> points, long mode)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(new CameraMessages.Data(), new CameraMessages.Data(), new CameraMessages.Data(), List.of(), 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("stereo.Data", body, Data::read);
    }

    static Data read(Reader in) {
      CameraMessages.Data leftChannel = CameraMessages.Data.read(in);
      CameraMessages.Data rightChannel = CameraMessages.Data.read(in);
      CameraMessages.Data disparity = CameraMessages.Data.read(in);
      long pointsCount = in.uint32();
      List<Pointcloud3dStereoElement> points = in.structs(in.length("points", pointsCount, 24),
          Pointcloud3dStereoElement::read);
      long mode = in.uint32();
      return new Data(leftChannel, rightChannel, disparity, points, mode);
    }

    @Override
    public void write(Writer out) {
      leftChannel.write(out);
      rightChannel.write(out);
      disparity.write(out);
      out.length("points", points.size(), 1398099);
      out.length("points", points.size(), 1398099);
      out.structs(points);
      out.uint32(mode);
    }
  }

  /** A pair of images, and the results computed from it. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(65, Kind.DATA, 1, "stereo.data.state", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE);

  private StereoMessages() {}
}
