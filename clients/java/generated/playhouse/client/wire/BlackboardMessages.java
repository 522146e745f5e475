// Generated from interfaces/064_blackboard.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.List;

/** Interface blackboard, code 64. Named values shared by clients. */
public final class BlackboardMessages {
  /** The interface's code. */
  public static final int CODE = 64;

  /** Subscribes to one entry; the answer has its value. */
  public static final MessageType<CommonMessages.BlackboardEntry> REQ_SUBSCRIBE_TO_KEY =
      new MessageType<>(64, Kind.REQ, 1, "blackboard.req.subscribe_to_key",
          CommonMessages.BlackboardEntry::decode);

  /** Unsubscribes one entry. */
  public static final MessageType<CommonMessages.BlackboardEntry> REQ_UNSUBSCRIBE_FROM_KEY =
      new MessageType<>(64, Kind.REQ, 2, "blackboard.req.unsubscribe_from_key",
          CommonMessages.BlackboardEntry::decode);

  /** Sets an entry. */
  public static final MessageType<CommonMessages.BlackboardEntry> REQ_SET_ENTRY =
      new MessageType<>(64, Kind.REQ, 3, "blackboard.req.set_entry", CommonMessages.BlackboardEntry::decode);

  /** Subscribes to all entries of a group. */
  public static final MessageType<CommonMessages.BlackboardEntry> REQ_SUBSCRIBE_TO_GROUP =
      new MessageType<>(64, Kind.REQ, 4, "blackboard.req.subscribe_to_group",
          CommonMessages.BlackboardEntry::decode);

  /** Unsubscribes a group. */
  public static final MessageType<CommonMessages.BlackboardEntry> REQ_UNSUBSCRIBE_FROM_GROUP =
      new MessageType<>(64, Kind.REQ, 5, "blackboard.req.unsubscribe_from_group",
          CommonMessages.BlackboardEntry::decode);

  /** Requests an entry once. */
  public static final MessageType<CommonMessages.BlackboardEntry> REQ_GET_ENTRY =
      new MessageType<>(64, Kind.REQ, 6, "blackboard.req.get_entry", CommonMessages.BlackboardEntry::decode);

  /** A subscribed entry has changed. */
  public static final MessageType<CommonMessages.BlackboardEntry> DATA_UPDATE =
      new MessageType<>(64, Kind.DATA, 1, "blackboard.data.update", CommonMessages.BlackboardEntry::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_SUBSCRIBE_TO_KEY, REQ_UNSUBSCRIBE_FROM_KEY, REQ_SET_ENTRY, REQ_SUBSCRIBE_TO_GROUP,
      REQ_UNSUBSCRIBE_FROM_GROUP, REQ_GET_ENTRY, DATA_UPDATE);

  private BlackboardMessages() {}
}
