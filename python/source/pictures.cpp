/// Binds render, which draws pictures, and report, which makes pages of runs.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <tuple>

#include "arguments.h"
#include "call.h"
#include "page/run_page.h"
#include "picture/ambient_occlusion.h"
#include "picture/parse_picture_options.h"
#include "picture/picture.h"
#include "python_mesh.h"
#include "transformesh/errors.h"

namespace transformesh::python {
namespace {

Axis axis_of(const std::string& name) {
  return std::array{Axis::x, Axis::y, Axis::z}[choice("up", name, {"x", "y", "z"})];
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
  std::vector<Mesh> copies;  ///< copies of the meshes that get a column
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

py::array render(const py::args& meshes, std::pair<int, int> size, std::pair<double, double> orbit,
                 const std::string& up, double zoom, const std::string& frame,
                 const std::optional<MeshPointer>& around, int views, int columns, int frames,
                 const std::string& color, const std::string& color_by,
                 const std::optional<std::pair<double, double>>& range,
                 const std::string& highlight, const py::object& segments,
                 const std::string& background, double crease_angle, bool ambient_occlusion,
                 bool edges, const py::object& progress) {
  Scene scene;
  for (const py::handle& mesh : meshes)
    scene.meshes.push_back(&py::cast<const PythonMesh&>(mesh).document.mesh);
  if (scene.meshes.empty()) throw UsageError("render: at least one mesh is needed");
  if (frames < 0) throw UsageError("frames: from 1 on, or 0 for a single picture");
  PictureOptions& picture = scene.picture;
  std::tie(picture.width, picture.height) = size;
  std::tie(picture.orbit.azimuth_deg, picture.orbit.elevation_deg) = orbit;
  picture.orbit.up = axis_of(up);
  picture.orbit.zoom = zoom;
  picture.framing = std::array{Framing::each, Framing::scale,
                               Framing::place}[choice("frame", frame, {"each", "scale", "place"})];
  if (around) picture.around = &(*around)->document.mesh;
  picture.views = views;
  picture.columns = columns;
  picture.range = range;
  if (!color.empty()) picture.shade.color.front = parse_color(color);
  picture.shade.color.by = color_by;
  picture.shade.color.highlight = highlight;
  picture.shade.segments = segments_of(segments);
  picture.shade.background = parse_background(background);
  picture.shade.crease_angle_deg = crease_angle;
  picture.shade.draw_edges = edges;
  const std::vector<Image> images = without_lock(
      progress, [&](const Progress& to) { return draw(scene, frames, ambient_occlusion, to); });
  return array_of(images, frames > 0);
}

// --- report --------------------------------------------------------------------------------------

/// Returns the page that shows runs. If `given` is empty, searches for share/transformesh in the
/// folders above the module, which is its place in the installation and in the build folder.
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

py::bytes report(const py::args& runs, std::size_t every, const std::string& title,
                 const std::string& color_by, const std::string& up, const py::object& viewer,
                 const py::object& progress) {
  std::vector<std::string> folders;
  for (const py::handle& run : runs) folders.push_back(path_text(run));
  if (folders.empty()) throw UsageError("report: the folder of a run is needed");
  if (every < 1) throw UsageError("every: from 1 on");
  axis_of(up);
  const std::string around = viewer_page(viewer.is_none() ? "" : path_text(viewer));
  return without_lock(progress, [&](const Progress& to) {
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
  using py::arg;
  const py::object none = py::none();
  module.def("render", &render, py::kw_only(), arg("size") = std::make_pair(800, 600),
             arg("orbit") = std::make_pair(30.0, 20.0), arg("up") = "y", arg("zoom") = 1.0,
             arg("frame") = "each", arg("around") = none, arg("views") = 1, arg("columns") = 0,
             arg("frames") = 0, arg("color") = "", arg("color_by") = "", arg("range") = none,
             arg("highlight") = "", arg("segments") = none, arg("background") = "#f7f7f7,#d6d9de",
             arg("crease_angle") = 40.0, arg("ambient_occlusion") = false, arg("edges") = false,
             arg("progress") = none,
             "A picture of meshes side by side as an array (height, width, 4) of red, green, blue, "
             "alpha. `views` draws each mesh from so many sides, `frames` makes a movie around "
             "them, (frames, height, width, 4). `color_by` names a column that colors stand for, "
             "`range` the numbers at their ends; `segments` are lines (k, 2, 3). See "
             "tm-render(1).");
  module.def("report", &report, py::kw_only(), arg("every") = 1, arg("title") = "",
             arg("color_by") = "", arg("up") = "y", arg("viewer") = none, arg("progress") = none,
             "The bytes of an HTML page that shows runs, the folders that the loops' programs "
             "write with --run, in 3D and over time. `viewer` is the page that shows them, where "
             "it is not installed. See tm-report(1).");
}

}  // namespace transformesh::python
