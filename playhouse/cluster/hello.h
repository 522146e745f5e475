#pragma once

/// Hello: the first message of a node.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace playhouse::cluster {

/// The body of a message kHello of this program.
std::vector<std::byte> hello();

/// Why a node that says this cannot join; empty: it can.
std::string why_not_joined(std::span<const std::byte> body);

}  // namespace playhouse::cluster
