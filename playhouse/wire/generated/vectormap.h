// Generated from interfaces/063_vectormap.toml by codegen (python3 -m codegen). Do not edit.
#pragma once

/// Maps of points, lines and areas in layers.

#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::vectormap {

inline constexpr std::uint16_t kCode = 63;

// Subtypes of messages.
/// Requests the list of layers.
inline constexpr std::uint8_t kReqGetMapInfo = 1;
/// Requests the features of a layer.
inline constexpr std::uint8_t kReqGetLayerData = 3;
/// Replaces the features of a layer.
inline constexpr std::uint8_t kReqWriteLayer = 4;

/// One feature.
struct FeatureData {
  std::string name{};
  /// Its shape, as OGC well-known binary, in map coordinates.
  std::vector<std::uint8_t> wkb{};
  /// Free text.
  std::string attrib{};

  friend bool operator==(const FeatureData&, const FeatureData&) = default;
};

/// Description of a layer.
struct LayerInfo {
  std::string name{};
  /// Bounding box of all its features. [frame p_MP, m]
  Extent2d extent{};

  friend bool operator==(const LayerInfo&, const LayerInfo&) = default;
};

/// A layer's features.
struct LayerData {
  std::string name{};
  std::vector<FeatureData> features{};

  friend bool operator==(const LayerData&, const LayerData&) = default;
};

/// List of layers.
struct Info {
  /// Id of the spatial reference system; 0: none.
  std::uint32_t srid = 0;
  std::vector<LayerInfo> layers{};
  /// Bounding box of all layers. [frame p_MP, m]
  Extent2d extent{};

  friend bool operator==(const Info&, const Info&) = default;
};

void read(Reader& in, FeatureData& m);
void write(Writer& out, const FeatureData& m);
void to_json(std::string& out, const FeatureData& m);
void read(Reader& in, LayerInfo& m);
void write(Writer& out, const LayerInfo& m);
void to_json(std::string& out, const LayerInfo& m);
void read(Reader& in, LayerData& m);
void write(Writer& out, const LayerData& m);
void to_json(std::string& out, const LayerData& m);
void read(Reader& in, Info& m);
void write(Writer& out, const Info& m);
void to_json(std::string& out, const Info& m);

}  // namespace playhouse::wire::vectormap
