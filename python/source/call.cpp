#include "call.h"

#include <algorithm>
#include <iterator>
#include <variant>

#include "clean/open/join_soup.h"
#include "io/comments.h"
#include "io/length_basis.h"
#include "support/counted.h"

namespace transformesh::python {

int threads = 0;

Progress progress_to(const py::object& callback) {
  return Progress([callback](std::string_view phase, double fraction) {
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (callback.is_none()) return true;
    const py::object answer = callback(phase, fraction);
    return answer.is_none() || py::cast<bool>(answer);
  });
}

// --- Arguments -----------------------------------------------------------------------------------

std::string Call::word(const char* name, const std::vector<std::string>& words) const {
  const auto given = get<std::string>(name);
  if (std::ranges::find(words, given) != words.end()) return given;
  std::string list;
  for (const std::string& known : words) list += (list.empty() ? "" : ", ") + known;
  throw UsageError(std::string(name) + ": '" + given + "' is none of " + list);
}

std::vector<const PythonMesh*> Call::meshes(const std::string& function) const {
  std::vector<const PythonMesh*> all;
  for (const py::handle& mesh : get<py::tuple>("meshes"))
    all.push_back(&converted<const PythonMesh&>(mesh, "meshes"));
  if (all.empty()) throw UsageError(function + ": at least one mesh is needed");
  return all;
}

std::optional<Vec3> Call::vector(const char* name) const {
  const py::object value = (*this)[name];
  if (value.is_none()) return std::nullopt;
  return vector_of(numbers_of(value, 3, name));
}

std::optional<Box> Call::box() const {
  const py::object value = (*this)["box"];
  if (value.is_none()) return std::nullopt;
  const std::vector<double> corners = numbers_of(value, 6, "box");
  return Box{vector_of(corners), vector_of({corners.begin() + 3, corners.end()})};
}

std::string Call::path(const char* name) const { return path_text((*this)[name]); }

std::function<void(const std::string& message)> Call::callback(const char* name) const {
  const py::object callback = (*this)[name];
  if (callback.is_none()) return {};
  return [callback](const std::string& message) {
    const py::gil_scoped_acquire locked;
    callback(message);
  };
}

void Call::set_smoothing(RemeshOptions& options) const {
  const auto smooth = get<std::variant<double, std::pair<double, double>, std::string>>("smooth");
  if (const auto* factor = std::get_if<double>(&smooth)) {
    options.smoothing = Smoothing::laplace;
    options.smooth_first = *factor;
  } else if (const auto* factors = std::get_if<std::pair<double, double>>(&smooth)) {
    options.smoothing = Smoothing::bilaplace;
    std::tie(options.smooth_first, options.smooth_second) = *factors;
  } else {
    options.smoothing = choice<Smoothing>(
        "smooth", {{"tangential", Smoothing::tangential}, {"none", Smoothing::none}});
  }
}

// --- Lengths and surfaces ------------------------------------------------------------------------

Length Call::length_as_given(const char* name, const char* otherwise) const {
  const auto given = get<std::optional<std::variant<double, std::string>>>(name);
  if (!given) return parse_length(otherwise);
  if (const auto* number = std::get_if<double>(&*given)) return {*number, Length::Unit::absolute};
  return parse_length(std::get<std::string>(*given));
}

double Call::resolve(const Length& length) {
  if (length.unit == Length::Unit::reference_edge) return length.resolve(0, reference_edge());
  LengthBasis basis("");
  basis.set_document(&document);
  return basis.resolve(length);
}

double Call::length(const char* name, double otherwise) {
  return (*this)[name].is_none() ? otherwise : resolve(length_as_given(name, "0"));
}

double Call::reference_edge() {
  LengthBasis basis("");
  basis.set_document(&document);
  const double edge = basis.reference_edge();
  set_reference_edge(document.style.comments, edge);
  return edge;
}

KeepOutOptions Call::keep_out() {
  const bool has_surface = !(*this)["keep_out"].is_none();
  if (has_surface == (*this)["gap"].is_none())
    throw UsageError(
        "give both keep_out, the mesh to keep away from, and gap, the distance to keep");
  if (!has_surface) return {};
  const KeepOutOptions options{&mesh("keep_out").document.mesh, length("gap")};
  if (!(options.gap > 0)) throw UsageError("gap must be above 0");
  if (options.surface->faces.empty())
    throw InputError("keep_out has no faces: there is nothing to keep away from");
  return options;
}

void Call::join() { report = join_places(document.mesh); }

MeshPointer Call::result(const Entries& entries) {
  append(report, entries);
  return mesh_of(std::move(document), report);
}

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

void warn(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 1) != 0) throw py::error_already_set();
}

void define_filter(py::module_& module, const char* name, MeshPointer (*function)(Call&)) {
  module.def(name, [function](const py::kwargs& arguments) {
    Call call(arguments);
    call.document = call.mesh("mesh").document;
    return function(call);
  });
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
