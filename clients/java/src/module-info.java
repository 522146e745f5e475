/** A client of Playhouse and of any Player 3 server. */
module playhouse.client {
  exports playhouse.client;
  exports playhouse.client.wire;
}
