package playhouse.client.wire;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Finds interfaces and messages. The messages of an interface are loaded when they are first needed. */
public final class Catalogue {
  private static final Map<String, Integer> CODES = Interfaces.NAMES.entrySet().stream()
      .collect(Collectors.toUnmodifiableMap(Map.Entry::getValue, Map.Entry::getKey));
  private static final Map<Integer, MessageType<?>> SHARED = byNumber(Interfaces.sharedMessages());
  private static final Map<Integer, Map<Integer, MessageType<?>>> OWN = new ConcurrentHashMap<>();

  /** The interface's name; its number as a text if no interface has this code. */
  public static String interfaceName(int code) {
    return Interfaces.NAMES.getOrDefault(code, Integer.toString(code));
  }

  /** The code of an interface; empty if there is none of this name. */
  public static Optional<Integer> interfaceCode(String name) {
    return Optional.ofNullable(CODES.get(name));
  }

  /** The names of all interfaces. */
  public static Set<String> interfaceNames() {
    return CODES.keySet();
  }

  /**
   * The message of these numbers. Answers have that of their request; shared messages apply to every
   * interface.
   */
  public static Optional<MessageType<?>> find(int interfaceCode, int kind, int subtype) {
    int number = number(kind == Kind.ACK.code() || kind == Kind.NACK.code() ? Kind.REQ.code() : kind, subtype);
    MessageType<?> shared = SHARED.get(number);
    return shared != null ? Optional.of(shared) : Optional.ofNullable(ownOf(interfaceCode).get(number));
  }

  private static Map<Integer, MessageType<?>> ownOf(int interfaceCode) {
    if (!Interfaces.NAMES.containsKey(interfaceCode)) {
      return Map.of();
    }
    return OWN.computeIfAbsent(interfaceCode, code -> byNumber(Interfaces.messagesOf(code)));
  }

  private static Map<Integer, MessageType<?>> byNumber(List<MessageType<?>> messages) {
    return messages.stream()
        .collect(Collectors.toUnmodifiableMap(each -> number(each.kind().code(), each.subtype()), Function.identity()));
  }

  private static int number(int kind, int subtype) {
    return kind << 8 | subtype;
  }

  private Catalogue() {}
}
