#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <tuple>

#include "io/document/losses.h"
#include "io/document/scalar.h"
#include "io/document/scalar_bytes.h"
#include "io/formats/column_groups.h"
#include "io/formats/glb.h"
#include "io/streams/source.h"
#include "mesh/adjacency.h"
#include "mesh/color_scale.h"
#include "mesh/coordinate_spacing.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

namespace transformesh {
namespace {

using OrderedJson = nlohmann::ordered_json;

// Primitive modes and other constants of the glTF standard.
constexpr int points_mode = 0;
constexpr int triangles_mode = 4;
constexpr int array_buffer = 34962;
constexpr int element_array_buffer = 34963;
constexpr std::uint32_t json_chunk_type = 0x4e4f534a;
constexpr std::uint32_t binary_chunk_type = 0x004e4942;

constexpr int component_type(std::uint8_t /*of*/) { return 5121; }
constexpr int component_type(std::uint16_t /*of*/) { return 5123; }
constexpr int component_type(std::uint32_t /*of*/) { return 5125; }
constexpr int component_type(float /*of*/) { return 5126; }

void append_u32(std::uint32_t value, std::string& bytes) {
  std::array<char, sizeof(value)> stored{};
  store_scalar(stored.data(), value, !host_is_little);
  bytes.append(stored.data(), stored.size());
}

void append_chunk(std::uint32_t kind, const std::string& content, char padding,
                  std::string& bytes) {
  constexpr std::size_t alignment = 4;  // bytes, by the standard
  const std::size_t missing = (alignment - content.size() % alignment) % alignment;
  append_u32(static_cast<std::uint32_t>(content.size() + missing), bytes);
  append_u32(kind, bytes);
  bytes.append(content).append(missing, padding);
}

std::string upper_case(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

/// Repeats vertices so that each vertex has a single texture coordinate, in the columns s and t.
Mesh split_at_seams(const Mesh& mesh, const Column& lists) {
  Mesh split = mesh;
  std::vector<Index> rows(mesh.positions.size());
  std::iota(rows.begin(), rows.end(), Index{0});
  std::vector<std::array<double, 2>> places(rows.size());
  std::vector<char> has_place(rows.size(), 0);
  std::map<std::tuple<Index, double, double>, Index> copies;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t i = 0; i < 3 && lists.list_offsets[f] < lists.list_offsets[f + 1]; ++i) {
      const Index vertex = mesh.faces[f][i];
      const double* const values = &lists.values[lists.list_offsets[f] + 2 * i];
      const std::array place{values[0], values[1]};
      if (!has_place[vertex]) places[vertex] = place, has_place[vertex] = 1;
      if (places[vertex] == place) continue;
      const auto [copy, is_new] =
          copies.emplace(std::tuple(vertex, place[0], place[1]), static_cast<Index>(rows.size()));
      if (is_new) rows.push_back(vertex), places.push_back(place);
      split.faces[f][i] = copy->second;
    }
  }
  split.vertex_columns = mesh.vertex_columns.select(rows);
  for (std::size_t v = mesh.positions.size(); v < rows.size(); ++v)
    split.positions.push_back(mesh.positions[rows[v]]);
  for (const std::size_t i : {0, 1}) {
    Column& column = split.vertex_columns.get(i == 0 ? "s" : "t", Scalar::float32, rows.size());
    for (std::size_t v = 0; v < rows.size(); ++v) column.values[v] = places[v][i];
  }
  return split;
}

class GlbWriter {
 public:
  explicit GlbWriter(const Document& document)
      : document_(document),
        mesh_(document.mesh),
        is_manifold_(!mesh_.faces.empty() &&
                     closed_opposites(mesh_, opposite_halfedges(mesh_)).has_value()) {
    const Column* const lists = corner_texture(mesh_.face_columns);
    if (lists == nullptr || mesh_.faces.empty()) return;
    mesh_ = split_at_seams(document.mesh, *lists);
    is_split_ = true;
  }

  WriteResult write() {
    OrderedJson json = {{"asset", asset()}};
    if (!mesh_.positions.empty()) add_scene(json);
    WriteResult result{file_of(json), losses(document_, {"GLB", kept_, kept_of_faces_})};
    result.notes.insert(result.notes.end(), notes_.begin(), notes_.end());
    return result;
  }

 private:
  OrderedJson asset() const {
    OrderedJson asset = {{"version", "2.0"}, {"generator", "tm"}};
    const std::vector<std::string>& comments = document_.style.comments;
    if (!comments.empty()) asset["extras"] = {{"comments", comments}};
    return asset;
  }

  void add_scene(OrderedJson& json) {
    OrderedJson primitive = {{"attributes", attributes()}};
    if (!mesh_.faces.empty()) primitive["indices"] = add_indices();
    primitive["mode"] = mesh_.faces.empty() ? points_mode : triangles_mode;
    primitive["material"] = 0;
    json["scene"] = 0;
    json["scenes"] = {{{"nodes", {0}}}};
    json["nodes"] = {{{"mesh", 0}}};
    json["meshes"] = {{{"primitives", {primitive}}}};
    if (is_manifold_) add_manifold(primitive, json);
    // Set these properties: the default material of glTF is metallic and invisible from behind.
    json["materials"] = {
        {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"doubleSided", true}}};
    if (!document_.texture.empty()) add_picture(json);
    json["accessors"] = accessors_;
    json["bufferViews"] = views_;
    json["buffers"] = {{{"byteLength", binary_.size()}}};
  }

  void add_picture(OrderedJson& json) {
    const std::size_t start = binary_.size();
    binary_ += document_.texture;
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", start}, {"byteLength", document_.texture.size()}});
    binary_.resize((binary_.size() + 3) / 4 * 4);
    json["images"] = {{{"bufferView", views_.size() - 1}, {"mimeType", "image/png"}}};
    json["textures"] = {{{"source", 0}}};
    OrderedJson& material = json["materials"][0];
    material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    material["extensions"] = {{"KHR_materials_unlit", OrderedJson::object()}};
    json["extensionsUsed"].push_back("KHR_materials_unlit");
  }

  /// Adds the primitive of EXT_mesh_manifold. Its accessor has the indices of the drawn primitive,
  /// and a sparse part that replaces vertices repeated for their texture coordinates.
  void add_manifold(const OrderedJson& primitive, OrderedJson& json) {
    const std::size_t indices = primitive["indices"];
    OrderedJson manifold = {{"attributes", {{"POSITION", primitive["attributes"]["POSITION"]}}},
                            {"indices", indices},
                            {"mode", triangles_mode}};
    OrderedJson extension;
    std::vector<std::uint32_t> places, values;
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index vertex = document_.mesh.faces[f][i];
        if (mesh_.faces[f][i] == vertex) continue;
        places.push_back(static_cast<std::uint32_t>(3 * f + i));
        values.push_back(vertex);
      }
    if (!places.empty()) {
      const std::size_t at = add(places, 1, 0), with = add(values, 1, 0);
      OrderedJson merged = accessors_[indices];
      const auto view = [&](std::size_t accessor) { return accessors_[accessor]["bufferView"]; };
      merged["sparse"] = {
          {"count", places.size()},
          {"indices", {{"bufferView", view(at)}, {"componentType", component_type(Index{})}}},
          {"values", {{"bufferView", view(with)}}}};
      manifold["indices"] = accessors_.size();
      accessors_.push_back(merged);
      extension["mergeIndices"] = at;
      extension["mergeValues"] = with;
    }
    extension["manifoldPrimitive"] = manifold;
    json["meshes"][0]["extensions"]["EXT_mesh_manifold"] = extension;
    json["extensionsUsed"].push_back("EXT_mesh_manifold");
  }

  OrderedJson attributes() {
    OrderedJson attributes = {{"POSITION", add_positions()}};
    const Columns& columns = mesh_.vertex_columns;
    add_normals(normal_group(columns), attributes);
    add_colors(color_group(columns), attributes);
    add_texture(texture_group(columns), attributes);
    for (const Column& column : columns.columns) add_scalar(column, attributes);
    // split_at_seams() replaced the columns s and t of the document.
    if (is_split_)
      for (const char* name : {"s", "t"}) std::erase(kept_, name);
    return attributes;
  }

  std::size_t add_positions() {
    std::vector<float> values;
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Vector3f high = -low;
    for (const Vec3& position : mesh_.positions) {
      const Eigen::Vector3f point = position.cast<float>();
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
      values.insert(values.end(), point.begin(), point.end());
      is_rounded_ = is_rounded_ || point.cast<double>() != position;
    }
    if (is_rounded_) notes_.emplace_back("glb: coordinates are rounded to float");
    const std::size_t accessor = add(values, 3, array_buffer);
    accessors_[accessor]["min"] = low;
    accessors_[accessor]["max"] = high;
    return accessor;
  }

  std::size_t add_indices() {
    std::vector<std::uint32_t> values;
    for (const Face& face : mesh_.faces) values.insert(values.end(), face.begin(), face.end());
    return add(values, 1, element_array_buffer);
  }

  void add_normals(const ColumnGroup& group, OrderedJson& attributes) {
    if (group.empty()) return;
    std::vector<float> values;
    for (std::size_t row = 0; row < mesh_.positions.size(); ++row) {
      const Vec3 normal(group[0]->values[row], group[1]->values[row], group[2]->values[row]);
      const Vec3 unit = normal.stableNormalized();
      if (unit.isZero()) return;  // the standard does not allow zero normals
      for (const double x : unit) values.push_back(static_cast<float>(x));
    }
    keep(group);
    attributes["NORMAL"] = add(values, 3, array_buffer);
  }

  void add_colors(const ColumnGroup& group, OrderedJson& attributes) {
    if (group.empty() || !are_in_range(group)) return;
    const Scalar type = group[0]->type;
    attributes["COLOR_0"] = is_floating(type)        ? add_color_rows<float>(group)
                            : type == Scalar::uint16 ? add_color_rows<std::uint16_t>(group)
                                                     : add_color_rows<std::uint8_t>(group);
    if (!is_floating(type)) accessors_.back()["normalized"] = true;
  }

  template <class T>
  std::size_t add_color_rows(const ColumnGroup& group) {
    const auto opaque = static_cast<T>(full_intensity(group[0]->type));
    // Four channels, because elements of three bytes would not be aligned to 4 bytes.
    constexpr std::size_t channels = 4;
    std::vector<T> values;
    for (std::size_t row = 0; row < mesh_.positions.size(); ++row)
      for (std::size_t i = 0; i < channels; ++i)
        values.push_back(i < group.size() ? static_cast<T>(group[i]->values[row]) : opaque);
    keep(group);
    return add(values, channels, array_buffer);
  }

  void add_texture(const ColumnGroup& group, OrderedJson& attributes) {
    if (group.empty() || !is_stored_in_floats(*group[0]) || !is_stored_in_floats(*group[1])) return;
    std::vector<float> values;
    for (std::size_t row = 0; row < mesh_.positions.size(); ++row) {
      values.push_back(static_cast<float>(group[0]->values[row]));
      values.push_back(static_cast<float>(1 - group[1]->values[row]));
    }
    keep(group);
    if (is_split_) kept_of_faces_.push_back("texcoord");
    attributes["TEXCOORD_0"] = add(values, 2, array_buffer);
  }

  void add_scalar(const Column& column, OrderedJson& attributes) {
    const bool is_kept = std::find(kept_.begin(), kept_.end(), column.name) != kept_.end();
    const std::string name = '_' + upper_case(column.name);
    if (is_kept || attributes.contains(name) || !is_stored_in_floats(column)) return;
    const std::vector<double>& values = column.values;
    if (std::any_of(values.begin(), values.end(),
                    [](double value) { return round_to_single(value) != value; }))
      notes_.push_back("glb: vertex property " + in_quotes(column.name) + " is rounded to float");
    keep({&column});
    attributes[name] = add(std::vector<float>(values.begin(), values.end()), 1, array_buffer);
  }

  static bool is_stored_in_floats(const Column& column) {
    return !column.list_count_type &&
           std::all_of(column.values.begin(), column.values.end(),
                       [](double value) { return std::isfinite(round_to_single(value)); });
  }

  void keep(const ColumnGroup& group) {
    for (const Column* column : group) kept_.push_back(column->name);
  }

  /// Stores values, `width` for each element, and returns the index of their accessor. `target` is
  /// 0 for values that are neither vertices nor indices.
  template <class T>
  std::size_t add(const std::vector<T>& values, std::size_t width, int target) {
    const std::size_t start = binary_.size();
    binary_.resize(start + sizeof(T) * values.size());
    char* to = binary_.data() + start;
    for (const T value : values) {
      store_scalar(to, value, !host_is_little);
      to += sizeof(T);
    }
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", start}, {"byteLength", binary_.size() - start}});
    if (target != 0) views_.back()["target"] = target;
    constexpr std::array<const char*, 5> types{"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", component_type(T{})},
                          {"count", values.size() / width},
                          {"type", types.at(width)}});
    return accessors_.size() - 1;
  }

  std::string file_of(const OrderedJson& json) const {
    constexpr std::size_t header_size = 12;  // bytes, by the standard
    std::string chunks;
    const std::string text = json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
    if (text.size() + binary_.size() > std::numeric_limits<std::uint32_t>::max() - 64)
      throw GoalError("a GLB file holds 4 GB at most, and this mesh takes more: write PLY or VTP");
    append_chunk(json_chunk_type, text, ' ', chunks);
    if (!binary_.empty()) append_chunk(binary_chunk_type, binary_, '\0', chunks);
    std::string bytes = "glTF";
    append_u32(2, bytes);
    append_u32(static_cast<std::uint32_t>(header_size + chunks.size()), bytes);
    return bytes + chunks;
  }

  const Document& document_;
  Mesh mesh_;
  bool is_manifold_;
  std::string binary_;
  OrderedJson views_ = OrderedJson::array();
  OrderedJson accessors_ = OrderedJson::array();
  std::vector<std::string_view> kept_;
  std::vector<std::string_view> kept_of_faces_;
  std::vector<std::string> notes_;
  bool is_rounded_ = false;
  bool is_split_ = false;  ///< vertices are repeated for texture coordinates of corners
};

}  // namespace

WriteResult write_glb(const Document& document) { return GlbWriter(document).write(); }

}  // namespace transformesh
