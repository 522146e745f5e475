package playhouse.client.wire;

/** A payload or a part of one: the records of the generated classes, whose components are in wire order. */
public interface Struct {
  /** Appends the fields. Throws WireException if a value is outside the range of its field. */
  void write(Writer out);

  /** The bytes on the wire. Throws WireException as {@link #write}. */
  default byte[] encode() {
    Writer out = new Writer();
    write(out);
    return out.bytes();
  }
}
