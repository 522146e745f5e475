package playhouse.client;

import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.WifiMessages;

/** Values of the wire to those of the proxies, and back. */
final class Convert {
  static List<Boolean> truths(byte[] values) {
    return IntStream.range(0, values.length).mapToObj(i -> values[i] != 0).toList();
  }

  static byte[] joined(byte[]... parts) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    for (byte[] part : parts) {
      out.writeBytes(part);
    }
    return out.toByteArray();
  }

  /** A value that there is if the flags have a bit. */
  static OptionalDouble onlyIf(long flags, int bit, double value) {
    return (flags & bit) != 0 ? OptionalDouble.of(value) : OptionalDouble.empty();
  }

  static <T> Optional<T> onlyIf(long flags, int bit, T value) {
    return (flags & bit) != 0 ? Optional.of(value) : Optional.empty();
  }

  /** A number that stands for none if it is {@code absent}. */
  static OptionalDouble unless(double absent, double value) {
    return value == absent ? OptionalDouble.empty() : OptionalDouble.of(value);
  }

  /** Of 0xRRGGBB. */
  static Color packedRgb(long color) {
    return new Color((int) (color >> 16 & 255), (int) (color >> 8 & 255), (int) (color & 255));
  }

  static Charging charging(int state) {
    return state < 0 ? Charging.IMPOSSIBLE : state == 0 ? Charging.NO : Charging.YES;
  }

  /** Levels in dBm are signed, all others are not. */
  static long level(int value, long unit) {
    return unit == WifiMessages.QUAL_DBM ? value : Integer.toUnsignedLong(value);
  }

  /** Of a range each, spread from {@code low} to {@code high}. */
  static double[] directions(double low, double high, double[] ranges) {
    return directions(low, high, ranges, List.of());
  }

  /** Of a range each: those of the elements if there is one per range, else spread. */
  static double[] directions(double low, double high, double[] ranges, List<CommonMessages.Pose3d> elements) {
    if (elements.size() == ranges.length && ranges.length > 1) {
      return elements.stream().mapToDouble(CommonMessages.Pose3d::pyaw).toArray();
    }
    double step = ranges.length > 1 ? (high - low) / (ranges.length - 1) : 0;
    return IntStream.range(0, ranges.length).mapToDouble(i -> low + i * step).toArray();
  }

  private Convert() {}
}
