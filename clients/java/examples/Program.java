package examples;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import playhouse.client.Client;
import playhouse.client.PlayerException;
import playhouse.client.WaitInterruptedException;

/** The command line that the examples share: PROGRAM [HOST:PORT [INDEX [SECONDS ...]]]. */
final class Program {
  private static final List<String> DEFAULTS = List.of("127.0.0.1:6665", "0", "0");

  /** What an example does with a robot, until the clock is up. */
  @FunctionalInterface
  interface Behaviour {
    void run(Client client, int index, Clock clock, List<Integer> more);
  }

  /** What the command line says. */
  private record Arguments(String address, int index, double seconds, List<Integer> more) {
    /** Throws NumberFormatException. */
    static Arguments of(String[] given) {
      List<String> words = new ArrayList<>(Arrays.asList(given));
      words.addAll(DEFAULTS.subList(Math.min(given.length, DEFAULTS.size()), DEFAULTS.size()));
      List<Integer> more = words.stream().skip(DEFAULTS.size()).map(Arguments::whole).toList();
      return new Arguments(words.get(0), whole(words.get(1)), seconds(words.get(2)), more);
    }

    /** A whole number up to 65535. */
    private static int whole(String word) {
      int number = Integer.parseInt(word);
      if (number < 0 || number > 65535) {
        throw new NumberFormatException(word);
      }
      return number;
    }

    private static double seconds(String word) {
      double number = new BigDecimal(word).doubleValue();
      if (number < 0 || Double.isInfinite(number)) {
        throw new NumberFormatException(word);
      }
      return number;
    }
  }

  /**
   * Connects, behaves, and ends with 0 when done, 1 on an error, 2 on wrong arguments, and 128 and its number
   * on a signal (130 on Ctrl-C).
   */
  static void run(String[] given, String usage, Behaviour behaviour) {
    Arguments arguments;
    try {
      arguments = Arguments.of(given);
    } catch (NumberFormatException error) {
      System.err.println("usage: " + usage);
      System.exit(2);
      return;
    }
    Clock clock = new Clock(arguments.seconds());
    CountDownLatch ended = new CountDownLatch(1);
    stopOnSignals(clock, ended);
    int code = 0;
    try (Client client = Client.connect(arguments.address())) {
      behaviour.run(client, arguments.index(), clock, arguments.more());
    } catch (WaitInterruptedException error) {
      // by a signal
    } catch (PlayerException error) {
      System.err.println(error.getMessage());
      code = 1;
    } finally {
      ended.countDown();
    }
    System.exit(code);
  }

  /**
   * On Ctrl-C, SIGTERM and SIGHUP the machine runs its shutdown hooks, and ends with 128 and the signal's
   * number. The hook interrupts the program, which leaves its try blocks, and so stops the robot, before the
   * machine ends. What nohup ignores stays ignored.
   */
  private static void stopOnSignals(Clock clock, CountDownLatch ended) {
    Thread program = Thread.currentThread();
    Runtime.getRuntime().addShutdownHook(new Thread(() -> {
      clock.stop();
      if (ended.getCount() > 0) {
        program.interrupt();
      }
      try {
        ended.await();
      } catch (InterruptedException error) {
        // nobody interrupts a hook
      }
    }));
  }

  private Program() {}
}
