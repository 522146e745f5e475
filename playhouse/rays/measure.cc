#include "playhouse/rays/measure.h"

namespace playhouse::rays {

void Scratch::make_room(std::size_t beams, const bodies::Space& space) {
  const bodies::Solids& solids = space.solids;
  for (std::vector<double>* column : {&range, &solid, &beam_x, &beam_y}) column->resize(beams + Scan::kPad);
  const std::size_t bodies = solids.moving() + simd::kEight;  // padded for vectors of eight
  for (std::vector<double>* column : {&x, &y, &distance, &bearing, &radius}) column->resize(bodies);
  place.resize(bodies);
  order.resize(bodies);
  for (std::vector<std::int32_t>* column : {&ring, &first, &last}) column->resize(bodies);
  met_by.resize(bodies);
  cell.resize(bodies);
  runs.resize(space.index.most_runs());
  stamp.assign(space.walls.edge_count(), 0);
  scans = 0;
}

}  // namespace playhouse::rays
