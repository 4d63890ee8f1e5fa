#include <Eigen/LU>
#include <algorithm>
#include <set>

#include "io/document/unit.h"
#include "io/formats/column_groups.h"
#include "io/formats/three_mf.h"
#include "io/formats/three_mf_model.h"
#include "io/formats/xml_elements.h"
#include "io/streams/zip_archive.h"
#include "mesh/index_limits.h"
#include "support/counted.h"

namespace transformesh {
namespace {

using CornerColors = std::array<std::optional<ByteColor>, 3>;

constexpr ByteColor opaque_white{255, 255, 255, 255};

std::string without_slash(std::string_view path) {
  return std::string(path.substr(std::min(path.find_first_not_of('/'), path.size())));
}

class ThreeMfReader {
 public:
  explicit ThreeMfReader(const Source& source)
      : source_(source), budget_(source), archive_(source, budget_) {}

  ReadResult read() {
    root_ = root_part();
    const ThreeMfModel& model = this->model(root_);
    Style& style = result_.document.style;
    style.format = Format::three_mf;
    style.coordinate = Scalar::float64;
    add_description(model.description);
    set_unit();
    for (const ThreeMfComponent& item : model.items) add(item, root_, Eigen::Affine3d::Identity());
    if (model.items.empty() && !model.objects.empty())
      note("the build has no items: the mesh is empty");
    add_colors();
    note_losses();
    return std::move(result_);
  }

 private:
  void note(const std::string& text) { result_.notes.push_back("3mf: " + text); }

  // --- Parts of the archive ----------------------------------------------------------------------

  /// Returns the path of the root model part: the target of the relationship `3dmodel`, or the
  /// usual name if the archive has no list of relationships.
  std::string root_part() const {
    const std::optional<std::string> list = archive_.read("_rels/.rels");
    if (!list) return "3D/3dmodel.model";
    const pugi::xml_document document = parse_xml({*list, source_.name});
    for (const pugi::xml_node& node : xml_elements(document, "Relationship"))
      if (std::string_view(node.attribute("Type").value()).ends_with("/3dmodel"))
        return without_slash(node.attribute("Target").value());
    source_.fail("the ZIP archive is not a 3MF file: '_rels/.rels' does not name a 3dmodel");
  }

  const ThreeMfModel& model(const std::string& part) {
    const auto found = models_.find(part);
    if (found != models_.end()) return found->second;
    const std::optional<std::string> xml = archive_.read(part);
    if (!xml) source_.fail("the 3MF file has no part " + in_quotes(part));
    const Source source{*xml, source_.name + ": " + part, source_.is_strict};
    ThreeMfModel read = read_three_mf_model(source, part);
    unread_properties_ += read.unread_properties;
    beam_lattices_ += read.beam_lattices;
    return models_.emplace(part, std::move(read)).first->second;
  }

  void add_description(const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      std::string line = text.substr(at, end - at);
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (!line.empty()) result_.document.style.comments.push_back(std::move(line));
      at = end + 1;
    }
  }

  void set_unit() {
    const std::string& name = model(root_).unit;
    const Unit* unit = find_unit(name);
    if (unit == nullptr) source_.fail("the 3MF file has the unknown unit " + in_quotes(name));
    transformesh::set_unit(result_.document, *unit);
  }

  // --- Objects -----------------------------------------------------------------------------------

  void add(const ThreeMfComponent& component, const std::string& from,
           const Eigen::Affine3d& to_build) {
    // Largest depth of nested components; each level needs 512 bytes of stack.
    constexpr std::size_t deepest = 256;
    // Number of bytes by which each component reduces the budget, so that repetitions of empty
    // components are limited, too.
    constexpr std::size_t cost_of_visit = 64;
    budget_.spend(cost_of_visit);
    const std::string part = component.part.empty() ? from : without_slash(component.part);
    const auto& objects = model(part).objects;
    const auto found = objects.find(component.object);
    if (found == objects.end())
      source_.fail("object " + in_quotes(component.object) + " is used, but missing in " +
                   in_quotes(part));
    const ThreeMfObject& object = found->second;
    if (!open_.insert(&object).second)
      source_.fail("object " + in_quotes(component.object) + " contains itself");
    if (open_.size() > deepest) source_.fail("components are nested more than 256 deep");
    const Eigen::Affine3d transform = to_build * component.to_parent;
    if (object.is_other) ++other_objects_;
    if (!object.is_other) add_mesh(object, transform);
    for (const ThreeMfComponent& inner : object.components) add(inner, part, transform);
    open_.erase(&object);
  }

  /// Adds the mesh of an object. If the transformation is a mirror image, faces are reversed, so
  /// that the outside stays outside.
  void add_mesh(const ThreeMfObject& object, const Eigen::Affine3d& transform) {
    Mesh& mesh = result_.document.mesh;
    budget_.spend(object.positions.size() * sizeof(Vec3) +
                  object.faces.size() * (sizeof(Face) + sizeof(CornerColors)));
    const std::size_t first = mesh.positions.size();
    if (first + object.positions.size() >= no_index) source_.fail(too_many_vertices);
    if (mesh.faces.size() + object.faces.size() >= no_index / 3) source_.fail(too_many_triangles);
    if (!object.faces.empty()) ++meshes_;
    const bool is_moved = !transform.matrix().isIdentity(0);
    for (const Vec3& position : object.positions)
      mesh.positions.push_back(is_moved ? Vec3(transform * position) : position);
    const bool is_mirrored = transform.linear().determinant() < 0;
    for (std::size_t f = 0; f < object.faces.size(); ++f) {
      Face face = object.faces[f];
      CornerColors colors = object.colors[f];
      for (Index& corner : face) corner += static_cast<Index>(first);
      if (is_mirrored) std::swap(face[1], face[2]), std::swap(colors[1], colors[2]);
      mesh.faces.push_back(face);
      colors_.push_back(colors);
    }
  }

  // --- Colors ------------------------------------------------------------------------------------

  void add_colors() {
    const auto has_color = [](const CornerColors& colors) {
      return std::any_of(colors.begin(), colors.end(),
                         [](const auto& color) { return color.has_value(); });
    };
    if (std::none_of(colors_.begin(), colors_.end(), has_color)) return;
    const bool are_uniform = std::all_of(colors_.begin(), colors_.end(), [](const CornerColors& c) {
      return c[0] == c[1] && c[1] == c[2];
    });
    Mesh& mesh = result_.document.mesh;
    std::vector<ByteColor> of_vertices;
    if (const bool are_of_vertices = !are_uniform || is_of_one_color(); are_of_vertices) {
      if (!find_vertex_colors(of_vertices))
        note("corners of a vertex have several colors, of which the first is kept");
      return set_columns(of_vertices, mesh.vertex_columns);
    }
    for (const CornerColors& colors : colors_)
      of_vertices.push_back(colors[0].value_or(opaque_white));
    set_columns(of_vertices, mesh.face_columns);
  }

  /// True if all faces have the same color. This color is then stored at vertices, because all
  /// formats can represent colors of vertices.
  bool is_of_one_color() const {
    return std::all_of(colors_.begin(), colors_.end(),
                       [&](const CornerColors& colors) { return colors[0] == colors_[0][0]; });
  }

  /// Finds a color for each vertex. Returns true if the corners at each vertex have the same color.
  bool find_vertex_colors(std::vector<ByteColor>& found) const {
    const Mesh& mesh = result_.document.mesh;
    found.assign(mesh.positions.size(), opaque_white);
    std::vector<char> is_known(found.size(), 0);
    bool agree = true;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index v = mesh.faces[f][i];
        const ByteColor color = colors_[f][i].value_or(opaque_white);
        agree = agree && (is_known[v] == 0 || found[v] == color);
        if (is_known[v] == 0) found[v] = color, is_known[v] = 1;
      }
    return agree;
  }

  static void set_columns(const std::vector<ByteColor>& colors, Columns& columns) {
    const bool is_opaque = std::all_of(colors.begin(), colors.end(),
                                       [](const ByteColor& color) { return color[3] == 255; });
    for (std::size_t c = 0; c < (is_opaque ? 3U : 4U); ++c) {
      Column& column = columns.get(color_channels[c], Scalar::uint8, colors.size());
      for (std::size_t row = 0; row < colors.size(); ++row) column.values[row] = colors[row][c];
    }
  }

  void note_losses() {
    if (meshes_ > 1) note(counted(meshes_, "object") + " read as one mesh");
    const auto left_out = [&](std::size_t count, const std::string& what) {
      if (count > 0) note(counted(count, what) + " left out");
    };
    left_out(other_objects_, "object for support or of another type");
    left_out(unread_properties_, "group of properties other than colors");
    left_out(beam_lattices_, "beam lattice");
    if (const std::size_t count = model(root_).other_metadata; count > 0)
      note(std::to_string(count) + " metadata left out");
  }

  const Source& source_;
  ExpansionBudget budget_;
  ZipReader archive_;
  std::string root_;
  std::map<std::string, ThreeMfModel> models_;
  /// The object that is being added, and the objects that contain it.
  std::set<const ThreeMfObject*> open_;
  std::vector<CornerColors> colors_;
  std::size_t meshes_ = 0, other_objects_ = 0, unread_properties_ = 0, beam_lattices_ = 0;
  ReadResult result_;
};

}  // namespace

ReadResult read_three_mf(const Source& source) { return ThreeMfReader(source).read(); }

}  // namespace transformesh
