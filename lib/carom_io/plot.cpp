#include "carom_io/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "carom/core/errors.hpp"
#include "carom_io/gnuplot.hpp"
#include "carom_io/number_text.hpp"

namespace carom::io {

namespace {

// gnuplot's point types: disc, square, triangle, diamond, triangle down, ring.
constexpr std::array<int, 6> kMarks{7, 5, 9, 13, 11, 6};

// A text as gnuplot's double-quoted string. All but letters, digits, spaces and UTF-8 is written as
// an octal escape, so no quote, backslash or backquote of the text is ever seen by gnuplot's
// parser. gnuplot reads on as long as digits follow, so a digit behind an escape is one as well.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  bool escaped = false;
  for (const char c : text) {
    const unsigned byte = static_cast<unsigned char>(c);
    const bool plain = (c >= '0' && c <= '9' && !escaped) || (c >= 'A' && c <= 'Z') ||
                       (c >= 'a' && c <= 'z') || c == ' ' || byte >= 0x80;
    if (plain) {
      result += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      result += ' ';
    } else {
      result += '\\';
      for (const unsigned shift : {6u, 3u, 0u})
        result += static_cast<char>('0' + (byte >> shift & 7u));
    }
    escaped = !plain && result.back() != ' ';
  }
  return result + '"';
}

std::string ink(const Color& color) {
  constexpr std::array<char, 17> digits{"0123456789abcdef"};
  std::string result = "rgb '#";
  for (const std::uint8_t channel : {color.red, color.green, color.blue}) {
    result += digits[channel / 16u];
    result += digits[channel % 16u];
  }
  return result + "'";
}

// A curve without a name must not be in the legend.
std::string legendEntry(const std::string& name) {
  return name.empty() ? " notitle" : " title " + quoted(name);
}

std::string coordinates(const Vector2& p) {
  return exactText(p.x()) + "," + exactText(p.y());
}

void requireFinite(bool finite, const std::string& what) {
  if (!finite) throw InvalidInput("plot: " + what + " is not finite");
}

std::string numbered(const std::string& kind, const std::string& name, std::size_t index) {
  return kind + " '" + name + "', point " + std::to_string(index);
}

std::string withoutMarkup(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else {
      result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

// Puts `content` between the first <tag> and </tag>.
void replaceElement(std::string& svg, const std::string& tag, const std::string& content) {
  const std::size_t open = svg.find("<" + tag + ">");
  const std::size_t close = svg.find("</" + tag + ">");
  if (open == std::string::npos || close == std::string::npos || close < open) return;
  const std::size_t start = open + tag.size() + 2;
  svg.replace(start, close - start, content);
}

std::pair<Real, Real> checkedRange(Real low, Real high) {
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high)) {
    throw InvalidInput("plot: range " + exactText(low) + " to " + exactText(high) +
                       ": must be finite and grow");
  }
  return {low, high};
}

}  // namespace

Plot::Plot(std::string title) : title_(std::move(title)) {}

Plot& Plot::describe(std::string text) {
  description_ = std::move(text);
  return *this;
}

Plot& Plot::xAxis(std::string label, Scale scale) {
  x_.label = std::move(label);
  x_.scale = scale;
  return *this;
}

Plot& Plot::yAxis(std::string label, Scale scale) {
  y_.label = std::move(label);
  y_.scale = scale;
  return *this;
}

Plot& Plot::xRange(Real low, Real high) {
  x_.range = checkedRange(low, high);
  return *this;
}

Plot& Plot::yRange(Real low, Real high) {
  y_.range = checkedRange(low, high);
  return *this;
}

Plot& Plot::equalAspect() {
  equalAspect_ = true;
  return *this;
}

Plot& Plot::size(int width, int height) {
  if (std::min(width, height) < 100 || std::max(width, height) > 4000) {
    throw InvalidInput("plot: size " + std::to_string(width) + " x " + std::to_string(height) +
                       ": sides must be 100 to 4000 pixels");
  }
  width_ = width;
  height_ = height;
  return *this;
}

Color Plot::nextColor() {
  return kPalette[colorsUsed_++ % kPalette.size()];
}

Plot& Plot::curve(std::string name, std::vector<Real> x, std::vector<Real> y, CurveStyle style) {
  if (x.size() != y.size() || x.empty()) {
    throw InvalidInput("plot: curve '" + name + "' has " + std::to_string(x.size()) + " x and " +
                       std::to_string(y.size()) + " y: must be as many, and at least one");
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    requireFinite(std::isfinite(x[i]) && std::isfinite(y[i]), numbered("curve", name, i));
  }
  if (!style.color) style.color = nextColor();
  curves_.push_back({std::move(name), std::move(x), std::move(y), style});
  return *this;
}

Plot& Plot::points(std::string name, std::vector<Real> x, std::vector<Real> y) {
  CurveStyle style;
  style.line = false;
  style.marks = true;
  return curve(std::move(name), std::move(x), std::move(y), style);
}

Plot& Plot::slope(std::string name, Real exponent, Real x0, Real y0) {
  requireFinite(std::isfinite(exponent) && std::isfinite(x0) && std::isfinite(y0),
                "slope '" + name + "'");
  if (x0 == 0) throw InvalidInput("plot: slope '" + name + "': x0 must not be 0");
  slopes_.push_back({std::move(name), exponent, x0, y0});
  return *this;
}

Plot& Plot::polygon(std::string name, std::vector<Vector2> corners, AreaStyle style) {
  if (corners.size() < 3) {
    throw InvalidInput("plot: polygon '" + name + "' has " + std::to_string(corners.size()) +
                       " corners: at least 3 are needed");
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    requireFinite(corners[i].allFinite(), numbered("polygon", name, i));
  }
  if (!style.color) style.color = nextColor();
  areas_.push_back({std::move(name), std::move(corners), style});
  return *this;
}

Plot& Plot::arrow(const Vector2& from, const Vector2& to, Color color) {
  requireFinite(from.allFinite() && to.allFinite(), "an arrow");
  arrows_.push_back({from, to, color});
  return *this;
}

Plot& Plot::label(const Vector2& at, std::string text) {
  requireFinite(at.allFinite(), "the place of label '" + text + "'");
  labels_.push_back({at, std::move(text)});
  return *this;
}

// gnuplot would leave such points out without a word.
void Plot::checkLogarithms() const {
  const auto check = [](const Axis& axis, Real value, const std::string& where) {
    if (axis.scale == Scale::Logarithmic && !(value > 0)) {
      throw InvalidInput("plot: " + where + ": " + exactText(value) +
                         " cannot stand on the logarithmic axis '" + axis.label + "'");
    }
  };
  for (const Curve& curve : curves_) {
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      check(x_, curve.x[i], numbered("curve", curve.name, i));
      check(y_, curve.y[i], numbered("curve", curve.name, i));
    }
  }
  for (const Area& area : areas_) {
    for (std::size_t i = 0; i < area.corners.size(); ++i) {
      check(x_, area.corners[i].x(), numbered("polygon", area.name, i));
      check(y_, area.corners[i].y(), numbered("polygon", area.name, i));
    }
  }
  for (const Axis* axis : {&x_, &y_}) {
    if (axis->range) check(*axis, axis->range->first, "the range");
  }
}

std::pair<Real, Real> Plot::rangeOfX() const {
  if (x_.range) return *x_.range;
  Real low = INFINITY, high = -INFINITY;
  for (const Curve& curve : curves_) {
    const auto [first, last] = std::minmax_element(curve.x.begin(), curve.x.end());
    low = std::min(low, *first);
    high = std::max(high, *last);
  }
  for (const Area& area : areas_) {
    for (const Vector2& corner : area.corners) {
      low = std::min(low, corner.x());
      high = std::max(high, corner.x());
    }
  }
  if (low > high) return {1, 10};
  return {low, high};
}

std::string Plot::script() const {
  checkLogarithms();
  std::string s;
  s += "set terminal svg size " + std::to_string(width_) + "," + std::to_string(height_) +
       " enhanced background rgb 'white' font 'Helvetica,13' linewidth 1 rounded\n";
  s += "set encoding utf8\n";
  s += "set title " + quoted(title_) + " noenhanced\n";
  s += "set border lc rgb '#57606a'\nset tics textcolor rgb '#1f2328'\n";
  s += "set grid xtics ytics lc rgb '#d8dee4' lt 1 lw 0.75\n";
  s += "set key outside right top vertical Left reverse samplen 2 noenhanced\n";
  const auto describeAxis = [&s](const char* name, const Axis& axis) {
    const std::string axisName(name);
    s += "set " + axisName + "label " + quoted(axis.label) + " noenhanced\n";
    if (axis.scale == Scale::Logarithmic) {
      // Only here is gnuplot's markup on: everywhere else texts are taken as they are.
      s += "set logscale " + axisName + "\nset format " + axisName + " '10^{%L}'\n";
    }
    if (axis.range) {
      s += "set " + axisName + "range [" + exactText(axis.range->first) + ":" +
           exactText(axis.range->second) + "]\n";
    }
  };
  describeAxis("x", x_);
  describeAxis("y", y_);
  if (equalAspect_) s += "set size ratio -1\n";
  for (const Arrow& arrow : arrows_) {
    s += "set arrow from " + coordinates(arrow.from) + " to " + coordinates(arrow.to) +
         " front filled lw 2 lc " + ink(arrow.color) + "\n";
  }
  for (const Label& label : labels_) {
    s += "set label " + quoted(label.text) + " at " + coordinates(label.at) +
         " front noenhanced textcolor rgb '#1f2328'\n";
  }

  std::string commands;
  std::size_t blocks = 0;
  const auto addData = [&](const std::string& lines, const std::string& how) {
    const std::string block = "$d" + std::to_string(blocks++);
    s += block + " << EOD\n" + lines + "EOD\n";
    commands += (commands.empty() ? "plot " : ", ") + block + " using 1:2 " + how;
  };
  for (const Area& area : areas_) {
    std::string lines;
    for (std::size_t i = 0; i <= area.corners.size(); ++i) {
      const Vector2& corner = area.corners[i % area.corners.size()];
      lines += exactText(corner.x()) + " " + exactText(corner.y()) + "\n";
    }
    const std::string color = ink(*area.style.color);
    addData(lines, "with filledcurves closed fillstyle transparent solid " +
                       exactText(area.style.opacity) + " noborder fillcolor " + color +
                       legendEntry(area.name));
    addData(lines, "with lines lw " + exactText(area.style.width) + " lc " + color + " notitle");
  }
  for (const Slope& slope : slopes_) {
    constexpr int kPieces = 100;
    const auto [low, high] = rangeOfX();
    std::string lines;
    for (int i = 0; i <= kPieces; ++i) {
      const Real part = Real(i) / kPieces;
      const Real x = x_.scale == Scale::Logarithmic ? low * std::pow(high / low, part)
                                                    : low + (high - low) * part;
      const Real y = slope.y0 * std::pow(x / slope.x0, slope.exponent);
      // Twelve digits: the power function's last bit is not the same in every C library.
      if (std::isfinite(y)) {
        lines += roundedText(x, std::chars_format::general, 12) + " " +
                 roundedText(y, std::chars_format::general, 12) + "\n";
      }
    }
    addData(lines, std::string(curves_.empty() ? "" : "noautoscale ") +
                       "with lines lw 1.5 dt 2 lc rgb '#888888'" + legendEntry(slope.name));
  }
  std::size_t marks = 0;
  for (const Curve& curve : curves_) {
    std::string lines;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      lines += exactText(curve.x[i]) + " " + exactText(curve.y[i]) + "\n";
    }
    const CurveStyle& style = curve.style;
    std::string how =
        style.marks ? (style.line ? "with linespoints" : "with points") : "with lines";
    how += " lc " + ink(*style.color);
    if (style.line) how += " lw " + exactText(style.width) + (style.dashed ? " dt 2" : " dt 1");
    if (style.marks) how += " pt " + std::to_string(kMarks[marks++ % kMarks.size()]) + " ps 0.6";
    addData(lines, how + legendEntry(curve.name));
  }
  if (commands.empty()) throw InvalidInput("plot '" + title_ + "' has nothing to draw");
  return s + commands + "\n";
}

std::string Plot::svg() const {
  std::string result = detail::runGnuplot(script());
  replaceElement(result, "title", withoutMarkup(title_));
  replaceElement(result, "desc", withoutMarkup(description_.empty() ? title_ : description_));
  return result;
}

void Plot::writeSvg(const std::filesystem::path& path) const {
  const std::string content = svg();
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file) throw DrawingError("cannot write " + path.string());
}

}  // namespace carom::io
