package programs;

import java.io.IOException;
import java.lang.reflect.Array;
import java.lang.reflect.RecordComponent;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import playhouse.client.WireException;
import playhouse.client.wire.Catalogue;
import playhouse.client.wire.Header;
import playhouse.client.wire.MessageType;
import playhouse.client.wire.Struct;
import playhouse.client.wire.WireName;

/**
 * Prints every message of a recorded stream as a line of JSON: its name, its value under the protocol's
 * names, and the bytes that the value encodes to. dump FILE; clients/python/tests/test_conformance.py
 * compares the lines with the values decoded in Python.
 */
final class Dump {
  private static final int BANNER_BYTES = 32;
  private static final int BYTE_NUMBERS = 1024;  // longer lists of bytes are printed in base64

  public static void main(String[] arguments) throws IOException {
    ByteBuffer left = ByteBuffer.wrap(Files.readAllBytes(Path.of(arguments[0])));
    if (arguments[0].endsWith(".s2c")) {
      left.position(BANNER_BYTES);
    }
    StringBuilder out = new StringBuilder();
    while (left.remaining() >= Header.BYTES) {
      Header header = Header.decode(left);
      if (header.size() > left.remaining()) {
        break;
      }
      byte[] body = new byte[(int) header.size()];
      left.get(body);
      out.append(line(header, body)).append('\n');
    }
    System.out.print(out);
  }

  private static String line(Header header, byte[] body) {
    Optional<MessageType<?>> row = Catalogue.find(header.interfaceCode(), header.kind(), header.subtype());
    Struct value = row.filter(MessageType::hasPayload).map(message -> decoded(message, body)).orElse(null);
    String again = value == null ? "" : HexFormat.of().formatHex(value.encode());
    String name = row.map(MessageType::name).orElse("");
    return "{\"name\":\"" + name + "\",\"value\":" + json(value) + ",\"again\":\"" + again + "\"}";
  }

  /** Null without a body, and for one that does not decode. */
  private static Struct decoded(MessageType<?> message, byte[] body) {
    try {
      return body.length == 0 ? null : message.decode(body);
    } catch (WireException error) {
      return null;
    }
  }

  private static String json(Object value) {
    if (value instanceof Struct) {
      return List.of(value.getClass().getRecordComponents()).stream()
          .map(component -> "\"" + name(component) + "\":" + json(of(component, value)))
          .collect(Collectors.joining(",", "{", "}"));
    }
    if (value instanceof byte[] bytes && bytes.length > BYTE_NUMBERS) {
      return "{\"base64\":\"" + Base64.getEncoder().encodeToString(bytes) + "\"}";
    }
    if (value instanceof List<?> list) {
      return list.stream().map(Dump::json).collect(Collectors.joining(",", "[", "]"));
    }
    if (value != null && value.getClass().isArray()) {
      return IntStream.range(0, Array.getLength(value)).mapToObj(i -> json(Array.get(value, i)))
          .collect(Collectors.joining(",", "[", "]"));
    }
    boolean hasNoForm = value instanceof Number number && !Double.isFinite(number.doubleValue());
    return hasNoForm ? "null" : String.valueOf(value);
  }

  private static Object of(RecordComponent component, Object value) {
    try {
      return component.getAccessor().invoke(value);
    } catch (ReflectiveOperationException error) {
      throw new IllegalStateException(error);
    }
  }

  /** minAngle is min_angle. */
  private static String name(RecordComponent component) {
    WireName name = component.getAnnotation(WireName.class);
    return name != null ? name.value() : component.getName().replaceAll("([A-Z])", "_$1").toLowerCase();
  }

  private Dump() {}
}
