package playhouse.client;

import playhouse.client.wire.Header;

/** A header and the undecoded body. */
record Message(Header header, byte[] body) {}
