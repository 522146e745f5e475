package playhouse.client;

import playhouse.client.wire.GpsMessages;

/** A satellite receiver. */
public final class Gps extends Updating<Fix> {
  Gps(Opening opening) {
    super(opening);
  }

  /** The newest fix. Throws NoDataException. */
  public Fix fix() {
    Stamped<GpsMessages.Data> stamped = stamped(GpsMessages.DATA_STATE);
    GpsMessages.Data data = stamped.value();
    return new Fix(data.latitude() * 1e-7, data.longitude() * 1e-7, data.altitude() * 1e-3, data.utmE(), data.utmN(),
        data.speed(), data.course(), data.quality(), data.numSats(), data.errHorz(), data.errVert(), stamped.time());
  }

  @Override
  Fix newest() {
    return fix();
  }
}
