package playhouse.client;

/** Base of devices that move a robot. Closing one while it moves stops it first. */
abstract class Mobile<T> extends Updating<T> {
  private boolean moving;

  Mobile(Opening opening) {
    super(opening);
  }

  /** Drives straight ahead, in m/s, until the next command. */
  public abstract void drive(double vx);

  /** Stands still. */
  public void stop() {
    drive(0);
  }

  /** Notes whether the command that is about to be sent is a motion. */
  final void setMoving(boolean moving) {
    this.moving = moving;
  }

  @Override
  public void close() {
    try {
      if (isOpen() && moving && !isGone() && session().connection().isAlive()) {
        stop();
      }
    } finally {
      super.close();
    }
  }
}
