// Generated from interfaces/040_camera.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface camera, code 40. Images. */
public final class CameraMessages {
  /** The interface's code. */
  public static final int CODE = 40;

  // Values of Data.format.
  public static final int FORMAT_MONO8 = 1;
  public static final int FORMAT_MONO16 = 2;
  public static final int FORMAT_RGB565 = 4;
  public static final int FORMAT_RGB888 = 5;

  // Values of Data.compression.
  public static final int COMPRESS_RAW = 0;
  public static final int COMPRESS_JPEG = 1;

  /**
   * One image. (player_camera_data_t)
   *
   * @param width In px.
   * @param height In px.
   * @param bpp Per pixel (in bit).
   * @param format Order and size of the colors.
   * @param fdiv Divides the values of a disparity image; 1 otherwise.
   * @param compression Raw or JPEG.
   * @param image Rows from the top, pixels from the left, or a JPEG file.
   */
  public record Data(
      long width, long height, long bpp, long format, long fdiv, long compression, byte[] image)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0L, 0L, 0L, 0L, 0L, 0L, new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("camera.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long width = in.uint32();
      long height = in.uint32();
      long bpp = in.uint32();
      long format = in.uint32();
      long fdiv = in.uint32();
      long compression = in.uint32();
      long imageCount = in.uint32();
      byte[] image = in.bytes(in.length("image", imageCount, 1));
      return new Data(width, height, bpp, format, fdiv, compression, image);
    }

    @Override
    public void write(Writer out) {
      out.uint32(width);
      out.uint32(height);
      out.uint32(bpp);
      out.uint32(format);
      out.uint32(fdiv);
      out.uint32(compression);
      out.length("image", image.length, 33554392);
      out.length("image", image.length, 33554392);
      out.bytes(image);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && width == that.width && height == that.height && bpp == that.bpp
          && format == that.format && fdiv == that.fdiv && compression == that.compression
          && Arrays.equals(image, that.image);
    }

    @Override
    public int hashCode() {
      return Objects.hash(width, height, bpp, format, fdiv, compression, Arrays.hashCode(image));
    }
  }

  /**
   * An input of the camera. (player_camera_source_t)
   *
   * @param norm Video norm, such as PAL or NTSC, NUL-terminated.
   * @param source Index of the input.
   */
  public record Source(byte[] norm, int source) implements Struct {
    /** Every number 0, every list empty. */
    public Source() {
      this(new byte[0], 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Source decode(byte[] body) {
      return Reader.decode("camera.Source", body, Source::read);
    }

    static Source read(Reader in) {
      long normCount = in.uint32();
      byte[] norm = in.bytes(in.length("norm", normCount, 1));
      int source = in.int32();
      return new Source(norm, source);
    }

    @Override
    public void write(Writer out) {
      out.length("norm", norm.length, 33554392);
      out.length("norm", norm.length, 33554392);
      out.bytes(norm);
      out.int32(source);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Source that && Arrays.equals(norm, that.norm) && source == that.source;
    }

    @Override
    public int hashCode() {
      return Objects.hash(source, Arrays.hashCode(norm));
    }
  }

  /** One image. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(40, Kind.DATA, 1, "camera.data.state", Data::decode);

  /** Requests the camera's input and norm. */
  public static final MessageType<Source> REQ_GET_SOURCE =
      new MessageType<>(40, Kind.REQ, 1, "camera.req.get_source", Source::decode);

  /** Selects the input and norm. */
  public static final MessageType<Source> REQ_SET_SOURCE =
      new MessageType<>(40, Kind.REQ, 2, "camera.req.set_source", Source::decode);

  /** Requests one image now. */
  public static final MessageType<Data> REQ_GET_IMAGE =
      new MessageType<>(40, Kind.REQ, 3, "camera.req.get_image", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_STATE, REQ_GET_SOURCE, REQ_SET_SOURCE, REQ_GET_IMAGE);

  private CameraMessages() {}
}
