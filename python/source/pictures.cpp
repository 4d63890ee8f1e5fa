/// Binds the functions render, which draws pictures, and report, which makes HTML pages about
/// recorded runs of evolutions.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <tuple>

#include "call.h"
#include "page/run_page.h"
#include "picture/ambient_occlusion.h"
#include "picture/parse_picture_options.h"
#include "picture/picture.h"

namespace transformesh::python {
namespace {

Axis axis_of(const Call& call) {
  return call.choice<Axis>("up", {{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}});
}

// --- render --------------------------------------------------------------------------------------

/// Returns an array (n, height, width, 4) of the pictures of a movie, or (height, width, 4) of one.
py::array array_of(const std::vector<Image>& images, bool is_movie) {
  const Image& first = images[0];
  std::vector<std::size_t> shape{static_cast<std::size_t>(first.height),
                                 static_cast<std::size_t>(first.width), 4};
  if (is_movie) shape.insert(shape.begin(), images.size());
  py::array_t<std::uint8_t> array(shape);
  std::uint8_t* place = array.mutable_data();
  for (const Image& image : images)
    place = std::copy_n(image.pixels.data()->data(), image.pixels.size() * 4, place);
  return array;
}

/// Returns the segments in an array (k, 2, 3) of ends.
std::vector<std::pair<Vec3, Vec3>> segments_of(const py::object& ends) {
  if (ends.is_none()) return {};
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(ends);
  if (!array || array.ndim() != 3 || array.shape(1) != 2 || array.shape(2) != 3)
    throw UsageError("segments: an array of shape (k, 2, 3) is needed");
  std::vector<std::pair<Vec3, Vec3>> segments;
  const double* number = array.data();
  for (py::ssize_t i = 0; i < array.shape(0); ++i, number += 6)
    segments.emplace_back(Vec3(number[0], number[1], number[2]),
                          Vec3(number[3], number[4], number[5]));
  return segments;
}

struct Scene {
  std::vector<const Mesh*> meshes;
  /// Copies of `meshes` with a column for ambient occlusion; empty if it is not drawn.
  std::vector<Mesh> copies;
  PictureOptions picture;
};

void set_openness_of_all(Scene& scene, const Progress& progress) {
  scene.picture.shade.openness = "tm:openness";
  for (const Mesh* mesh : scene.meshes) {
    scene.copies.push_back(*mesh);
    set_openness(scene.copies.back(), scene.picture.shade.openness, progress);
  }
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) scene.meshes[i] = &scene.copies[i];
}

std::vector<Image> draw(Scene& scene, int frames, bool has_occlusion, const Progress& progress) {
  if (has_occlusion) set_openness_of_all(scene, progress);
  std::vector<Image> images;
  scene.picture.frames = std::max(frames, 1);
  for (int frame = 0; frame < scene.picture.frames; ++frame) {
    scene.picture.frame = frame;
    images.push_back(draw_picture(scene.meshes, scene.picture, progress));
  }
  return images;
}

ShadeOptions shading(const Call& call) {
  ShadeOptions shade;
  const auto color = call.get<std::string>("color");
  if (!color.empty()) shade.color.front = parse_color(color);
  call("color_by", shade.color.by)("highlight", shade.color.highlight);
  shade.segments = segments_of(call["segments"]);
  shade.background = parse_background(call.get<std::string>("background"));
  call("crease_angle", shade.crease_angle_deg)("edges", shade.draw_edges);
  return shade;
}

py::array render(Call& call) {
  Scene scene;
  for (const PythonMesh* mesh : call.meshes("render")) scene.meshes.push_back(&mesh->document.mesh);
  const auto frames = call.get<int>("frames");
  if (frames < 0) throw UsageError("frames: from 1 on, or 0 for a single picture");
  PictureOptions& picture = scene.picture;
  std::tie(picture.width, picture.height) = call.get<std::pair<int, int>>("size");
  std::tie(picture.orbit.azimuth_deg, picture.orbit.elevation_deg) =
      call.get<std::pair<double, double>>("orbit");
  picture.orbit.up = axis_of(call);
  picture.framing = call.choice<Framing>(
      "frame", {{"each", Framing::each}, {"scale", Framing::scale}, {"place", Framing::place}});
  if (!call["around"].is_none()) picture.around = &call.mesh("around").document.mesh;
  call("zoom", picture.orbit.zoom)("views", picture.views)("columns", picture.columns);
  call("range", picture.range);
  picture.shade = shading(call);
  const auto has_occlusion = call.get<bool>("ambient_occlusion");
  return array_of(
      call.run([&](const Progress& to) { return draw(scene, frames, has_occlusion, to); }),
      frames > 0);
}

// --- report --------------------------------------------------------------------------------------

/// Returns the HTML of the viewer page, read from the path `given`. If `given` is empty, searches
/// for share/transformesh/viewer.html in all folders above the Python module. The page has this
/// place in the installation and in the build folder.
std::string viewer_page(const std::string& given) {
  std::filesystem::path path = given;
  if (given.empty()) {
    const py::module_ module = py::module_::import("transformesh");
    std::filesystem::path folder = py::cast<std::string>(module.attr("__file__"));
    while (!std::filesystem::exists(path) && folder.has_relative_path()) {
      folder = folder.parent_path();
      path = folder / "share" / "transformesh" / "viewer.html";
    }
  }
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw GoalError(
        given.empty()
            ? "the viewer is not there, as share/transformesh/viewer.html in no folder above the "
              "module: it is installed with the programs where scripts/setup --browser "
              "was run before they were built; or name one with viewer="
            : "viewer: '" + given + "' cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

py::bytes report(Call& call) {
  std::vector<std::string> folders;
  for (const py::handle& run : call.get<py::tuple>("runs")) folders.push_back(path_text(run));
  if (folders.empty()) throw UsageError("report: the folder of a run is needed");
  const auto every = call.get<std::size_t>("every");
  if (every < 1) throw UsageError("every: from 1 on");
  axis_of(call);
  const std::string around = viewer_page(call["viewer"].is_none() ? "" : call.path("viewer"));
  const auto title = call.get<std::string>("title");
  const auto color_by = call.get<std::string>("color_by");
  const auto up = call.get<std::string>("up");
  return call.run([&](const Progress& to) {
    Page page = read_runs_page(folders, {every}, to);
    if (!color_by.empty() && !has_column(page, color_by))
      throw UsageError("color_by: no mesh has a property '" + color_by + "' of numbers");
    if (!title.empty()) page.title = title;
    page.color_by = color_by;
    page.version = "tm-report " TM_VERSION;
    page.up = up;
    return page_html(page, around);
  });
}

}  // namespace

void bind_pictures(py::module_& module) {
  define(module, "render", &render);
  define(module, "report", &report);
}

}  // namespace transformesh::python
