package playhouse.client;

/** The value of a data message, and the server's time of it in s. */
record Stamped<P>(P value, double time) {}
