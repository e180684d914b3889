// OFF: the word OFF, three counts, one vertex per line, one face per line (count of corners, then
// their indices).
#include "carom_io/mesh_formats.hpp"

namespace carom::io::detail {

namespace {

// COFF, NOFF, STOFF and their combinations put colours, normals or texture behind the three
// coordinates, where they are skipped. Other prefixes change the meaning of the coordinates.
bool isThreeDimensional(std::string_view keyword) {
  if (keyword.substr(0, 2) == "ST") keyword.remove_prefix(2);
  if (keyword.substr(0, 1) == "C") keyword.remove_prefix(1);
  if (keyword.substr(0, 1) == "N") keyword.remove_prefix(1);
  return keyword == "OFF";
}

}  // namespace

TriangleMesh readOff(const MeshSource& source) {
  TextReader reader(source, true);
  const std::string_view keyword = reader.wordAnywhere("the word OFF");
  if (!isThreeDimensional(keyword)) reader.fail("an OFF file starts with the word OFF");

  std::string_view text = reader.wordAnywhere("the number of vertices");
  if (text == "BINARY") reader.fail("binary OFF files are not read");
  // The shortest vertex is "0 0 0" and a line's end, the shortest face "3 0 0 0" and a line's end.
  const std::size_t vertexCount =
      reader.fitting(reader.wholeIn(text, "the number of vertices"), 6, "vertices");
  text = reader.wordAnywhere("the number of faces");
  const std::size_t faceCount =
      reader.fitting(reader.wholeIn(text, "the number of faces"), 8, "faces");
  // The number of edges follows, which nobody uses; some files leave it out.

  TriangleMesh mesh;
  mesh.vertices.reserve(vertexCount);
  mesh.triangles.reserve(faceCount);
  for (std::size_t i = 0; i < vertexCount; ++i) {
    const std::string wanted = "vertex " + std::to_string(i) + " of " + std::to_string(vertexCount);
    if (!reader.nextLine()) reader.fail("the file ends where " + wanted + " should be");
    const Real x = reader.number(wanted), y = reader.number(wanted), z = reader.number(wanted);
    mesh.vertices.emplace_back(x, y, z);
  }
  std::vector<std::int32_t> corners;
  for (std::size_t f = 0; f < faceCount; ++f) {
    const std::string wanted = "face " + std::to_string(f) + " of " + std::to_string(faceCount);
    if (!reader.nextLine()) reader.fail("the file ends where " + wanted + " should be");
    const std::int64_t count = reader.whole(wanted);
    if (count < 3) reader.fail(wanted + " has " + std::to_string(count) + " corners");
    corners.clear();
    for (std::int64_t k = 0; k < count; ++k) {
      const std::int64_t index = reader.whole("a corner of " + wanted);
      if (index < 0 || index >= static_cast<std::int64_t>(vertexCount)) {
        reader.fail(wanted + " names vertex " + std::to_string(index) + ", but there are " +
                    std::to_string(vertexCount));
      }
      corners.push_back(static_cast<std::int32_t>(index));
    }
    addFan(mesh, corners);
  }
  return mesh;
}

}  // namespace carom::io::detail
