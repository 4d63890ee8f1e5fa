#include "tm/page/page.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "tm/page/encode.h"
#include "tm/picture/colormap.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json column_json(const PackedColumn& column) {
  return {{"name", column.name}, {"low", column.low}, {"high", column.high}};
}

/// Where in a page's columns this one is.
auto find_column(Json& columns, const std::string& name) {
  return std::ranges::find_if(columns, [&](const Json& column) { return column["name"] == name; });
}

/// The columns of all meshes, with the ends of their values in any of them.
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

Json mesh_json(const PageMesh& mesh, const std::string& place) {
  const std::string& block = mesh.block.empty() ? place : mesh.block;
  return {{"number", mesh.number},
          {"label", mesh.label},
          {"vertices", mesh.mesh.vertices},
          {"faces", mesh.mesh.faces},
          {"low", vector_json(mesh.mesh.low)},
          {"high", vector_json(mesh.mesh.high)},
          {"radius", mesh.mesh.radius},
          {"block", block}};
}

/// The eye, and the rays of the image's corners as far as a depth of 1.
Json camera_json(const RunView& view, const std::string& photograph) {
  const CameraRecord& record = view.camera;
  const PinholeCamera& camera = record.camera;
  // Where the size is unknown the principal point is taken for the center.
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
    throw InputError("the report of '" + run.name + "' is damaged: it is no JSON object");
  return report;
}

Json run_json(const PageRun& run, std::size_t number) {
  Json meshes = Json::array();
  for (std::size_t i = 0; i < run.meshes.size(); ++i)
    meshes.push_back(mesh_json(run.meshes[i], block_name(number, i)));
  Json cameras = Json::array();
  for (std::size_t i = 0; i < run.views.size(); ++i)
    cameras.push_back(camera_json(run.views[i], photograph_name(number, i)));
  return {{"name", run.name},
          {"tool", run.tool},
          {"version", run.version},
          {"commands", run.commands},
          {"log", run.log},
          {"report", report_json(run)},
          {"columns", columns_json(run)},
          {"meshes", meshes},
          {"target", run.target ? mesh_json(*run.target, block_name(number, {})) : Json()},
          {"cameras", cameras}};
}

/// So many colors that between them sRGB is as good as linear.
Json colors_json(double low) {
  constexpr int steps = 64;
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

/// A script that is none: the text of a script element ends at the first `</`.
std::string data_element(const std::string& id, const std::string& type, std::string text) {
  for (std::size_t i = 0; (i = text.find('<', i)) != std::string::npos; i += 6)
    text.replace(i, 1, "\\u003c");
  return "<script id=\"" + id + "\" type=\"" + type + "\">" + text + "</script>\n";
}

void append_block(std::string& html, const PageMesh& mesh, const std::string& name) {
  html += data_element(name, "text/plain", base64(mesh.mesh.block));
}

}  // namespace

std::string page_json(const Page& page) {
  Json runs = Json::array();
  for (const PageRun& run : page.runs) runs.push_back(run_json(run, runs.size()));
  return text_of({{"title", page.title},
                  {"version", page.version},
                  {"color_by", page.color_by},
                  {"up", page.up},
                  {"live", page.is_live},
                  {"colors", {{"one_sign", colors_json(0)}, {"two_signs", colors_json(-1)}}},
                  {"runs", runs}});
}

std::string block_name(std::size_t run, std::optional<std::size_t> index) {
  if (!index) return "target-" + std::to_string(run);
  return "mesh-" + std::to_string(run) + '-' + std::to_string(*index);
}

std::string photograph_name(std::size_t run, std::size_t index) {
  return "photograph-" + std::to_string(run) + '-' + std::to_string(index);
}

std::string page_html(const Page& page, std::string_view viewer) {
  std::string data = data_element("page", "application/json", page_json(page));
  if (!page.is_live) {
    for (std::size_t i = 0; i < page.runs.size(); ++i) {
      const PageRun& run = page.runs[i];
      if (run.target) append_block(data, *run.target, block_name(i, {}));
      for (std::size_t k = 0; k < run.meshes.size(); ++k)
        append_block(data, run.meshes[k], block_name(i, k));
      for (std::size_t k = 0; k < run.views.size(); ++k)
        if (!run.views[k].photograph.empty())
          data +=
              data_element(photograph_name(i, k), "text/plain", base64(run.views[k].photograph));
    }
  }
  std::string html(viewer);
  if (page.is_live) replace(html, "connect-src 'none'", "connect-src 'self'");
  replace(html, "<!--tm:title-->", html_escaped(page.title));
  replace(html, "<!--tm:data-->", data);
  return html;
}

}  // namespace transformesh
