#include "columns_binding.h"

#include <pybind11/stl.h>

#include "transformesh/errors.h"

namespace transformesh::python {
namespace {

struct PythonColumns {
  MeshPointer mesh;
  bool is_of_vertices;

  Columns& columns() const {
    Mesh& of = mesh->document.mesh;
    return is_of_vertices ? of.vertex_columns : of.face_columns;
  }
  std::size_t rows() const {
    const Mesh& of = mesh->document.mesh;
    return is_of_vertices ? of.positions.size() : of.faces.size();
  }
  Column& at(const std::string& name) const {
    if (Column* column = columns().find(name)) return *column;
    throw py::key_error(name);
  }
};

// Scalar types, and their names in NumPy.
const std::pair<Scalar, const char*> type_names[] = {
    {Scalar::int8, "int8"},       {Scalar::uint8, "uint8"},    {Scalar::int16, "int16"},
    {Scalar::uint16, "uint16"},   {Scalar::int32, "int32"},    {Scalar::uint32, "uint32"},
    {Scalar::float32, "float32"}, {Scalar::float64, "float64"}};

py::dtype dtype_of(Scalar scalar) {
  for (const auto& [type, name] : type_names)
    if (type == scalar) return py::dtype(name);
  return py::dtype("float64");
}

// Returns the type of a column that stores this array. 64-bit integers, the default of NumPy, are
// stored as 32-bit integers.
Scalar scalar_of(const py::array& array) {
  const std::string name = py::str(array.dtype().attr("name"));
  for (const auto& [type, known] : type_names)
    if (name == known) return type;
  if (name == "bool") return Scalar::uint8;
  if (name == "int64") return Scalar::int32;
  if (name == "uint64") return Scalar::uint32;
  throw InputError("a column of " + name + " cannot be stored");
}

// Throws if an integer does not fit into 32 bits.
void check_range(const std::string& name, Scalar type, const std::vector<double>& values) {
  const double least = type == Scalar::int32 ? -2147483648.0 : 0;
  const double most = type == Scalar::int32 ? 2147483647.0 : 4294967295.0;
  if (type != Scalar::int32 && type != Scalar::uint32) return;
  for (const double value : values)
    if (value < least || value > most)
      throw InputError("column '" + name + "': " + std::to_string(static_cast<long>(value)) +
                       " does not fit into 32 bits; store it as a float");
}

py::object list_array(const Column& column) {
  py::list lists;
  for (std::size_t row = 0; row + 1 < column.list_offsets.size(); ++row) {
    const std::size_t first = column.list_offsets[row];
    lists.append(py::array_t<double>(static_cast<py::ssize_t>(column.list_offsets[row + 1] - first),
                                     column.values.data() + first));
  }
  return lists;
}

py::object get(const PythonColumns& self, const std::string& name) {
  Column& column = self.at(name);
  if (column.list_count_type) return list_array(column);
  py::array_t<double> doubles(static_cast<py::ssize_t>(column.values.size()), column.values.data(),
                              py::cast(self.mesh));
  if (column.type == Scalar::float64) return doubles;
  // The copy is read-only, since writing to it would not change the column.
  py::object copy = doubles.attr("astype")(dtype_of(column.type));
  copy.attr("setflags")(py::arg("write") = false);
  return copy;
}

void retire(const PythonColumns& self, Column& column) {
  self.mesh->retired.push_back(std::move(column.values));
}

void set(const PythonColumns& self, const std::string& name, const py::array& values) {
  if (values.ndim() != 1 || static_cast<std::size_t>(values.shape(0)) != self.rows())
    throw InputError("column '" + name + "': an array of " + std::to_string(self.rows()) +
                     " numbers is needed");
  const Scalar type = scalar_of(values);
  const py::array_t<double, py::array::c_style | py::array::forcecast> doubles(values);
  // The values are copied before the column changes, because the array may be a view of this
  // column.
  std::vector<double> copy(doubles.data(), doubles.data() + doubles.size());
  check_range(name, type, copy);
  if (Column* old = self.columns().find(name)) retire(self, *old);
  self.columns().get(name, type, self.rows()).values = std::move(copy);
}

void erase(const PythonColumns& self, const std::string& name) {
  retire(self, self.at(name));
  self.columns().erase(name);
}

std::vector<std::string> names(const PythonColumns& self) {
  std::vector<std::string> all;
  for (const Column& column : self.columns().columns) all.push_back(column.name);
  return all;
}

}  // namespace

py::object vertex_columns(const MeshPointer& mesh) { return py::cast(PythonColumns{mesh, true}); }
py::object face_columns(const MeshPointer& mesh) { return py::cast(PythonColumns{mesh, false}); }

void bind_columns(py::module_& module) {
  const py::object columns =
      py::class_<PythonColumns>(
          module, "Columns",
          "A dict of arrays. Columns of doubles are arrays on the mesh's own memory; others are "
          "read-only copies: assign an array to change them.")
          .def("__getitem__", &get)
          .def("__setitem__", &set)
          .def("__delitem__", &erase)
          .def("__len__", [](const PythonColumns& self) { return self.columns().columns.size(); })
          .def("__iter__",
               [](const PythonColumns& self) { return py::iter(py::cast(names(self))); })
          .def("__contains__",
               [](const PythonColumns& self, const std::string& name) {
                 return self.columns().find(name) != nullptr;
               })
          .def("__repr__", [](const PythonColumns& self) {
            return std::string(py::str(py::cast(names(self))));
          });
  // Adds the methods that make the class behave like a dict, from MutableMapping.
  const py::object mapping = py::module_::import("collections.abc").attr("MutableMapping");
  mapping.attr("register")(columns);
  for (const char* name : {"keys", "values", "items", "get", "update", "pop"})
    columns.attr(name) = mapping.attr(name);
}

}  // namespace transformesh::python
