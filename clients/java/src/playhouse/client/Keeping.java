package playhouse.client;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import playhouse.client.wire.MessageType;
import playhouse.client.wire.Struct;

/** Base of devices whose data messages are queued until the program takes them. */
abstract class Keeping<T> extends Updating<T> {
  private static final int WAITING_LIMIT = 1024;  // the oldest are dropped

  private final ArrayDeque<T> kept = new ArrayDeque<>();

  Keeping(Opening opening) {
    super(opening);
  }

  @Override
  T next(Duration timeout) {
    while (kept.isEmpty()) {
      nextData(timeout);
    }
    return newest();
  }

  @Override
  T newest() {
    return kept.remove();
  }

  @Override
  void take(MessageType<?> message, Struct value, double time) {
    if (kept.size() == WAITING_LIMIT) {
      kept.remove();
    }
    kept.add(meaning(value));
    super.take(message, value, time);
  }

  @Override
  void forgetData() {
    kept.clear();
    super.forgetData();
  }

  List<T> takeKept() {
    List<T> taken = new ArrayList<>(kept);
    kept.clear();
    return taken;
  }

  abstract T meaning(Struct value);
}
