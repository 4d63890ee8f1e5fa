#include "io/formats/gltf_scene.h"

#include "lib/io/gltf_text.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

std::vector<GltfInstance> instances_of(const Json& json) {
  const std::string text = json.dump();
  return gltf_instances(GltfFile({text, "input"}, ""));
}

}  // namespace

TEST_CASE("gltf: nodes move what is below them") {
  Json json = gltf_tetrahedron();
  const double half = std::sqrt(0.5);
  json["nodes"] =
      Json::array({{{"children", {1, 2}}, {"translation", {1, 0, 0}}},
                   {{"mesh", 0}, {"rotation", {0, 0, half, half}}, {"scale", {2, 2, 2}}},
                   {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 5, 6, 7, 1}}}});
  const auto instances = instances_of(json);
  REQUIRE(instances.size() == 2);
  // A quarter turn about z maps x to y.
  CHECK((instances[0].to_scene * Vec3(1, 0, 0)).isApprox(Vec3(1, 2, 0)));
  CHECK(instances[1].to_scene * Vec3(1, 1, 1) == Vec3(7, 7, 6));
}

TEST_CASE("gltf: without scenes, nodes without parents are roots") {
  Json json = gltf_tetrahedron();
  json.erase("scene");
  json.erase("scenes");
  json["nodes"] = Json::array({{{"mesh", 0}}, {{"children", {0}}, {"translation", {0, 0, 3}}}});
  const auto instances = instances_of(json);
  REQUIRE(instances.size() == 1);
  CHECK(instances[0].to_scene.translation() == Vec3(0, 0, 3));
}

TEST_CASE("gltf: circles of nodes, and nodes with two parents, are refused") {
  Json json = gltf_tetrahedron();
  json["nodes"] = Json::array({{{"children", {1}}}, {{"children", {0}}}});
  CHECK(contains(read_error(json.dump()), "node 0 is reached twice"));
  json["nodes"] = Json::array({{{"children", {1, 2}}}, {{"children", {2}}}, {{"mesh", 0}}});
  CHECK(contains(read_error(json.dump()), "node 2 is reached twice"));
  json["nodes"] = Json::array({{{"children", {9}}}});
  CHECK(contains(read_error(json.dump()), "element 9 of nodes"));
  json["nodes"] = Json::array({{{"mesh", 0}, {"scale", {1, 2}}}});
  CHECK(contains(read_error(json.dump()), "scale of a node is not an array of 3 numbers"));
}

TEST_CASE("gltf: a chain of a hundred thousand nodes needs no stack") {
  Json json = gltf_tetrahedron();
  json["nodes"] = Json::array();
  for (int i = 1; i <= 100000; ++i) json["nodes"].push_back({{"children", {i}}});
  json["nodes"].push_back({{"mesh", 0}});
  CHECK(instances_of(json).size() == 1);
}
