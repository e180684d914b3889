#include "carom_io/recorder.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "carom/core/errors.hpp"
#include "carom_io/deflate.hpp"
#include "carom_io/number_text.hpp"

extern "C" {
// The two ends of the player's script (player.S).
extern const char carom_player_begin[];
extern const char carom_player_end[];
}

namespace carom::io {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kNumbersPerPose = 7;
// A quaternion's component times this is stored: steps of 1.2e-4, invisible, and small enough to
// pack well.
constexpr Real kQuaternionSteps = 8191;

std::string_view playerScript() {
  return {carom_player_begin, static_cast<std::size_t>(carom_player_end - carom_player_begin)};
}

// --- checks ---

std::string textOf(const Vector3& v) {
  return "(" + exactText(v.x()) + ", " + exactText(v.y()) + ", " + exactText(v.z()) + ")";
}

std::string textOf(const Quaternion& q) {
  return "(" + exactText(q.w) + ", " + exactText(q.x) + ", " + exactText(q.y) + ", " +
         exactText(q.z) + ")";
}

Real normOf(const Quaternion& q) {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

void checkPose(const Pose& pose, const std::string& where) {
  if (!pose.position.allFinite()) {
    throw InvalidInput(where + ": position " + textOf(pose.position) + " is not finite");
  }
  const Real norm = normOf(pose.orientation);
  if (!std::isfinite(norm) || norm == 0) {
    throw InvalidInput(where + ": orientation " + textOf(pose.orientation) +
                       " has no direction: its norm must be finite and positive");
  }
}

void checkCount(std::size_t given, std::size_t needed, const std::string& what,
                const std::string& where) {
  if (given != needed) {
    throw InvalidInput(where + " has " + std::to_string(given) + " " + what +
                       ": the recording has " + std::to_string(needed));
  }
}

// Which sizes and points of a shape must be sound.
struct ShapeCheck {
  const std::string& name;

  void positive(Real value, const char* what) const {
    if (!(value > 0) || !std::isfinite(value)) {
      fail(std::string(what) + " " + exactText(value) + " must be finite and positive");
    }
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw InvalidInput("body '" + name + "': " + why);
  }

  void operator()(const Ball& s) const {
    positive(s.radius, "radius");
  }
  void operator()(const Box& s) const {
    for (int axis = 0; axis < 3; ++axis) positive(s.size[axis], "edge");
  }
  void operator()(const Capsule& s) const {
    positive(s.radius, "radius");
    if (s.length != 0) positive(s.length, "length");
  }
  void operator()(const Cylinder& s) const {
    positive(s.radius, "radius");
    positive(s.length, "length");
  }
  void operator()(const Disc& s) const {
    positive(s.radius, "radius");
  }
  void operator()(const Polygon& s) const {
    if (s.corners.size() < 3) fail("a polygon needs at least 3 corners");
    for (const Vector2& corner : s.corners) {
      if (!corner.allFinite()) fail("a corner is not finite");
    }
  }
  void operator()(const Mesh& s) const {
    const std::size_t count = s.surface.vertices.size();
    if (s.surface.triangles.empty()) fail("its mesh has no triangles");
    for (std::size_t i = 0; i < count; ++i) {
      if (!s.surface.vertices[i].allFinite())
        fail("vertex " + std::to_string(i) + " is not finite");
    }
    for (std::size_t t = 0; t < s.surface.triangles.size(); ++t) {
      for (const std::int32_t index : s.surface.triangles[t]) {
        if (index < 0 || static_cast<std::size_t>(index) >= count) {
          fail("triangle " + std::to_string(t) + " names vertex " + std::to_string(index) + " of " +
               std::to_string(count));
        }
      }
    }
  }
  void operator()(const Plane& s) const {
    positive(s.size, "size");
    positive(s.gridStep, "grid step");
    if (s.size / s.gridStep > 1000) fail("a grid of more than 1000 lines each way");
  }
  void operator()(const Polyline& s) const {
    if (s.points.size() < 2) fail("a polyline needs at least 2 points");
    for (const Vector3& point : s.points) {
      if (!point.allFinite()) fail("a point is not finite");
    }
  }
};

// --- what the player reads ---

Json json(const Vector3& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

std::string json(const Color& color) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : {color.red, color.green, color.blue}) {
    text += digits[channel / 16u];
    text += digits[channel % 16u];
  }
  return text;
}

struct ShapeJson {
  Json operator()(const Ball& s) const {
    return {{"type", "ball"}, {"radius", s.radius}};
  }
  Json operator()(const Box& s) const {
    return {{"type", "box"}, {"size", json(s.size)}};
  }
  Json operator()(const Capsule& s) const {
    return {{"type", "capsule"}, {"radius", s.radius}, {"length", s.length}};
  }
  Json operator()(const Cylinder& s) const {
    return {{"type", "cylinder"}, {"radius", s.radius}, {"length", s.length}};
  }
  Json operator()(const Disc& s) const {
    return {{"type", "disc"}, {"radius", s.radius}};
  }
  Json operator()(const Polygon& s) const {
    Json corners = Json::array();
    for (const Vector2& corner : s.corners)
      corners.push_back(Json::array({corner.x(), corner.y()}));
    return {{"type", "polygon"}, {"corners", corners}};
  }
  // Vertices and triangles stand in the packed part.
  Json operator()(const Mesh& s) const {
    return {{"type", "mesh"},
            {"vertices", s.surface.vertices.size()},
            {"triangles", s.surface.triangles.size()}};
  }
  Json operator()(const Plane& s) const {
    return {{"type", "plane"}, {"size", s.size}, {"step", s.gridStep}};
  }
  Json operator()(const Polyline& s) const {
    Json points = Json::array();
    for (const Vector3& point : s.points) points.push_back(json(point));
    return {{"type", "polyline"}, {"points", points}};
  }
};

// Appends numbers byte plane by byte plane, the lowest first: all first bytes, all second bytes,
// ... The high bytes of neighbouring numbers are alike, which deflate finds only when they lie side
// by side.
template <class Bits, class Number>
void appendPlanes(std::string& bytes, const std::vector<Number>& numbers) {
  static_assert(sizeof(Bits) == sizeof(Number));
  for (unsigned shift = 0; shift < 8 * sizeof(Bits); shift += 8) {
    for (const Number number : numbers) {
      bytes += static_cast<char>(static_cast<std::uint64_t>(std::bit_cast<Bits>(number)) >> shift &
                                 0xffu);
    }
  }
}

// Steps in which a body's positions are stored: the middle of its path, and the size of a step.
struct Grid {
  Vector3 middle = Vector3::Zero();
  Real step = 0;
};

Grid gridOf(const std::vector<Frame>& frames, std::size_t body) {
  Vector3 low = frames.front().poses[body].position, high = low;
  for (const Frame& frame : frames) {
    low = low.cwiseMin(frame.poses[body].position);
    high = high.cwiseMax(frame.poses[body].position);
  }
  Grid grid;
  grid.middle = low + (high - low) / 2;
  grid.step = ((high - low) / 2).maxCoeff() / 32767;
  return grid;
}

std::int16_t rounded(Real value) {
  return static_cast<std::int16_t>(std::clamp(std::nearbyint(value), Real(-32767), Real(32767)));
}

// The seven numbers of a body's pose over all frames, each as its difference from the straight line
// through the two frames before. Unsigned arithmetic wraps, so the differences need no more than 16
// bits.
void appendPoses(std::vector<std::uint16_t>& out, const std::vector<Frame>& frames,
                 std::size_t body) {
  const Grid grid = gridOf(frames, body);
  const std::size_t count = frames.size();
  std::array<std::vector<std::uint16_t>, kNumbersPerPose> numbers;
  Quaternion before;
  for (const Frame& frame : frames) {
    const Pose& pose = frame.poses[body];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real offset =
          pose.position[static_cast<int>(axis)] - grid.middle[static_cast<int>(axis)];
      const std::int16_t number = grid.step > 0 ? rounded(offset / grid.step) : std::int16_t{0};
      numbers[axis].push_back(static_cast<std::uint16_t>(number));
    }
    // q and -q are one rotation: take the one nearer to the frame before, for small differences.
    const Quaternion& q = pose.orientation;
    const Real along = q.w * before.w + q.x * before.x + q.y * before.y + q.z * before.z;
    const Real factor = (along < 0 ? -1 : 1) / normOf(q);
    before = {q.w * factor, q.x * factor, q.y * factor, q.z * factor};
    const std::array<Real, 4> parts{before.w, before.x, before.y, before.z};
    for (std::size_t k = 0; k < 4; ++k) {
      numbers[3 + k].push_back(static_cast<std::uint16_t>(rounded(parts[k] * kQuaternionSteps)));
    }
  }
  for (const std::vector<std::uint16_t>& series : numbers) {
    for (std::size_t f = 0; f < count; ++f) {
      const int expected = f >= 2 ? 2 * series[f - 1] - series[f - 2] : f == 1 ? series[0] : 0;
      out.push_back(static_cast<std::uint16_t>(series[f] - expected));
    }
  }
}

// Steps in which the balls of a swarm are stored: a fiftieth of the radius, unless 16 bits do not
// reach that far.
Grid gridOf(const std::vector<Frame>& frames, std::size_t swarm, Real radius) {
  Vector3 low = frames.front().swarms[swarm].front(), high = low;
  for (const Frame& frame : frames) {
    for (const Vector3& position : frame.swarms[swarm]) {
      low = low.cwiseMin(position);
      high = high.cwiseMax(position);
    }
  }
  Grid grid;
  grid.middle = low + (high - low) / 2;
  grid.step = std::max(radius / 50, ((high - low) / 2).maxCoeff() / 32767);
  return grid;
}

// The coordinates of each ball over all frames, as their differences from the straight line through
// the two frames before. Of 10 000 balls most differences fit into a byte, whatever their sign: the
// sign is put into the lowest bit, which leaves the high bytes zero.
void appendSwarm(std::vector<std::uint16_t>& out, const std::vector<Frame>& frames,
                 std::size_t swarm, Real radius) {
  const Grid grid = gridOf(frames, swarm, radius);
  const std::size_t balls = frames.front().swarms[swarm].size();
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t ball = 0; ball < balls; ++ball) {
      int last = 0, before = 0;
      for (std::size_t f = 0; f < frames.size(); ++f) {
        const Real offset = frames[f].swarms[swarm][ball][axis] - grid.middle[axis];
        const int number = rounded(offset / grid.step);
        const int expected = f >= 2 ? 2 * last - before : last;
        const auto difference = static_cast<std::int16_t>(number - expected);
        const unsigned sign = difference < 0 ? 0xffffu : 0u;
        out.push_back(static_cast<std::uint16_t>((2 * static_cast<unsigned>(difference)) ^ sign));
        before = last;
        last = number;
      }
    }
  }
}

// --- files ---

void writeFile(const std::filesystem::path& path, std::string_view content) {
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file) throw RecordingFileError("cannot write " + path.string());
}

std::string asMarkup(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string csvTitle(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

}  // namespace

Recording::Recording(std::string title, std::string description)
    : title_(std::move(title)), description_(std::move(description)), cases_(1) {}

void Recording::requireNoFrames(const std::string& what) const {
  if (cases_.size() > 1 || !cases_.front().frames.empty()) {
    throw InvalidInput("recording '" + title_ + "': " + what +
                       " must be added before the first frame");
  }
}

void Recording::requireAllFrames() const {
  for (const Case& one : cases_) {
    if (one.frames.empty()) {
      throw InvalidInput("recording '" + title_ + "', case '" + one.label + "': it has no frames");
    }
  }
}

void Recording::requireFreeName(const std::string& name) const {
  if (name.empty()) throw InvalidInput("recording '" + title_ + "': a body needs a name");
  const auto sameName = [&](const auto& other) { return other.name == name; };
  if (std::any_of(bodies_.begin(), bodies_.end(), sameName) ||
      std::any_of(swarms_.begin(), swarms_.end(), sameName)) {
    throw InvalidInput("body '" + name + "': the name is taken");
  }
}

Color Recording::nextColor() {
  return kPalette[colorsUsed_++ % kPalette.size()];
}

void Recording::addAnyBody(Body body) {
  requireNoFrames("body '" + body.name + "'");
  requireFreeName(body.name);
  std::visit(ShapeCheck{body.name}, body.shape);
  if (!(body.style.opacity >= 0 && body.style.opacity <= 1)) {
    throw InvalidInput("body '" + body.name + "': opacity " + exactText(body.style.opacity) +
                       " must be 0 to 1");
  }
  if (!body.style.color) {
    body.style.color = std::holds_alternative<Plane>(body.shape) ? kGray : nextColor();
  }
  bodies_.push_back(std::move(body));
}

std::size_t Recording::addBody(std::string name, Shape shape, BodyStyle style) {
  addAnyBody({std::move(name), std::move(shape), style, std::nullopt});
  return movingBodies_++;
}

void Recording::addFixed(std::string name, Shape shape, Pose pose, BodyStyle style) {
  checkPose(pose, "body '" + name + "'");
  addAnyBody({std::move(name), std::move(shape), style, pose});
}

std::size_t Recording::addSwarm(std::string name, Swarm swarm) {
  requireNoFrames("swarm '" + name + "'");
  requireFreeName(name);
  const ShapeCheck check{name};
  if (swarm.count == 0) check.fail("a swarm needs at least one ball");
  check.positive(swarm.radius, "radius");
  if (!swarm.period.allFinite() || swarm.period.minCoeff() < 0) {
    check.fail("period " + textOf(swarm.period) + " must be finite and not negative");
  }
  if (!swarm.color) swarm.color = nextColor();
  swarms_.push_back({std::move(name), swarm});
  return swarms_.size() - 1;
}

std::size_t Recording::addChannel(std::string name, std::string unit) {
  requireNoFrames("channel '" + name + "'");
  if (name.empty()) throw InvalidInput("recording '" + title_ + "': a channel needs a name");
  for (const Channel& other : channels_) {
    if (other.name == name) throw InvalidInput("channel '" + name + "': the name is taken");
  }
  channels_.push_back({std::move(name), std::move(unit)});
  return channels_.size() - 1;
}

std::size_t Recording::addArrow(std::string name, std::optional<Color> color, Real scale) {
  requireNoFrames("arrow '" + name + "'");
  if (!(scale > 0) || !std::isfinite(scale)) {
    throw InvalidInput("arrow '" + name + "': scale " + exactText(scale) +
                       " must be finite and positive");
  }
  const Color chosen = color ? *color : kPalette[5 - arrows_.size() % 6];
  arrows_.push_back({std::move(name), chosen, scale});
  return arrows_.size() - 1;
}

void Recording::setView(View view) {
  const bool finite = view.up.allFinite() && view.direction.allFinite() &&
                      (!view.target || view.target->allFinite()) &&
                      (!view.distance || std::isfinite(*view.distance));
  if (!finite) throw InvalidInput("view: a number is not finite");
  if (view.distance && !(*view.distance > 0)) {
    throw InvalidInput("view: distance " + exactText(*view.distance) + " must be positive");
  }
  // The sine of the angle between the two, squared; below 1e-6 the picture has no stable "up".
  const Real product = view.up.squaredNorm() * view.direction.squaredNorm();
  const Real along = view.up.dot(view.direction);
  if (!view.flat && !(product - along * along > 1e-6 * product)) {
    throw InvalidInput("view: direction " + textOf(view.direction) + " and up " + textOf(view.up) +
                       " must not be parallel or zero");
  }
  view_ = std::move(view);
}

void Recording::setParameter(std::string name) {
  parameter_ = std::move(name);
}

void Recording::beginCase(std::string label) {
  if (cases_.back().frames.empty()) {
    // The first call names the case that exists from the start; later ones must follow frames.
    if (cases_.size() > 1 || !cases_.back().label.empty()) requireAllFrames();
    cases_.back().label = std::move(label);
    return;
  }
  cases_.push_back({std::move(label), {}});
}

void Recording::addFrame(Frame frame) {
  Case& current = cases_.back();
  std::string where = "recording '" + title_ + "'";
  if (!current.label.empty()) where += ", case '" + current.label + "'";
  where += ", frame " + std::to_string(current.frames.size());

  if (!std::isfinite(frame.time)) {
    throw InvalidInput(where + ": time " + exactText(frame.time) + " is not finite");
  }
  if (!current.frames.empty() && !(frame.time > current.frames.back().time)) {
    throw InvalidInput(where + ": time " + exactText(frame.time) +
                       " must be greater than that of the frame before, " +
                       exactText(current.frames.back().time));
  }
  checkCount(frame.poses.size(), movingBodies_, "poses of moving bodies", where);
  checkCount(frame.channels.size(), channels_.size(), "channel values", where);
  checkCount(frame.arrows.size(), arrows_.size(), "arrows", where);
  std::size_t moving = 0;
  for (const Body& body : bodies_) {
    if (!body.fixedAt) checkPose(frame.poses[moving++], where + ", body '" + body.name + "'");
  }
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (!std::isfinite(frame.channels[i])) {
      throw InvalidInput(where + ", channel '" + channels_[i].name +
                         "': " + exactText(frame.channels[i]) + " is not finite");
    }
  }
  for (std::size_t i = 0; i < arrows_.size(); ++i) {
    if (!frame.arrows[i].from.allFinite() || !frame.arrows[i].vector.allFinite()) {
      throw InvalidInput(where + ", arrow '" + arrows_[i].name + "' is not finite");
    }
  }
  checkCount(frame.swarms.size(), swarms_.size(), "swarms", where);
  for (std::size_t i = 0; i < swarms_.size(); ++i) {
    const std::string swarm = where + ", swarm '" + swarms_[i].name + "'";
    checkCount(frame.swarms[i].size(), swarms_[i].swarm.count, "positions", swarm);
    for (const Vector3& position : frame.swarms[i]) {
      if (!position.allFinite()) {
        throw InvalidInput(swarm + ": position " + textOf(position) + " is not finite");
      }
    }
  }
  current.frames.push_back(std::move(frame));
}

std::size_t Recording::frameCount() const {
  return cases_.back().frames.size();
}

// The part of the page that says what the packed numbers mean.
std::string Recording::header() const {
  Json bodies = Json::array();
  for (const Body& body : bodies_) {
    Json one = std::visit(ShapeJson{}, body.shape);
    one["name"] = body.name;
    one["color"] = json(*body.style.color);
    one["opacity"] = body.style.opacity;
    one["wireframe"] = body.style.wireframe;
    one["axes"] = body.style.axes;
    one["trail"] = body.style.trail;
    if (body.fixedAt) {
      const Quaternion& q = body.fixedAt->orientation;
      one["pose"] = Json::array({body.fixedAt->position.x(), body.fixedAt->position.y(),
                                 body.fixedAt->position.z(), q.w, q.x, q.y, q.z});
    }
    bodies.push_back(std::move(one));
  }
  Json channels = Json::array();
  for (const Channel& channel : channels_) {
    channels.push_back({{"name", channel.name}, {"unit", channel.unit}});
  }
  Json arrows = Json::array();
  for (const ArrowKind& arrow : arrows_) {
    arrows.push_back({{"name", arrow.name}, {"color", json(arrow.color)}, {"scale", arrow.scale}});
  }
  Json swarms = Json::array();
  for (const SwarmKind& kind : swarms_) {
    swarms.push_back({{"name", kind.name},
                      {"count", kind.swarm.count},
                      {"radius", kind.swarm.radius},
                      {"color", json(*kind.swarm.color)},
                      {"period", json(kind.swarm.period)}});
  }
  Json cases = Json::array();
  for (const Case& one : cases_) {
    Json grids = Json::array(), swarmGrids = Json::array();
    for (std::size_t body = 0; body < movingBodies_; ++body) {
      const Grid grid = gridOf(one.frames, body);
      grids.push_back(Json::array({grid.middle.x(), grid.middle.y(), grid.middle.z(), grid.step}));
    }
    for (std::size_t i = 0; i < swarms_.size(); ++i) {
      const Grid grid = gridOf(one.frames, i, swarms_[i].swarm.radius);
      swarmGrids.push_back(
          Json::array({grid.middle.x(), grid.middle.y(), grid.middle.z(), grid.step}));
    }
    cases.push_back({{"label", one.label},
                     {"frames", one.frames.size()},
                     {"grids", grids},
                     {"swarmGrids", swarmGrids}});
  }
  Json view{{"flat", view_.flat}, {"up", json(view_.up)}, {"direction", json(view_.direction)}};
  if (view_.target) view["target"] = json(*view_.target);
  if (view_.distance) view["distance"] = *view_.distance;
  const Json all{{"format", 1},
                 {"title", title_},
                 {"description", description_},
                 {"parameter", parameter_},
                 {"view", view},
                 {"bodies", bodies},
                 {"channels", channels},
                 {"arrows", arrows},
                 {"swarms", swarms},
                 {"cases", cases}};
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// The numbers, in the order in which the player takes them: meshes, then per case times, channels,
// arrows, poses, swarms.
std::string Recording::motion() const {
  std::string bytes;
  for (const Body& body : bodies_) {
    const Mesh* mesh = std::get_if<Mesh>(&body.shape);
    if (mesh == nullptr) continue;
    std::vector<float> coordinates;
    for (const Vector3& v : mesh->surface.vertices) {
      for (int axis = 0; axis < 3; ++axis) coordinates.push_back(static_cast<float>(v[axis]));
    }
    std::vector<std::int32_t> indices;
    for (const std::array<std::int32_t, 3>& triangle : mesh->surface.triangles) {
      indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    appendPlanes<std::uint32_t>(bytes, coordinates);
    appendPlanes<std::uint32_t>(bytes, indices);
  }
  for (const Case& one : cases_) {
    std::vector<Real> times, channels;
    for (const Frame& frame : one.frames) times.push_back(frame.time);
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      for (const Frame& frame : one.frames) channels.push_back(frame.channels[c]);
    }
    std::vector<float> arrows;
    for (std::size_t a = 0; a < arrows_.size(); ++a) {
      for (int number = 0; number < 6; ++number) {
        for (const Frame& frame : one.frames) {
          const Arrow& arrow = frame.arrows[a];
          arrows.push_back(
              static_cast<float>(number < 3 ? arrow.from[number] : arrow.vector[number - 3]));
        }
      }
    }
    std::vector<std::uint16_t> poses;
    for (std::size_t body = 0; body < movingBodies_; ++body) appendPoses(poses, one.frames, body);
    appendPlanes<std::uint64_t>(bytes, times);
    appendPlanes<std::uint64_t>(bytes, channels);
    appendPlanes<std::uint32_t>(bytes, arrows);
    std::vector<std::uint16_t> swarms;
    for (std::size_t i = 0; i < swarms_.size(); ++i) {
      appendSwarm(swarms, one.frames, i, swarms_[i].swarm.radius);
    }
    appendPlanes<std::uint16_t>(bytes, poses);
    appendPlanes<std::uint16_t>(bytes, swarms);
  }
  return detail::base64(detail::deflated(bytes));
}

std::string Recording::page(bool figure, const std::string& playerUrl) const {
  requireAllFrames();
  // "</script>" inside a text would end the element early.
  std::string headerText;
  for (const char c : header()) headerText += c == '<' ? std::string("\\u003c") : std::string(1, c);

  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  html += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  html += "<title>" + asMarkup(title_) + "</title>\n</head>\n";
  html += std::string("<body class=\"") + (figure ? "carom-figure" : "carom-page") + "\">\n";
  html += "<main id=\"carom-player\">\n";
  if (!figure) html += "<h1>" + asMarkup(title_) + "</h1>\n";
  if (!description_.empty()) {
    html += "<p class=\"carom-description\">" + asMarkup(description_) + "</p>\n";
  }
  html += "<noscript><p>This picture moves: it needs JavaScript.</p></noscript>\n</main>\n";
  html += "<script type=\"application/json\" id=\"carom-header\">" + headerText + "</script>\n";
  html += "<script type=\"text/plain\" id=\"carom-motion\">" + motion() + "</script>\n";
  if (playerUrl.empty()) {
    html += "<script>";
    html += playerScript();
    html += "</script>\n";
  } else {
    html += "<script src=\"" + asMarkup(playerUrl) + "\"></script>\n";
  }
  return html + "</body>\n</html>\n";
}

void Recording::writeHtml(const std::filesystem::path& path) const {
  writeFile(path, page(false, ""));
}

void Recording::writeFigure(const std::filesystem::path& path, const std::string& playerUrl) const {
  writeFile(path, page(true, playerUrl));
}

void Recording::writeCsv(const std::filesystem::path& path) const {
  requireAllFrames();
  std::string text = csvTitle(parameter_.empty() ? "case" : parameter_) + ",t [s]";
  for (const Body& body : bodies_) {
    if (body.fixedAt) continue;
    for (const char* part : {" x [m]", " y [m]", " z [m]", " qw", " qx", " qy", " qz"}) {
      text += "," + csvTitle(body.name + part);
    }
  }
  for (const SwarmKind& kind : swarms_) {
    for (std::size_t ball = 1; ball <= kind.swarm.count; ++ball) {
      for (const char* part : {" x [m]", " y [m]", " z [m]"}) {
        text += "," + csvTitle(kind.name + " " + std::to_string(ball) + part);
      }
    }
  }
  for (const Channel& channel : channels_) {
    text += "," + csvTitle(channel.unit.empty() ? channel.name
                                                : channel.name + " [" + channel.unit + "]");
  }
  text += '\n';
  for (const Case& one : cases_) {
    for (const Frame& frame : one.frames) {
      text += csvTitle(one.label) + "," + exactText(frame.time);
      for (const Pose& pose : frame.poses) {
        const Quaternion& q = pose.orientation;
        for (const Real number :
             {pose.position.x(), pose.position.y(), pose.position.z(), q.w, q.x, q.y, q.z}) {
          text += "," + exactText(number);
        }
      }
      for (const std::vector<Vector3>& swarm : frame.swarms) {
        for (const Vector3& position : swarm) {
          for (int axis = 0; axis < 3; ++axis) text += "," + exactText(position[axis]);
        }
      }
      for (const Real value : frame.channels) text += "," + exactText(value);
      text += '\n';
    }
  }
  writeFile(path, text);
}

void writePlayer(const std::filesystem::path& path) {
  writeFile(path, playerScript());
}

}  // namespace carom::io
