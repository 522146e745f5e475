// Generated from interfaces/063_vectormap.toml by codegen (python3 -m codegen). Do not edit.
#pragma once


#include <cstdint>
#include <string>
#include <vector>

#include "playhouse/wire/generated/common.h"

namespace playhouse::wire::vectormap {

inline constexpr std::uint16_t kCode = 63;

// Subtypes of messages.
inline constexpr std::uint8_t kReqGetMapInfo = 1;
inline constexpr std::uint8_t kReqGetLayerData = 3;
inline constexpr std::uint8_t kReqWriteLayer = 4;

struct FeatureData {
  std::string name{};
  std::vector<std::uint8_t> wkb{};
  std::string attrib{};

  friend bool operator==(const FeatureData&, const FeatureData&) = default;
};

struct LayerInfo {
  std::string name{};
  /// [frame p_MP]
  Extent2d extent{};

  friend bool operator==(const LayerInfo&, const LayerInfo&) = default;
};

struct LayerData {
  std::string name{};
  std::vector<FeatureData> features{};

  friend bool operator==(const LayerData&, const LayerData&) = default;
};

struct Info {
  std::uint32_t srid = 0;
  std::vector<LayerInfo> layers{};
  /// [frame p_MP]
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
