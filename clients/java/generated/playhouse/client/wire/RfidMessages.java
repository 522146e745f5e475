// Generated from interfaces/056_rfid.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface rfid, code 56. Reads and writes radio tags. */
public final class RfidMessages {
  /** The interface's code. */
  public static final int CODE = 56;

  /**
   * One tag. (player_rfid_tag_t)
   *
   * @param type Type of tag.
   * @param guid Id of the tag, as bytes.
   */
  public record Tag(long type, byte[] guid) implements Struct {
    /** Every number 0, every list empty. */
    public Tag() {
      this(0L, new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Tag decode(byte[] body) {
      return Reader.decode("rfid.Tag", body, Tag::read);
    }

    static Tag read(Reader in) {
      long type = in.uint32();
      long guidCount = in.uint32();
      byte[] guid = in.bytes(in.length("guid", guidCount, 1));
      return new Tag(type, guid);
    }

    @Override
    public void write(Writer out) {
      out.uint32(type);
      out.length("guid", guid.length, 33554392);
      out.length("guid", guid.length, 33554392);
      out.bytes(guid);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Tag that && type == that.type && Arrays.equals(guid, that.guid);
    }

    @Override
    public int hashCode() {
      return Objects.hash(type, Arrays.hashCode(guid));
    }
  }

  /**
   * Tags in range. (player_rfid_data_t)
   *
   * @param tags Tags.
   */
  public record Data(List<Tag> tags) implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("rfid.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long tagsCount = in.uint32();
      List<Tag> tags = in.structs(in.length("tags", tagsCount, 12), Tag::read);
      return new Data(tags);
    }

    @Override
    public void write(Writer out) {
      out.length("tags", tags.size(), 2796199);
      out.length("tags", tags.size(), 2796199);
      out.structs(tags);
    }
  }

  /** Tags in range. */
  public static final MessageType<Data> DATA_TAGS =
      new MessageType<>(56, Kind.DATA, 1, "rfid.data.tags", Data::decode);

  /** Switches the reader on or off. */
  public static final MessageType<Nothing> REQ_POWER =
      new MessageType<>(56, Kind.REQ, 1, "rfid.req.power", null);

  /** Reads a tag. */
  public static final MessageType<Nothing> REQ_READTAG =
      new MessageType<>(56, Kind.REQ, 2, "rfid.req.readtag", null);

  /** Writes a tag. */
  public static final MessageType<Nothing> REQ_WRITETAG =
      new MessageType<>(56, Kind.REQ, 3, "rfid.req.writetag", null);

  /** Locks a tag against writing. */
  public static final MessageType<Nothing> REQ_LOCKTAG =
      new MessageType<>(56, Kind.REQ, 4, "rfid.req.locktag", null);

  static final List<MessageType<?>> MESSAGES = List.of(
      DATA_TAGS, REQ_POWER, REQ_READTAG, REQ_WRITETAG, REQ_LOCKTAG);

  private RfidMessages() {}
}
