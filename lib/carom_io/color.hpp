#pragma once
// Which colours do pictures use?
//
// The eight colours of Okabe and Ito (2008, "Color universal design"): people with any of the
// common kinds of colour blindness can tell them apart, on a light ground as well as on a dark one.
// Pictures do not speak by colour alone: curves with marks have different marks, areas and bodies
// carry names.

#include <array>
#include <cstdint>

/// \defgroup io Files, tables and pictures
/// Mesh files, text tables, plots and recordings: what programs read and what they show.

/// Files, tables and pictures, beside the layers of the engine.
namespace carom::io {

/// A colour as a screen shows it: sRGB, 0 to 255 per channel. \ingroup io
struct Color {
  std::uint8_t red = 0;    ///< red
  std::uint8_t green = 0;  ///< green
  std::uint8_t blue = 0;   ///< blue
};

inline constexpr Color kBlue{0, 114, 178};      ///< first colour of the palette \ingroup io
inline constexpr Color kVermilion{213, 94, 0};  ///< second colour of the palette \ingroup io
inline constexpr Color kGreen{0, 158, 115};     ///< third colour of the palette \ingroup io
inline constexpr Color kPurple{204, 121, 167};  ///< fourth colour of the palette \ingroup io
inline constexpr Color kOrange{230, 159, 0};    ///< fifth colour of the palette \ingroup io
inline constexpr Color kSkyBlue{86, 180, 233};  ///< sixth colour of the palette \ingroup io
inline constexpr Color kYellow{240, 228,
                               66};  ///< for accents; too pale for lines on white \ingroup io
inline constexpr Color kGray{136, 136, 136};  ///< for what stands in the background \ingroup io

/// The colours that curves and bodies get in turn when they name none. \ingroup io
inline constexpr std::array<Color, 6> kPalette{kBlue,   kVermilion, kGreen,
                                               kPurple, kOrange,    kSkyBlue};

}  // namespace carom::io
