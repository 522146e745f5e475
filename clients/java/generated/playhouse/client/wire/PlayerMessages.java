// Generated from interfaces/001_player.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * Interface player, code 1. The server itself: lists, opens and closes devices, and selects the delivery of
 * data. Always open as player:0.
 */
public final class PlayerMessages {
  /** The interface's code. */
  public static final int CODE = 1;

  // Values of DeviceReq.access.
  public static final int OPEN_MODE = 1;
  public static final int CLOSE_MODE = 2;
  public static final int ERROR_MODE = 3;

  // Values of DeviceDatamodeReq.mode.
  public static final int DATAMODE_PUSH = 1;
  public static final int DATAMODE_PULL = 2;

  // Values of AddReplaceRuleReq.replace.
  public static final int MSG_REPLACE_RULE_ACCEPT = 0;
  public static final int MSG_REPLACE_RULE_REPLACE = 1;
  public static final int MSG_REPLACE_RULE_IGNORE = 2;

  /**
   * The devices of a server. (player_device_devlist_t)
   *
   * @param devices In the order of creation, without player:0.
   */
  public record DeviceDevlist(List<CommonMessages.Devaddr> devices) implements Struct {
    /** Every number 0, every list empty. */
    public DeviceDevlist() {
      this(List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DeviceDevlist decode(byte[] body) {
      return Reader.decode("player.DeviceDevlist", body, DeviceDevlist::read);
    }

    static DeviceDevlist read(Reader in) {
      in.uint32();
      List<CommonMessages.Devaddr> devices = in.structs(in.length("devices", 4096, 16),
          CommonMessages.Devaddr::read);
      return new DeviceDevlist(devices);
    }

    @Override
    public void write(Writer out) {
      out.length("devices", devices.size(), 4096);
      out.length("devices", devices.size(), 4096);
      out.structs(devices);
    }
  }

  /**
   * A device and the driver behind it. (player_device_driverinfo_t)
   *
   * @param addr The queried device.
   * @param driverName NUL-terminated; empty in the request.
   */
  public record DeviceDriverinfo(CommonMessages.Devaddr addr, byte[] driverName) implements Struct {
    /** Every number 0, every list empty. */
    public DeviceDriverinfo() {
      this(new CommonMessages.Devaddr(), new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DeviceDriverinfo decode(byte[] body) {
      return Reader.decode("player.DeviceDriverinfo", body, DeviceDriverinfo::read);
    }

    static DeviceDriverinfo read(Reader in) {
      CommonMessages.Devaddr addr = CommonMessages.Devaddr.read(in);
      in.uint32();
      byte[] driverName = in.bytes(in.length("driver_name", 64, 1));
      return new DeviceDriverinfo(addr, driverName);
    }

    @Override
    public void write(Writer out) {
      addr.write(out);
      out.length("driver_name", driverName.length, 64);
      out.length("driver_name", driverName.length, 64);
      out.bytes(driverName);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof DeviceDriverinfo that && addr.equals(that.addr)
          && Arrays.equals(driverName, that.driverName);
    }

    @Override
    public int hashCode() {
      return Objects.hash(addr, Arrays.hashCode(driverName));
    }
  }

  /**
   * Request to open or close a device, and its answer. (player_device_req_t)
   *
   * @param addr The device; in the answer, completed with host and robot.
   * @param access Requested or granted access.
   * @param driverName NUL-terminated; empty in the request.
   */
  public record DeviceReq(CommonMessages.Devaddr addr, int access, byte[] driverName) implements Struct {
    /** Every number 0, every list empty. */
    public DeviceReq() {
      this(new CommonMessages.Devaddr(), 0, new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DeviceReq decode(byte[] body) {
      return Reader.decode("player.DeviceReq", body, DeviceReq::read);
    }

    static DeviceReq read(Reader in) {
      CommonMessages.Devaddr addr = CommonMessages.Devaddr.read(in);
      int access = in.uint8();
      in.uint32();
      byte[] driverName = in.bytes(in.length("driver_name", 64, 1));
      return new DeviceReq(addr, access, driverName);
    }

    @Override
    public void write(Writer out) {
      addr.write(out);
      out.uint8(access);
      out.length("driver_name", driverName.length, 64);
      out.length("driver_name", driverName.length, 64);
      out.bytes(driverName);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof DeviceReq that && addr.equals(that.addr) && access == that.access
          && Arrays.equals(driverName, that.driverName);
    }

    @Override
    public int hashCode() {
      return Objects.hash(addr, access, Arrays.hashCode(driverName));
    }
  }

  /**
   * A delivery mode. (player_device_datamode_req_t)
   *
   * @param mode Push or pull.
   */
  public record DeviceDatamodeReq(int mode) implements Struct {
    /** Every number 0, every list empty. */
    public DeviceDatamodeReq() {
      this(0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DeviceDatamodeReq decode(byte[] body) {
      return Reader.decode("player.DeviceDatamodeReq", body, DeviceDatamodeReq::read);
    }

    static DeviceDatamodeReq read(Reader in) {
      int mode = in.uint8();
      return new DeviceDatamodeReq(mode);
    }

    @Override
    public void write(Writer out) {
      out.uint8(mode);
    }
  }

  /**
   * A key. (player_device_auth_req_t)
   *
   * @param authKey Auth key.
   */
  public record DeviceAuthReq(byte[] authKey) implements Struct {
    /** Every number 0, every list empty. */
    public DeviceAuthReq() {
      this(new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DeviceAuthReq decode(byte[] body) {
      return Reader.decode("player.DeviceAuthReq", body, DeviceAuthReq::read);
    }

    static DeviceAuthReq read(Reader in) {
      in.uint32();
      byte[] authKey = in.bytes(in.length("auth_key", 32, 1));
      return new DeviceAuthReq(authKey);
    }

    @Override
    public void write(Writer out) {
      out.length("auth_key", authKey.length, 32);
      out.length("auth_key", authKey.length, 32);
      out.bytes(authKey);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof DeviceAuthReq that && Arrays.equals(authKey, that.authKey);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(authKey);
    }
  }

  /**
   * A robot's name and its port. (player_device_nameservice_req_t)
   *
   * @param name Name.
   * @param port 0 in the request.
   */
  public record DeviceNameserviceReq(byte[] name, int port) implements Struct {
    /** Every number 0, every list empty. */
    public DeviceNameserviceReq() {
      this(new byte[0], 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static DeviceNameserviceReq decode(byte[] body) {
      return Reader.decode("player.DeviceNameserviceReq", body, DeviceNameserviceReq::read);
    }

    static DeviceNameserviceReq read(Reader in) {
      in.uint32();
      byte[] name = in.bytes(in.length("name", 64, 1));
      int port = in.uint16();
      return new DeviceNameserviceReq(name, port);
    }

    @Override
    public void write(Writer out) {
      out.length("name", name.length, 64);
      out.length("name", name.length, 64);
      out.bytes(name);
      out.uint16(port);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof DeviceNameserviceReq that && Arrays.equals(name, that.name)
          && port == that.port;
    }

    @Override
    public int hashCode() {
      return Objects.hash(port, Arrays.hashCode(name));
    }
  }

  /**
   * Messages to which a rule applies, and its effect; -1 matches anything. (player_add_replace_rule_req_t)
   *
   * @param interf Interface code, or -1.
   * @param index Device index, or -1.
   * @param type Message type, or -1.
   * @param subtype Message subtype, or -1.
   * @param replace Keep all, keep the newest, or drop.
   */
  public record AddReplaceRuleReq(
      int interf, int index, int type, int subtype, int replace)
      implements Struct {
    /** Every number 0, every list empty. */
    public AddReplaceRuleReq() {
      this(0, 0, 0, 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static AddReplaceRuleReq decode(byte[] body) {
      return Reader.decode("player.AddReplaceRuleReq", body, AddReplaceRuleReq::read);
    }

    static AddReplaceRuleReq read(Reader in) {
      int interf = in.int32();
      int index = in.int32();
      int type = in.int32();
      int subtype = in.int32();
      int replace = in.int32();
      return new AddReplaceRuleReq(interf, index, type, subtype, replace);
    }

    @Override
    public void write(Writer out) {
      out.int32(interf);
      out.int32(index);
      out.int32(type);
      out.int32(subtype);
      out.int32(replace);
    }
  }

  /** Lists the devices that this connection can open. */
  public static final MessageType<DeviceDevlist> REQ_DEVLIST =
      new MessageType<>(1, Kind.REQ, 1, "player.req.devlist", DeviceDevlist::decode);

  /** Requests the name of the driver behind a device. */
  public static final MessageType<DeviceDriverinfo> REQ_DRIVERINFO =
      new MessageType<>(1, Kind.REQ, 2, "player.req.driverinfo", DeviceDriverinfo::decode);

  /** Opens or closes a device; the answer has the granted access. */
  public static final MessageType<DeviceReq> REQ_DEV =
      new MessageType<>(1, Kind.REQ, 3, "player.req.dev", DeviceReq::decode);

  /** Requests one round of data, in pull mode; a synch ends the round. */
  public static final MessageType<Nothing> REQ_DATA =
      new MessageType<>(1, Kind.REQ, 4, "player.req.data", null);

  /** Selects the delivery mode: immediately (push) or on request (pull). */
  public static final MessageType<DeviceDatamodeReq> REQ_DATAMODE =
      new MessageType<>(1, Kind.REQ, 5, "player.req.datamode", DeviceDatamodeReq::decode);

  /**
   * Sends an authentication key: a guest's token, of a run with access control (docs/guests.md); NACK if it
   * admits nobody.
   */
  public static final MessageType<DeviceAuthReq> REQ_AUTH =
      new MessageType<>(1, Kind.REQ, 7, "player.req.auth", DeviceAuthReq::decode);

  /** Requests the port of a named robot; unused, answered by NACK. */
  public static final MessageType<DeviceNameserviceReq> REQ_NAMESERVICE =
      new MessageType<>(1, Kind.REQ, 8, "player.req.nameservice", DeviceNameserviceReq::decode);

  /** Adds a replace rule: which queued messages a newer one replaces. */
  public static final MessageType<AddReplaceRuleReq> REQ_ADD_REPLACE_RULE =
      new MessageType<>(1, Kind.REQ, 10, "player.req.add_replace_rule", AddReplaceRuleReq::decode);

  /** Ends a round of data; no message was dropped since the previous one. */
  public static final MessageType<Nothing> SYNCH_OK =
      new MessageType<>(1, Kind.SYNCH, 1, "player.synch.ok", null);

  /** Ends a round of data; the body is the number of messages dropped since the previous one. */
  public static final MessageType<CommonMessages.Uint32> SYNCH_OVERFLOW =
      new MessageType<>(1, Kind.SYNCH, 2, "player.synch.overflow", CommonMessages.Uint32::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_DEVLIST, REQ_DRIVERINFO, REQ_DEV, REQ_DATA, REQ_DATAMODE, REQ_AUTH, REQ_NAMESERVICE,
      REQ_ADD_REPLACE_RULE, SYNCH_OK, SYNCH_OVERFLOW);

  private PlayerMessages() {}
}
