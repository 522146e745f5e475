package playhouse.client;

import java.util.Arrays;
import java.util.Objects;
import java.util.OptionalLong;
import playhouse.client.wire.CameraMessages;

/**
 * An image. The array is not copied.
 *
 * @param width In pixels.
 * @param height In pixels.
 * @param format CameraMessages.FORMAT_MONO8, FORMAT_MONO16 (of Playhouse: depth in mm, little-endian, 0 if nothing
 *     is in range), FORMAT_RGB565 or FORMAT_RGB888.
 * @param isJpeg Whether the data are a JPEG file.
 * @param data The pixels, rows from the top, pixels from the left; or a JPEG file.
 * @param time The server's, in s.
 */
public record Image(int width, int height, int format, boolean isJpeg, byte[] data, double time) {
  static Image of(long width, long height, long format, boolean isJpeg, byte[] data, double time) {
    return new Image(whole(width), whole(height), whole(format), isJpeg, data, time);
  }

  /**
   * (red, green, blue), or (brightness), or (depth in mm). Throws InvalidValueException for a JPEG file, for
   * other formats, outside the image, and if the data are shorter than the image.
   */
  public int[] pixel(int column, int row) {
    int size = bytesOfPixel();
    if (isJpeg || size == 0) {
      throw new InvalidValueException("pixels can be told of raw MONO8, MONO16 and RGB888 alone");
    }
    if (column < 0 || column >= width || row < 0 || row >= height) {
      throw new InvalidValueException(
          "pixel " + column + ", " + row + " is outside the " + width + " x " + height + " picture");
    }
    long before = (long) row * width + column;
    if (before >= data.length / size) {
      throw new InvalidValueException("the picture has fewer bytes than pixels: " + data.length);
    }
    int first = (int) before * size;
    return switch (size) {
      case 1 -> new int[] {data[first] & 0xFF};
      case 2 -> new int[] {data[first] & 0xFF | (data[first + 1] & 0xFF) << 8};
      default -> new int[] {data[first] & 0xFF, data[first + 1] & 0xFF, data[first + 2] & 0xFF};
    };
  }

  /**
   * For images of a camera with {@code image "segmentation"}: the id of the model at the pixel, as in
   * Client.models(), up to 24 bits; empty without a model. Throws InvalidValueException as pixel(), and for
   * other formats.
   */
  public OptionalLong modelId(int column, int row) {
    int[] channels = pixel(column, row);
    if (channels.length != 3) {
      throw new InvalidValueException("which model a pixel shows is told by RGB888 alone");
    }
    int number = channels[0] << 16 | channels[1] << 8 | channels[2];
    return number > 0 ? OptionalLong.of(number - 1) : OptionalLong.empty();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Image that && width == that.width && height == that.height && format == that.format
        && isJpeg == that.isJpeg && Arrays.equals(data, that.data) && time == that.time;
  }

  @Override
  public int hashCode() {
    return Objects.hash(width, height, format, isJpeg, Arrays.hashCode(data), time);
  }

  private int bytesOfPixel() {
    return switch (format) {
      case CameraMessages.FORMAT_MONO8 -> 1;
      case CameraMessages.FORMAT_MONO16 -> 2;
      case CameraMessages.FORMAT_RGB888 -> 3;
      default -> 0;
    };
  }

  /** No message has room for pictures with numbers beyond. */
  private static int whole(long number) {
    return (int) Math.min(number, Integer.MAX_VALUE);
  }
}
