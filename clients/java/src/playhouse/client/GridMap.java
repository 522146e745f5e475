package playhouse.client;

import java.util.Arrays;
import java.util.zip.DataFormatException;
import java.util.zip.Inflater;
import playhouse.client.wire.MapMessages;

/** A grid map: a device of the interface map. */
public final class GridMap extends Device {
  private static final int TILE = 512;  // cells along a side of a tile, so that any map fits into messages
  private static final long MOST_CELLS = 1 << 26;

  GridMap(Opening opening) {
    super(opening);
  }

  /**
   * Size and place of the map, without its cells. Throws WireException if the numbers are those of no map.
   */
  public Grid grid() {
    MapMessages.Info info = answer(MapMessages.REQ_GET_INFO);
    Pose origin = Pose.of(info.origin());
    double size = info.scale();
    if (!(size > 0 && Double.isFinite(size) && Double.isFinite(origin.x()) && Double.isFinite(origin.y())
        && Double.isFinite(origin.a()))) {
      throw new WireException(name() + ": invalid map: cells of " + Words.of(size) + " m from ("
          + Words.of(origin.x()) + ", " + Words.of(origin.y()) + ", " + Words.of(origin.a()) + ") on");
    }
    return new Grid(size, info.width(), info.height(), origin);
  }

  /**
   * The whole map, row by row from the bottom: cells()[row][column] is 1 if the cell is occupied, -1 if it is
   * free, 0 if that is unknown. Throws WireException for a map of more than 2^26 cells, and for faulty
   * answers.
   */
  public byte[][] cells() {
    Grid grid = grid();
    if ((double) grid.width() * grid.height() > MOST_CELLS) {
      throw new WireException(
          name() + ": " + grid.width() + " x " + grid.height() + " cells are over the limit of " + MOST_CELLS);
    }
    if (grid.width() == 0 || grid.height() == 0) {
      return new byte[0][];
    }
    int width = (int) grid.width();
    int height = (int) grid.height();
    byte[][] rows = new byte[height][width];
    for (int row = 0; row < height; row += TILE) {
      for (int column = 0; column < width; column += TILE) {
        copyTile(rows, column, row, Math.min(TILE, width - column), Math.min(TILE, height - row));
      }
    }
    return rows;
  }

  private void copyTile(byte[][] rows, int column, int row, int width, int height) {
    MapMessages.Data tile =
        answer(MapMessages.REQ_GET_DATA, new MapMessages.Data(column, row, width, height, 0, new byte[0]));
    byte[] values = uncompressed(tile.data(), width * height);
    if (values.length != width * height) {
      throw new WireException(name() + ": a tile of " + width + " x " + height + " cells is damaged");
    }
    int limit = Math.max(tile.dataRange(), 1);
    for (int i = 0; i < values.length; ++i) {
      rows[row + i / width][column + i % width] = occupancy(values[i], limit);
    }
  }

  /** 1 and -1 beyond half of the limit, else 0. */
  private static byte occupancy(int value, int limit) {
    return (byte) (2 * value > limit ? 1 : 2 * value < -limit ? -1 : 0);
  }

  /**
   * At most one byte more than {@code count}; the data themselves if they are not a zlib stream, as of a
   * server without it.
   */
  private static byte[] uncompressed(byte[] data, int count) {
    Inflater inflater = new Inflater();
    try {
      inflater.setInput(data);
      byte[] out = new byte[count + 1];
      int size = 0;
      int more;
      while (size < out.length && (more = inflater.inflate(out, size, out.length - size)) > 0) {
        size += more;
      }
      return Arrays.copyOf(out, size);
    } catch (DataFormatException error) {
      return data;
    } finally {
      inflater.end();
    }
  }
}
