// A controller whose constructor throws.
#include <stdexcept>

#include "playhouse/controllers/controller.h"

struct Broken : playhouse::controllers::Controller {
  Broken() { throw std::runtime_error("has no batteries"); }
  void decide(playhouse::controllers::Robot&) override {}
};

PLAYHOUSE_CONTROLLER(Broken)
