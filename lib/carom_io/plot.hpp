#pragma once
// How does a program draw a diagram?
//
// It names axes, curves and marks; gnuplot draws them as SVG. Each figure is one file, the same
// bytes on every run (no date, numbers in full), white behind dark ink so that it can be read on a
// dark page too. gnuplot runs as a child process that gets its script on standard input: texts are
// quoted so that nothing in them is taken for a command.
//
// Not handled: several panels in one figure, error bars, surfaces.

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/core/real.hpp"
#include "carom_io/color.hpp"

namespace carom::io {

/// Thrown when a picture cannot be drawn for a reason outside the program: gnuplot is missing or
/// fails, a file cannot be written.
/// \ingroup io
class DrawingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How an axis is divided. \ingroup io
enum class Scale {
  Linear,       ///< equal differences are equally far apart
  Logarithmic,  ///< equal ratios are equally far apart; powers of ten are labelled
};

/// How a curve is drawn. \ingroup io
struct CurveStyle {
  bool line = true;                 ///< join the points
  bool marks = false;               ///< draw a mark at each point
  bool dashed = false;              ///< a dashed line
  Real width = 2;                   ///< of the line [pixels]
  std::optional<Color> color = {};  ///< the next one of the palette when not given
};

/// How an area is drawn. \ingroup io
struct AreaStyle {
  Real opacity = 0.25;              ///< of the filling, 0 to 1
  Real width = 2;                   ///< of the outline [pixels]
  std::optional<Color> color = {};  ///< the next one of the palette when not given
};

/// A two-dimensional diagram or picture. \ingroup io
class Plot {
 public:
  /// An empty diagram. \param title stands above it
  explicit Plot(std::string title);

  /// Says what the picture shows, for those who cannot see it: put into the SVG as its description.
  /// \param text one or two sentences \return this plot, for chaining
  Plot& describe(std::string text);

  /// The horizontal axis. \param label with the unit: "t [s]" \param scale linear or logarithmic
  /// \return this plot, for chaining
  Plot& xAxis(std::string label, Scale scale = Scale::Linear);

  /// The vertical axis. \param label with the unit: "height [m]" \param scale linear or logarithmic
  /// \return this plot, for chaining
  Plot& yAxis(std::string label, Scale scale = Scale::Linear);

  /// Fixes the range of the horizontal axis, which otherwise fits the data.
  /// \param low left end \param high right end, greater than low \return this plot, for chaining
  /// \throws InvalidInput unless low < high, both finite
  Plot& xRange(Real low, Real high);

  /// Fixes the range of the vertical axis, which otherwise fits the data.
  /// \param low lower end \param high upper end, greater than low \return this plot, for chaining
  /// \throws InvalidInput unless low < high, both finite
  Plot& yRange(Real low, Real high);

  /// One unit is equally long on both axes: for pictures of shapes. \return this plot, for chaining
  Plot& equalAspect();

  /// The size of the picture.
  /// \param width [pixels]
  /// \param height [pixels]
  /// \return this plot, for chaining
  /// \throws InvalidInput unless both are 100 to 4000
  Plot& size(int width, int height);

  /// A curve through points.
  /// \param name for the legend; empty: not in the legend
  /// \param x of the points [unit of the axis] \param y of the points [unit of the axis], as many
  /// \param style how it is drawn
  /// \return this plot, for chaining
  /// \throws InvalidInput when there are no points, counts differ, a number is not finite, or a
  ///        number is not positive on a logarithmic axis (checked when the plot is written); the
  ///        message names the point
  Plot& curve(std::string name, std::vector<Real> x, std::vector<Real> y, CurveStyle style = {});

  /// Marks at points, without a line. \param name for the legend
  /// \param x of the points [unit of the axis] \param y of the points [unit of the axis], as many
  /// \return this plot, for chaining \throws InvalidInput as curve() does
  Plot& points(std::string name, std::vector<Real> x, std::vector<Real> y);

  /// A thin grey line y = y0 (x / x0)^exponent, straight on two logarithmic axes: "the error falls
  /// as h^2".
  /// \param name for the legend: "slope 2" \param exponent of the power
  /// \param x0 a point of the line, not 0 \param y0 a point of the line
  /// \return this plot, for chaining \throws InvalidInput when a number is not finite or x0 is 0
  Plot& slope(std::string name, Real exponent, Real x0, Real y0);

  /// A filled polygon.
  /// \param name for the legend; empty: not in the legend
  /// \param corners in order, at least three; closed by itself
  /// \param style how it is drawn
  /// \return this plot, for chaining
  /// \throws InvalidInput when there are fewer than three or one is not finite
  Plot& polygon(std::string name, std::vector<Vector2> corners, AreaStyle style = {});

  /// An arrow. \param from its tail \param to its head \param color of the arrow
  /// \return this plot, for chaining \throws InvalidInput when a number is not finite
  Plot& arrow(const Vector2& from, const Vector2& to, Color color = {30, 30, 30});

  /// A word in the picture. \param at its left end \param text the word
  /// \return this plot, for chaining \throws InvalidInput when a number is not finite
  Plot& label(const Vector2& at, std::string text);

  /// The script that gnuplot is given. \return the text, with the data inside
  /// \throws InvalidInput as curve() says
  std::string script() const;

  /// Draws the picture. \return the SVG file as text
  /// \throws InvalidInput as curve() says \throws DrawingError when gnuplot is missing or fails
  std::string svg() const;

  /// Draws the picture into a file. \param path of the file to write
  /// \throws InvalidInput as curve() says
  /// \throws DrawingError when gnuplot is missing or fails, or the file cannot be written
  void writeSvg(const std::filesystem::path& path) const;

 private:
  struct Axis {
    std::string label;
    Scale scale = Scale::Linear;
    std::optional<std::pair<Real, Real>> range;
  };
  struct Curve {
    std::string name;
    std::vector<Real> x, y;
    CurveStyle style;
  };
  struct Slope {
    std::string name;
    Real exponent, x0, y0;
  };
  struct Area {
    std::string name;
    std::vector<Vector2> corners;
    AreaStyle style;
  };
  struct Arrow {
    Vector2 from, to;
    Color color;
  };
  struct Label {
    Vector2 at;
    std::string text;
  };

  void checkLogarithms() const;
  std::pair<Real, Real> rangeOfX() const;
  Color nextColor();

  std::string title_, description_;
  Axis x_, y_;
  bool equalAspect_ = false;
  int width_ = 760, height_ = 480;
  std::size_t colorsUsed_ = 0;
  std::vector<Curve> curves_;
  std::vector<Slope> slopes_;
  std::vector<Area> areas_;
  std::vector<Arrow> arrows_;
  std::vector<Label> labels_;
};

}  // namespace carom::io
