#include "corpus/chains/triangle_mesh.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace chains {
namespace {

static_assert(std::endian::native == std::endian::little);

enum class Encoding { text, little, big };

/// Reads consecutive numbers from the body of a file.
class Numbers {
 public:
  Numbers(const std::string& bytes, std::size_t begin, Encoding encoding)
      : at_(bytes.data() + begin), end_(bytes.data() + bytes.size()), encoding_(encoding) {}

  double next(const std::string& type) {
    if (encoding_ == Encoding::text)
      return type.starts_with("float") && type != "float64" ? rounded_to_float(next_text())
                                                            : next_text();
    if (type == "double" || type == "float64") return take<double>();
    if (type == "float" || type == "float32") return take<float>();
    if (type == "int" || type == "int32") return take<std::int32_t>();
    if (type == "uint" || type == "uint32") return take<std::uint32_t>();
    if (type == "short" || type == "int16") return take<std::int16_t>();
    if (type == "ushort" || type == "uint16") return take<std::uint16_t>();
    if (type == "char" || type == "int8") return take<std::int8_t>();
    if (type == "uchar" || type == "uint8") return take<std::uint8_t>();
    throw std::runtime_error("unknown type " + type);
  }

 private:
  double next_text() {
    while (at_ != end_ && std::strchr(" \t\r\n", *at_) != nullptr) ++at_;
    double value = 0;
    const auto [rest, error] = std::from_chars(at_, end_, value);
    if (error != std::errc()) throw std::runtime_error("a number is missing");
    at_ = rest;
    return value;
  }
  template <typename T>
  double take() {
    if (static_cast<std::size_t>(end_ - at_) < sizeof(T)) throw std::runtime_error("ends early");
    std::array<char, sizeof(T)> raw;
    std::copy(at_, at_ + sizeof(T), raw.begin());
    if (encoding_ == Encoding::big) std::reverse(raw.begin(), raw.end());
    at_ += sizeof(T);
    return static_cast<double>(std::bit_cast<T>(raw));
  }

  const char* at_;
  const char* end_;
  Encoding encoding_;
};

struct Property {
  // type of the count of a list; empty if the property is not a list
  std::string name, type, count_type;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::little;
  std::vector<Element> elements;
  std::size_t size = 0;  ///< length of the header in bytes
};

Header read_header(const std::string& bytes) {
  const std::size_t end = bytes.find("end_header\n");
  if (end == std::string::npos) throw std::runtime_error("no end_header");
  Header header;
  header.size = end + std::strlen("end_header\n");
  std::istringstream lines(bytes.substr(0, end));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, first, second;
    words >> word >> first;
    if (word == "format")
      header.encoding = first == "ascii"                  ? Encoding::text
                        : first == "binary_little_endian" ? Encoding::little
                                                          : Encoding::big;
    if (word == "element") {
      header.elements.push_back({first, 0, {}});
      words >> header.elements.back().count;
    }
    if (word != "property") continue;
    Property property;
    property.type = first;
    if (first == "list") words >> property.count_type >> property.type;
    words >> property.name;
    header.elements.back().properties.push_back(property);
  }
  return header;
}

std::uint32_t index_of(double value) {
  if (!(value >= 0 && value < 4294967295.0)) throw std::runtime_error("a bad vertex index");
  return static_cast<std::uint32_t>(value);
}

void read_vertex(const Element& element, Numbers& numbers, TriangleMesh& mesh) {
  Point p{};
  for (const Property& property : element.properties) {
    const double value = numbers.next(property.type);
    for (std::size_t k = 0; k < 3; ++k)
      if (property.name == std::string(1, "xyz"[k])) {
        p[k] = value;
        mesh.type = property.type.starts_with("float") && property.type != "float64"
                        ? Type::float32
                        : Type::float64;
      }
  }
  mesh.points.push_back(p);
}

void read_face(const Element& element, Numbers& numbers, TriangleMesh& mesh) {
  for (const Property& property : element.properties) {
    if (property.count_type.empty()) {
      numbers.next(property.type);
      continue;
    }
    std::vector<double> values(static_cast<std::size_t>(numbers.next(property.count_type)));
    for (double& value : values) value = numbers.next(property.type);
    if (!property.name.starts_with("vertex_ind")) continue;
    if (values.size() != 3) throw std::runtime_error("a face is no triangle");
    mesh.faces.push_back({index_of(values[0]), index_of(values[1]), index_of(values[2])});
  }
}

TriangleMesh read_ply(const std::string& bytes) {
  const Header header = read_header(bytes);
  Numbers numbers(bytes, header.size, header.encoding);
  TriangleMesh mesh;
  for (const Element& element : header.elements)
    for (std::size_t i = 0; i < element.count; ++i)
      if (element.name == "vertex")
        read_vertex(element, numbers, mesh);
      else
        read_face(element, numbers, mesh);
  return mesh;
}

TriangleMesh read_off(const std::string& bytes) {
  std::string text;  // lines without comments
  std::istringstream lines(bytes);
  for (std::string line; std::getline(lines, line);) text += line.substr(0, line.find('#')) + '\n';
  Numbers numbers(text, std::strlen("OFF"), Encoding::text);
  const auto next = [&] { return numbers.next({}); };
  TriangleMesh mesh;
  mesh.points.resize(static_cast<std::size_t>(next()));
  mesh.faces.resize(static_cast<std::size_t>(next()));
  next();
  for (Point& p : mesh.points)
    for (double& x : p) x = next();
  for (Triangle& face : mesh.faces) {
    if (next() != 3) throw std::runtime_error("a face is no triangle");
    for (std::uint32_t& v : face) v = index_of(next());
  }
  return mesh;
}

TriangleMesh read_stl(const std::string& bytes) {
  if (bytes.size() < 84) throw std::runtime_error("neither PLY nor OFF nor binary STL");
  Numbers numbers(bytes, 80, Encoding::little);
  TriangleMesh mesh;
  mesh.type = Type::float32;
  const auto count = static_cast<std::uint32_t>(numbers.next("uint"));
  if (bytes.size() != 84 + 50 * std::size_t{count}) throw std::runtime_error("no binary STL");
  for (std::uint32_t f = 0; f < count; ++f) {
    for (int i = 0; i < 3; ++i) numbers.next("float");
    for (int i = 0; i < 3; ++i) {
      const double x = numbers.next("float"), y = numbers.next("float");
      mesh.points.push_back({x, y, numbers.next("float")});
    }
    numbers.next("ushort");
    mesh.faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  return mesh;
}

template <typename T>
void put(std::string& bytes, T value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(raw.data(), raw.size());
}

}  // namespace

TriangleMesh read_mesh(const std::string& bytes) {
  if (bytes.starts_with("ply")) return read_ply(bytes);
  if (bytes.starts_with("OFF")) return read_off(bytes);
  return read_stl(bytes);
}

std::string write_ply(const TriangleMesh& mesh) {
  const bool is_float = mesh.type == Type::float32;
  const std::string type = is_float ? "float" : "double";
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(mesh.points.size()) + '\n';
  for (const char axis : {'x', 'y', 'z'}) bytes += "property " + type + ' ' + axis + '\n';
  bytes += "element face " + std::to_string(mesh.faces.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& p : mesh.points)
    for (const double x : p)
      if (is_float)
        put(bytes, static_cast<float>(x));
      else
        put(bytes, x);
  for (const Triangle& face : mesh.faces) {
    put(bytes, std::uint8_t{3});
    for (const std::uint32_t v : face) put(bytes, static_cast<std::int32_t>(v));
  }
  return bytes;
}

void append(TriangleMesh& mesh, const TriangleMesh& other, bool is_flipped) {
  const auto shift = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (Triangle face : other.faces) {
    for (std::uint32_t& v : face) v += shift;
    if (is_flipped) std::swap(face[1], face[2]);
    mesh.faces.push_back(face);
  }
}

double diagonal(const TriangleMesh& mesh) {
  if (mesh.points.empty()) return 0;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] =
        std::minmax_element(mesh.points.begin(), mesh.points.end(),
                            [k](const Point& p, const Point& q) { return p[k] < q[k]; });
    sum += ((*high)[k] - (*low)[k]) * ((*high)[k] - (*low)[k]);
  }
  return std::sqrt(sum);
}

double largest_coordinate(const TriangleMesh& mesh) {
  double largest = 0;
  for (const Point& p : mesh.points)
    for (const double x : p) largest = std::max(largest, std::abs(x));
  return largest;
}

}  // namespace chains
