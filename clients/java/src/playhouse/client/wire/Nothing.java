package playhouse.client.wire;

/** The payload of messages without a body; there are no values of it. */
public final class Nothing implements Struct {
  private Nothing() {}

  @Override
  public void write(Writer out) {}
}
