#pragma once
// How does a program show what moved?
//
// It records: which bodies there are and what they look like, then, for each moment, where they
// are. The recording is written as one HTML page that plays by double-click, without a server or a
// network, and as CSV. The picture replays numbers that the compiled program computed; nothing is
// computed again in the browser, so picture, text and code cannot disagree.
//
// Poses are stored as 16-bit integers, each body on its own scale; what is stored is the difference
// from the straight line through the two frames before, which is small for smooth motion and packs
// well. A picture is therefore accurate to 1/65000 of a body's own path. Times, channels and CSV
// are exact.
//
// Thousands of equal balls that need not be seen to turn are a swarm: drawn in one go, and stored
// to a hundredth of their radius.
//
// Not handled: bodies that change shape, or that appear and vanish (put them far away).

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"
#include "carom/rotation/quaternion.hpp"
#include "carom_io/color.hpp"

namespace carom::io {

/// Thrown when a recording's file cannot be written. \ingroup io
class RecordingFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A ball about the body's origin, striped like a billiard ball so that its turning can be seen.
/// \ingroup io
struct Ball {
  Real radius = 0.5;  ///< [m], > 0
};

/// A box about the body's origin. \ingroup io
struct Box {
  Vector3 size = Vector3::Ones();  ///< whole lengths of the edges along x, y, z [m, body], > 0
};

/// A cylinder with round caps about the body's origin, along the body's z axis. \ingroup io
struct Capsule {
  Real radius = 0.25;  ///< [m], > 0
  Real length = 1;     ///< between the centres of the caps [m], >= 0
};

/// A cylinder about the body's origin, along the body's z axis. \ingroup io
struct Cylinder {
  Real radius = 0.5;  ///< [m], > 0
  Real length = 1;    ///< [m], > 0
};

/// A flat disc in the body's xy plane, with a radius drawn: a body of a two-dimensional scene.
/// \ingroup io
struct Disc {
  Real radius = 0.5;  ///< [m], > 0
};

/// A flat polygon in the body's xy plane, convex or not: a body of a two-dimensional scene.
/// \ingroup io
struct Polygon {
  std::vector<Vector2> corners;  ///< in order [m, body], at least 3
};

/// Any closed or open surface of triangles; sharp edges are drawn. \ingroup io
struct Mesh {
  TriangleMesh surface;  ///< corners [m, body]
};

/// A square piece of the plane z = 0 of the body, with a grid: floor or wall. \ingroup io
struct Plane {
  Real size = 10;     ///< length of the sides [m], > 0
  Real gridStep = 1;  ///< distance of the lines [m], > 0
};

/// A thin line through the body's points: a wire, a path, a two-dimensional wall. \ingroup io
struct Polyline {
  std::vector<Vector3> points;  ///< in order [m, body], at least 2
};

/// What a body can look like. \ingroup io
using Shape = std::variant<Ball, Box, Capsule, Cylinder, Disc, Polygon, Mesh, Plane, Polyline>;

/// How a body is painted. \ingroup io
struct BodyStyle {
  std::optional<Color> color = {};  ///< the next one of the palette when not given; grey for Plane
  Real opacity = 1;                 ///< 0 (unseen) to 1
  bool wireframe = false;           ///< only the edges
  bool axes = false;                ///< draw the body's frame: x red, y green, z blue
  bool trail = false;               ///< draw the path of the body's origin
};

/// Where a body is: p_world = position + rotate(orientation, p_body). \ingroup io
struct Pose {
  Vector3 position = Vector3::Zero();  ///< of the body's origin [m, world]
  Quaternion orientation = {};         ///< from body to world; pictures divide it by its norm
};

/// An arrow at a moment. \ingroup io
struct Arrow {
  Vector3 from = Vector3::Zero();  ///< its tail [m, world]
  Vector3 vector =
      Vector3::Zero();  ///< from tail to head, in its own unit; a zero vector is not drawn
};

/// Many equal balls, discs in a flat scene, that move and do not turn. \ingroup io
struct Swarm {
  std::size_t count = 1;            ///< how many, > 0
  Real radius = 0.5;                ///< of each [m], > 0
  std::optional<Color> color = {};  ///< the next one of the palette when not given
  /// Edges of a periodic box, 0 along an axis where there is none: a ball that leaves on one side
  /// and comes in on the other is not drawn on the way between [m]
  Vector3 period = Vector3::Zero();
};

/// One moment of a recording. \ingroup io
struct Frame {
  Real time = 0;                 ///< [s], greater than that of the frame before
  std::vector<Pose> poses = {};  ///< of the moving bodies, in the order in which they were added
  std::vector<Real> channels =
      {};  ///< values of the channels, in the order in which they were added
  std::vector<Arrow> arrows = {};  ///< the arrows, in the order in which they were added
  std::vector<std::vector<Vector3>> swarms =
      {};  ///< where the balls of each swarm are, in the order in which they were added [m, world]
};

/// From where a scene is seen. What is not given is chosen so that all frames fit. \ingroup io
struct View {
  bool flat = false;              ///< a two-dimensional scene: look along -z, y is up
  Vector3 up = Vector3::UnitZ();  ///< which way is up on the screen [world]
  Vector3 direction = Vector3(-0.5, 1.0, -0.45);  ///< from the eye into the scene [world]
  std::optional<Vector3> target = {};  ///< the point in the middle of the picture [m, world]
  std::optional<Real> distance = {};   ///< from eye to target [m]; for flat, half the height shown
};

/// Collects bodies and frames, and writes them as pages and tables. \ingroup io
class Recording {
 public:
  /// An empty recording.
  /// \param title stands above the picture
  /// \param description what the picture shows, in a sentence or two; read aloud to those who
  ///        cannot see it
  explicit Recording(std::string title, std::string description = "");

  /// Adds a body that moves: every frame holds its pose. Call before the first frame.
  /// \param name unique in the recording, shown in the list of bodies and in the CSV file's titles
  /// \param shape what it looks like \param style how it is painted
  /// \return its index in Frame::poses
  /// \throws InvalidInput when a size is not finite and positive, a mesh has an index out of range,
  ///        the name is taken or empty, or frames have been added
  std::size_t addBody(std::string name, Shape shape, BodyStyle style = {});

  /// Adds a body that stays where it is; frames do not mention it. Call before the first frame.
  /// \param name unique in the recording \param shape what it looks like
  /// \param pose where it is \param style how it is painted
  /// \throws InvalidInput as addBody() does, and when the pose is not finite
  void addFixed(std::string name, Shape shape, Pose pose = {}, BodyStyle style = {});

  /// Adds a swarm, of which every frame holds all positions. Call before the first frame.
  /// \param name unique in the recording, shown in the list of bodies
  /// \param swarm how many balls, how large
  /// \return its index in Frame::swarms
  /// \throws InvalidInput when there are no balls, the radius is not finite and positive, the
  ///        period not finite or negative, the name is taken or empty, or frames have been added
  std::size_t addSwarm(std::string name, Swarm swarm);

  /// Adds a number that is plotted over time under the scene. Channels of one unit share an axis.
  /// Call before the first frame.
  /// \param name "kinetic energy" \param unit "J"; empty for a pure number
  /// \return its index in Frame::channels
  /// \throws InvalidInput when the name is taken or empty, or frames have been added
  std::size_t addChannel(std::string name, std::string unit);

  /// Adds an arrow that every frame places. Call before the first frame.
  /// \param name "velocity" \param color of the arrow; the next one of the palette when not given
  /// \param scale metres drawn per unit of the vector, > 0
  /// \return its index in Frame::arrows
  /// \throws InvalidInput when the scale is not finite and positive, or frames have been added
  std::size_t addArrow(std::string name, std::optional<Color> color = {}, Real scale = 1);

  /// Sets from where the scene is seen. \param view the view
  /// \throws InvalidInput when a number is not finite, up and direction are parallel, or the
  ///        distance is not > 0
  void setView(View view);

  /// Names the quantity that differs from case to case; it stands beside the slider.
  /// \param name "restitution e"
  void setParameter(std::string name);

  /// Starts the next case: the same bodies once more, for another value of the parameter. The page
  /// has a slider over the cases. A recording that never calls this has one case.
  /// \param label the value, as shown: "0.25"
  /// \throws InvalidInput when the case before has no frames
  void beginCase(std::string label);

  /// Adds a moment to the current case.
  /// \param frame poses of all moving bodies, all channels, all arrows, all swarms
  /// \throws InvalidInput when a count differs from what was added, a number is not finite, a
  ///        quaternion is zero, or the time is not greater than that of the frame before; the
  ///        message names frame and body, and the recording stays as it was
  void addFrame(Frame frame);

  /// How many frames the current case has. \return their number
  std::size_t frameCount() const;

  /// Writes one page that plays by double-click: about 0.6 MB for the player, plus the motion.
  /// \param path of the file to write
  /// \throws InvalidInput when a case has no frames
  /// \throws RecordingFileError when the file cannot be written
  void writeHtml(const std::filesystem::path& path) const;

  /// Writes the same player for an `<iframe>`: no title, the picture fills the frame.
  /// \param path of the file to write
  /// \param playerUrl where the page finds the player, relative to itself, so that many figures
  ///        share one file (see writePlayer()); empty: the player is inside
  /// \throws InvalidInput when a case has no frames
  /// \throws RecordingFileError when the file cannot be written
  void writeFigure(const std::filesystem::path& path, const std::string& playerUrl = "") const;

  /// Writes times, poses and channels as comma-separated values, numbers in full: one line per
  /// frame and case.
  /// \param path of the file to write
  /// \throws InvalidInput when a case has no frames
  /// \throws RecordingFileError when the file cannot be written
  void writeCsv(const std::filesystem::path& path) const;

 private:
  struct Body {
    std::string name;
    Shape shape;
    BodyStyle style;
    std::optional<Pose> fixedAt;
  };
  struct Channel {
    std::string name, unit;
  };
  struct ArrowKind {
    std::string name;
    Color color;
    Real scale;
  };
  struct SwarmKind {
    std::string name;
    Swarm swarm;
  };
  struct Case {
    std::string label;
    std::vector<Frame> frames;
  };

  void addAnyBody(Body body);
  void requireFreeName(const std::string& name) const;
  Color nextColor();
  void requireNoFrames(const std::string& what) const;
  void requireAllFrames() const;
  std::string header() const;
  std::string motion() const;
  std::string page(bool figure, const std::string& playerUrl) const;

  std::string title_, description_, parameter_;
  View view_;
  std::size_t colorsUsed_ = 0, movingBodies_ = 0;
  std::vector<Body> bodies_;
  std::vector<Channel> channels_;
  std::vector<ArrowKind> arrows_;
  std::vector<SwarmKind> swarms_;
  std::vector<Case> cases_;
};

/// Writes the player's script, for figures that share it (Recording::writeFigure()).
/// \param path of the file to write
/// \throws RecordingFileError when the file cannot be written
/// \ingroup io
void writePlayer(const std::filesystem::path& path);

}  // namespace carom::io
