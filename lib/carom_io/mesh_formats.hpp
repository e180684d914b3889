#pragma once
// What the readers of the four formats share: the content of a file in memory, words with line
// numbers, and checked indices. Internal to carom_io.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "carom/mass/triangle_mesh.hpp"
#include "carom_io/mesh_file.hpp"

namespace carom::io::detail {

/// A file in memory.
struct MeshSource {
  std::string name;          ///< for messages
  std::string_view content;  ///< all its bytes
};

/// Ends reading with "name:line: what".
[[noreturn]] void failAtLine(const MeshSource& source, std::size_t line, const std::string& what);
/// Ends reading with "name, byte n: what".
[[noreturn]] void failAtByte(const MeshSource& source, std::size_t byte, const std::string& what);

/// A word as messages show it: in quotes, cut short, without control characters.
/// \param text the word
std::string shown(std::string_view text);

/// Walks over a text file line by line and word by word. Everything behind a '#' is left out where
/// asked for.
class TextReader {
 public:
  /// A reader at the start of a text. \param source the file, kept by reference
  /// \param comments whether '#' starts a comment \param start the byte to start at
  TextReader(const MeshSource& source, bool comments, std::size_t start = 0);

  /// Goes to the next line that has a word. \return false at the end of the file
  bool nextLine();
  /// The next word of this line. \return nothing at the end of the line
  std::optional<std::string_view> word();
  /// The next word of this line or of the next ones.
  /// \param wanted what should come, for the message
  /// \return the word
  std::string_view wordAnywhere(const std::string& wanted);
  /// The next word of this line as a finite number. \param wanted what should come, for the message
  /// \return the number
  Real number(const std::string& wanted);
  /// The next word of this line as a whole number. \param wanted what should come, for the message
  /// \return the number
  std::int64_t whole(const std::string& wanted);
  /// A word as a finite number.
  /// \param text the word
  /// \param wanted what it should be, for the message
  /// \return the number
  Real numberIn(std::string_view text, const std::string& wanted) const;
  /// A word as a whole number.
  /// \param text the word
  /// \param wanted what it should be, for the message
  /// \return the number
  std::int64_t wholeIn(std::string_view text, const std::string& wanted) const;
  /// A count that the rest of the file can hold. \param count as read
  /// \param bytesEach the fewest bytes that one takes
  /// \param wanted what is counted, for the message
  /// \return the count
  std::size_t fitting(std::int64_t count, std::size_t bytesEach, const std::string& wanted) const;
  /// Ends reading with the current line. \param what is wrong
  [[noreturn]] void fail(const std::string& what) const;
  /// The number of the current line, from 1.
  std::size_t line() const {
    return line_;
  }
  /// Where the line behind the current one starts.
  std::size_t nextByte() const {
    return next_;
  }

 private:
  const MeshSource& source_;
  bool comments_;
  std::size_t next_;       // start of the line behind the current one
  std::size_t line_ = 0;   // number of the current line
  std::string_view rest_;  // what has not been read of the current line
};

/// Adds a polygon as a fan of triangles about its first corner.
/// \param corners its corners, at least 3
void addFan(TriangleMesh& mesh, const std::vector<std::int32_t>& corners);

/// Reads the format that the ending of the source's name stands for. \param source the file
/// \return the mesh \throws MeshFileError
TriangleMesh readAny(const MeshSource& source);

/// The readers. \param source the file \return the mesh \throws MeshFileError
TriangleMesh readOff(const MeshSource& source);
/// Wavefront OBJ, see readOff().
TriangleMesh readObj(const MeshSource& source);
/// STL, see readOff().
TriangleMesh readStl(const MeshSource& source);
/// PLY, see readOff().
TriangleMesh readPly(const MeshSource& source);

}  // namespace carom::io::detail
