#include "page/page.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "page/encode.h"
#include "picture/colormap.h"
#include "support/base64.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json column_json(const PackedColumn& column) {
  return {{"name", column.name}, {"low", column.low}, {"high", column.high}};
}

/// Returns the column of this name in a page's columns.
auto find_column(Json& columns, const std::string& name) {
  return std::ranges::find_if(columns, [&](const Json& column) { return column["name"] == name; });
}

/// Returns the columns of all meshes, each with the range of its values over all meshes.
Json columns_json(const PageRun& run) {
  Json columns = Json::array();
  for (const PageMesh& mesh : run.meshes) {
    for (const PackedColumn& column : mesh.mesh.columns) {
      const auto known = find_column(columns, column.name);
      if (known == columns.end()) {
        columns.push_back(column_json(column));
      } else {
        (*known)["low"] = std::min((*known)["low"].get<double>(), column.low);
        (*known)["high"] = std::max((*known)["high"].get<double>(), column.high);
      }
    }
  }
  return columns;
}

std::string numbered_name(const char* what, std::size_t run, std::size_t index) {
  return std::string(what) + '-' + std::to_string(run) + '-' + std::to_string(index);
}

constexpr const char *mesh_prefix = "mesh", *target_prefix = "target";

std::string block_name(const PageMesh& mesh, const char* prefix, std::size_t run,
                       std::size_t index) {
  return mesh.block.empty() ? numbered_name(prefix, run, index) : mesh.block;
}

std::string photograph_name(std::size_t run, const PageViews& views, std::size_t index) {
  return numbered_name("photograph", run, views.number) + '-' + std::to_string(index);
}

Json mesh_json(const PageMesh& mesh, const std::string& block) {
  return {{"number", mesh.number},
          {"label", mesh.label},
          {"vertices", mesh.mesh.vertices},
          {"faces", mesh.mesh.faces},
          {"low", vector_json(mesh.mesh.low)},
          {"high", vector_json(mesh.mesh.high)},
          {"radius", mesh.mesh.radius},
          {"block", block}};
}

/// Returns the camera center, and the rays of the image corners up to depth 1.
Json camera_json(const RunView& view, const std::string& photograph) {
  const CameraRecord& record = view.camera;
  const PinholeCamera& camera = record.camera;
  // If the image size is unknown, the principal point is assumed to be the center.
  const double width = record.width > 0 ? record.width : 2 * camera.intrinsics(0, 2) + 1;
  const double height = record.height > 0 ? record.height : 2 * camera.intrinsics(1, 2) + 1;
  Json corners = Json::array();
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    corners.push_back(vector_json(camera.ray(x * width - 0.5, y * height - 0.5)));
  return {{"name", record.name},
          {"center", vector_json(camera.center())},
          {"corners", corners},
          {"photograph", view.photograph.empty() ? "" : photograph}};
}

Json report_json(const PageRun& run) {
  if (run.report.empty()) return nullptr;
  Json report = Json::parse(run.report, nullptr, false);
  if (!report.is_object())
    throw InputError("the report of '" + run.name + "' is damaged: it is not a JSON object");
  return report;
}

Json run_json(const PageRun& run, std::size_t number) {
  const auto meshes_json = [&](const std::vector<PageMesh>& meshes, const char* prefix) {
    Json json = Json::array();
    for (const PageMesh& mesh : meshes)
      json.push_back(mesh_json(mesh, block_name(mesh, prefix, number, json.size())));
    return json;
  };
  Json views = Json::array();
  for (const PageViews& step : run.views) {
    Json cameras = Json::array();
    for (const RunView& view : step.views)
      cameras.push_back(camera_json(view, photograph_name(number, step, cameras.size())));
    views.push_back({{"number", step.number}, {"cameras", cameras}});
  }
  return {{"name", run.name},
          {"tool", run.tool},
          {"version", run.version},
          {"commands", run.commands},
          {"log", run.log},
          {"events", run.events},
          {"report", report_json(run)},
          {"columns", columns_json(run)},
          {"meshes", meshes_json(run.meshes, mesh_prefix)},
          {"targets", meshes_json(run.targets, target_prefix)},
          {"views", views}};
}

/// Samples a color scale so densely that interpolation in sRGB matches linear interpolation.
Json colors_json(double low) {
  constexpr int steps = 64;  // chosen by hand; not measured
  Json colors = Json::array();
  for (int i = 0; i <= steps; ++i) {
    const Color color = ColorScale{low, 1}.at(low + (1 - low) * i / steps);
    colors.push_back({srgb_byte(color.x()), srgb_byte(color.y()), srgb_byte(color.z())});
  }
  return colors;
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void replace(std::string& text, std::string_view place, const std::string& by) {
  const std::size_t found = text.find(place);
  if (found == std::string::npos)
    throw InputError("the viewer is damaged: it has no place for " + std::string(place));
  text.replace(found, place.size(), by);
}

/// Returns a script element with data. Escapes `<`, because the first `</` would end the element.
std::string data_element(const std::string& id, const std::string& type, std::string text) {
  for (std::size_t i = 0; (i = text.find('<', i)) != std::string::npos; i += 6)
    text.replace(i, 1, "\\u003c");
  return "<script id=\"" + id + "\" type=\"" + type + "\">" + text + "</script>\n";
}

/// Returns the axis, with sign, nearest to the up direction of the photographs, which are seldom
/// upside down. Returns y if there are none, or if they were taken from all directions.
std::string axis_up(const std::vector<PageRun>& runs) {
  Vec3 up = Vec3::Zero();
  double count = 0;
  for (const PageRun& run : runs)
    for (const PageViews& step : run.views)
      for (const RunView& view : step.views) {
        up -= view.camera.camera.rotation.row(1).transpose();
        ++count;
      }
  // Least length of the mean up vector. If all cameras look down by 70 degrees, the length is 0.34.
  constexpr double least = 0.3;
  Eigen::Index axis = 1;
  if (!(up.cwiseAbs().maxCoeff(&axis) > least * count)) return "y";
  return (up[axis] < 0 ? "-" : "") + std::string(1, "xyz"[axis]);
}

}  // namespace

std::string page_json(const Page& page) {
  Json runs = Json::array();
  for (const PageRun& run : page.runs) runs.push_back(run_json(run, runs.size()));
  return text_of({{"title", page.title},
                  {"version", page.version},
                  {"color_by", page.color_by},
                  {"up", page.up == "auto" ? axis_up(page.runs) : page.up},
                  {"live", page.is_live},
                  {"colors", {{"one_sign", colors_json(0)}, {"two_signs", colors_json(-1)}}},
                  {"runs", runs}});
}

PageBlocks page_blocks(std::span<const PageRun> runs) {
  PageBlocks blocks;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto add = [&](const std::vector<PageMesh>& meshes, const char* prefix) {
      for (std::size_t k = 0; k < meshes.size(); ++k)
        blocks.emplace_back(block_name(meshes[k], prefix, i, k), &meshes[k].mesh.block);
    };
    add(runs[i].targets, target_prefix);
    add(runs[i].meshes, mesh_prefix);
    for (const PageViews& step : runs[i].views)
      for (std::size_t k = 0; k < step.views.size(); ++k)
        if (!step.views[k].photograph.empty())
          blocks.emplace_back(photograph_name(i, step, k), &step.views[k].photograph);
  }
  return blocks;
}

std::string page_html(const Page& page, std::string_view viewer) {
  std::string data = data_element("page", "application/json", page_json(page));
  if (!page.is_live)
    for (const auto& [name, bytes] : page_blocks(page.runs))
      data += data_element(name, "text/plain", base64(*bytes));
  std::string html(viewer);
  if (page.is_live) replace(html, "connect-src 'none'", "connect-src 'self'");
  replace(html, "<!--tm:title-->", html_escaped(page.title));
  replace(html, "<!--tm:data-->", data);
  return html;
}

}  // namespace transformesh
