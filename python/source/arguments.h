/// Converts and checks arguments from Python that are not meshes: numbers, words, an obstacle. All
/// functions throw UsageError, naming the argument.
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

/// Returns the numbers of a scalar, sequence or array of any shape. Their number must be `count`.
std::vector<double> numbers_of(const py::handle& value, std::size_t count, const std::string& name);
Vec3 vector_of(const std::vector<double>& numbers);
/// Returns the vector of three numbers, or nothing for None.
std::optional<Vec3> optional_vector(const py::handle& value, const std::string& name);
/// Returns the box between two corners, or nothing for None.
std::optional<Box> optional_box(const py::handle& value);

/// Returns the index of `word` in `words`.
std::size_t choice(const std::string& name, const std::string& word,
                   std::initializer_list<const char*> words);

/// Argument `smooth`: a factor of Laplacian smoothing, two factors for two passes, or a word.
using SmoothingChoice = std::variant<double, std::pair<double, double>, std::string>;
void set_smoothing(const SmoothingChoice& smooth, RemeshOptions& options);

/// Returns an obstacle with its gap. Both arguments must be given, or none.
KeepOutOptions keep_out_of(const std::optional<MeshPointer>& surface,
                           const std::optional<PythonLength>& gap, Lengths& lengths);

/// Issues Python warnings for notes that a program would print on stderr.
void warn(const std::vector<std::string>& notes);

/// Merges equal positions of a soup (join_soup.h) and issues a warning. Returns the entry of the
/// report with the number of vertices that were merged.
Entries join_places(Mesh& mesh);

}  // namespace transformesh::python
