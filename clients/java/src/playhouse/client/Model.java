package playhouse.client;

import java.util.List;

/**
 * One model of the simulated world.
 *
 * @param name Its full name.
 * @param type For instance "position"; independent of macros.
 * @param parent Name of its parent; empty for a top-level model.
 * @param devices Its own devices.
 * @param id Unique in the run.
 */
public record Model(String name, String type, String parent, List<DeviceAddress> devices, long id) {}
