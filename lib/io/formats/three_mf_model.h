/// One model part of a 3MF archive: its objects and their colors.
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

/// Red, green, blue and alpha; [0, 255].
using ByteColor = std::array<std::uint8_t, 4>;

struct ThreeMfComponent {
  std::string object;         ///< identifier of the object
  std::string part;           ///< model part that holds the object; empty: this part
  Eigen::Affine3d to_parent;  ///< maps the object's coordinates to the parent's
};

struct ThreeMfObject {
  std::vector<Vec3> positions;
  std::vector<Face> faces;
  std::vector<std::array<std::optional<ByteColor>, 3>> colors;  ///< corner colors of each face
  std::vector<ThreeMfComponent> components;
  bool is_other = false;  ///< true if the object's type excludes it from the model
};

struct ThreeMfModel {
  std::string unit = "millimeter";
  std::string description;  ///< metadata entry `Description`
  std::size_t other_metadata = 0;
  std::map<std::string, ThreeMfObject> objects;  ///< objects by their identifiers
  std::vector<ThreeMfComponent> items;           ///< items of the build
  std::size_t unread_properties = 0;  ///< groups of materials other than colors, such as textures
  std::size_t beam_lattices = 0;
};

/// Reads a model part. `source` holds its XML and the name of the archive. Throws InputError.
ThreeMfModel read_three_mf_model(const Source& source, const std::string& part);

}  // namespace transformesh
