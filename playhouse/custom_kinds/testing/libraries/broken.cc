// A custom model whose constructor throws.
#include <stdexcept>

#include "playhouse/world/custom_library.h"

struct Broken : playhouse::world::CustomKind {
  Broken() { throw std::runtime_error("has no batteries"); }
  Sizes configure(std::span<const std::string>) override { return {}; }
};

PLAYHOUSE_CUSTOM_KIND(Broken)
