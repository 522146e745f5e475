package playhouse.client;

/** What a device is opened with. */
record Opening(Client client, Session session, String interfaceName, int index, Access access) {}
