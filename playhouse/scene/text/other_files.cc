#include "playhouse/scene/text/other_files.h"

#include <algorithm>
#include <array>

#include "playhouse/base/in_quotes.h"
#include "playhouse/mesh/read_mesh.h"
#include "playhouse/scene/images/bitmap.h"
#include "playhouse/scene/images/ros_map.h"

namespace playhouse::scene {
namespace {

using namespace std::string_view_literals;

constexpr std::array kImages = {"\x89PNG"sv, "\xff\xd8\xff"sv, "GIF8"sv, "II*\0"sv, "MM\0*"sv};
constexpr std::string_view kRecording = "\x89MCAP";
constexpr std::string_view kSavedRun = "playhouse saved run ";

/// Text of PNM images, "P5\n": no word of a world file begins so.
bool is_pnm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6' &&
         std::string_view(" \t\r\n").find(bytes[2]) != std::string_view::npos;
}

bool is_image(const std::string& path, std::string_view bytes) {
  return is_image_name(path) || is_pnm(bytes) ||
         std::ranges::any_of(kImages, [&](std::string_view magic) { return bytes.starts_with(magic); });
}

}  // namespace

std::optional<std::string> what_else(const std::string& path, std::string_view bytes) {
  const std::string name = escaped(path);
  if (is_image(path, bytes))
    return "is an image, not a world: playhouse convert " + name +
           " --scale METRES makes one of it, METRES of a pixel";
  if (is_map_name(path))
    return "is a map of ROS, not a world: playhouse convert " + name + " makes one of it";
  if (mesh::is_mesh_name(path)) return "is a mesh, not a world: a model of a world has it by the word mesh";
  if (bytes.starts_with(kRecording))
    return "is a recording, not a world: playhouse replay, run --again, picture, film and export read it";
  if (bytes.starts_with(kSavedRun)) return "is a saved run, not a world: playhouse run --from " + name;
  return std::nullopt;
}

}  // namespace playhouse::scene
