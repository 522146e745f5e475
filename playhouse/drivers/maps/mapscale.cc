#include "playhouse/drivers/maps/mapscale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "playhouse/drivers/maps/map_filter.h"

namespace playhouse::drivers {

namespace {

constexpr double kMostScaledCells = 1 << 26;
constexpr double kNoPart = 1e-3;  // of a cell, as sizes are float32

/// Cells of the source along one axis that a cell overlaps.
struct CellSpan {
  int first = 0, end = 0;
};

/// Of each cell; `ratio`: how many cells of the source it is long.
std::vector<CellSpan> spans(int count, double ratio, int source_count) {
  const double most = source_count;
  std::vector<CellSpan> all;
  for (int i = 0; i < count; ++i) {
    const double from = std::floor(i * ratio + kNoPart), to = std::ceil((i + 1) * ratio - kNoPart);
    all.push_back({static_cast<int>(std::min(from, most)), static_cast<int>(std::min(to, most))});
  }
  return all;
}

/// Of a part of the source that is beyond it, if `is_beyond`.
std::int8_t worst_of(const GridMap& source, const CellSpan& columns, const CellSpan& rows, bool is_beyond) {
  bool unknown = is_beyond;
  for (int row = rows.first; row < rows.end; ++row) {
    for (int column = columns.first; column < columns.end; ++column) {
      const std::int8_t cell =
          source.cells[static_cast<std::size_t>(row) * source.info.width + static_cast<std::size_t>(column)];
      if (cell > 0) return 1;
      unknown = unknown || cell == 0;
    }
  }
  return unknown ? std::int8_t{0} : std::int8_t{-1};
}

}  // namespace

Result<GridMap> MapScale::map(const GridMap& source) const {
  const double ratio = resolution / static_cast<double>(source.info.scale);
  const double width = std::max(std::ceil(source.width() / ratio - kNoPart), 1.0),
               height = std::max(std::ceil(source.height() / ratio - kNoPart), 1.0);
  if (!(width * height <= kMostScaledCells))
    return Error{{}, fmt::format("would have more than {:.0f} cells of {} m", kMostScaledCells, resolution)};
  GridMap scaled;
  scaled.info = {static_cast<float>(resolution), static_cast<std::uint32_t>(width),
                 static_cast<std::uint32_t>(height), source.info.origin};
  const std::vector<CellSpan> columns = spans(scaled.width(), ratio, source.width()),
                              rows = spans(scaled.height(), ratio, source.height());
  scaled.cells.reserve(columns.size() * rows.size());
  const auto is_beyond = [&](int i, int count) { return (i + 1) * ratio > count + kNoPart; };
  for (int row = 0; row < scaled.height(); ++row)
    for (int column = 0; column < scaled.width(); ++column)
      scaled.cells.push_back(worst_of(source, columns[static_cast<std::size_t>(column)],
                                      rows[static_cast<std::size_t>(row)],
                                      is_beyond(column, source.width()) || is_beyond(row, source.height())));
  return scaled;
}

Result<MapScale> map_scale_options(SectionFields fields) {
  constexpr double kFinestScale = 1e-4, kCoarsestScale = 1000;  // m
  const double resolution = fields.length({"resolution", "Size of a cell, 0.0001 to 1000.", {}, "required"},
                                          -1, SectionFields::kAnyNumber);
  fields.expect(resolution >= kFinestScale && resolution <= kCoarsestScale, "resolution",
                "is needed, from 0.0001 to 1000 m per cell");
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return MapScale{resolution};
}

constinit const DriverDefinition kMapScaleDriver{
    .name = "mapscale",
    .doc = "A map with cells of another size.",
    .provides = kMapFilterProvides,
    .uses = kMapFilterUses,
    .read_options = reading<map_scale_options>,
    .make = make_map_filter<map_scale_options, MapScale>,
};

}  // namespace playhouse::drivers
