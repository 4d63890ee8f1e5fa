#include <Eigen/Geometry>
#include <algorithm>

#include "io/document/losses.h"
#include "io/document/scalar.h"
#include "io/document/scalar_bytes.h"
#include "io/document/unit.h"
#include "io/formats/stl.h"
#include "io/streams/source.h"
#include "io/streams/text_buffer.h"
#include "mesh/coordinate_spacing.h"
#include "mesh/local_measures.h"
#include "support/counted.h"
#include "transformesh/measure.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

struct Facet {
  Eigen::Vector3f normal;
  std::array<Eigen::Vector3f, 3> corners;
};

/// Returns a face as STL facet. Its normal is computed from the rounded corners. The normal is zero
/// if the triangle of the rounded corners has no area.
Facet facet_of(const Mesh& mesh, const Face& face) {
  Facet facet;
  for (std::size_t i = 0; i < 3; ++i) facet.corners[i] = mesh.positions[face[i]].cast<float>();
  const Vec3 first = facet.corners[0].cast<double>();
  const Vec3 cross =
      (facet.corners[1].cast<double>() - first).cross(facet.corners[2].cast<double>() - first);
  facet.normal = cross.stableNormalized().cast<float>();
  return facet;
}

bool is_blank_or_control(char c) { return c == ' ' || (c >= '\0' && c < ' '); }

/// Returns the comment as a name for the header: without surrounding blanks, and without a leading
/// `solid`. Many readers assume that a file that starts with `solid` is text.
std::string as_name(std::string comment) {
  constexpr std::string_view word = "solid";
  std::replace_if(comment.begin(), comment.end(), is_blank_or_control, ' ');
  std::string_view name = comment;
  while (!name.empty() && (name.front() == ' ' || name.starts_with(word)))
    name.remove_prefix(name.front() == ' ' ? 1 : word.size());
  while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
  return std::string(name);
}

/// Returns the first comment that is neither a comment of this suite nor looks like one.
std::string header_name_of(const Document& document) {
  for (const std::string& comment : document.style.comments) {
    std::string name = as_name(comment);
    if (!is_own_comment(comment) && !is_own_comment(name)) return name;
  }
  return {};
}

void add_point(std::string_view keyword, const Eigen::Vector3f& point, TextBuffer& text) {
  text.add(keyword);
  for (const Eigen::Index axis : {0, 1, 2}) {
    text.add(' ');
    text.add_number(point[axis]);
  }
  text.add('\n');
}

std::string text_of(const Document& document) {
  const std::string name = header_name_of(document);
  const std::string ending = (name.empty() ? "" : " ") + name + '\n';
  TextBuffer text;
  text.add("solid" + ending);
  for (const Face& face : document.mesh.faces) {
    const Facet facet = facet_of(document.mesh, face);
    add_point("facet normal", facet.normal, text);
    text.add("outer loop\n");
    for (const Eigen::Vector3f& corner : facet.corners) add_point("vertex", corner, text);
    text.add("endloop\nendfacet\n");
  }
  text.add("endsolid" + ending);
  return text.take();
}

char* store_point(const Eigen::Vector3f& point, char* to) {
  constexpr bool swapped = !host_is_little;
  for (const Eigen::Index axis : {0, 1, 2}) {
    store_scalar(to, point[axis], swapped);
    to += sizeof(float);
  }
  return to;
}

std::string bytes_of(const Document& document, const Column* attribute) {
  constexpr bool swapped = !host_is_little;
  constexpr std::size_t header_size = 80;  // size of the header: 80 bytes of text
  const std::vector<Face>& faces = document.mesh.faces;
  std::string bytes(header_size + sizeof(std::uint32_t) + stl_facet_size * faces.size(), '\0');
  header_name_of(document).copy(bytes.data(), header_size);
  char* to = bytes.data() + header_size;
  store_scalar(to, static_cast<std::uint32_t>(faces.size()), swapped);
  to += sizeof(std::uint32_t);
  for (std::size_t row = 0; row < faces.size(); ++row) {
    const Facet facet = facet_of(document.mesh, faces[row]);
    to = store_point(facet.normal, to);
    for (const Eigen::Vector3f& corner : facet.corners) to = store_point(corner, to);
    const double value = attribute ? attribute->values[row] : 0;
    store_scalar(to, to_scalar<std::uint16_t>(value), swapped);
    to += sizeof(std::uint16_t);
  }
  return bytes;
}

void add_geometry_losses(const Mesh& mesh, std::vector<std::string>& notes) {
  const std::size_t isolated = mesh.positions.size() - used_positions(mesh).size();
  if (isolated > 0) {
    notes.push_back("stl: " + counted(isolated, "point") +
                    " without a face cannot be stored in STL, dropped");
  }
  const bool is_rounded =
      std::any_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3& position) {
        return std::any_of(position.begin(), position.end(),
                           [](double x) { return round_to_single(x) != x; });
      });
  if (is_rounded) notes.emplace_back("stl: coordinates are rounded to float");
}

}  // namespace

WriteResult write_stl(const Document& document) {
  const bool is_text = document.style.format == Format::stl_ascii;
  const bool has_attribute = !is_text && has_columns(document.mesh.face_columns, {"attribute"});
  Keeps keeps{"STL", {}, {}};
  if (has_attribute) keeps.face_columns = {"attribute"};
  keeps.comments = 1;
  WriteResult result;
  result.notes = losses(document, keeps);
  add_geometry_losses(document.mesh, result.notes);
  note_lost_unit(document, "stl", "millimeter", result.notes);
  result.bytes =
      is_text ? text_of(document)
              : bytes_of(document,
                         has_attribute ? document.mesh.face_columns.find("attribute") : nullptr);
  return result;
}

}  // namespace transformesh
