#include "page/page.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "helpers/shapes.h"
#include "page/encode.h"
#include "support/base64.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

using Json = nlohmann::json;

constexpr const char* viewer =
    "<meta content=\"connect-src 'none'\"><title><!--tm:title--></title><!--tm:data-->";

Page page_of_two_meshes() {
  Mesh mesh = test::tetrahedron();
  mesh.vertex_columns.get("heat", Scalar::float64, 4).values = {-1, 2, 0, 0};
  PageRun run;
  run.name = "</script><b>";
  run.log = "iteration,faces\n1,4\n";
  run.events = "iteration,time,kind\n1,1,split\n";
  run.report = R"({"result": {"stop": "converged"}})";
  run.meshes = {{0, "", pack(mesh)}, {7, "result", pack(test::scaled(mesh, 3))}};
  Page page;
  page.title = "a <title>";
  page.runs = {run};
  return page;
}

/// Returns the content of the element with this id.
std::string content(const std::string& html, const std::string& id) {
  const std::size_t begin = html.find('>', html.find("id=\"" + id + '"')) + 1;
  return html.substr(begin, html.find("</script>", begin) - begin);
}

}  // namespace

TEST_CASE("a page contains all data, and every mesh") {
  const Page page = page_of_two_meshes();
  const std::string html = page_html(page, viewer);
  CHECK(html.find("<title>a &lt;title&gt;</title>") != std::string::npos);
  const Json json = Json::parse(content(html, "page"));
  CHECK(json == Json::parse(page_json(page)));
  CHECK(json["runs"][0]["name"] == "</script><b>");
  CHECK(json["runs"][0]["meshes"][1]["number"] == 7);
  CHECK(json["runs"][0]["meshes"][1]["faces"] == 4);
  CHECK(json["runs"][0]["columns"][0] == Json{{"name", "heat"}, {"low", -1.0}, {"high", 2.0}});
  CHECK(json["runs"][0]["report"]["result"]["stop"] == "converged");
  CHECK(json["runs"][0]["targets"].empty());
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string name = json["runs"][0]["meshes"][i]["block"];
    CHECK(content(html, name) == base64(page.runs[0].meshes[i].mesh.block));
  }
  CHECK(html.find("connect-src 'none'") != std::string::npos);
}

TEST_CASE("up follows the option, else the cameras, else is y") {
  Page page = page_of_two_meshes();
  const auto up = [&] { return Json::parse(page_json(page))["up"]; };
  CHECK(up() == "y");
  // Cameras around the z axis that point down at it.
  std::vector<RunView>& views = page.runs[0].views.emplace_back().views;
  for (const double angle : {0.0, 2.0, 4.0}) {
    const Vec3 forward(-std::cos(angle), -std::sin(angle), -0.5);
    const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
    views.emplace_back().camera.camera.rotation << right.transpose(),
        forward.cross(right).normalized().transpose(), forward.normalized().transpose();
  }
  CHECK(up() == "z");
  for (RunView& view : views) view.camera.camera.rotation.topRows(2) *= -1;
  CHECK(up() == "-z");
  views.resize(2);
  views[1].camera.camera.rotation.topRows(2) = -views[0].camera.camera.rotation.topRows(2);
  CHECK(up() == "y");
  page.up = "x";
  CHECK(up() == "x");
}

TEST_CASE("a live page has no meshes, and may ask for them") {
  Page page = page_of_two_meshes();
  page.is_live = true;
  const std::string html = page_html(page, viewer);
  CHECK(html.find("mesh-0-0\" type") == std::string::npos);
  CHECK(html.find("connect-src 'self'") != std::string::npos);
}

TEST_CASE("a viewer without placeholders, and an invalid report, are reported") {
  Page page = page_of_two_meshes();
  CHECK_THROWS_AS(page_html(page, "<html>"), InputError);
  page.runs[0].report = "{";
  CHECK_THROWS_AS(page_json(page), InputError);
}

TEST_CASE("colors of the page are those of pictures: viridis, and blue over white to red") {
  const Json colors = Json::parse(page_json(page_of_two_meshes()))["colors"];
  CHECK(colors["one_sign"].front() == Json{68, 1, 84});
  CHECK(colors["one_sign"].back() == Json{253, 231, 37});
  CHECK(colors["two_signs"][32] == Json{247, 247, 247});
}
