#include "io/formats/three_mf_model.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/formats/xml_elements.h"
#include "io/streams/number_text.h"
#include "mesh/index_limits.h"
#include "support/counted.h"

namespace transformesh {
namespace {

using Node = pugi::xml_node;

/// Returns the name of an element or attribute without its namespace prefix.
std::string_view local_name(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

const char* attribute(const Node& node, std::string_view name) {
  for (const pugi::xml_attribute& found : node.attributes())
    if (local_name(found.name()) == name) return found.value();
  return "";
}

Node child(const Node& node, std::string_view name) {
  for (const Node& found : node.children())
    if (local_name(found.name()) == name) return found;
  return {};
}

/// True if a file that requires this extension can be read. Slices, beams and production
/// identifiers are ignored; the triangles still define the shape.
bool is_read(std::string_view name_space) {
  for (const std::string_view part :
       {"/core/2015/02", "/material/2015/02", "/production/2015/06", "/slice/2015/07",
        "/beamlattice/2017/02", "/trianglesets/2021/07"})
    if (name_space.find(part) != std::string_view::npos) return true;
  return false;
}

/// Parses a color of the form `#RRGGBB` or `#RRGGBBAA`.
std::optional<ByteColor> color_in(std::string_view text) {
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return std::nullopt;
  ByteColor color{0, 0, 0, 255};
  for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i) {
    const char* last = text.data() + 2 * i + 3;
    const auto [end, error] = std::from_chars(text.data() + 2 * i + 1, last, color[i], 16);
    if (error != std::errc() || end != last) return std::nullopt;
  }
  return color;
}

class ModelReader {
 public:
  ModelReader(const Source& source, const std::string& part) : source_(source), part_(part) {}

  ThreeMfModel read() {
    const pugi::xml_document document = parse_xml(source_);
    const Node root = document.document_element();
    if (local_name(root.name()) != "model") fail("has no element 'model'");
    check_extensions(root);
    if (const std::string_view unit = attribute(root, "unit"); !unit.empty()) model_.unit = unit;
    read_metadata(root);
    for (const Node& node : child(root, "resources").children()) read_resource(node);
    for (const Node& node : child(root, "build").children())
      if (local_name(node.name()) == "item") model_.items.push_back(component(node));
    return std::move(model_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    source_.fail(in_quotes(part_) + ' ' + what);
  }

  void check_extensions(const Node& root) const {
    std::string_view prefixes = attribute(root, "requiredextensions");
    while (!prefixes.empty()) {
      const std::size_t blank = std::min(prefixes.find_first_of(" \t\r\n"), prefixes.size());
      const std::string prefix(prefixes.substr(0, blank));
      prefixes.remove_prefix(std::min(blank + 1, prefixes.size()));
      const std::string_view name_space = root.attribute(("xmlns:" + prefix).c_str()).value();
      if (!prefix.empty() && !is_read(name_space))
        fail("requires the extension " + in_quotes(name_space) + ", which is not supported");
    }
  }

  void read_metadata(const Node& root) {
    for (const Node& node : root.children()) {
      if (local_name(node.name()) != "metadata") continue;
      const bool is_description = std::string_view(node.attribute("name").value()) == "Description";
      if (is_description) model_.description = node.text().get();
      if (!is_description) ++model_.other_metadata;
    }
  }

  // --- Resources ---------------------------------------------------------------------------------

  void read_resource(const Node& node) {
    const std::string_view kind = local_name(node.name());
    const std::string id = attribute(node, "id");
    if (kind == "basematerials") {
      read_colors(node, "displaycolor", colors_[id]);
    } else if (kind == "colorgroup") {
      read_colors(node, "color", colors_[id]);
    } else if (kind == "metadata") {
      ++model_.other_metadata;
    } else if (kind == "object") {
      const auto [place, is_new] = model_.objects.emplace(id, ThreeMfObject());
      if (!is_new) fail("has two objects " + in_quotes(id));
      read_object(node, id, place->second);
    } else {
      ++model_.unread_properties;
    }
  }

  void read_colors(const Node& node, const char* key, std::vector<ByteColor>& colors) const {
    for (const Node& entry : node.children()) {
      const auto color = color_in(attribute(entry, key));
      if (!color) fail("has the color " + in_quotes(attribute(entry, key)) + ", not #RRGGBB");
      colors.push_back(*color);
    }
  }

  void read_object(const Node& node, const std::string& id, ThreeMfObject& object) {
    object_ = "object " + in_quotes(id);
    const std::string_view type = attribute(node, "type");
    object.is_other = type == "support" || type == "solidsupport" || type == "other";
    const Node mesh = child(node, "mesh");
    read_vertices(child(mesh, "vertices"), object);
    read_triangles(child(mesh, "triangles"), node, object);
    if (child(mesh, "beamlattice")) ++model_.beam_lattices;
    for (const Node& entry : child(node, "components").children())
      object.components.push_back(component(entry));
  }

  double number(const Node& node, const char* key, const std::string& what) const {
    const std::string_view text = node.attribute(key).value();
    const char* first = text.data();
    double value = 0;
    const Parsed parsed = parse_number(first, text.data() + text.size(), value);
    if (parsed != Parsed::ok || first != text.data() + text.size() || !std::isfinite(value))
      fail(std::string("has ") + key + '=' + in_quotes(text) + " in " + what +
           ", which is not a finite number");
    return value;
  }

  void read_vertices(const Node& vertices, ThreeMfObject& object) const {
    for (const Node& node : vertices.children()) {
      if (object.positions.size() >= no_index - 1) source_.fail(too_many_vertices);
      const std::string what =
          "vertex " + std::to_string(object.positions.size()) + " of " + object_;
      object.positions.emplace_back(number(node, "x", what), number(node, "y", what),
                                    number(node, "z", what));
    }
  }

  void read_triangles(const Node& triangles, const Node& node, ThreeMfObject& object) {
    for (const Node& triangle : triangles.children()) {
      if (local_name(triangle.name()) != "triangle") continue;
      Face face{};
      constexpr std::array<const char*, 3> keys{"v1", "v2", "v3"};
      for (std::size_t i = 0; i < 3; ++i)
        face[i] = index(triangle.attribute(keys[i]), object.positions.size(), [&] {
          return std::string(keys[i]) + " of triangle " + std::to_string(object.faces.size()) +
                 " of " + object_;
        });
      object.faces.push_back(face);
      object.colors.push_back(colors_of(triangle, node));
    }
    if (object.faces.size() >= no_index / 3) source_.fail(too_many_triangles);
  }

  template <class What>
  Index index(const pugi::xml_attribute& given, std::size_t count, const What& what) const {
    const std::string_view text = given.value();
    const char* first = text.data();
    std::uint64_t value = 0;
    const Parsed parsed = parse_number(first, text.data() + text.size(), value);
    if (parsed != Parsed::ok || first != text.data() + text.size() || value >= count)
      fail("has " + in_quotes(text) + " as " + what() + ", but " + there_are(count, "element"));
    return static_cast<Index>(value);
  }

  /// Returns the colors of the corners of a triangle. If attributes of the triangle are missing,
  /// attributes of the object or of the first corner are used.
  std::array<std::optional<ByteColor>, 3> colors_of(const Node& triangle,
                                                    const Node& object) const {
    std::array<std::optional<ByteColor>, 3> result;
    const pugi::xml_attribute own = triangle.attribute("pid");
    const pugi::xml_attribute group = own ? own : object.attribute("pid");
    const auto colors = colors_.find(group.value());
    if (!group || colors == colors_.end()) return result;
    const pugi::xml_attribute first = triangle.attribute("p1");
    for (std::size_t i = 0; i < 3; ++i) {
      constexpr std::array<const char*, 3> keys{"p1", "p2", "p3"};
      pugi::xml_attribute given = triangle.attribute(keys[i]);
      if (!given) given = first ? first : object.attribute("pindex");
      if (!given) continue;
      result[i] = colors->second[index(given, colors->second.size(),
                                       [&] { return "a color of " + object_; })];
    }
    return result;
  }

  // --- Places ------------------------------------------------------------------------------------

  ThreeMfComponent component(const Node& node) const {
    return {attribute(node, "objectid"), attribute(node, "path"),
            transform(attribute(node, "transform"))};
  }

  /// Parses a transformation from twelve numbers. They are the rows of a matrix M that maps the row
  /// vector v to v M.
  Eigen::Affine3d transform(const std::string& text) const {
    Eigen::Affine3d result = Eigen::Affine3d::Identity();
    if (text.empty()) return result;
    const std::vector<double> m = xml_numbers(text, "a transform", source_);
    constexpr std::size_t size = 12;  // numbers of a 3MF transform
    if (m.size() != size) fail("has a transform of " + counted(m.size(), "number") + ", not 12");
    for (std::size_t i = 0; i < size; ++i)
      result(static_cast<Eigen::Index>(i % 3), static_cast<Eigen::Index>(i / 3)) = m[i];
    return result;
  }

  const Source& source_;
  const std::string& part_;
  std::string object_;  ///< name of the current object in messages
  std::map<std::string, std::vector<ByteColor>> colors_;
  ThreeMfModel model_;
};

}  // namespace

ThreeMfModel read_three_mf_model(const Source& source, const std::string& part) {
  return ModelReader(source, part).read();
}

}  // namespace transformesh
