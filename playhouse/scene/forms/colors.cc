#include "playhouse/scene/forms/colors.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "playhouse/base/nearest_word.h"

namespace playhouse::scene {
namespace {

struct NamedColor {
  std::string_view name;
  std::uint32_t rgb;
};

// X11's colour table: original spelling without spaces, "grey" as
// "gray", sorted case-insensitively. gray0 to gray100 are computed.
// clang-format off
constexpr NamedColor kColors[] = {
    {"AliceBlue", 0xF0F8FF}, {"AntiqueWhite", 0xFAEBD7}, {"AntiqueWhite1", 0xFFEFDB},
    {"AntiqueWhite2", 0xEEDFCC}, {"AntiqueWhite3", 0xCDC0B0}, {"AntiqueWhite4", 0x8B8378}, {"aqua", 0x00FFFF},
    {"aquamarine", 0x7FFFD4}, {"aquamarine1", 0x7FFFD4}, {"aquamarine2", 0x76EEC6}, {"aquamarine3", 0x66CDAA},
    {"aquamarine4", 0x458B74}, {"azure", 0xF0FFFF}, {"azure1", 0xF0FFFF}, {"azure2", 0xE0EEEE},
    {"azure3", 0xC1CDCD}, {"azure4", 0x838B8B}, {"beige", 0xF5F5DC}, {"bisque", 0xFFE4C4},
    {"bisque1", 0xFFE4C4}, {"bisque2", 0xEED5B7}, {"bisque3", 0xCDB79E}, {"bisque4", 0x8B7D6B},
    {"black", 0x000000}, {"BlanchedAlmond", 0xFFEBCD}, {"blue", 0x0000FF}, {"blue1", 0x0000FF},
    {"blue2", 0x0000EE}, {"blue3", 0x0000CD}, {"blue4", 0x00008B}, {"BlueViolet", 0x8A2BE2},
    {"brown", 0xA52A2A}, {"brown1", 0xFF4040}, {"brown2", 0xEE3B3B}, {"brown3", 0xCD3333},
    {"brown4", 0x8B2323}, {"burlywood", 0xDEB887}, {"burlywood1", 0xFFD39B}, {"burlywood2", 0xEEC591},
    {"burlywood3", 0xCDAA7D}, {"burlywood4", 0x8B7355}, {"CadetBlue", 0x5F9EA0}, {"CadetBlue1", 0x98F5FF},
    {"CadetBlue2", 0x8EE5EE}, {"CadetBlue3", 0x7AC5CD}, {"CadetBlue4", 0x53868B}, {"chartreuse", 0x7FFF00},
    {"chartreuse1", 0x7FFF00}, {"chartreuse2", 0x76EE00}, {"chartreuse3", 0x66CD00},
    {"chartreuse4", 0x458B00}, {"chocolate", 0xD2691E}, {"chocolate1", 0xFF7F24}, {"chocolate2", 0xEE7621},
    {"chocolate3", 0xCD661D}, {"chocolate4", 0x8B4513}, {"coral", 0xFF7F50}, {"coral1", 0xFF7256},
    {"coral2", 0xEE6A50}, {"coral3", 0xCD5B45}, {"coral4", 0x8B3E2F}, {"CornflowerBlue", 0x6495ED},
    {"cornsilk", 0xFFF8DC}, {"cornsilk1", 0xFFF8DC}, {"cornsilk2", 0xEEE8CD}, {"cornsilk3", 0xCDC8B1},
    {"cornsilk4", 0x8B8878}, {"crimson", 0xDC143C}, {"cyan", 0x00FFFF}, {"cyan1", 0x00FFFF},
    {"cyan2", 0x00EEEE}, {"cyan3", 0x00CDCD}, {"cyan4", 0x008B8B}, {"DarkBlue", 0x00008B},
    {"DarkCyan", 0x008B8B}, {"DarkGoldenrod", 0xB8860B}, {"DarkGoldenrod1", 0xFFB90F},
    {"DarkGoldenrod2", 0xEEAD0E}, {"DarkGoldenrod3", 0xCD950C}, {"DarkGoldenrod4", 0x8B6508},
    {"DarkGray", 0xA9A9A9}, {"DarkGreen", 0x006400}, {"DarkKhaki", 0xBDB76B}, {"DarkMagenta", 0x8B008B},
    {"DarkOliveGreen", 0x556B2F}, {"DarkOliveGreen1", 0xCAFF70}, {"DarkOliveGreen2", 0xBCEE68},
    {"DarkOliveGreen3", 0xA2CD5A}, {"DarkOliveGreen4", 0x6E8B3D}, {"DarkOrange", 0xFF8C00},
    {"DarkOrange1", 0xFF7F00}, {"DarkOrange2", 0xEE7600}, {"DarkOrange3", 0xCD6600},
    {"DarkOrange4", 0x8B4500}, {"DarkOrchid", 0x9932CC}, {"DarkOrchid1", 0xBF3EFF}, {"DarkOrchid2", 0xB23AEE},
    {"DarkOrchid3", 0x9A32CD}, {"DarkOrchid4", 0x68228B}, {"DarkRed", 0x8B0000}, {"DarkSalmon", 0xE9967A},
    {"DarkSeaGreen", 0x8FBC8F}, {"DarkSeaGreen1", 0xC1FFC1}, {"DarkSeaGreen2", 0xB4EEB4},
    {"DarkSeaGreen3", 0x9BCD9B}, {"DarkSeaGreen4", 0x698B69}, {"DarkSlateBlue", 0x483D8B},
    {"DarkSlateGray", 0x2F4F4F}, {"DarkSlateGray1", 0x97FFFF}, {"DarkSlateGray2", 0x8DEEEE},
    {"DarkSlateGray3", 0x79CDCD}, {"DarkSlateGray4", 0x528B8B}, {"DarkTurquoise", 0x00CED1},
    {"DarkViolet", 0x9400D3}, {"DebianRed", 0xD70751}, {"DeepPink", 0xFF1493}, {"DeepPink1", 0xFF1493},
    {"DeepPink2", 0xEE1289}, {"DeepPink3", 0xCD1076}, {"DeepPink4", 0x8B0A50}, {"DeepSkyBlue", 0x00BFFF},
    {"DeepSkyBlue1", 0x00BFFF}, {"DeepSkyBlue2", 0x00B2EE}, {"DeepSkyBlue3", 0x009ACD},
    {"DeepSkyBlue4", 0x00688B}, {"DimGray", 0x696969}, {"DodgerBlue", 0x1E90FF}, {"DodgerBlue1", 0x1E90FF},
    {"DodgerBlue2", 0x1C86EE}, {"DodgerBlue3", 0x1874CD}, {"DodgerBlue4", 0x104E8B}, {"firebrick", 0xB22222},
    {"firebrick1", 0xFF3030}, {"firebrick2", 0xEE2C2C}, {"firebrick3", 0xCD2626}, {"firebrick4", 0x8B1A1A},
    {"FloralWhite", 0xFFFAF0}, {"ForestGreen", 0x228B22}, {"fuchsia", 0xFF00FF}, {"gainsboro", 0xDCDCDC},
    {"GhostWhite", 0xF8F8FF}, {"gold", 0xFFD700}, {"gold1", 0xFFD700}, {"gold2", 0xEEC900},
    {"gold3", 0xCDAD00}, {"gold4", 0x8B7500}, {"goldenrod", 0xDAA520}, {"goldenrod1", 0xFFC125},
    {"goldenrod2", 0xEEB422}, {"goldenrod3", 0xCD9B1D}, {"goldenrod4", 0x8B6914}, {"gray", 0xBEBEBE},
    {"green", 0x00FF00}, {"green1", 0x00FF00}, {"green2", 0x00EE00}, {"green3", 0x00CD00},
    {"green4", 0x008B00}, {"GreenYellow", 0xADFF2F}, {"honeydew", 0xF0FFF0}, {"honeydew1", 0xF0FFF0},
    {"honeydew2", 0xE0EEE0}, {"honeydew3", 0xC1CDC1}, {"honeydew4", 0x838B83}, {"HotPink", 0xFF69B4},
    {"HotPink1", 0xFF6EB4}, {"HotPink2", 0xEE6AA7}, {"HotPink3", 0xCD6090}, {"HotPink4", 0x8B3A62},
    {"IndianRed", 0xCD5C5C}, {"IndianRed1", 0xFF6A6A}, {"IndianRed2", 0xEE6363}, {"IndianRed3", 0xCD5555},
    {"IndianRed4", 0x8B3A3A}, {"indigo", 0x4B0082}, {"ivory", 0xFFFFF0}, {"ivory1", 0xFFFFF0},
    {"ivory2", 0xEEEEE0}, {"ivory3", 0xCDCDC1}, {"ivory4", 0x8B8B83}, {"khaki", 0xF0E68C},
    {"khaki1", 0xFFF68F}, {"khaki2", 0xEEE685}, {"khaki3", 0xCDC673}, {"khaki4", 0x8B864E},
    {"lavender", 0xE6E6FA}, {"LavenderBlush", 0xFFF0F5}, {"LavenderBlush1", 0xFFF0F5},
    {"LavenderBlush2", 0xEEE0E5}, {"LavenderBlush3", 0xCDC1C5}, {"LavenderBlush4", 0x8B8386},
    {"LawnGreen", 0x7CFC00}, {"LemonChiffon", 0xFFFACD}, {"LemonChiffon1", 0xFFFACD},
    {"LemonChiffon2", 0xEEE9BF}, {"LemonChiffon3", 0xCDC9A5}, {"LemonChiffon4", 0x8B8970},
    {"LightBlue", 0xADD8E6}, {"LightBlue1", 0xBFEFFF}, {"LightBlue2", 0xB2DFEE}, {"LightBlue3", 0x9AC0CD},
    {"LightBlue4", 0x68838B}, {"LightCoral", 0xF08080}, {"LightCyan", 0xE0FFFF}, {"LightCyan1", 0xE0FFFF},
    {"LightCyan2", 0xD1EEEE}, {"LightCyan3", 0xB4CDCD}, {"LightCyan4", 0x7A8B8B},
    {"LightGoldenrod", 0xEEDD82}, {"LightGoldenrod1", 0xFFEC8B}, {"LightGoldenrod2", 0xEEDC82},
    {"LightGoldenrod3", 0xCDBE70}, {"LightGoldenrod4", 0x8B814C}, {"LightGoldenrodYellow", 0xFAFAD2},
    {"LightGray", 0xD3D3D3}, {"LightGreen", 0x90EE90}, {"LightPink", 0xFFB6C1}, {"LightPink1", 0xFFAEB9},
    {"LightPink2", 0xEEA2AD}, {"LightPink3", 0xCD8C95}, {"LightPink4", 0x8B5F65}, {"LightSalmon", 0xFFA07A},
    {"LightSalmon1", 0xFFA07A}, {"LightSalmon2", 0xEE9572}, {"LightSalmon3", 0xCD8162},
    {"LightSalmon4", 0x8B5742}, {"LightSeaGreen", 0x20B2AA}, {"LightSkyBlue", 0x87CEFA},
    {"LightSkyBlue1", 0xB0E2FF}, {"LightSkyBlue2", 0xA4D3EE}, {"LightSkyBlue3", 0x8DB6CD},
    {"LightSkyBlue4", 0x607B8B}, {"LightSlateBlue", 0x8470FF}, {"LightSlateGray", 0x778899},
    {"LightSteelBlue", 0xB0C4DE}, {"LightSteelBlue1", 0xCAE1FF}, {"LightSteelBlue2", 0xBCD2EE},
    {"LightSteelBlue3", 0xA2B5CD}, {"LightSteelBlue4", 0x6E7B8B}, {"LightYellow", 0xFFFFE0},
    {"LightYellow1", 0xFFFFE0}, {"LightYellow2", 0xEEEED1}, {"LightYellow3", 0xCDCDB4},
    {"LightYellow4", 0x8B8B7A}, {"lime", 0x00FF00}, {"LimeGreen", 0x32CD32}, {"linen", 0xFAF0E6},
    {"magenta", 0xFF00FF}, {"magenta1", 0xFF00FF}, {"magenta2", 0xEE00EE}, {"magenta3", 0xCD00CD},
    {"magenta4", 0x8B008B}, {"maroon", 0xB03060}, {"maroon1", 0xFF34B3}, {"maroon2", 0xEE30A7},
    {"maroon3", 0xCD2990}, {"maroon4", 0x8B1C62}, {"MediumAquamarine", 0x66CDAA}, {"MediumBlue", 0x0000CD},
    {"MediumOrchid", 0xBA55D3}, {"MediumOrchid1", 0xE066FF}, {"MediumOrchid2", 0xD15FEE},
    {"MediumOrchid3", 0xB452CD}, {"MediumOrchid4", 0x7A378B}, {"MediumPurple", 0x9370DB},
    {"MediumPurple1", 0xAB82FF}, {"MediumPurple2", 0x9F79EE}, {"MediumPurple3", 0x8968CD},
    {"MediumPurple4", 0x5D478B}, {"MediumSeaGreen", 0x3CB371}, {"MediumSlateBlue", 0x7B68EE},
    {"MediumSpringGreen", 0x00FA9A}, {"MediumTurquoise", 0x48D1CC}, {"MediumVioletRed", 0xC71585},
    {"MidnightBlue", 0x191970}, {"MintCream", 0xF5FFFA}, {"MistyRose", 0xFFE4E1}, {"MistyRose1", 0xFFE4E1},
    {"MistyRose2", 0xEED5D2}, {"MistyRose3", 0xCDB7B5}, {"MistyRose4", 0x8B7D7B}, {"moccasin", 0xFFE4B5},
    {"NavajoWhite", 0xFFDEAD}, {"NavajoWhite1", 0xFFDEAD}, {"NavajoWhite2", 0xEECFA1},
    {"NavajoWhite3", 0xCDB38B}, {"NavajoWhite4", 0x8B795E}, {"navy", 0x000080}, {"NavyBlue", 0x000080},
    {"OldLace", 0xFDF5E6}, {"olive", 0x808000}, {"OliveDrab", 0x6B8E23}, {"OliveDrab1", 0xC0FF3E},
    {"OliveDrab2", 0xB3EE3A}, {"OliveDrab3", 0x9ACD32}, {"OliveDrab4", 0x698B22}, {"orange", 0xFFA500},
    {"orange1", 0xFFA500}, {"orange2", 0xEE9A00}, {"orange3", 0xCD8500}, {"orange4", 0x8B5A00},
    {"OrangeRed", 0xFF4500}, {"OrangeRed1", 0xFF4500}, {"OrangeRed2", 0xEE4000}, {"OrangeRed3", 0xCD3700},
    {"OrangeRed4", 0x8B2500}, {"orchid", 0xDA70D6}, {"orchid1", 0xFF83FA}, {"orchid2", 0xEE7AE9},
    {"orchid3", 0xCD69C9}, {"orchid4", 0x8B4789}, {"PaleGoldenrod", 0xEEE8AA}, {"PaleGreen", 0x98FB98},
    {"PaleGreen1", 0x9AFF9A}, {"PaleGreen2", 0x90EE90}, {"PaleGreen3", 0x7CCD7C}, {"PaleGreen4", 0x548B54},
    {"PaleTurquoise", 0xAFEEEE}, {"PaleTurquoise1", 0xBBFFFF}, {"PaleTurquoise2", 0xAEEEEE},
    {"PaleTurquoise3", 0x96CDCD}, {"PaleTurquoise4", 0x668B8B}, {"PaleVioletRed", 0xDB7093},
    {"PaleVioletRed1", 0xFF82AB}, {"PaleVioletRed2", 0xEE799F}, {"PaleVioletRed3", 0xCD6889},
    {"PaleVioletRed4", 0x8B475D}, {"PapayaWhip", 0xFFEFD5}, {"PeachPuff", 0xFFDAB9}, {"PeachPuff1", 0xFFDAB9},
    {"PeachPuff2", 0xEECBAD}, {"PeachPuff3", 0xCDAF95}, {"PeachPuff4", 0x8B7765}, {"peru", 0xCD853F},
    {"pink", 0xFFC0CB}, {"pink1", 0xFFB5C5}, {"pink2", 0xEEA9B8}, {"pink3", 0xCD919E}, {"pink4", 0x8B636C},
    {"plum", 0xDDA0DD}, {"plum1", 0xFFBBFF}, {"plum2", 0xEEAEEE}, {"plum3", 0xCD96CD}, {"plum4", 0x8B668B},
    {"PowderBlue", 0xB0E0E6}, {"purple", 0xA020F0}, {"purple1", 0x9B30FF}, {"purple2", 0x912CEE},
    {"purple3", 0x7D26CD}, {"purple4", 0x551A8B}, {"red", 0xFF0000}, {"red1", 0xFF0000}, {"red2", 0xEE0000},
    {"red3", 0xCD0000}, {"red4", 0x8B0000}, {"RosyBrown", 0xBC8F8F}, {"RosyBrown1", 0xFFC1C1},
    {"RosyBrown2", 0xEEB4B4}, {"RosyBrown3", 0xCD9B9B}, {"RosyBrown4", 0x8B6969}, {"RoyalBlue", 0x4169E1},
    {"RoyalBlue1", 0x4876FF}, {"RoyalBlue2", 0x436EEE}, {"RoyalBlue3", 0x3A5FCD}, {"RoyalBlue4", 0x27408B},
    {"SaddleBrown", 0x8B4513}, {"salmon", 0xFA8072}, {"salmon1", 0xFF8C69}, {"salmon2", 0xEE8262},
    {"salmon3", 0xCD7054}, {"salmon4", 0x8B4C39}, {"SandyBrown", 0xF4A460}, {"SeaGreen", 0x2E8B57},
    {"SeaGreen1", 0x54FF9F}, {"SeaGreen2", 0x4EEE94}, {"SeaGreen3", 0x43CD80}, {"SeaGreen4", 0x2E8B57},
    {"seashell", 0xFFF5EE}, {"seashell1", 0xFFF5EE}, {"seashell2", 0xEEE5DE}, {"seashell3", 0xCDC5BF},
    {"seashell4", 0x8B8682}, {"sienna", 0xA0522D}, {"sienna1", 0xFF8247}, {"sienna2", 0xEE7942},
    {"sienna3", 0xCD6839}, {"sienna4", 0x8B4726}, {"silver", 0xC0C0C0}, {"SkyBlue", 0x87CEEB},
    {"SkyBlue1", 0x87CEFF}, {"SkyBlue2", 0x7EC0EE}, {"SkyBlue3", 0x6CA6CD}, {"SkyBlue4", 0x4A708B},
    {"SlateBlue", 0x6A5ACD}, {"SlateBlue1", 0x836FFF}, {"SlateBlue2", 0x7A67EE}, {"SlateBlue3", 0x6959CD},
    {"SlateBlue4", 0x473C8B}, {"SlateGray", 0x708090}, {"SlateGray1", 0xC6E2FF}, {"SlateGray2", 0xB9D3EE},
    {"SlateGray3", 0x9FB6CD}, {"SlateGray4", 0x6C7B8B}, {"snow", 0xFFFAFA}, {"snow1", 0xFFFAFA},
    {"snow2", 0xEEE9E9}, {"snow3", 0xCDC9C9}, {"snow4", 0x8B8989}, {"SpringGreen", 0x00FF7F},
    {"SpringGreen1", 0x00FF7F}, {"SpringGreen2", 0x00EE76}, {"SpringGreen3", 0x00CD66},
    {"SpringGreen4", 0x008B45}, {"SteelBlue", 0x4682B4}, {"SteelBlue1", 0x63B8FF}, {"SteelBlue2", 0x5CACEE},
    {"SteelBlue3", 0x4F94CD}, {"SteelBlue4", 0x36648B}, {"tan", 0xD2B48C}, {"tan1", 0xFFA54F},
    {"tan2", 0xEE9A49}, {"tan3", 0xCD853F}, {"tan4", 0x8B5A2B}, {"teal", 0x008080}, {"thistle", 0xD8BFD8},
    {"thistle1", 0xFFE1FF}, {"thistle2", 0xEED2EE}, {"thistle3", 0xCDB5CD}, {"thistle4", 0x8B7B8B},
    {"tomato", 0xFF6347}, {"tomato1", 0xFF6347}, {"tomato2", 0xEE5C42}, {"tomato3", 0xCD4F39},
    {"tomato4", 0x8B3626}, {"turquoise", 0x40E0D0}, {"turquoise1", 0x00F5FF}, {"turquoise2", 0x00E5EE},
    {"turquoise3", 0x00C5CD}, {"turquoise4", 0x00868B}, {"violet", 0xEE82EE}, {"VioletRed", 0xD02090},
    {"VioletRed1", 0xFF3E96}, {"VioletRed2", 0xEE3A8C}, {"VioletRed3", 0xCD3278}, {"VioletRed4", 0x8B2252},
    {"wheat", 0xF5DEB3}, {"wheat1", 0xFFE7BA}, {"wheat2", 0xEED8AE}, {"wheat3", 0xCDBA96},
    {"wheat4", 0x8B7E66}, {"white", 0xFFFFFF}, {"WhiteSmoke", 0xF5F5F5}, {"yellow", 0xFFFF00},
    {"yellow1", 0xFFFF00}, {"yellow2", 0xEEEE00}, {"yellow3", 0xCDCD00}, {"yellow4", 0x8B8B00},
    {"YellowGreen", 0x9ACD32},
};
// clang-format on

/// Entries that are not X11's, unknown to Stage 4.
constexpr std::string_view kOthers[] = {"aqua", "crimson", "DebianRed", "fuchsia", "indigo",
                                        "lime", "olive",   "silver",    "teal"};

Color opaque(std::uint32_t rgb) {
  const auto channel = [rgb](int shift) { return static_cast<float>((rgb >> shift) & 0xFF) / 255.0f; };
  return {channel(16), channel(8), channel(0), 1};
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Normalised to the table's spelling, in lower case.
std::string table_spelling(std::string_view name) {
  std::string word;
  for (const char c : name)
    if (c != ' ') word += lower(c);
  if (const std::size_t grey = word.find("grey"); grey != std::string::npos) word[grey + 2] = 'a';
  return word;
}

/// The table's sort order.
bool is_below(std::string_view a, std::string_view b) {
  return std::ranges::lexicographical_compare(a, b, {}, lower, lower);
}

std::uint32_t gray_rgb(int percent) {
  return static_cast<std::uint32_t>(percent * 2.55 + 0.5) * 0x010101u;
}

/// The colour of "gray0" .. "gray100".
std::optional<Color> gray_level(std::string_view word) {
  if (!word.starts_with("gray") || word.size() < 5 || word.size() > 7) return std::nullopt;
  int percent = 0;
  for (const char c : word.substr(4)) {
    if (c < '0' || c > '9') return std::nullopt;
    percent = 10 * percent + (c - '0');
  }
  if (percent > 100) return std::nullopt;
  return opaque(gray_rgb(percent));
}

}  // namespace

std::optional<Color> color_by_name(std::string_view name) {
  const std::string word = table_spelling(name);
  if (const auto gray = gray_level(word)) return gray;
  const auto found =
      std::lower_bound(std::begin(kColors), std::end(kColors), word,
                       [](const NamedColor& color, const std::string& w) { return is_below(color.name, w); });
  if (found == std::end(kColors) || is_below(word, found->name)) return std::nullopt;
  return opaque(found->rgb);
}

std::uint32_t rgba8(const Color& color) {
  const auto channel = [](float value) {
    const float within = std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0.0f;
    return static_cast<std::uint32_t>(within * 255.0f + 0.5f);
  };
  return channel(color.r) << 24 | channel(color.g) << 16 | channel(color.b) << 8 | channel(color.a);
}

std::string color_name(const Color& color, bool others) {
  const std::uint32_t rgb = rgba8(color) >> 8;
  if (opaque(rgb) != color) return {};
  std::string_view best;
  for (const NamedColor& named : kColors) {
    if (named.rgb != rgb || (!others && std::ranges::find(kOthers, named.name) != std::end(kOthers)))
      continue;
    if (best.empty() || named.name.size() < best.size()) best = named.name;
  }
  if (!best.empty()) return std::string(best);
  for (int percent = 0; percent <= 100; ++percent)
    if (gray_rgb(percent) == rgb) return "gray" + std::to_string(percent);
  return {};
}

std::string color_hint(std::string_view name) {
  std::vector<std::string> spelt;
  for (const NamedColor& color : kColors) spelt.push_back(table_spelling(color.name));
  return did_you_mean(table_spelling(name), std::vector<std::string_view>(spelt.begin(), spelt.end()));
}

}  // namespace playhouse::scene
