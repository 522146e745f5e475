package playhouse.client;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;

/**
 * Ranges and their directions, pairwise, in the order of measurement. The arrays are not copied.
 *
 * @param ranges In m.
 * @param angles In rad, counter-clockwise from the sensor's x axis.
 * @param maxRange In m.
 * @param time The server's, in s.
 */
public record Scan(double[] ranges, double[] angles, double maxRange, double time) {
  /** The shortest range of all; maxRange if there is no beam. */
  public double nearest() {
    return nearest(-Math.PI, Math.PI);
  }

  /** The shortest range between two directions in rad; maxRange if no beam is there. */
  public double nearest(double low, double high) {
    return IntStream.range(0, Math.min(ranges.length, angles.length))
        .filter(i -> low <= angles[i] && angles[i] <= high)
        .mapToDouble(i -> ranges[i]).min().orElse(maxRange);
  }

  /** End points of the beams, in the sensor's frame. */
  public List<Point> points() {
    return IntStream.range(0, Math.min(ranges.length, angles.length))
        .mapToObj(i -> new Point(ranges[i] * Math.cos(angles[i]), ranges[i] * Math.sin(angles[i]))).toList();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Scan that && Arrays.equals(ranges, that.ranges) && Arrays.equals(angles, that.angles)
        && maxRange == that.maxRange && time == that.time;
  }

  @Override
  public int hashCode() {
    return Objects.hash(Arrays.hashCode(ranges), Arrays.hashCode(angles), maxRange, time);
  }

  static Scan of(double[] ranges, double[] angles, double maxRange, double time) {
    return new Scan(ranges, angles, maxRange, time);
  }
}
