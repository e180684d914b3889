// STL: triangles as three corners each, without indices; as text or as 50-byte records.
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "carom_io/mesh_formats.hpp"

namespace carom::io::detail {

namespace {

constexpr std::size_t kHeaderBytes = 84;  // 80 bytes of anything, then the number of triangles
constexpr std::size_t kTriangleBytes =
    50;  // a normal and three corners as floats, then two bytes of anything

// Gives equal corners one index. Equal means equal in all bits, but for the sign of zero: 0 and -0
// are one place.
class VertexMerger {
 public:
  explicit VertexMerger(TriangleMesh& mesh) : mesh_(mesh) {}

  std::int32_t indexOf(const Vector3& corner) {
    const Key key{std::bit_cast<std::uint64_t>(corner.x() + 0.0),
                  std::bit_cast<std::uint64_t>(corner.y() + 0.0),
                  std::bit_cast<std::uint64_t>(corner.z() + 0.0)};
    const auto [place, isNew] =
        indices_.try_emplace(key, static_cast<std::int32_t>(mesh_.vertices.size()));
    if (isNew) mesh_.vertices.push_back(corner);
    return place->second;
  }

 private:
  using Key = std::array<std::uint64_t, 3>;
  struct Mix {
    // Multiply and fold: the low bits of a coordinate are often all zero.
    std::size_t operator()(const Key& key) const {
      std::uint64_t h = 0;
      for (const std::uint64_t part : key) {
        h = (h ^ part) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
      }
      return static_cast<std::size_t>(h);
    }
  };
  TriangleMesh& mesh_;
  std::unordered_map<Key, std::int32_t, Mix> indices_;
};

std::uint32_t bitsAt(std::string_view bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  }
  return bits;
}

TriangleMesh readBinary(const MeshSource& source) {
  const std::size_t count = bitsAt(source.content, 80);
  TriangleMesh mesh;
  mesh.triangles.reserve(count);
  VertexMerger merger(mesh);
  for (std::size_t t = 0; t < count; ++t) {
    std::array<std::int32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = kHeaderBytes + t * kTriangleBytes + 12 * (k + 1);
      Vector3 corner;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Real value = std::bit_cast<float>(bitsAt(source.content, at + 4 * axis));
        if (!std::isfinite(value)) {
          failAtByte(source, at + 4 * axis,
                     "a coordinate of triangle " + std::to_string(t) + " is not finite");
        }
        corner[static_cast<int>(axis)] = value;
      }
      triangle[k] = merger.indexOf(corner);
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

void expectWord(TextReader& reader, const std::string& wanted) {
  const std::string_view found = reader.wordAnywhere("'" + wanted + "'");
  if (lowered(found) != wanted) reader.fail("'" + wanted + "' should be here");
}

TriangleMesh readText(const MeshSource& source) {
  TextReader reader(source, false);
  TriangleMesh mesh;
  VertexMerger merger(mesh);
  bool insideSolid = false;
  while (reader.nextLine()) {
    const std::string keyword = lowered(*reader.word());
    if (keyword == "solid" && !insideSolid) {
      insideSolid = true;  // the rest of the line is a name
    } else if (keyword == "endsolid" && insideSolid) {
      insideSolid = false;
    } else if (keyword == "facet" && insideSolid) {
      // The normal is not needed, and is often wrong or missing in real files: its line is skipped.
      if (!reader.nextLine()) reader.fail("the file ends in the middle of a facet");
      expectWord(reader, "outer");
      expectWord(reader, "loop");
      std::array<std::int32_t, 3> triangle{};
      for (std::int32_t& index : triangle) {
        expectWord(reader, "vertex");
        const Real x = reader.number("x"), y = reader.number("y"), z = reader.number("z");
        index = merger.indexOf({x, y, z});
      }
      expectWord(reader, "endloop");
      expectWord(reader, "endfacet");
      mesh.triangles.push_back(triangle);
    } else {
      reader.fail(insideSolid ? "'facet' or 'endsolid' should be here" : "'solid' should be here");
    }
  }
  if (insideSolid) reader.fail("the file ends before 'endsolid'");
  return mesh;
}

}  // namespace

// Many binary files start with the word "solid" too; the size alone is sure. In a text file the
// four bytes of the count are letters, which would promise hundreds of millions of triangles.
TriangleMesh readStl(const MeshSource& source) {
  const std::string_view bytes = source.content;
  if (bytes.size() >= kHeaderBytes && (bytes.size() - kHeaderBytes) % kTriangleBytes == 0 &&
      (bytes.size() - kHeaderBytes) / kTriangleBytes == bitsAt(bytes, 80)) {
    return readBinary(source);
  }
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start != std::string_view::npos && lowered(bytes.substr(start, 5)) == "solid" &&
      bytes.find('\0') == std::string_view::npos) {
    return readText(source);
  }
  if (bytes.size() < kHeaderBytes) {
    failAtByte(source, bytes.size(),
               "neither a text STL file ('solid ...') nor a binary one, "
               "which has 84 bytes before the first triangle");
  }
  const std::uint64_t count = bitsAt(bytes, 80);
  failAtByte(source, 80,
             std::to_string(count) + " triangles need " +
                 std::to_string(kHeaderBytes + kTriangleBytes * count) +
                 " bytes, but the file has " + std::to_string(bytes.size()));
}

}  // namespace carom::io::detail
