// Generated from interfaces/063_vectormap.toml by codegen (python3 -m codegen). Do not edit.
package playhouse.client.wire;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Interface vectormap, code 63. Maps of points, lines and areas in layers. */
public final class VectormapMessages {
  /** The interface's code. */
  public static final int CODE = 63;

  /**
   * One feature. (player_vectormap_feature_data_t)
   *
   * @param name Name.
   * @param wkb Its shape, as OGC well-known binary, in map coordinates.
   * @param attrib Free text.
   */
  public record FeatureData(byte[] name, byte[] wkb, byte[] attrib) implements Struct {
    /** Every number 0, every list empty. */
    public FeatureData() {
      this(new byte[0], new byte[0], new byte[0]);
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static FeatureData decode(byte[] body) {
      return Reader.decode("vectormap.FeatureData", body, FeatureData::read);
    }

    static FeatureData read(Reader in) {
      long nameCount = in.uint32();
      byte[] name = in.bytes(in.length("name", nameCount, 1));
      long wkbCount = in.uint32();
      byte[] wkb = in.bytes(in.length("wkb", wkbCount, 1));
      long attribCount = in.uint32();
      byte[] attrib = in.bytes(in.length("attrib", attribCount, 1));
      return new FeatureData(name, wkb, attrib);
    }

    @Override
    public void write(Writer out) {
      out.length("name", name.length, 33554392);
      out.length("name", name.length, 33554392);
      out.bytes(name);
      out.length("wkb", wkb.length, 33554392);
      out.length("wkb", wkb.length, 33554392);
      out.bytes(wkb);
      out.length("attrib", attrib.length, 33554392);
      out.length("attrib", attrib.length, 33554392);
      out.bytes(attrib);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof FeatureData that && Arrays.equals(name, that.name)
          && Arrays.equals(wkb, that.wkb) && Arrays.equals(attrib, that.attrib);
    }

    @Override
    public int hashCode() {
      return Objects.hash(Arrays.hashCode(name), Arrays.hashCode(wkb), Arrays.hashCode(attrib));
    }
  }

  /**
   * Description of a layer. (player_vectormap_layer_info_t)
   *
   * @param name Name.
   * @param extent Bounding box of all its features (in m, frame p_MP).
   */
  public record LayerInfo(byte[] name, CommonMessages.Extent2d extent) implements Struct {
    /** Every number 0, every list empty. */
    public LayerInfo() {
      this(new byte[0], new CommonMessages.Extent2d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static LayerInfo decode(byte[] body) {
      return Reader.decode("vectormap.LayerInfo", body, LayerInfo::read);
    }

    static LayerInfo read(Reader in) {
      long nameCount = in.uint32();
      byte[] name = in.bytes(in.length("name", nameCount, 1));
      CommonMessages.Extent2d extent = CommonMessages.Extent2d.read(in);
      return new LayerInfo(name, extent);
    }

    @Override
    public void write(Writer out) {
      out.length("name", name.length, 33554392);
      out.length("name", name.length, 33554392);
      out.bytes(name);
      extent.write(out);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof LayerInfo that && Arrays.equals(name, that.name) && extent.equals(that.extent);
    }

    @Override
    public int hashCode() {
      return Objects.hash(extent, Arrays.hashCode(name));
    }
  }

  /**
   * A layer's features. (player_vectormap_layer_data_t)
   *
   * @param name Name.
   * @param features Features.
   */
  public record LayerData(byte[] name, List<FeatureData> features) implements Struct {
    /** Every number 0, every list empty. */
    public LayerData() {
      this(new byte[0], List.of());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static LayerData decode(byte[] body) {
      return Reader.decode("vectormap.LayerData", body, LayerData::read);
    }

    static LayerData read(Reader in) {
      long nameCount = in.uint32();
      byte[] name = in.bytes(in.length("name", nameCount, 1));
      long featuresCount = in.uint32();
      List<FeatureData> features = in.structs(in.length("features", featuresCount, 24), FeatureData::read);
      return new LayerData(name, features);
    }

    @Override
    public void write(Writer out) {
      out.length("name", name.length, 33554392);
      out.length("name", name.length, 33554392);
      out.bytes(name);
      out.length("features", features.size(), 1398099);
      out.length("features", features.size(), 1398099);
      out.structs(features);
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof LayerData that && Arrays.equals(name, that.name)
          && features.equals(that.features);
    }

    @Override
    public int hashCode() {
      return Objects.hash(features, Arrays.hashCode(name));
    }
  }

  /**
   * List of layers. (player_vectormap_info_t)
   *
   * @param srid Id of the spatial reference system; 0: none.
   * @param layers Layers.
   * @param extent Bounding box of all layers (in m, frame p_MP).
   */
  public record Info(long srid, List<LayerInfo> layers, CommonMessages.Extent2d extent) implements Struct {
    /** Every number 0, every list empty. */
    public Info() {
      this(0L, List.of(), new CommonMessages.Extent2d());
    }

    /** Decodes a body; bytes after the last field are ignored. Throws WireException. */
    public static Info decode(byte[] body) {
      return Reader.decode("vectormap.Info", body, Info::read);
    }

    static Info read(Reader in) {
      long srid = in.uint32();
      long layersCount = in.uint32();
      List<LayerInfo> layers = in.structs(in.length("layers", layersCount, 40), LayerInfo::read);
      CommonMessages.Extent2d extent = CommonMessages.Extent2d.read(in);
      return new Info(srid, layers, extent);
    }

    @Override
    public void write(Writer out) {
      out.uint32(srid);
      out.length("layers", layers.size(), 838859);
      out.length("layers", layers.size(), 838859);
      out.structs(layers);
      extent.write(out);
    }
  }

  /** Requests the list of layers. */
  public static final MessageType<Info> REQ_GET_MAP_INFO =
      new MessageType<>(63, Kind.REQ, 1, "vectormap.req.get_map_info", Info::decode);

  /** Requests the features of a layer. */
  public static final MessageType<LayerData> REQ_GET_LAYER_DATA =
      new MessageType<>(63, Kind.REQ, 3, "vectormap.req.get_layer_data", LayerData::decode);

  /** Replaces the features of a layer. */
  public static final MessageType<LayerData> REQ_WRITE_LAYER =
      new MessageType<>(63, Kind.REQ, 4, "vectormap.req.write_layer", LayerData::decode);

  static final List<MessageType<?>> MESSAGES = List.of(
      REQ_GET_MAP_INFO, REQ_GET_LAYER_DATA, REQ_WRITE_LAYER);

  private VectormapMessages() {}
}
