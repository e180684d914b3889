// PLY: a text header that declares elements and their properties, then the numbers, as text or
// binary.
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "carom_io/mesh_formats.hpp"

namespace carom::io::detail {

namespace {

enum class Encoding { Text, LittleEndian, BigEndian };

struct NumberType {
  std::size_t bytes = 0;
  bool isSigned = false;
  bool isFloat = false;
};

struct Property {
  std::string name;
  NumberType type;
  std::optional<NumberType> countType;  // of a list
};

struct Element {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::Text;
  std::vector<Element> elements;
};

NumberType numberType(const TextReader& reader, std::string_view name) {
  if (name == "char" || name == "int8") return {1, true, false};
  if (name == "uchar" || name == "uint8") return {1, false, false};
  if (name == "short" || name == "int16") return {2, true, false};
  if (name == "ushort" || name == "uint16") return {2, false, false};
  if (name == "int" || name == "int32") return {4, true, false};
  if (name == "uint" || name == "uint32") return {4, false, false};
  if (name == "float" || name == "float32") return {4, true, true};
  if (name == "double" || name == "float64") return {8, true, true};
  reader.fail(shown(name) + " is no type of PLY");
}

std::string_view wordOfLine(TextReader& reader, const std::string& wanted) {
  const std::optional<std::string_view> found = reader.word();
  if (!found) reader.fail("the line ends where " + wanted + " should be");
  return *found;
}

// Reads up to and with end_header.
Header readHeader(TextReader& reader) {
  if (!reader.nextLine() || reader.word() != "ply")
    reader.fail("a PLY file starts with the word ply");
  Header header;
  bool hasFormat = false;
  while (reader.nextLine()) {
    const std::string_view keyword = *reader.word();
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "end_header") {
      if (!hasFormat) reader.fail("the header has no line 'format'");
      return header;
    }
    if (keyword == "format") {
      const std::string_view name = wordOfLine(reader, "a format");
      if (name == "ascii") {
        header.encoding = Encoding::Text;
      } else if (name == "binary_little_endian") {
        header.encoding = Encoding::LittleEndian;
      } else if (name == "binary_big_endian") {
        header.encoding = Encoding::BigEndian;
      } else {
        reader.fail("a format other than ascii, binary_little_endian, binary_big_endian");
      }
      hasFormat = true;
    } else if (keyword == "element") {
      Element element;
      element.name = wordOfLine(reader, "the name of an element");
      element.count = reader.whole("how many there are");
      if (element.count < 0 || element.count > std::numeric_limits<std::int32_t>::max()) {
        reader.fail(std::to_string(element.count) + " elements: must be 0 to 2147483647");
      }
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      if (header.elements.empty()) reader.fail("a property before the first element");
      Property property;
      std::string_view type = wordOfLine(reader, "a type");
      if (type == "list") {
        property.countType = numberType(reader, wordOfLine(reader, "the type of the count"));
        if (property.countType->isFloat) reader.fail("the count of a list must be a whole number");
        type = wordOfLine(reader, "the type of the items");
      }
      property.type = numberType(reader, type);
      property.name = wordOfLine(reader, "the name of a property");
      header.elements.back().properties.push_back(std::move(property));
    } else {
      reader.fail(shown(keyword) + " starts no line of a PLY header");
    }
  }
  reader.fail("the file ends before end_header");
}

// The numbers behind the header, one after the other, whatever their encoding.
class Body {
 public:
  Body(const MeshSource& source, TextReader& text, Encoding encoding)
      : source_(source), text_(text), encoding_(encoding), at_(text.nextByte()) {}

  Real next(const NumberType& type, const std::string& wanted) {
    if (encoding_ == Encoding::Text) {
      return text_.numberIn(text_.wordAnywhere(wanted), wanted);
    }
    if (source_.content.size() - at_ < type.bytes)
      fail("the file ends where " + wanted + " should be");
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < type.bytes; ++k) {
      const std::size_t place = encoding_ == Encoding::BigEndian ? k : type.bytes - 1 - k;
      bits = bits << 8 | static_cast<unsigned char>(source_.content[at_ + place]);
    }
    const Real value = valueOf(bits, type);
    if (!std::isfinite(value)) fail("a number is not finite: " + wanted);
    at_ += type.bytes;
    return value;
  }

  // The fewest bytes that a number takes: a digit and a space, or its size.
  std::size_t bytesOf(const NumberType& type) const {
    return encoding_ == Encoding::Text ? 2 : type.bytes;
  }

  // Refuses a count that the rest of the file cannot hold.
  void mustFit(Real count, std::size_t bytesEach, const std::string& wanted) const {
    const std::size_t position = encoding_ == Encoding::Text ? text_.nextByte() : at_;
    // The line that is being read may hold numbers still: its start is not known here, so text
    // counts from the start of the file, which bounds memory as well.
    const std::size_t left = source_.content.size() - (encoding_ == Encoding::Text ? 0 : position);
    if (count * static_cast<Real>(bytesEach) > static_cast<Real>(left + 1)) {
      fail(std::to_string(static_cast<std::int64_t>(count)) + " " + wanted +
           " are promised, but the file has no room for them");
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (encoding_ == Encoding::Text) text_.fail(what);
    failAtByte(source_, at_, what);
  }

 private:
  static Real valueOf(std::uint64_t bits, const NumberType& type) {
    if (type.isFloat) {
      return type.bytes == 8 ? std::bit_cast<double>(bits)
                             : Real(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }
    if (!type.isSigned) return static_cast<Real>(bits);
    // Two's complement of fewer than 64 bits: what is at least half the range stands for a negative
    // number.
    const Real range = static_cast<Real>(std::uint64_t{1} << (8 * type.bytes));
    const Real value = static_cast<Real>(bits);
    return value < range / 2 ? value : value - range;
  }

  const MeshSource& source_;
  TextReader& text_;
  Encoding encoding_;
  std::size_t at_;
};

std::size_t listLength(Body& body, const Property& property, const std::string& wanted) {
  const Real length = body.next(*property.countType, "the length of " + wanted);
  if (length < 0 || length != std::floor(length))
    body.fail("a list with a length that is no count: " + wanted);
  body.mustFit(length, body.bytesOf(property.type), "items of " + wanted);
  return static_cast<std::size_t>(length);
}

void readVertex(Body& body, const Element& element, TriangleMesh& mesh, const std::string& which) {
  Vector3 position = Vector3::Zero();
  for (const Property& property : element.properties) {
    const std::string wanted = "'" + property.name + "' of " + which;
    if (property.countType) {
      for (std::size_t k = listLength(body, property, wanted); k > 0; --k)
        body.next(property.type, wanted);
      continue;
    }
    const Real value = body.next(property.type, wanted);
    if (property.name == "x") position.x() = value;
    if (property.name == "y") position.y() = value;
    if (property.name == "z") position.z() = value;
  }
  mesh.vertices.push_back(position);
}

bool namesCorners(const Property& property) {
  return property.countType &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

void readFace(Body& body, const Element& element, std::int64_t vertexCount, TriangleMesh& mesh,
              const std::string& which) {
  std::vector<std::int32_t> corners;
  for (const Property& property : element.properties) {
    const std::string wanted = "'" + property.name + "' of " + which;
    std::size_t length = property.countType ? listLength(body, property, wanted) : 1;
    if (!namesCorners(property)) {
      for (; length > 0; --length) body.next(property.type, wanted);
      continue;
    }
    if (length < 3) body.fail(which + " has " + std::to_string(length) + " corners");
    corners.clear();
    for (; length > 0; --length) {
      const Real index = body.next(property.type, wanted);
      if (index < 0 || index >= static_cast<Real>(vertexCount) || index != std::floor(index)) {
        body.fail(which + " names a vertex that does not exist; there are " +
                  std::to_string(vertexCount));
      }
      corners.push_back(static_cast<std::int32_t>(index));
    }
  }
  addFan(mesh, corners);
}

bool hasCoordinates(const Element& element) {
  int found = 0;
  for (const Property& property : element.properties) {
    const std::string& name = property.name;
    if (!property.countType && (name == "x" || name == "y" || name == "z")) ++found;
  }
  return found == 3;
}

bool hasCorners(const Element& element) {
  int found = 0;
  for (const Property& property : element.properties) found += namesCorners(property);
  return found == 1;
}

}  // namespace

TriangleMesh readPly(const MeshSource& source) {
  TextReader text(source, false);
  const Header header = readHeader(text);
  std::int64_t vertexCount = -1;
  bool faces = false;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") {
      if (vertexCount >= 0 || !hasCoordinates(element)) {
        text.fail("the header must declare one element 'vertex' with x, y and z, each once");
      }
      vertexCount = element.count;
    }
    if (element.name == "face") {
      if (faces || !hasCorners(element)) {
        text.fail("the header must declare one element 'face' with one list 'vertex_indices'");
      }
      faces = true;
    }
  }
  if (vertexCount < 0 || !faces)
    text.fail("the header must declare the elements 'vertex' and 'face'");

  TriangleMesh mesh;
  Body body(source, text, header.encoding);
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;  // takes no bytes, however many there are
    std::size_t bytesEach = 0;
    for (const Property& property : element.properties) {
      bytesEach += body.bytesOf(property.countType ? *property.countType : property.type);
    }
    body.mustFit(static_cast<Real>(element.count), bytesEach, "elements '" + element.name + "'");
    for (std::int64_t i = 0; i < element.count; ++i) {
      const std::string which = element.name + " " + std::to_string(i);
      if (element.name == "face") {
        readFace(body, element, vertexCount, mesh, which);
      } else if (element.name == "vertex") {
        readVertex(body, element, mesh, which);
      } else {
        TriangleMesh skipped;
        readVertex(body, element, skipped, which);
      }
    }
  }
  return mesh;
}

}  // namespace carom::io::detail
