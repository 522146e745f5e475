// Generated from interfaces/023_wifi.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface wifi, code 23. State of wireless network links. */
public final class WifiMessages {
  /** The interface's code. */
  public static final int CODE = 23;

  // Values of Data.qual_type: unit of link quality.
  public static final int QUAL_DBM = 1;
  public static final int QUAL_REL = 2;
  public static final int QUAL_UNKNOWN = 3;

  // Values of Data.mode and Link.mode.
  public static final int MODE_UNKNOWN = 0;
  public static final int MODE_AUTO = 1;
  public static final int MODE_ADHOC = 2;
  public static final int MODE_INFRA = 3;
  public static final int MODE_MASTER = 4;
  public static final int MODE_REPEAT = 5;
  public static final int MODE_SECOND = 6;

  /**
   * One link. (player_wifi_link_t)
   *
   * @param mac Hardware address, as a string.
   * @param ip Network address, as a string.
   * @param essid Name of the network, as a string.
   * @param mode Role in the network.
   * @param freq In MHz.
   * @param encrypt 0: open, else encrypted.
   * @param qual Quality, up to Data.maxqual.
   * @param level Signal, up to Data.maxlevel (signed).
   * @param noise Noise, up to Data.maxnoise (signed).
   */
  public record Link(
      byte[] mac, byte[] ip, byte[] essid, long mode, long freq, long encrypt, long qual, int level, int
      noise)
      implements Struct {
    /** Every number 0, every list empty. */
    public Link() {
      this(new byte[0], new byte[0], new byte[0], 0L, 0L, 0L, 0L, 0, 0);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Link decode(byte[] body) {
      return Reader.decode("wifi.Link", body, Link::read);
    }

    static Link read(Reader in) {
      in.uint32();
      byte[] mac = in.bytes(in.length("mac", 32, 1));
      in.uint32();
      byte[] ip = in.bytes(in.length("ip", 32, 1));
      in.uint32();
      byte[] essid = in.bytes(in.length("essid", 32, 1));
      long mode = in.uint32();
      long freq = in.uint32();
      long encrypt = in.uint32();
      long qual = in.uint32();
      int level = in.int32();
      int noise = in.int32();
      return new Link(mac, ip, essid, mode, freq, encrypt, qual, level, noise);
    }

    @Override
    public void write(Writer out) {
      out.length("mac", mac.length, 32);
      out.length("mac", mac.length, 32);
      out.bytes(mac);
      out.length("ip", ip.length, 32);
      out.length("ip", ip.length, 32);
      out.bytes(ip);
      out.length("essid", essid.length, 32);
      out.length("essid", essid.length, 32);
      out.bytes(essid);
      out.uint32(mode);
      out.uint32(freq);
      out.uint32(encrypt);
      out.uint32(qual);
      out.int32(level);
      out.int32(noise);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Link that && Arrays.equals(mac, that.mac) && Arrays.equals(ip, that.ip)
          && Arrays.equals(essid, that.essid) && mode == that.mode && freq == that.freq
          && encrypt == that.encrypt && qual == that.qual && level == that.level && noise == that.noise;
    }

    @Override
    public int hashCode() {
      return Objects.hash(mode, freq, encrypt, qual, level, noise, Arrays.hashCode(mac), Arrays.hashCode(ip),
          Arrays.hashCode(essid));
    }
  }

  /**
   * Every link and the state of the card. (player_wifi_data_t)
   *
   * @param links Links.
   * @param throughput Estimated throughput of the card (in bit/s).
   * @param bitrate Configured bit rate of the card (in bit/s).
   * @param mode Role in the network.
   * @param qualType Unit of quality, level and noise.
   * @param maxqual Maximum reported quality.
   * @param maxlevel Maximum reported signal level (signed).
   * @param maxnoise Maximum reported noise level (signed).
   * @param ap Hardware address of the access point, as a string (32 elements).
   */
  public record Data(
      List<Link> links, long throughput, long bitrate, long mode, long qualType, long maxqual, int maxlevel,
      int maxnoise, byte[] ap)
      implements Struct {
    /** Every number 0, every list empty. */
    public Data() {
      this(List.of(), 0L, 0L, 0L, 0L, 0L, 0, 0, new byte[32]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Data decode(byte[] body) {
      return Reader.decode("wifi.Data", body, Data::read);
    }

    static Data read(Reader in) {
      long linksCount = in.uint32();
      List<Link> links = in.structs(in.length("links", linksCount, 48), Link::read);
      long throughput = in.uint32();
      long bitrate = in.uint32();
      long mode = in.uint32();
      long qualType = in.uint32();
      long maxqual = in.uint32();
      int maxlevel = in.int32();
      int maxnoise = in.int32();
      byte[] ap = in.bytes(32);
      return new Data(links, throughput, bitrate, mode, qualType, maxqual, maxlevel, maxnoise, ap);
    }

    @Override
    public void write(Writer out) {
      out.length("links", links.size(), 699049);
      out.length("links", links.size(), 699049);
      out.structs(links);
      out.uint32(throughput);
      out.uint32(bitrate);
      out.uint32(mode);
      out.uint32(qualType);
      out.uint32(maxqual);
      out.int32(maxlevel);
      out.int32(maxnoise);
      out.fixed("ap", ap, 32);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Data that && links.equals(that.links) && throughput == that.throughput
          && bitrate == that.bitrate && mode == that.mode && qualType == that.qualType
          && maxqual == that.maxqual && maxlevel == that.maxlevel && maxnoise == that.maxnoise
          && Arrays.equals(ap, that.ap);
    }

    @Override
    public int hashCode() {
      return Objects.hash(links, throughput, bitrate, mode, qualType, maxqual, maxlevel, maxnoise,
          Arrays.hashCode(ap));
    }
  }

  /**
   * The card's own address. (player_wifi_mac_req_t)
   *
   * @param mac Hardware address, as a string.
   */
  public record MacReq(byte[] mac) implements Struct {
    /** Every number 0, every list empty. */
    public MacReq() {
      this(new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static MacReq decode(byte[] body) {
      return Reader.decode("wifi.MacReq", body, MacReq::read);
    }

    static MacReq read(Reader in) {
      in.uint32();
      byte[] mac = in.bytes(in.length("mac", 32, 1));
      return new MacReq(mac);
    }

    @Override
    public void write(Writer out) {
      out.length("mac", mac.length, 32);
      out.length("mac", mac.length, 32);
      out.bytes(mac);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof MacReq that && Arrays.equals(mac, that.mac);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(mac);
    }
  }

  /**
   * The address of a station. (player_wifi_iwspy_addr_req_t)
   *
   * @param address Hardware address, as a string (32 elements).
   */
  public record IwspyAddrReq(byte[] address) implements Struct {
    /** Every number 0, every list empty. */
    public IwspyAddrReq() {
      this(new byte[32]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static IwspyAddrReq decode(byte[] body) {
      return Reader.decode("wifi.IwspyAddrReq", body, IwspyAddrReq::read);
    }

    static IwspyAddrReq read(Reader in) {
      byte[] address = in.bytes(32);
      return new IwspyAddrReq(address);
    }

    @Override
    public void write(Writer out) {
      out.fixed("address", address, 32);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof IwspyAddrReq that && Arrays.equals(address, that.address);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(address);
    }
  }

  /** Requests the card's own address. */
  public static final MessageType<MacReq> REQ_MAC =
      new MessageType<>(23, Kind.REQ, 1, "wifi.req.mac", MacReq::decode);

  /** Starts monitoring the links to an address. */
  public static final MessageType<IwspyAddrReq> REQ_IWSPY_ADD =
      new MessageType<>(23, Kind.REQ, 2, "wifi.req.iwspy_add", IwspyAddrReq::decode);

  /** Stops monitoring the links to an address. */
  public static final MessageType<IwspyAddrReq> REQ_IWSPY_DEL =
      new MessageType<>(23, Kind.REQ, 3, "wifi.req.iwspy_del", IwspyAddrReq::decode);

  /** Sends a packet to an address to measure its link. */
  public static final MessageType<IwspyAddrReq> REQ_IWSPY_PING =
      new MessageType<>(23, Kind.REQ, 4, "wifi.req.iwspy_ping", IwspyAddrReq::decode);

  /** Every link and the state of the card. */
  public static final MessageType<Data> DATA_STATE =
      new MessageType<>(23, Kind.DATA, 1, "wifi.data.state", Data::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_MAC, REQ_IWSPY_ADD, REQ_IWSPY_DEL, REQ_IWSPY_PING, DATA_STATE);

  private WifiMessages() {}
}
