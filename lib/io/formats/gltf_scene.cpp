#include "io/formats/gltf_scene.h"

#include <array>

namespace transformesh {
namespace {

template <std::size_t size>
std::array<double, size> member_numbers(const GltfFile& file, const GltfJson& node, const char* key,
                                        std::array<double, size> fallback) {
  const auto found = node.find(key);
  if (found == node.end()) return fallback;
  bool is_fit = found->is_array() && found->size() == size;
  for (std::size_t i = 0; is_fit && i < size; ++i) {
    is_fit = (*found)[i].is_number();
    if (is_fit) fallback[i] = (*found)[i].template get<double>();
  }
  if (!is_fit)
    file.fail(std::string(key) + " of a node is not an array of " + std::to_string(size) +
              " numbers");
  return fallback;
}

/// Returns the transformation of a node. The file has a matrix by columns, or translation times
/// rotation times scale.
Eigen::Affine3d transform_of(const GltfFile& file, const GltfJson& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node.contains("matrix")) {
    const auto m = member_numbers<16>(file, node, "matrix", {});
    for (std::size_t i = 0; i < 12; ++i)
      transform(static_cast<Eigen::Index>(i % 3), static_cast<Eigen::Index>(i / 3)) =
          m[i / 3 * 4 + i % 3];
    return transform;
  }
  const auto t = member_numbers<3>(file, node, "translation", {0, 0, 0});
  const auto r = member_numbers<4>(file, node, "rotation", {0, 0, 0, 1});
  const auto s = member_numbers<3>(file, node, "scale", {1, 1, 1});
  transform.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  // Normalize the quaternion, because its floats do not have length 1 exactly.
  const Eigen::Quaterniond rotation(r[3], r[0], r[1], r[2]);
  if (node.contains("rotation") && rotation.squaredNorm() > 0)
    transform.rotate(rotation.normalized());
  transform.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  return transform;
}

class Walk {
 public:
  explicit Walk(const GltfFile& file) : file_(file), is_visited_(file.count("nodes"), 0) {}

  std::vector<GltfInstance> run() {
    push(roots(), Eigen::Affine3d::Identity());
    while (!waiting_.empty()) {
      const auto [node, parent] = waiting_.back();
      waiting_.pop_back();
      visit(node, parent);
    }
    return std::move(instances_);
  }

 private:
  struct Waiting {
    std::size_t node;
    Eigen::Affine3d parent;
  };

  std::vector<std::size_t> indices_in(const GltfJson& object, const char* key) const {
    std::vector<std::size_t> indices;
    const auto list = object.find(key);
    if (list == object.end()) return indices;
    if (!list->is_array()) file_.fail(std::string(key) + " of the scene is not an array");
    for (const GltfJson& index : *list) {
      if (!index.is_number_unsigned()) file_.fail("the index of a node is not a whole number");
      indices.push_back(index.get<std::size_t>());
    }
    return indices;
  }

  std::vector<std::size_t> roots() const {
    if (file_.count("scenes") > 0) {
      const std::size_t scene = file_.whole(file_.json(), "scene", "the file", 0);
      return indices_in(file_.element("scenes", scene), "nodes");
    }
    std::vector<char> is_child(is_visited_.size(), 0);
    for (std::size_t i = 0; i < is_child.size(); ++i)
      for (const std::size_t child : indices_in(file_.element("nodes", i), "children"))
        if (child < is_child.size()) is_child[child] = 1;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < is_child.size(); ++i)
      if (is_child[i] == 0) found.push_back(i);
    return found;
  }

  /// Pushes nodes on the stack in reverse order, so that the first node is visited first.
  void push(const std::vector<std::size_t>& nodes, const Eigen::Affine3d& parent) {
    for (std::size_t i = nodes.size(); i-- > 0;) waiting_.push_back({nodes[i], parent});
  }

  void visit(std::size_t index, const Eigen::Affine3d& parent) {
    const GltfJson& node = file_.element("nodes", index);
    if (is_visited_[index] != 0)
      file_.fail("node " + std::to_string(index) +
                 " is reached twice: the nodes of a scene must be a tree");
    is_visited_[index] = 1;
    const Eigen::Affine3d transform = parent * transform_of(file_, node);
    if (node.contains("mesh"))
      instances_.push_back({file_.whole(node, "mesh", "node " + std::to_string(index)), transform});
    push(indices_in(node, "children"), transform);
  }

  const GltfFile& file_;
  std::vector<char> is_visited_;
  std::vector<Waiting> waiting_;
  std::vector<GltfInstance> instances_;
};

}  // namespace

std::vector<GltfInstance> gltf_instances(const GltfFile& file) { return Walk(file).run(); }

}  // namespace transformesh
