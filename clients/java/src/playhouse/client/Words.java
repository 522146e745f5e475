package playhouse.client;

import java.math.BigDecimal;
import java.math.MathContext;
import java.time.Duration;
import java.util.Collection;

/** Parts of the texts of errors, which read the same in every language. */
final class Words {
  private static final double NEAR = 0.6;  // of 1, the likeness of equal words

  /** A number as in the other libraries: nan, inf, 0.1. */
  static String of(double value) {
    if (Double.isNaN(value)) {
      return "nan";
    }
    return Double.isInfinite(value) ? (value > 0 ? "inf" : "-inf") : Double.toString(value);
  }

  /** A duration in seconds, with six digits at most: 5, 0.05. */
  static String seconds(Duration duration) {
    BigDecimal exact = BigDecimal.valueOf(duration.getSeconds()).add(BigDecimal.valueOf(duration.getNano(), 9));
    return exact.round(new MathContext(6)).stripTrailingZeros().toPlainString();
  }

  /** ' (did you mean "laser"?)' for the nearest known word, empty if none is near. */
  static String didYouMean(String word, Collection<String> known) {
    String nearest = null;
    double best = NEAR;
    for (String each : known) {
      double likeness = likeness(each, word);
      if (likeness > best || likeness == best && (nearest == null || each.compareTo(nearest) > 0)) {
        nearest = each;
        best = likeness;
      }
    }
    return nearest == null ? "" : " (did you mean \"" + nearest + "\"?)";
  }

  /** 1 for equal words, 0 for words without a common letter. */
  private static double likeness(String a, String b) {
    return a.isEmpty() && b.isEmpty() ? 1 : 2.0 * common(a, b) / (a.length() + b.length());
  }

  /** Letters of the longest common part, and of the parts before and after it. */
  private static int common(String a, String b) {
    int length = 0;
    int atA = 0;
    int atB = 0;
    for (int i = 0; i < a.length() - length; ++i) {
      for (int j = 0; j < b.length() - length; ++j) {
        int same = 0;
        while (i + same < a.length() && j + same < b.length() && a.charAt(i + same) == b.charAt(j + same)) {
          ++same;
        }
        if (same > length) {
          length = same;
          atA = i;
          atB = j;
        }
      }
    }
    if (length == 0) {
      return 0;
    }
    return length + common(a.substring(0, atA), b.substring(0, atB))
        + common(a.substring(atA + length), b.substring(atB + length));
  }

  private Words() {}
}
