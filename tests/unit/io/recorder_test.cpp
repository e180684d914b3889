#include "carom_io/recorder.hpp"

#include <zlib.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "carom/core/errors.hpp"
#include "scratch.hpp"
#include "support/catch.hpp"

using namespace carom;
using carom_test::ContainsSubstring;
using carom_test::Scratch;
using carom_test::WithinAbs;

namespace {

// What stands between the tag with this id and the next "</script>".
std::string scriptElement(const std::string& html, const std::string& id) {
  const std::size_t tag = html.find("id=\"" + id + "\"");
  REQUIRE(tag != std::string::npos);
  const std::size_t start = html.find('>', tag) + 1;
  return html.substr(start, html.find("</script>", start) - start);
}

std::string fromBase64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xffu);
    }
  }
  return bytes;
}

std::string inflated(const std::string& packed) {
  std::string bytes(1 << 22, '\0');
  uLongf size = bytes.size();
  REQUIRE(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                     reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK);
  bytes.resize(size);
  return bytes;
}

// Reads the packed numbers the way the page does, from the description of the format alone.
class Unpacker {
 public:
  explicit Unpacker(std::string bytes) : bytes_(std::move(bytes)) {}

  template <class Bits>
  std::vector<Bits> take(std::size_t count) {
    std::vector<Bits> result(count, Bits{0});
    for (std::size_t plane = 0; plane < sizeof(Bits); ++plane) {
      for (std::size_t i = 0; i < count; ++i) {
        result[i] = static_cast<Bits>(
            result[i] |
            static_cast<Bits>(static_cast<Bits>(static_cast<unsigned char>(bytes_.at(at_++)))
                              << (8 * plane)));
      }
    }
    return result;
  }
  std::size_t left() const {
    return bytes_.size() - at_;
  }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

io::Pose turned(Real x, Real y, Real z, Real angle) {
  return {.position = {x, y, z}, .orientation = {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}};
}

}  // namespace

TEST_CASE("the page holds the poses that were recorded, to a 65000th of each body's path") {
  io::Recording recording("Test </script> & more", "Two bodies.");
  recording.addBody("far", io::Ball{.radius = 1});
  recording.addBody("near", io::Box{});
  recording.addFixed("floor", io::Plane{});
  recording.addChannel("energy", "J");
  recording.addArrow("velocity");
  recording.setParameter("e");
  constexpr int kFrames = 50;
  std::vector<io::Frame> frames;
  for (const char* label : {"0", "1"}) {
    recording.beginCase(label);
    for (int i = 0; i < kFrames; ++i) {
      const Real t = 0.1 * i;
      io::Frame frame{
          .time = t,
          .poses = {turned(1000 * t, -t * t, 7, 9 * t), turned(0.001 * std::sin(t), 5, 0, -t)},
          .channels = {std::exp(-t) / 3},
          .arrows = {{.from = {t, 0, 0}, .vector = {0, 2, 0}}}};
      if (label[0] == '1') frames.push_back(frame);
      recording.addFrame(frame);
    }
  }
  const Scratch scratch;
  recording.writeHtml(scratch.file("a.html"));
  const std::string html = Scratch::read(scratch.file("a.html"));
  const nlohmann::json header = nlohmann::json::parse(scriptElement(html, "carom-header"));
  CHECK(header["title"] == "Test </script> & more");
  REQUIRE(header["cases"].size() == 2);
  CHECK(header["cases"][1]["label"] == "1");
  CHECK(header["bodies"][2]["pose"].size() == 7);

  Unpacker unpacker(inflated(fromBase64(scriptElement(html, "carom-motion"))));
  for (int skipFirst = 0; skipFirst < 2; ++skipFirst) {
    const std::vector<std::uint64_t> times = unpacker.take<std::uint64_t>(kFrames);
    const std::vector<std::uint64_t> energy = unpacker.take<std::uint64_t>(kFrames);
    const std::vector<std::uint32_t> arrows = unpacker.take<std::uint32_t>(6 * kFrames);
    const std::vector<std::uint16_t> stored = unpacker.take<std::uint16_t>(2 * 7 * kFrames);
    for (std::size_t f = 0; f < kFrames; ++f) {
      CHECK(std::bit_cast<double>(times[f]) == frames[f].time);
      CHECK(std::bit_cast<double>(energy[f]) == frames[f].channels[0]);
      CHECK(std::bit_cast<float>(arrows[f]) == static_cast<float>(frames[f].arrows[0].from.x()));
      CHECK(std::bit_cast<float>(arrows[4 * kFrames + f]) == 2.0f);
    }
    for (std::size_t body = 0; body < 2; ++body) {
      const nlohmann::json grid = header["cases"][0]["grids"][body];
      std::array<std::vector<std::int16_t>, 7> q;
      for (std::size_t s = 0; s < 7; ++s) {
        for (std::size_t f = 0; f < kFrames; ++f) {
          const int expected = f >= 2 ? 2 * q[s][f - 1] - q[s][f - 2] : f == 1 ? q[s][0] : 0;
          q[s].push_back(
              static_cast<std::int16_t>(stored[(body * 7 + s) * kFrames + f] + expected));
        }
      }
      const Real step = grid[3].get<Real>();
      CHECK(step <= (body == 0 ? 4900.0 : 0.002) / 65000);
      for (std::size_t f = 0; f < kFrames; ++f) {
        const io::Pose& pose = frames[f].poses[body];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Real place = grid[axis].get<Real>() + q[axis][f] * step;
          // Half a step, and the rounding of the largest coordinate.
          CHECK_THAT(place,
                     WithinAbs(pose.position[static_cast<int>(axis)], 0.5001 * step + 1e-12));
        }
        const Real along = (q[3][f] * pose.orientation.w + q[6][f] * pose.orientation.z) / 8191;
        CHECK_THAT(std::abs(along), WithinAbs(1, 1e-4));
      }
    }
  }
  CHECK(unpacker.left() == 0);
}

TEST_CASE("a mesh travels in the page with its vertices and triangles") {
  TriangleMesh surface;
  surface.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}};
  surface.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  io::Recording recording("m");
  recording.addBody("mesh", io::Mesh{surface});
  recording.addFrame({.time = 0, .poses = {{}}});
  const Scratch scratch;
  recording.writeFigure(scratch.file("a.html"), "replay.js");
  const std::string html = Scratch::read(scratch.file("a.html"));
  CHECK_THAT(html, ContainsSubstring("<script src=\"replay.js\"></script>"));
  CHECK(html.size() < 3000);  // the player is not inside
  Unpacker unpacker(inflated(fromBase64(scriptElement(html, "carom-motion"))));
  const std::vector<std::uint32_t> coordinates = unpacker.take<std::uint32_t>(12);
  const std::vector<std::uint32_t> indices = unpacker.take<std::uint32_t>(12);
  CHECK(std::bit_cast<float>(coordinates[11]) == 0.1f);
  CHECK(indices[1] == 2);
  CHECK(indices[11] == 3);
}

TEST_CASE("a page asks nothing of the network and holds the player whole") {
  io::Recording recording("one ball");
  recording.addBody("ball", io::Ball{});
  recording.addFrame({.time = 0, .poses = {{}}});
  const Scratch scratch;
  recording.writeHtml(scratch.file("a.html"));
  io::writePlayer(scratch.file("replay.js"));
  const std::string html = Scratch::read(scratch.file("a.html"));
  const std::string player = Scratch::read(scratch.file("replay.js"));
  CHECK(player == Scratch::read(CAROM_SOURCE_DIR "/docs/players/dist/replay.js"));
  CHECK_THAT(html, ContainsSubstring(player));
  CHECK(html.find("src=") > html.find(player));
  CHECK(html.find("<link") > html.find(player));
  CHECK(player.find("</script") == std::string::npos);
  CHECK_THAT(player, ContainsSubstring("three.js authors"));  // the licence asks for it
}

TEST_CASE("the CSV file has one line per frame, with numbers in full") {
  io::Recording recording("csv");
  recording.addBody("a, \"b\"", io::Ball{});
  recording.addChannel("energy", "J");
  recording.addFrame({.time = 0.1, .poses = {turned(1.0 / 3, 0, 0, 0)}, .channels = {2}});
  const Scratch scratch;
  recording.writeCsv(scratch.file("a.csv"));
  CHECK(
      Scratch::read(scratch.file("a.csv")) ==
      "case,t [s],\"a, \"\"b\"\" x [m]\",\"a, \"\"b\"\" y [m]\",\"a, \"\"b\"\" z [m]\","
      "\"a, \"\"b\"\" qw\",\"a, \"\"b\"\" qx\",\"a, \"\"b\"\" qy\",\"a, \"\"b\"\" qz\",energy [J]\n"
      ",0.1,0.3333333333333333,0,0,1,0,0,0,2\n");
}

TEST_CASE("a bad frame is refused by name and leaves the recording as it was") {
  io::Recording recording("r");
  recording.addBody("ball", io::Ball{});
  recording.addBody("box", io::Box{});
  recording.addChannel("energy", "J");
  const Real nan = std::nan("");
  recording.addFrame({.time = 0, .poses = {{}, {}}, .channels = {1}});
  const auto add = [&recording](io::Frame frame) { recording.addFrame(std::move(frame)); };
  CHECK_THROWS_WITH(add({.time = 1, .poses = {{}, turned(0, nan, 0, 0)}, .channels = {1}}),
                    ContainsSubstring("frame 1, body 'box': position (0, nan, 0)"));
  CHECK_THROWS_WITH(add({.time = 1, .poses = {{.orientation = {0, 0, 0, 0}}, {}}, .channels = {1}}),
                    ContainsSubstring("frame 1, body 'ball': orientation (0, 0, 0, 0)"));
  CHECK_THROWS_WITH(add({.time = 1, .poses = {{}}, .channels = {1}}),
                    ContainsSubstring("frame 1 has 1 poses of moving bodies"));
  CHECK_THROWS_WITH(add({.time = 1, .poses = {{}, {}}, .channels = {INFINITY}}),
                    ContainsSubstring("channel 'energy'"));
  CHECK_THROWS_AS(add({.time = 1, .poses = {{}, {}}}), InvalidInput);
  CHECK_THROWS_WITH(add({.time = 0, .poses = {{}, {}}, .channels = {1}}),
                    ContainsSubstring("must be greater"));
  CHECK_THROWS_AS(add({.time = nan, .poses = {{}, {}}, .channels = {1}}), InvalidInput);
  CHECK(recording.frameCount() == 1);
  CHECK_THROWS_AS(recording.addBody("late", io::Ball{}), InvalidInput);
}

TEST_CASE("bodies and views that cannot be drawn are refused by name") {
  io::Recording recording("r");
  CHECK_THROWS_WITH(recording.addBody("b", io::Ball{.radius = -1}),
                    ContainsSubstring("body 'b': radius -1"));
  CHECK_THROWS_AS(recording.addBody("b", io::Box{.size = {1, 0, 1}}), InvalidInput);
  CHECK_THROWS_AS(recording.addBody("", io::Ball{}), InvalidInput);
  TriangleMesh broken;
  broken.vertices = {{0, 0, 0}};
  broken.triangles = {{0, 0, 1}};
  CHECK_THROWS_WITH(recording.addBody("m", io::Mesh{broken}),
                    ContainsSubstring("triangle 0 names vertex 1"));
  recording.addBody("b", io::Ball{});
  CHECK_THROWS_AS(recording.addFixed("b", io::Ball{}), InvalidInput);
  CHECK_THROWS_AS(recording.setView({.direction = Vector3::UnitZ()}), InvalidInput);
}

TEST_CASE("a recording without frames writes nothing") {
  const Scratch scratch;
  io::Recording recording("empty");
  recording.addBody("b", io::Ball{});
  CHECK_THROWS_WITH(recording.writeHtml(scratch.file("a.html")), ContainsSubstring("no frames"));
  CHECK_FALSE(std::filesystem::exists(scratch.file("a.html")));
  recording.beginCase("0");
  CHECK_THROWS_WITH(recording.beginCase("1"), ContainsSubstring("case '0'"));
  recording.addFrame({.time = 0, .poses = {{}}});
  recording.beginCase("1");
  CHECK_THROWS_WITH(recording.writeCsv(scratch.file("a.csv")), ContainsSubstring("case '1'"));
  recording.addFrame({.time = 0, .poses = {{}}});
  CHECK_THROWS_AS(recording.writeHtml(scratch.file("no/folder/a.html")), io::RecordingFileError);
}

TEST_CASE("the page holds where the balls of a swarm are, to a hundredth of their radius") {
  io::Recording recording("Swarms");
  recording.addBody("one", io::Ball{});
  recording.addSwarm("few", {.count = 3, .radius = 0.1});
  recording.addSwarm("far", {.count = 2, .radius = 0.001, .period = {0, 2000, 0}});
  constexpr int kFrames = 20;
  std::vector<io::Frame> frames;
  for (int i = 0; i < kFrames; ++i) {
    const Real t = i;
    io::Frame frame{.time = t, .poses = {turned(t, 0, 0, 0)}};
    // Straight, in a circle, at rest; and jumps from side to side, further than 16 bits of a
    // fiftieth of the radius reach.
    frame.swarms = {{{t, -t, 0}, {std::sin(t), std::cos(t), 3}, {1, 2, 3}},
                    {{0, i % 2 == 0 ? -1000.0 : 1000.0, t}, {5, 5, 5}}};
    frames.push_back(frame);
    recording.addFrame(frame);
  }
  const Scratch scratch;
  recording.writeHtml(scratch.file("a.html"));
  const std::string html = Scratch::read(scratch.file("a.html"));
  const nlohmann::json header = nlohmann::json::parse(scriptElement(html, "carom-header"));
  REQUIRE(header["swarms"].size() == 2);
  CHECK(header["swarms"][0]["name"] == "few");
  CHECK(header["swarms"][1]["period"][1] == 2000);
  CHECK(header["swarms"][0]["color"] != header["swarms"][1]["color"]);

  Unpacker unpacker(inflated(fromBase64(scriptElement(html, "carom-motion"))));
  unpacker.take<std::uint64_t>(kFrames);      // times
  unpacker.take<std::uint16_t>(7 * kFrames);  // the body
  const std::vector<std::uint16_t> stored = unpacker.take<std::uint16_t>(3 * 5 * kFrames);
  CHECK(unpacker.left() == 0);
  std::size_t at = 0;
  for (std::size_t swarm = 0; swarm < 2; ++swarm) {
    const nlohmann::json grid = header["cases"][0]["swarmGrids"][swarm];
    const Real step = grid[3].get<Real>();
    CHECK_THAT(step, WithinAbs(swarm == 0 ? 0.002 : 1000.0 / 32767, 1e-12));
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t ball = 0; ball < frames[0].swarms[swarm].size(); ++ball) {
        std::vector<std::int16_t> numbers;
        for (std::size_t f = 0; f < kFrames; ++f) {
          // The lowest bit is the sign: 0, 1, 2, 3, 4 stand for 0, -1, 1, -2, 2.
          const int packed = stored[at++];
          const int difference = packed % 2 == 0 ? packed / 2 : -(packed + 1) / 2;
          const int expected = f >= 2   ? 2 * numbers[f - 1] - numbers[f - 2]
                               : f == 1 ? numbers[0]
                                        : 0;
          numbers.push_back(static_cast<std::int16_t>(difference + expected));
          CHECK_THAT(grid[static_cast<std::size_t>(axis)].get<Real>() + numbers[f] * step,
                     WithinAbs(frames[f].swarms[swarm][ball][axis], 0.501 * step));
        }
      }
    }
  }
}

TEST_CASE("the balls of a swarm stand in the CSV file by number") {
  io::Recording recording("Swarms");
  recording.addSwarm("crowd", {.count = 2});
  recording.addFrame({.time = 0.5, .swarms = {{{1, 2, 3}, {-1, 0.1, 0}}}});
  const Scratch scratch;
  recording.writeCsv(scratch.file("a.csv"));
  CHECK(Scratch::read(scratch.file("a.csv")) ==
        "case,t [s],crowd 1 x [m],crowd 1 y [m],crowd 1 z [m],crowd 2 x [m],crowd 2 y [m],"
        "crowd 2 z [m]\n,0.5,1,2,3,-1,0.1,0\n");
}

TEST_CASE("swarms that cannot be drawn are refused by name") {
  io::Recording recording("Swarms");
  const auto refused = [&](const std::string& name, const io::Swarm& swarm, const char* why) {
    CHECK_THROWS_WITH(recording.addSwarm(name, swarm), ContainsSubstring(why));
  };
  recording.addBody("ball", io::Ball{});
  refused("ball", {}, "the name is taken");
  refused("", {}, "needs a name");
  refused("none", {.count = 0}, "'none': a swarm needs at least one ball");
  refused("flat", {.radius = 0}, "radius 0 must be finite and positive");
  refused("torus", {.period = {0, -1, 0}}, "must be finite and not negative");
  recording.addSwarm("crowd", {.count = 2});
  CHECK_THROWS_WITH(recording.addBody("crowd", io::Ball{}), ContainsSubstring("the name is taken"));

  const io::Frame sound{.time = 1, .poses = {{}}, .swarms = {{{0, 0, 0}, {1, 0, 0}}}};
  io::Frame bad = sound;
  bad.swarms = {};
  CHECK_THROWS_WITH(recording.addFrame(bad), ContainsSubstring("swarms"));
  bad = sound;
  bad.swarms[0].pop_back();
  CHECK_THROWS_WITH(recording.addFrame(bad), ContainsSubstring("swarm 'crowd' has 1 positions"));
  bad = sound;
  bad.swarms[0][1].z() = 1.0 / 0.0;
  CHECK_THROWS_WITH(recording.addFrame(bad), ContainsSubstring("swarm 'crowd': position"));
  CHECK(recording.frameCount() == 0);
  recording.addFrame(sound);
  CHECK_THROWS_WITH(recording.addSwarm("late", {}), ContainsSubstring("before the first frame"));
}
