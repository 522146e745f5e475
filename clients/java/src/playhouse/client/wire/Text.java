package playhouse.client.wire;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import playhouse.client.WireException;

/** Text fields: on the wire raw bytes with a NUL at the end, which is part of their count. */
public final class Text {
  /** The text of a field, up to the first NUL; what is no UTF-8 becomes the replacement character. */
  public static String of(byte[] field) {
    int end = 0;
    while (end < field.length && field[end] != 0) {
      ++end;
    }
    return new String(field, 0, end, StandardCharsets.UTF_8);
  }

  /**
   * The text as a field, NUL-terminated. Throws WireException for half a surrogate pair, and for a NUL
   * inside.
   */
  public static byte[] field(String text) {
    if (text.indexOf('\0') >= 0) {
      throw new WireException("'" + text.replace("\0", "\\x00") + "' has a NUL in it, where receivers would end it");
    }
    try {
      ByteBuffer encoded = StandardCharsets.UTF_8.newEncoder().encode(CharBuffer.wrap(text));
      return Arrays.copyOf(Arrays.copyOf(encoded.array(), encoded.limit()), encoded.limit() + 1);
    } catch (CharacterCodingException error) {
      throw new WireException("'" + escaped(text) + "' cannot be sent as UTF-8: surrogates not allowed");
    }
  }

  private static String escaped(String text) {
    StringBuilder out = new StringBuilder();
    for (char c : text.toCharArray()) {
      out.append(Character.isSurrogate(c) ? String.format("\\u%04x", (int) c) : String.valueOf(c));
    }
    return out.toString();
  }

  private Text() {}
}
