#pragma once

/// Hello: the first message of a node: the format that it speaks, its build, and the token of the run.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace playhouse::cluster {

/// The body of a message kHello of this program, with the token of the run.
std::vector<std::byte> hello(std::string_view token = {});

/// Why a node that says this cannot join; empty: it can. `token`: of the run; empty: any.
std::string why_not_joined(std::span<const std::byte> body, std::string_view token = {});

}  // namespace playhouse::cluster
