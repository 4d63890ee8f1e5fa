/// What Python hands over besides meshes, checked: numbers, words, another surface. Mistakes are
/// UsageErrors that name the argument.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "call.h"
#include "python_mesh.h"
#include "transformesh/measure.h"
#include "transformesh/mesh.h"
#include "transformesh/remesh.h"

namespace transformesh::python {

/// So many numbers, of any shape.
std::vector<double> numbers_of(const py::handle& value, std::size_t count, const std::string& name);
Vec3 vector_of(const std::vector<double>& numbers);
/// Two corners.
Box box_of(const py::handle& value);

/// One of the words, by its place.
std::size_t choice(const std::string& name, const std::string& word,
                   std::initializer_list<const char*> words);

/// A factor of the Laplace-Beltrami operator, two where it is used twice, or a word.
using SmoothingChoice = std::variant<double, std::pair<double, double>, std::string>;
void set_smoothing(const SmoothingChoice& smooth, RemeshOptions& options);

/// A surface to stay away from, and how far: both or none.
KeepOutOptions keep_out_of(const std::optional<MeshPointer>& surface,
                           const std::optional<PythonLength>& gap, Lengths& lengths);

/// What a program would say on stderr, as warnings.
void warn(const std::vector<std::string>& notes);

/// Joins equal places where only indices keep faces apart (join_soup.h), with a warning. Returns
/// how many vertices were joined with others.
std::size_t join_places(Mesh& mesh);

}  // namespace transformesh::python
