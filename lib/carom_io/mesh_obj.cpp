// OBJ: lines "v x y z" and "f a b c ...", where a corner is "vertex/texture/normal" and counts from
// 1, or backwards from the last vertex when it is negative.
#include <algorithm>
#include <array>

#include "carom_io/mesh_formats.hpp"

namespace carom::io::detail {

namespace {

// Lines without a surface of triangles in them: normals, texture, names, materials, points and
// lines.
constexpr std::array<std::string_view, 14> kSkipped{
    "vn", "vt", "vp", "g", "o", "s", "mg", "l", "p", "usemtl", "mtllib", "usemap", "lod", "maplib"};

}  // namespace

TriangleMesh readObj(const MeshSource& source) {
  TextReader reader(source, true);
  TriangleMesh mesh;
  std::vector<std::int32_t> corners;
  // A face may name a vertex that comes later, so the largest index is judged at the end.
  std::int64_t largest = -1;
  std::size_t lineOfLargest = 0;

  while (reader.nextLine()) {
    const std::string_view kind = *reader.word();
    if (kind == "v") {
      const Real x = reader.number("x"), y = reader.number("y"), z = reader.number("z");
      mesh.vertices.emplace_back(x, y, z);
    } else if (kind == "f" || kind == "fo") {
      corners.clear();
      for (std::optional<std::string_view> text = reader.word(); text; text = reader.word()) {
        if (*text == "\\") {
          // The line goes on in the next one.
          if (!reader.nextLine()) reader.fail("the file ends in the middle of a face");
          continue;
        }
        const std::string_view first = text->substr(0, text->find('/'));
        std::int64_t index = reader.wholeIn(first, "the index of a vertex");
        const std::int64_t count = static_cast<std::int64_t>(mesh.vertices.size());
        if (index == 0 || index < -count || index > 2147483647) {
          reader.fail("a face names vertex " + std::to_string(index) + ", but there are " +
                      std::to_string(count) + " so far, counted from 1");
        }
        index = index > 0 ? index - 1 : count + index;
        if (index > largest) {
          largest = index;
          lineOfLargest = reader.line();
        }
        corners.push_back(static_cast<std::int32_t>(index));
      }
      if (corners.size() < 3) {
        reader.fail("a face with " + std::to_string(corners.size()) + " corners");
      }
      addFan(mesh, corners);
    } else if (std::find(kSkipped.begin(), kSkipped.end(), kind) == kSkipped.end()) {
      reader.fail(shown(kind) + " starts no line that is known here");
    }
  }
  if (largest >= static_cast<std::int64_t>(mesh.vertices.size())) {
    failAtLine(source, lineOfLargest,
               "a face names vertex " + std::to_string(largest + 1) + ", but there are " +
                   std::to_string(mesh.vertices.size()) + ", counted from 1");
  }
  if (mesh.vertices.empty()) reader.fail("the file has no vertices");
  return mesh;
}

}  // namespace carom::io::detail
