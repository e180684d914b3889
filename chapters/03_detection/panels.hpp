#pragma once
// Several small diagrams in one picture.
//
// Each panel is drawn by itself; an SVG may hold others, each at its own place.

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "carom_io/plot.hpp"

/// Writes panels of one size in rows, from left to right and from top to bottom.
/// \param path of the SVG file \param panels all drawn with size(width, height)
/// \param columns panels in a row \param width of a panel [pixels]
/// \param height of a panel [pixels]
inline void writePanels(const std::filesystem::path& path,
                        const std::vector<carom::io::Plot>& panels, int columns, int width,
                        int height) {
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  std::ofstream file(path, std::ios::binary);
  file << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << columns * width << "\" height=\""
       << rows * height << "\" viewBox=\"0 0 " << columns * width << ' ' << rows * height
       << "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  int number = 0;
  for (const carom::io::Plot& panel : panels) {
    const std::string svg = panel.svg();
    // Behind the XML declaration, which only a whole file may have, the element itself.
    file << "<svg x=\"" << number % columns * width << "\" y=\"" << number / columns * height << '"'
         << svg.substr(svg.find("<svg") + 4) << '\n';
    ++number;
  }
  file << "</svg>\n";
  if (!file) throw carom::io::DrawingError("cannot write " + path.string());
}
