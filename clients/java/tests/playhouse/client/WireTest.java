package playhouse.client;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import java.lang.reflect.InvocationTargetException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;
import playhouse.client.wire.Catalogue;
import playhouse.client.wire.CommonMessages;
import playhouse.client.wire.Header;
import playhouse.client.wire.Kind;
import playhouse.client.wire.LaserMessages;
import playhouse.client.wire.LocalizeMessages;
import playhouse.client.wire.MapMessages;
import playhouse.client.wire.PlayerMessages;
import playhouse.client.wire.Position2dMessages;
import playhouse.client.wire.Reader;
import playhouse.client.wire.Struct;
import playhouse.client.wire.Text;
import playhouse.client.wire.Writer;

/** Laws of the encoding: round trips, and hostile bytes that throw WireException and nothing else. */
public final class WireTest {
  @Test
  public void whatDecodesEncodesToBytesThatMeanTheSame() throws Exception {
    Random random = new Random(1);
    for (Class<?> type : payloads()) {
      int decoded = 0;
      for (int i = 0; i < 200; ++i) {
        Optional<Struct> value = decode(type, words(random, 1 + random.nextInt(59)));
        if (value.isPresent()) {
          byte[] body = value.get().encode();
          Struct again = decode(type, body).orElseThrow();
          assertArrayEquals(type.getName(), body, again.encode());
          assertEquals(value.get(), again);
          assertEquals(value.get().hashCode(), again.hashCode());
          ++decoded;
        }
      }
      assertTrue(type.getName(), decoded > 0);
    }
  }

  @Test
  public void aBodyThatIsCutShortThrows() throws Exception {
    for (Class<?> type : payloads()) {
      byte[] body = ((Struct) type.getConstructor().newInstance()).encode();
      assertTrue(decode(type, body).isPresent());
      for (int size = 0; size < body.length; ++size) {
        assertTrue(type + " cut to " + size + " bytes", decode(type, Arrays.copyOf(body, size)).isEmpty());
      }
    }
  }

  @Test
  public void bytesAfterTheEndAreIgnored() {
    Position2dMessages.CmdCar value = new Position2dMessages.CmdCar(1, 2);
    byte[] body = value.encode();
    assertEquals(value, Position2dMessages.CmdCar.decode(Arrays.copyOf(body, body.length + 3)));
  }

  @Test
  public void aHugeLengthThrowsBeforeAnythingIsAllocated() {
    byte[] body = ints(-1, -1);
    Expect.error(WireException.class, "devices has a length of 4294967295, over its limit of 4096",
        () -> PlayerMessages.DeviceDevlist.decode(body));
    Expect.error(WireException.class, "key claims 4294967295 elements, but 0 bytes are left",
        () -> CommonMessages.IntpropReq.decode(body));
  }

  @Test
  public void theSecondLengthCountsAndMayNotExceedTheFirst() {
    byte[] key = {'a', 'b', 'c', 'd'};
    assertArrayEquals(key, CommonMessages.IntpropReq.decode(ints(8, 4, 0x61626364, 5)).key());
    Expect.error(WireException.class, "common.IntpropReq: byte 8: key has a length of 4, over its limit of 3",
        () -> CommonMessages.IntpropReq.decode(ints(3, 4, 0x61626364, 5)));
  }

  @Test
  public void aCountMayTravelApartFromItsList() {
    MapMessages.Data value = new MapMessages.Data(1, 2, 3, 4, -1, new byte[] {1, -1});
    assertArrayEquals(ints(1, 2, 3, 4, 2, -1, 2, 0x01FF0000), value.encode());
    assertEquals(value, MapMessages.Data.decode(value.encode()));
  }

  @Test
  public void aNumberThatDoesNotFitItsFieldThrows() {
    Expect.error(WireException.class, "^256 is outside \\[0, 255\\]$",
        () -> new PlayerMessages.DeviceDatamodeReq(256).encode());
    Expect.error(WireException.class, "^-1 is outside", () -> new CommonMessages.Uint32(-1).encode());
    Expect.error(WireException.class, "driver_name has 65 elements, over its limit of 64",
        () -> new PlayerMessages.DeviceReq(new CommonMessages.Devaddr(), 0, new byte[65]).encode());
    Expect.error(WireException.class, "cov has 5 elements instead of 6",
        () -> new LocalizeMessages.SetPose(new CommonMessages.Pose2d(), new double[5]).encode());
  }

  @Test
  public void narrowNumbersKeepTheirLowBits() {
    Reader in = new Reader(ints(0x101, 0x12345, 200, -200));
    assertEquals(List.of(1, 0x2345, -56, 56), List.of(in.uint8(), in.uint16(), in.int8(), in.int8()));
    Header header = Header.decode(ByteBuffer.wrap(ints(0, 0, 0x10004, 0x10001, 0x101, 0x102, 0, 0, 0, 0)));
    assertEquals(List.of(4, 1, 1, 2),
        List.of(header.interfaceCode(), header.index(), header.kind(), header.subtype()));
  }

  @Test
  public void textsCarryTheirNul() {
    assertArrayEquals(new byte[] {'r', '0', 0}, Text.field("r0"));
    assertEquals("r0", Text.of("r0\0junk".getBytes(StandardCharsets.UTF_8)));
    assertEquals("r0", Text.of(new byte[] {'r', '0'}));
    assertEquals("sch\u00f6n", Text.of(Text.field("sch\u00f6n")));
    Expect.error(WireException.class, "has a NUL in it", () -> Text.field("r0\0"));
    Expect.error(WireException.class, "^'r\\\\udcff' cannot be sent as UTF-8", () -> Text.field("r\udcff"));
  }

  @Test
  public void answersShareTheTypeOfTheirRequest() {
    assertSame(Position2dMessages.REQ_GET_GEOM, Catalogue.find(4, Kind.ACK.code(), 1).orElseThrow());
    assertSame(CommonMessages.REQ_CAPABILITIES, Catalogue.find(999, Kind.NACK.code(), 255).orElseThrow());
    assertEquals(Optional.empty(), Catalogue.find(4, Kind.DATA.code(), 99));
    assertEquals(Optional.empty(), Catalogue.find(999, Kind.DATA.code(), 1));
  }

  @Test
  public void aWriterGrowsWithWhatIsWritten() {
    Writer out = new Writer();
    out.float32s(new float[10_000]);
    out.bytes(new byte[] {1, 2, 3, 4, 5});
    assertEquals(40_008, out.bytes().length);
    assertArrayEquals(new byte[] {1, 2, 3, 4, 5, 0, 0, 0}, Arrays.copyOfRange(out.bytes(), 40_000, 40_008));
  }

  @Test
  public void valuesWithArraysAreEqualIfTheirElementsAre() {
    LaserMessages.Data one = new LaserMessages.Data(0, 1, 0.5f, 8, new float[] {1, 2}, new byte[] {3}, 1);
    LaserMessages.Data same = new LaserMessages.Data(0, 1, 0.5f, 8, new float[] {1, 2}, new byte[] {3}, 1);
    LaserMessages.Data other = new LaserMessages.Data(0, 1, 0.5f, 8, new float[] {1, 3}, new byte[] {3}, 1);
    assertEquals(one, same);
    assertEquals(one.hashCode(), same.hashCode());
    assertTrue(!one.equals(other));
  }

  /** The structs of all interfaces. */
  private static List<Class<?>> payloads() throws ClassNotFoundException {
    List<Class<?>> found = new ArrayList<>();
    for (String name : Stream.concat(Stream.of("common"), Catalogue.interfaceNames().stream().sorted()).toList()) {
      String words = Arrays.stream(name.split("_"))
          .map(word -> word.substring(0, 1).toUpperCase() + word.substring(1)).collect(Collectors.joining());
      Class<?> messages = Class.forName("playhouse.client.wire." + words + "Messages");
      found.addAll(Arrays.stream(messages.getDeclaredClasses()).filter(Struct.class::isAssignableFrom).toList());
    }
    assertTrue(found.size() > 200);
    return found;
  }

  /** Empty if the bytes throw WireException. */
  private static Optional<Struct> decode(Class<?> type, byte[] body) throws Exception {
    try {
      return Optional.of((Struct) type.getMethod("decode", byte[].class).invoke(null, (Object) body));
    } catch (InvocationTargetException error) {
      if (error.getCause() instanceof WireException) {
        return Optional.empty();
      }
      throw error;
    }
  }

  /** Words as bodies have them: mostly small numbers, so that lengths are often believable. */
  private static byte[] words(Random random, int count) {
    ByteBuffer out = ByteBuffer.allocate(4 * count);
    for (int i = 0; i < count; ++i) {
      int choice = random.nextInt(5);
      out.putInt(choice < 4 ? choice : random.nextInt());
    }
    return out.array();
  }

  private static byte[] ints(int... values) {
    ByteBuffer out = ByteBuffer.allocate(4 * values.length);
    Arrays.stream(values).forEach(out::putInt);
    return out.array();
  }
}
