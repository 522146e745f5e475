package playhouse.client;

/** Whether a battery is being charged. */
public enum Charging {
  IMPOSSIBLE,
  NO,
  YES
}
