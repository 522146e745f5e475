package playhouse.client.wire;

import java.util.function.Function;

/**
 * One message type of one interface, as PLAYER_POSITION2D_CMD_VEL; the generated classes have them all.
 *
 * @param interfaceCode Code of the interface; 0 for messages that all interfaces share.
 * @param kind DATA, CMD, REQ or SYNCH; answers have the type of their request.
 * @param subtype Its number.
 * @param name For instance "position2d.cmd.vel".
 * @param decoder Decodes a body; null if the message has none.
 * @param <P> The payload, {@link Nothing} if there is none.
 */
public record MessageType<P extends Struct>(
    int interfaceCode, Kind kind, int subtype, String name, Function<byte[], P> decoder) {
  /** Whether the message has a body. */
  public boolean hasPayload() {
    return decoder != null;
  }

  /**
   * Decodes a body of this message, which must have one; bytes after its end are ignored. Throws
   * WireException.
   */
  public P decode(byte[] body) {
    return decoder.apply(body);
  }
}
