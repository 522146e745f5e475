package playhouse.client;

import java.io.ByteArrayOutputStream;
import java.util.List;
import playhouse.client.wire.OpaqueMessages;
import playhouse.client.wire.Struct;
import playhouse.client.wire.Text;

/** Byte messages: those between robots for a simulated radio, driver-specific for other drivers. */
public final class Opaque extends Keeping<byte[]> {
  Opaque(Opening opening) {
    super(opening);
  }

  /** Sends to the driver; a radio broadcasts it to all radios in range. */
  public void send(byte[] message) {
    command(OpaqueMessages.CMD_DATA, new OpaqueMessages.Data(message));
  }

  /**
   * For a radio: sends to the radio with this network address, "" to broadcast. Returns when the message is
   * queued. Throws RequestRefusedException for an unknown address, a message that is too long, or a full
   * queue.
   */
  public void sendTo(String address, byte[] message) {
    ByteArrayOutputStream data = new ByteArrayOutputStream();
    data.writeBytes(Text.field(address));
    data.writeBytes(message);
    request(OpaqueMessages.REQ_DATA, new OpaqueMessages.Data(data.toByteArray()));
  }

  /** Messages of read() since the last call, in order. */
  public List<byte[]> takeMessages() {
    return takeKept();
  }

  @Override
  byte[] meaning(Struct value) {
    return ((OpaqueMessages.Data) value).data();
  }
}
