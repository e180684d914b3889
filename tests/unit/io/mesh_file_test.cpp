#include "carom_io/mesh_file.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include "carom_io/mesh_formats.hpp"
#include "scratch.hpp"
#include "support/catch.hpp"

using namespace carom;
using carom_test::ContainsSubstring;
using carom_test::Scratch;

namespace {

// A tetrahedron whose coordinates are floats, so that every format can hold them, in the order of
// the OFF file.
const std::string kOff =
    "OFF # a tetrahedron\n4 4 6\n0 0 0\n1.5 0 0\n0 -2 0\n0 0 0.25\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 "
    "3 2\n";
const std::string kObj =
    "# a tetrahedron\nmtllib none.mtl\no tet\nv 0 0 0\nv 1.5 0 0\nv 0 -2 0\nv 0 0 0.25\nvn 0 0 1\n"
    "f 1 2 3\nf 1/1 4/2/1 2//1\nf -4 -2 -1\nf 2 4 3\n";

TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1.5, 0, 0}, {0, -2, 0}, {0, 0, 0.25}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return mesh;
}

template <class Number>
std::string bytesOf(Number number, bool bigEndian = false) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  const bool machineIsBig = std::endian::native == std::endian::big;
  if (bigEndian != machineIsBig) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string plyHeader(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment by hand\nelement vertex 4\nproperty double x\nproperty float y\n"
         "property float z\nproperty uchar red\nelement face 4\n"
         "property list uchar int vertex_indices\nend_header\n";
}

std::string textPly() {
  return plyHeader("ascii") +
         "0 0 0 9\n1.5 0 0 9\n0 -2 0 9\n0 0 0.25 9\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";
}

std::string binaryPly(bool big) {
  std::string text = plyHeader(big ? "binary_big_endian" : "binary_little_endian");
  const TriangleMesh mesh = tetrahedron();
  for (const Vector3& v : mesh.vertices) {
    text += bytesOf(v.x(), big) + bytesOf(static_cast<float>(v.y()), big) +
            bytesOf(static_cast<float>(v.z()), big) + '\x09';
  }
  for (const std::array<std::int32_t, 3>& t : mesh.triangles) {
    text += '\x03';
    for (const std::int32_t index : t) text += bytesOf(index, big);
  }
  return text;
}

std::string textStl() {
  std::string text = "solid a tetrahedron\n";
  const TriangleMesh mesh = tetrahedron();
  for (const std::array<std::int32_t, 3>& t : mesh.triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::int32_t index : t) {
      const Vector3& v = mesh.vertices[static_cast<std::size_t>(index)];
      text += "      vertex " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " +
              std::to_string(v.z()) + "\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid a tetrahedron\n";
}

std::string binaryStl() {
  std::string text = "solid, as many binary files begin";
  text.resize(80, ' ');
  const TriangleMesh mesh = tetrahedron();
  text += bytesOf(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const std::array<std::int32_t, 3>& t : mesh.triangles) {
    text += std::string(12, '\0');
    for (const std::int32_t index : t) {
      const Vector3& v = mesh.vertices[static_cast<std::size_t>(index)];
      for (int axis = 0; axis < 3; ++axis) text += bytesOf(static_cast<float>(v[axis]));
    }
    text += std::string(2, '\0');
  }
  return text;
}

struct Sample {
  const char* name;
  std::string content;
};

std::vector<Sample> samples() {
  return {{"a.off", kOff},           {"b.obj", kObj},      {"c.stl", textStl()},
          {"d.STL", binaryStl()},    {"e.ply", textPly()}, {"f.ply", binaryPly(false)},
          {"g.ply", binaryPly(true)}};
}

bool sameSurface(const TriangleMesh& a, const TriangleMesh& b) {
  // STL numbers its vertices in the order in which triangles name them: compare corners.
  if (a.triangles.size() != b.triangles.size() || a.vertices.size() != b.vertices.size())
    return false;
  for (std::size_t t = 0; t < a.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& p = a.vertices[static_cast<std::size_t>(a.triangles[t][k])];
      const Vector3& q = b.vertices[static_cast<std::size_t>(b.triangles[t][k])];
      if (p != q) return false;
    }
  }
  return true;
}

// What readMesh() promises for any file: a mesh that is whole, or a MeshFileError. Returns whether
// it was read.
bool readsOrRefuses(const std::string& name, const std::string& content) {
  try {
    const TriangleMesh mesh = io::detail::readAny({name, content});
    const auto exists = [&mesh](std::int32_t index) {
      return index >= 0 && static_cast<std::size_t>(index) < mesh.vertices.size();
    };
    for (const Vector3& v : mesh.vertices) REQUIRE(v.allFinite());
    for (const std::array<std::int32_t, 3>& t : mesh.triangles) {
      REQUIRE((exists(t[0]) && exists(t[1]) && exists(t[2])));
    }
    return true;
  } catch (const io::MeshFileError& error) {
    REQUIRE_THAT(error.what(), ContainsSubstring(name));
    return false;
  }
}

void checkRefused(const std::string& name, const std::string& content, const std::string& message) {
  const Scratch scratch;
  const std::filesystem::path path = scratch.write(name, content);
  INFO(content);
  CHECK_THROWS_AS(io::readMesh(path), io::MeshFileError);
  CHECK_THROWS_WITH(io::readMesh(path), ContainsSubstring(name) && ContainsSubstring(message));
}

}  // namespace

TEST_CASE("every format gives the same tetrahedron") {
  const Scratch scratch;
  for (const Sample& sample : samples()) {
    INFO(sample.name);
    CHECK(sameSurface(io::readMesh(scratch.write(sample.name, sample.content)), tetrahedron()));
  }
}

TEST_CASE("lines may end as on any system") {
  const Scratch scratch;
  for (const Sample& sample : {Sample{"a.off", kOff}, Sample{"b.obj", kObj},
                               Sample{"c.stl", textStl()}, Sample{"e.ply", textPly()}}) {
    for (const char* end : {"\r\n", "\r"}) {
      std::string content;
      for (const char c : sample.content)
        content += c == '\n' ? std::string(end) : std::string(1, c);
      INFO(sample.name);
      CHECK(sameSurface(io::readMesh(scratch.write(sample.name, content)), tetrahedron()));
    }
  }
}

TEST_CASE("coordinates keep the digits of a double") {
  const Scratch scratch;
  const std::string rest = " 1000000.0000000001 0\n";
  const TriangleMesh off = io::readMesh(scratch.write(
      "a.off", "OFF\n3 1 0\n0.1" + rest + "1 0 0\n+0.30000000000000004 1e-3 -1E+2\n3 0 1 2\n"));
  CHECK(off.vertices[0] == Vector3(0.1, 1000000.0000000001, 0));
  CHECK(off.vertices[2] == Vector3(0.30000000000000004, 0.001, -100));
}

TEST_CASE("a polygon becomes a fan about its first corner") {
  const Scratch scratch;
  const TriangleMesh mesh = io::readMesh(
      scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 \\\n 3 4 5\n"));
  REQUIRE(mesh.triangles.size() == 3);
  CHECK(mesh.triangles[0] == std::array<std::int32_t, 3>{0, 1, 2});
  CHECK(mesh.triangles[2] == std::array<std::int32_t, 3>{0, 3, 4});
}

TEST_CASE("STL corners merge when they are the same number, also for minus zero") {
  std::string content = binaryStl();
  // The first corner of the first triangle is (0, 0, 0): make its x a minus zero.
  content[84 + 12 + 3] = '\x80';
  const Scratch scratch;
  CHECK(io::readMesh(scratch.write("a.stl", content)).vertices.size() == 4);
  // One unit in the last place is another corner.
  content[84 + 12] = '\x01';
  CHECK(io::readMesh(scratch.write("a.stl", content)).vertices.size() == 5);
}

TEST_CASE("a broken text file is refused with its line") {
  checkRefused("a.off", "", "empty");
  checkRefused("a.off", "\n\n", "the file ends");
  checkRefused("a.off", "FFO\n1 1 1\n", ":1: ");
  checkRefused("a.off", "OFF\n2 1 0\n0 0 0\n1 nan 0\n3 0 1 1\n", ":4: 'nan' is not finite");
  checkRefused("a.off", "OFF\n1 1 0\n0 0 inf\n3 0 0 0\n", ":3: 'inf'");
  checkRefused("a.off", "OFF\n1 1 0\n0 0 1e999\n3 0 0 0\n", "range of a double");
  checkRefused("a.off", "OFF\n1 1 0\n0 0 1x\n3 0 0 0\n", "'1x' is not a number");
  checkRefused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
               ":6: face 0 of 1 names vertex 3");
  checkRefused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "names vertex -1");
  checkRefused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1     \n", "has 2 corners");
  checkRefused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "the line ends");
  checkRefused("a.off", "OFF BINARY\n", "binary OFF");
  checkRefused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", ":4: a face names vertex 4");
  checkRefused("a.obj", "v 0 0 0\nf 1 1 -2\n", ":2: a face names vertex -2");
  checkRefused("a.obj", "v 0 0 0\nf 0 1 1\n", "names vertex 0");
  checkRefused("a.obj", "v 0 0 0\nf 1 1\n", "2 corners");
  checkRefused("a.obj", "v 0 0 0\nf 1 1 99999999999999999999\n", "not a whole number");
  checkRefused("a.obj",
               "\x7f"
               "ELF\n",
               "starts no line");
  checkRefused("a.obj", "# nothing\n", "no vertices");
  checkRefused("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "the file ends");
  checkRefused("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", ":4: ");
  checkRefused("a.stl", "solid x\n", "before 'endsolid'");
  checkRefused("a.ply", "ply\nelement vertex 1\n", "before end_header");
  checkRefused("a.ply", "ply\nformat ascii 1.0\nend_header\n", "'vertex' and 'face'");
  checkRefused("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", ":4: 'quad'");
}

TEST_CASE("a count that the file has no room for is refused before memory is taken") {
  checkRefused("a.off", "OFF\n2000000000 1 0\n0 0 0\n", "2000000000 vertices are promised");
  checkRefused("a.off", "OFF\n-1 1 0\n", "-1 vertices");
  checkRefused("a.off", "OFF\n99999999999999999999999 1 0\n", "not a whole number");
  std::string stl = binaryStl();
  stl.replace(80, 4, bytesOf(std::uint32_t{4000000000u}));
  checkRefused("a.stl", stl, "4000000000 triangles need 200000000084 bytes");
  checkRefused("a.stl", binaryStl().substr(0, 200), "byte 80");
  std::string ply = binaryPly(false);
  ply.replace(ply.find("vertex 4"), 8, "vertex 2000000000");
  checkRefused("a.ply", ply, "elements 'vertex' are promised");
  ply = binaryPly(true);  // the length 3 becomes 3 * 2^24
  ply.replace(ply.find("uchar int"), 9, "uint int");
  checkRefused("a.ply", ply, "are promised");
  ply = binaryPly(true);
  ply.replace(ply.find("element face 4"), 14, "element nothing 2000000000\nelement face 4");
  CHECK(readsOrRefuses("b.ply", ply));  // two thousand million times nothing is nothing
}

TEST_CASE("binary numbers that are no numbers are refused with their byte") {
  std::string stl = binaryStl();
  stl.replace(84 + 12, 4, bytesOf(std::uint32_t{0x7fc00000u}));
  checkRefused("a.stl", stl, "byte 96: a coordinate of triangle 0 is not finite");
  std::string ply = binaryPly(false);
  ply.replace(ply.size() - 4, 4, bytesOf(std::int32_t{-1}));
  checkRefused("a.ply", ply, "face 3 names a vertex that does not exist");
}

TEST_CASE("what is no mesh file is refused by name") {
  const Scratch scratch;
  CHECK_THROWS_WITH(io::readMesh(scratch.file("none.off")), ContainsSubstring("no such file"));
  CHECK_THROWS_WITH(io::readMesh(scratch.write("a.txt", "x")), ContainsSubstring("'.txt'"));
  std::filesystem::create_directories(scratch.file("folder.off"));
  CHECK_THROWS_WITH(io::readMesh(scratch.file("folder.off")), ContainsSubstring("regular file"));
  CHECK_THROWS_WITH(io::readMesh("/dev/zero"), ContainsSubstring("regular file"));
}

TEST_CASE("a file cut short anywhere is read or refused, never more") {
  for (const Sample& sample : samples()) {
    for (std::size_t length = 0; length < sample.content.size(); ++length) {
      const bool read = readsOrRefuses(sample.name, sample.content.substr(0, length));
      // Cutting off what stands behind the last corner's first digit can leave a whole file. An OBJ
      // file has no counts: any line's end is an end.
      const bool isObj = std::string(sample.name) == "b.obj";
      if (read && !isObj) CHECK(length + 26 >= sample.content.size());
    }
  }
}

TEST_CASE("a file with random damage is read or refused, never more") {
  const unsigned seed = 20240607;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  const std::vector<std::string> words{"-1", "99999999999", "nan", "1e308", "0",
                                       "\\", "#",           "\n",  " "};
  for (const Sample& sample : samples()) {
    int refused = 0;
    for (int round = 0; round < 1000; ++round) {
      std::string content = sample.content;
      for (std::size_t hits = 1 + below(4); hits > 0; --hits) {
        const std::size_t at = below(content.size());
        switch (below(4)) {
          case 0:
            content[at] = static_cast<char>(random());
            break;
          case 1:
            content.erase(at, 1 + below(8));
            break;
          case 2:
            content.insert(at, words[below(words.size())]);
            break;
          default: {
            // One after the other: a call's arguments have no fixed order, and the seed must mean
            // one test.
            const std::size_t from = below(content.size());
            content.insert(at, content.substr(from, below(40)));
            break;
          }
        }
        if (content.empty()) break;
      }
      if (!readsOrRefuses(sample.name, content)) ++refused;
    }
    INFO(sample.name);
    CHECK(refused > 100);  // the damage is felt
  }
}
