// Generated from interfaces/007_blobfinder.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface blobfinder, code 7. Finds regions of one color (blobs) in camera images. */
public final class BlobfinderMessages {
  /** The interface's code. */
  public static final int CODE = 7;

  /**
   * A blob. Pixel coordinates start at the top left corner of the image. (player_blobfinder_blob_t)
   *
   * @param id Channel that detected it.
   * @param color 0xRRGGBB, for display.
   * @param area Area in pixels (in px).
   * @param x Column of its centre (in px).
   * @param y Row of its centre (in px).
   * @param left First column (in px).
   * @param right Last column (in px).
   * @param top First row (in px).
   * @param bottom Last row (in px).
   * @param range Distance; 0 if unknown (in m).
   */
  public record Blob(
      long id, long color, long area, long x, long y, long left, long right, long top, long bottom, float
      range)
      implements Struct {
    /** Every number 0, every list empty. */
    public Blob() {
      this(0L, 0L, 0L, 0L, 0L, 0L, 0L, 0L, 0L, 0f);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Blob decode(byte[] body) {
      return Reader.decode("blobfinder.Blob", body, Blob::read);
    }

    static Blob read(Reader in) {
      long id = in.uint32();
      long color = in.uint32();
      long area = in.uint32();
      long x = in.uint32();
      long y = in.uint32();
      long left = in.uint32();
      long right = in.uint32();
      long top = in.uint32();
      long bottom = in.uint32();
      float range = in.float32();
      return new Blob(id, color, area, x, y, left, right, top, bottom, range);
    }

    @Override
    public void write(Writer out) {
      out.uint32(id);
      out.uint32(color);
      out.uint32(area);
      out.uint32(x);
      out.uint32(y);
      out.uint32(left);
      out.uint32(right);
      out.uint32(top);
      out.uint32(bottom);
      out.float32(range);
    }
  }

  /**
   * The blobs of one image. (player_blobfinder_data_t)
   *
   * @param width Of the image (in px).
   * @param height Of the image (in px).
   * @param blobs Blobs.
   */
  public record Data(long width, long height, List<Blob> blobs) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(0L, 0L, List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("blobfinder.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long width = in.uint32();
      long height = in.uint32();
      long blobsCount = in.uint32();
      List<Blob> blobs = in.structs(in.length("blobs", blobsCount, 40), Blob::read);
      return new Data(width, height, blobs);
    }

    @Override
    public void write(Writer out) {
      out.uint32(width);
      out.uint32(height);
      out.length("blobs", blobs.size(), 838859);
      out.length("blobs", blobs.size(), 838859);
      out.structs(blobs);
    }
  }

  /**
   * The colors that a channel detects, as ranges of red, green and blue. (player_blobfinder_color_config_t)
   *
   * @param channel Channel; -1 means all (signed).
   * @param rmin Rmin.
   * @param rmax Rmax.
   * @param gmin Gmin.
   * @param gmax Gmax.
   * @param bmin Bmin.
   * @param bmax Bmax.
   */
  public record ColorConfig(
      int channel, long rmin, long rmax, long gmin, long gmax, long bmin, long bmax)
      implements Struct {
    /** Every number 0, every list empty. */
    public ColorConfig() {
      this(0, 0L, 0L, 0L, 0L, 0L, 0L);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static ColorConfig decode(byte[] body) {
      return Reader.decode("blobfinder.ColorConfig", body, ColorConfig::read);
    }

    static ColorConfig read(Reader in) {
      int channel = in.int32();
      long rmin = in.uint32();
      long rmax = in.uint32();
      long gmin = in.uint32();
      long gmax = in.uint32();
      long bmin = in.uint32();
      long bmax = in.uint32();
      return new ColorConfig(channel, rmin, rmax, gmin, gmax, bmin, bmax);
    }

    @Override
    public void write(Writer out) {
      out.int32(channel);
      out.uint32(rmin);
      out.uint32(rmax);
      out.uint32(gmin);
      out.uint32(gmax);
      out.uint32(bmin);
      out.uint32(bmax);
    }
  }

  /**
   * Settings of the camera; -1 leaves a setting unchanged. (player_blobfinder_imager_config_t)
   *
   * @param brightness 0 to 255.
   * @param contrast 0 to 255.
   * @param colormode 0 RGB, 1 RGB without white balance, 2 YUV, 3 YUV without white balance.
   * @param autogain 0 off, 1 on.
   */
  public record ImagerConfig(int brightness, int contrast, int colormode, int autogain) implements Struct {
    /** Every number 0, every list empty. */
    public ImagerConfig() {
      this(0, 0, 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static ImagerConfig decode(byte[] body) {
      return Reader.decode("blobfinder.ImagerConfig", body, ImagerConfig::read);
    }

    static ImagerConfig read(Reader in) {
      int brightness = in.int32();
      int contrast = in.int32();
      int colormode = in.int32();
      int autogain = in.int32();
      return new ImagerConfig(brightness, contrast, colormode, autogain);
    }

    @Override
    public void write(Writer out) {
      out.int32(brightness);
      out.int32(contrast);
      out.int32(colormode);
      out.int32(autogain);
    }
  }

  /** The blobs of one image. */
  public static final MessageType<Data> DATA_BLOBS =
      new MessageType<>(7, Kind.DATA, 1, "blobfinder.data.blobs", Data::decode);

  /** Sets the colors that a channel detects. */
  public static final MessageType<ColorConfig> REQ_SET_COLOR =
      new MessageType<>(7, Kind.REQ, 1, "blobfinder.req.set_color", ColorConfig::decode);

  /** Sets brightness, contrast and other settings of the camera. */
  public static final MessageType<ImagerConfig> REQ_SET_IMAGER_PARAMS =
      new MessageType<>(7, Kind.REQ, 2, "blobfinder.req.set_imager_params", ImagerConfig::decode);

  /** Requests the colors that a channel detects. */
  public static final MessageType<ColorConfig> REQ_GET_COLOR =
      new MessageType<>(7, Kind.REQ, 3, "blobfinder.req.get_color", ColorConfig::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_BLOBS, REQ_SET_COLOR, REQ_SET_IMAGER_PARAMS, REQ_GET_COLOR);

  private BlobfinderMessages() {}
}
