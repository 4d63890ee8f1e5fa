#include "arguments.h"

#include "clean/stitch/join_soup.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh::python {

std::vector<double> numbers_of(const py::handle& value, std::size_t count,
                               const std::string& name) {
  const py::array_t<double> array = py::array_t<double>::ensure(value);
  if (!array) throw UsageError(name + ": numbers are needed");
  if (static_cast<std::size_t>(array.size()) != count)
    throw UsageError(name + ": " + std::to_string(count) + " numbers are needed, not " +
                     std::to_string(array.size()));
  const py::object flat = array.attr("ravel")();
  return py::cast<std::vector<double>>(flat.attr("tolist")());
}

Vec3 vector_of(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

std::optional<Vec3> optional_vector(const py::handle& value, const std::string& name) {
  if (value.is_none()) return std::nullopt;
  return vector_of(numbers_of(value, 3, name));
}

std::optional<Box> optional_box(const py::handle& value) {
  if (value.is_none()) return std::nullopt;
  const std::vector<double> corners = numbers_of(value, 6, "box");
  return Box{vector_of(corners), vector_of({corners.begin() + 3, corners.end()})};
}

std::size_t choice(const std::string& name, const std::string& word,
                   std::initializer_list<const char*> words) {
  std::string list;
  std::size_t place = 0;
  for (const char* known : words) {
    if (word == known) return place;
    list += (place++ == 0 ? "" : ", ") + std::string(known);
  }
  throw UsageError(name + ": '" + word + "' is none of " + list);
}

void set_smoothing(const SmoothingChoice& smooth, RemeshOptions& options) {
  if (const auto* factor = std::get_if<double>(&smooth)) {
    options.smoothing = Smoothing::laplace;
    options.smooth_first = *factor;
  } else if (const auto* factors = std::get_if<std::pair<double, double>>(&smooth)) {
    options.smoothing = Smoothing::bilaplace;
    std::tie(options.smooth_first, options.smooth_second) = *factors;
  } else if (choice("smooth", std::get<std::string>(smooth), {"tangential", "none"}) == 1) {
    options.smoothing = Smoothing::none;
  }
}

KeepOutOptions keep_out_of(const std::optional<MeshPointer>& surface,
                           const std::optional<PythonLength>& gap, Lengths& lengths) {
  if (surface.has_value() != gap.has_value())
    throw UsageError(
        "give both keep_out, the mesh to keep away from, and gap, the distance to keep");
  if (!surface) return {};
  const KeepOutOptions options{&(*surface)->document.mesh, lengths(*gap)};
  if (!(options.gap > 0)) throw UsageError("gap must be above 0");
  if (options.surface->faces.empty())
    throw InputError("keep_out has no faces: there is nothing to keep away from");
  return options;
}

void warn(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw py::error_already_set();
}

Entries join_places(Mesh& mesh) {
  const StitchResult result = join_soup(mesh);
  if (result.joined_vertices > 0)
    warn({counted(result.joined_vertices, "vertex") +
          " joined with others in the same place, as stitch() does"});
  if (result.dropped_faces > 0)
    warn({counted(result.dropped_faces, "face") + " with two corners in one place dropped"});
  return {{"joined_vertices", result.joined_vertices}};
}

}  // namespace transformesh::python
