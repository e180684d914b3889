#include "carom_io/mesh_file.hpp"

#include <fstream>
#include <string>
#include <system_error>

#include "carom_io/mesh_formats.hpp"

namespace carom::io {

namespace {

std::string contentOf(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw MeshFileError(name + ": there is no such file");
  }
  // A directory has no content; a pipe or a device may have content without end.
  if (status.type() != std::filesystem::file_type::regular) {
    throw MeshFileError(name + ": is not a regular file");
  }
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) throw MeshFileError(name + ": cannot be opened");
  std::string content(size, '\0');
  file.read(content.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(file.gcount()) != size) {
    throw MeshFileError(name + ": reading stopped at byte " + std::to_string(file.gcount()));
  }
  return content;
}

}  // namespace

TriangleMesh readMesh(const std::filesystem::path& path) {
  const std::string content = contentOf(path);
  return detail::readAny({path.string(), content});
}

namespace detail {

TriangleMesh readAny(const MeshSource& source) {
  if (source.content.empty()) throw MeshFileError(source.name + ": the file is empty");
  std::string ending = std::filesystem::path(source.name).extension().string();
  for (char& c : ending) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".off") return readOff(source);
  if (ending == ".obj") return readObj(source);
  if (ending == ".stl") return readStl(source);
  if (ending == ".ply") return readPly(source);
  throw MeshFileError(source.name + ": the ending '" + ending +
                      "' names no known format; known are .off, .obj, .stl, .ply");
}

}  // namespace detail

}  // namespace carom::io
