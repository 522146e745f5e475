package playhouse.client;

import playhouse.client.wire.MessageType;
import playhouse.client.wire.Struct;

/** Takes the data of a device within {@link Client#read}. */
@FunctionalInterface
public interface DataListener {
  /** {@code time} is the server's, in s. */
  void take(MessageType<?> message, Struct value, double time);
}
