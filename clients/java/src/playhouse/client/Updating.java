package playhouse.client;

import java.time.Duration;
import java.util.Iterator;

/**
 * A device whose data are read one after the other.
 *
 * @param <T> The value of a data message.
 */
public abstract class Updating<T> extends Device {
  Updating(Opening opening) {
    super(opening);
  }

  /** Reads for ever: one value per new data message. Throws RequestTimeoutException. */
  public Iterable<T> updates() {
    return updates(session().timeout());
  }

  /** The same with a time-out for each value. */
  public Iterable<T> updates(Duration timeout) {
    Deadline.checked(timeout);
    return () -> new Iterator<>() {
      @Override
      public boolean hasNext() {
        return true;
      }

      @Override
      public T next() {
        return Updating.this.next(timeout);
      }
    };
  }

  T next(Duration timeout) {
    nextData(timeout);
    return newest();
  }

  /** The value of the newest data. */
  abstract T newest();
}
