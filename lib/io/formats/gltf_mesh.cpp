#include "io/formats/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "io/formats/column_groups.h"
#include "io/formats/gltf_accessor.h"
#include "mesh/index_limits.h"
#include "support/counted.h"
#include "support/lower_case.h"

namespace transformesh {
namespace {

// Primitive modes of the glTF standard: 0 for points, 1 to 3 for lines, 4 to 6 for triangles.
constexpr std::size_t as_points = 0;
constexpr std::size_t as_triangles = 4;
constexpr std::size_t as_strip = 5;
constexpr std::size_t as_fan = 6;

const GltfJson& member(const GltfJson& object, const char* key) {
  static const GltfJson nothing = GltfJson::object();
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_object() ? *found : nothing;
}

class MeshReader {
 public:
  MeshReader(const GltfFile& file, std::size_t mesh, ExpansionBudget& budget, GltfLosses& losses)
      : file_(file),
        entry_(file.element("meshes", mesh)),
        name_("mesh " + std::to_string(mesh)),
        budget_(budget),
        losses_(losses) {}

  Mesh read() {
    const auto primitives = entry_.find("primitives");
    if (primitives == entry_.end() || !primitives->is_array())
      file_.fail(name_ + " has no primitives");
    for (const GltfJson& primitive : *primitives) {
      if (!primitive.is_object()) file_.fail("a primitive of " + name_ + " is not an object");
      read_primitive(primitive);
    }
    add_face_colors();
    merge();
    return std::move(mesh_);
  }

 private:
  void read_primitive(const GltfJson& primitive) {
    const std::size_t mode = file_.whole(primitive, "mode", name_, as_triangles);
    if (mode > as_fan)
      file_.fail("a primitive of " + name_ + " has the unknown mode " + std::to_string(mode));
    if (mode != as_points && mode < as_triangles) {
      ++losses_.line_primitives;
      return;
    }
    const GltfJson& attributes = member(primitive, "attributes");
    // Add vertices only if they differ from those of the previous primitive, because primitives of
    // several materials often share vertices.
    if (attributes != attributes_ || mesh_.positions.empty()) add_vertices(attributes);
    if (mode == as_points) return;
    add_faces(primitive, mode);
    face_colors_.resize(mesh_.faces.size(), color_of(primitive));
  }

  // --- Vertices ----------------------------------------------------------------------------------

  void add_vertices(const GltfJson& attributes) {
    attributes_ = attributes;
    first_ = mesh_.positions.size();
    Mesh part;
    const GltfNumbers positions = numbers(attributes, "POSITION", no_index - 1 - first_);
    if (positions.width != 3)
      file_.fail("the positions of " + name_ + " are not vectors of three numbers");
    for (std::size_t i = 0; i < positions.size(); ++i)
      part.positions.emplace_back(positions.values[3 * i], positions.values[3 * i + 1],
                                  positions.values[3 * i + 2]);
    add_columns(attributes, part);
    add_missing_colors(mesh_.vertex_columns, first_, part.vertex_columns, part.positions.size());
    mesh_.vertex_columns.concatenate(part.vertex_columns, first_, part.positions.size());
    mesh_.positions.insert(mesh_.positions.end(), part.positions.begin(), part.positions.end());
  }

  GltfNumbers numbers(const GltfJson& attributes, const std::string& key, std::size_t most) {
    const std::size_t accessor = file_.whole(attributes, key, "a primitive of " + name_);
    constexpr std::size_t bytes = 8;  // size of a double; bytes
    const GltfJson& entry = file_.element("accessors", accessor);
    const std::size_t count = file_.whole(entry, "count", "accessor " + std::to_string(accessor));
    budget_.spend(bytes * std::min<std::size_t>(count, no_index) * 3);
    return gltf_numbers(file_, accessor, most);
  }

  void add_columns(const GltfJson& attributes, Mesh& part) {
    const std::size_t rows = part.positions.size();
    for (const auto& [key, value] : attributes.items()) {
      if (key == "POSITION") continue;
      const GltfNumbers found = numbers(attributes, key, rows);
      if (found.size() != rows)
        file_.fail("the attribute " + in_quotes(key) + " of " + name_ + " has " +
                   counted(found.size(), "element") + ", but " + there_are(rows, "vertex"));
      add_attribute(key, found, part.vertex_columns);
    }
  }

  void add_attribute(const std::string& key, const GltfNumbers& found, Columns& columns) {
    if (key == "NORMAL" && found.width == 3) {
      add_group({"nx", "ny", "nz"}, found, columns);
    } else if (key == "COLOR_0" && found.width >= 3) {
      add_colors(found, columns);
    } else if (key == "TEXCOORD_0" && found.width == 2) {
      add_group({"s", "t"}, found, columns);
      // Convert v, which runs downwards in glTF.
      for (double& value : columns.find("t")->values) value = 1 - value;
    } else if (key.starts_with('_') && key.size() > 1 && found.width == 1) {
      const std::string name = column_name(lower_case(key.substr(1)));
      add_group({name.c_str()}, found, columns);
    } else {
      ++losses_.unread_attributes;
    }
  }

  static void add_group(const std::vector<const char*>& names, const GltfNumbers& found,
                        Columns& columns) {
    for (std::size_t c = 0; c < names.size(); ++c) {
      Column& column = columns.get(names[c], Scalar::float32, found.size());
      for (std::size_t i = 0; i < found.size(); ++i)
        column.values[i] = found.values[i * found.width + c];
    }
  }

  /// Adds color columns. Colors that are stored as bytes remain bytes. If all vertices are opaque,
  /// no alpha column is added. The standard requires integer colors to be normalized; other integer
  /// colors are read as if they were.
  static void add_colors(const GltfNumbers& found, Columns& columns) {
    bool is_opaque = true;
    for (std::size_t i = 0; i < found.size() && found.width == 4; ++i)
      is_opaque = is_opaque && found.values[4 * i + 3] == found.one;
    const Scalar type = found.is_byte ? Scalar::uint8 : Scalar::float32;
    for (std::size_t c = 0; c < (is_opaque ? 3 : found.width); ++c) {
      Column& column = columns.get(color_channels[c], type, found.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        const double value = found.values[i * found.width + c] / found.one;
        column.values[i] = found.is_byte ? std::round(255 * value) : value;
      }
    }
  }

  // --- Faces -------------------------------------------------------------------------------------

  std::vector<Index> corners(const GltfJson& primitive) {
    const std::size_t count = mesh_.positions.size() - first_;
    std::vector<Index> result(count);
    std::iota(result.begin(), result.end(), static_cast<Index>(first_));
    if (!primitive.contains("indices")) return result;
    return indices(primitive, count);
  }

  std::vector<Index> indices(const GltfJson& primitive, std::size_t vertices) {
    const GltfNumbers found = numbers(primitive, "indices", 3 * std::size_t{no_index / 3});
    std::vector<Index> result;
    result.reserve(found.values.size());
    for (std::size_t i = 0; i < found.values.size(); ++i) {
      const double value = found.values[i];
      if (!(value >= 0 && value < static_cast<double>(vertices)) || value != std::floor(value))
        file_.fail("corner " + std::to_string(i) + " of " + name_ +
                   " has a vertex index out of range, as " + there_are(vertices, "vertex"));
      result.push_back(static_cast<Index>(first_ + static_cast<std::size_t>(value)));
    }
    return result;
  }

  void add_faces(const GltfJson& primitive, std::size_t mode) {
    const std::vector<Index> list = corners(primitive);
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      mesh_.faces.push_back({list[a], list[b], list[c]});
    };
    if (mode == as_triangles) {
      if (list.size() % 3 != 0)
        file_.fail("a primitive of triangles of " + name_ + " has " +
                   counted(list.size(), "corner"));
      for (std::size_t i = 2; i < list.size(); i += 3) add(i - 2, i - 1, i);
    }
    const bool is_strip = mode == as_strip;
    are_triangles_ = are_triangles_ && mode == as_triangles;
    for (std::size_t i = 2; i < list.size() && mode != as_triangles; ++i) {
      const std::size_t turned = is_strip ? i % 2 : 0;
      is_strip ? add(i - 2, i - 1 + turned, i - turned) : add(0, i - 1, i);
    }
    if (mesh_.faces.size() >= no_index / 3) file_.fail(too_many_triangles);
  }

  // --- Colors of materials -----------------------------------------------------------------------

  using Color = std::array<double, 4>;

  Color color_of(const GltfJson& primitive) const {
    Color color{1, 1, 1, 1};
    if (!primitive.contains("material")) return color;
    const GltfJson& material =
        file_.element("materials", file_.whole(primitive, "material", "a primitive of " + name_));
    const GltfJson& looks = member(material, "pbrMetallicRoughness");
    const auto factor = looks.find("baseColorFactor");
    if (factor == looks.end() || !factor->is_array() || factor->size() != color.size())
      return color;
    for (std::size_t i = 0; i < color.size(); ++i)
      if ((*factor)[i].is_number()) color[i] = (*factor)[i].get<double>();
    return color;
  }

  /// Adds the colors of materials to faces, unless all are white, which means no color.
  void add_face_colors() {
    const Color white{1, 1, 1, 1};
    const auto is_white = [&](const Color& color) { return color == white; };
    if (std::all_of(face_colors_.begin(), face_colors_.end(), is_white)) return;
    const bool is_opaque = std::all_of(face_colors_.begin(), face_colors_.end(),
                                       [](const Color& color) { return color[3] == 1; });
    for (std::size_t c = 0; c < (is_opaque ? 3U : 4U); ++c) {
      Column& column = mesh_.face_columns.get(color_channels[c], Scalar::uint8, mesh_.faces.size());
      for (std::size_t f = 0; f < face_colors_.size(); ++f)
        column.values[f] = std::round(255 * std::clamp(face_colors_[f][c], 0.0, 1.0));
    }
  }

  // --- EXT_mesh_manifold -------------------------------------------------------------------------

  /// Takes the corners of the EXT_mesh_manifold primitive: those of all primitives in order, but
  /// with repeated vertices replaced by one of them.
  void merge() {
    const GltfJson& extension = member(member(entry_, "extensions"), "EXT_mesh_manifold");
    const GltfJson& primitive = member(extension, "manifoldPrimitive");
    if (!primitive.contains("indices")) return;
    const GltfJson& attributes = member(primitive, "attributes");
    const bool shares_vertices = first_ == 0 && attributes_.contains("POSITION") &&
                                 attributes.contains("POSITION") &&
                                 attributes["POSITION"] == attributes_["POSITION"];
    std::vector<Index> merged;
    if (shares_vertices && are_triangles_) merged = indices(primitive, mesh_.positions.size());
    if (merged.size() != 3 * mesh_.faces.size() || merged.empty()) {
      ++losses_.unused_merges;
      return;
    }
    replace_corners(merged);
  }

  void replace_corners(const std::vector<Index>& merged) {
    std::vector<char> was_used(mesh_.positions.size(), 0), is_used(was_used);
    const std::vector<Face> before = mesh_.faces;
    for (std::size_t i = 0; i < merged.size(); ++i) {
      was_used[before[i / 3][i % 3]] = 1;
      is_used[merged[i]] = 1;
      mesh_.faces[i / 3][i % 3] = merged[i];
    }
    std::vector<Index> kept;
    for (Index v = 0; v < is_used.size(); ++v)
      if (is_used[v] != 0 || was_used[v] == 0) kept.push_back(v);
    if (kept.size() == is_used.size()) return;
    make_corner_texture(before, mesh_);
    keep_vertices(kept);
  }

  void keep_vertices(const std::vector<Index>& kept) {
    std::vector<Index> number(mesh_.positions.size(), no_index);
    for (Index v = 0; v < kept.size(); ++v) {
      number[kept[v]] = v;
      mesh_.positions[v] = mesh_.positions[kept[v]];
    }
    mesh_.positions.resize(kept.size());
    mesh_.vertex_columns = mesh_.vertex_columns.select(kept);
    for (Face& face : mesh_.faces)
      for (Index& corner : face) corner = number[corner];
  }

  const GltfFile& file_;
  const GltfJson& entry_;
  std::string name_;
  ExpansionBudget& budget_;
  GltfLosses& losses_;
  GltfJson attributes_;    ///< attributes of the primitive whose vertices were read last
  std::size_t first_ = 0;  ///< index in the mesh of the first of the vertices that were read last
  bool are_triangles_ = true;
  std::vector<Color> face_colors_;
  Mesh mesh_;
};

}  // namespace

Mesh gltf_mesh(const GltfFile& file, std::size_t mesh, ExpansionBudget& budget,
               GltfLosses& losses) {
  return MeshReader(file, mesh, budget, losses).read();
}

}  // namespace transformesh
