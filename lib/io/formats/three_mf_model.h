/// One model part (XML file) of a 3MF archive: its objects and their colors.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "io/streams/source.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Red, green, blue and alpha, each in [0, 255].
using ByteColor = std::array<std::uint8_t, 4>;

struct ThreeMfComponent {
  std::string object;  ///< identifier of the object that is used
  /// Path of the model part that contains the object; empty if it is the same part.
  std::string part;
  /// Transformation from the object's coordinates to those of its parent.
  Eigen::Affine3d to_parent;
};

struct ThreeMfObject {
  std::vector<Vec3> positions;
  std::vector<Face> faces;
  /// For each face, the colors of its corners.
  std::vector<std::array<std::optional<ByteColor>, 3>> colors;
  std::vector<ThreeMfComponent> components;
  /// True if the type of the object, such as support, excludes it from the model.
  bool is_other = false;
};

struct ThreeMfModel {
  std::string unit = "millimeter";
  std::string description;  ///< text of the metadata entry `Description`
  std::size_t other_metadata = 0;
  std::map<std::string, ThreeMfObject> objects;  ///< objects by their identifiers
  /// Items of the build section, which are the objects to be printed.
  std::vector<ThreeMfComponent> items;
  /// Number of groups of materials other than colors, such as textures, which are not read.
  std::size_t unread_properties = 0;
  std::size_t beam_lattices = 0;
};

/// Reads a model part. `source` has its XML text and the name of the archive. Throws InputError.
ThreeMfModel read_three_mf_model(const Source& source, const std::string& part);

}  // namespace transformesh
