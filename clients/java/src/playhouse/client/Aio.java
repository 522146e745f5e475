package playhouse.client;

import playhouse.client.wire.AioMessages;

/** Analog inputs and outputs; in Playhouse a custom model: its readings are inputs, its commands outputs. */
public final class Aio extends Updating<double[]> {
  Aio(Opening opening) {
    super(opening);
  }

  /** One per input, in V. Throws NoDataException. */
  public double[] voltages() {
    return Doubles.of(stamped(AioMessages.DATA_STATE).value().voltages());
  }

  /** Sets one output, in V. */
  public void set(int output, double voltage) {
    command(AioMessages.CMD_STATE, new AioMessages.Cmd(output, narrowed("voltage", voltage)));
  }

  @Override
  double[] newest() {
    return voltages();
  }
}
