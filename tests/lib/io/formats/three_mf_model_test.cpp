#include "io/formats/three_mf_model.h"

#include "lib/io/stored_zip.h"

using namespace transformesh;
using namespace transformesh::testing;

namespace {

ThreeMfModel model_of(const std::string& xml) {
  return read_three_mf_model({xml, "input"}, "3dmodel.model");
}

std::string error_of(const std::string& xml) {
  try {
    model_of(xml);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

std::string object(const std::string& content, const std::string& attributes = "") {
  return "<model><resources><object id=\"1\" " + attributes + ">" + content +
         "</object></resources></model>";
}

}  // namespace

TEST_CASE("3mf model: vertices, triangles and components with transforms") {
  const ThreeMfModel model =
      model_of("<model unit=\"inch\"><resources><object id=\"7\">" + three_mf_triangle(3) +
               "</object><object id=\"8\"><components><component objectid=\"7\" "
               "transform=\"0 1 0 -1 0 0 0 0 1 10 20 30\"/></components></object></resources>"
               "<build><item objectid=\"8\" path=\"/3D/other.model\"/></build></model>");
  CHECK(model.unit == "inch");
  CHECK(model.objects.at("7").positions[1] == Vec3(1, 0, 3));
  CHECK(model.objects.at("7").faces == std::vector<Face>{{0, 1, 2}});
  // The rows are the images of the axes: x goes to y, and y to -x.
  CHECK(model.objects.at("8").components.at(0).to_parent * Vec3(1, 2, 0) == Vec3(8, 21, 30));
  CHECK(model.items.at(0).part == "/3D/other.model");
}

TEST_CASE("3mf model: colors of triangles, objects and corners") {
  const std::string groups =
      "<model><resources><basematerials id=\"5\"><base name=\"a\" displaycolor=\"#102030\"/>"
      "</basematerials><m:colorgroup id=\"6\"><m:color color=\"#FF000080\"/><m:color "
      "color=\"#00ff00\"/></m:colorgroup><object id=\"1\" pid=\"5\" pindex=\"0\">";
  const auto colors_with = [&](const std::string& attributes) {
    return model_of(groups + three_mf_triangle(0, attributes) + "</object></resources></model>")
        .objects.at("1")
        .colors.at(0);
  };
  const ByteColor base{16, 32, 48, 255}, red{255, 0, 0, 128}, green{0, 255, 0, 255};
  CHECK(colors_with("") == std::array<std::optional<ByteColor>, 3>{base, base, base});
  CHECK(colors_with("pid=\"6\" p1=\"1\"") ==
        std::array<std::optional<ByteColor>, 3>{green, green, green});
  CHECK(colors_with("pid=\"6\" p1=\"0\" p2=\"1\" p3=\"1\"") ==
        std::array<std::optional<ByteColor>, 3>{red, green, green});
  CHECK_THROWS_WITH_AS(colors_with("pid=\"6\" p1=\"2\""),
                       doctest::Contains("'2' as a color of object"), InputError);
}

TEST_CASE("3mf model: what is malformed is named") {
  CHECK(contains(error_of("<model>"), "XML is not well-formed"));
  CHECK(contains(error_of("<other/>"), "'3dmodel.model' has no element 'model'"));
  CHECK(contains(error_of(object("<mesh><vertices><vertex x=\"1\" y=\"2\"/></vertices></mesh>")),
                 "z='' in vertex 0 of object '1', which is not a finite number"));
  CHECK(contains(error_of(object("<mesh><vertices/><triangles><triangle v1=\"0\" v2=\"1\" "
                                 "v3=\"2\"/></triangles></mesh>")),
                 "'0' as v1 of triangle 0 of object '1', but there are 0 elements"));
  CHECK(contains(error_of(object("<components><component objectid=\"1\" transform=\"1 2\"/>"
                                 "</components>")),
                 "a transform of 2 numbers"));
  CHECK(contains(error_of("<model><resources><object id=\"1\"/><object id=\"1\"/></resources>"
                          "</model>"),
                 "two objects '1'"));
  CHECK(contains(error_of("<model><resources><colorgroup id=\"1\"><color color=\"red\"/>"
                          "</colorgroup></resources></model>"),
                 "the color 'red', not #RRGGBB"));
  CHECK(contains(error_of("<model requiredextensions=\"s\" xmlns:s=\"http://secure/2019/04\"/>"),
                 "requires the extension 'http://secure/2019/04'"));
}
