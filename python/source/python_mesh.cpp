#include "python_mesh.h"

#include <pybind11/stl.h>

#include <cmath>

#include "advice.h"
#include "call.h"
#include "clean/box/tile.h"
#include "columns_binding.h"
#include "io/formats/file_format.h"
#include "io/streams/atomic_file.h"
#include "io/streams/streams.h"
#include "transformesh/mesh_io.h"

namespace transformesh::python {
namespace {

template <typename Number>
bool holds(const py::array& array) {
  return py::isinstance<py::array_t<Number>>(array);
}

void check_rows(const py::array& array, const std::string& name) {
  if (!array || array.ndim() != 2 || array.shape(1) != 3)
    throw InputError(name + ": an array of shape (n, 3) is needed");
}

template <typename Number>
std::vector<Vec3> read_vectors(const py::array& array) {
  const py::array_t<Number> numbers(array);  // may be a copy, which must outlive `rows`
  const auto rows = numbers.template unchecked<2>();
  std::vector<Vec3> vectors(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    vectors[static_cast<std::size_t>(i)] = Vec3(rows(i, 0), rows(i, 1), rows(i, 2));
  return vectors;
}

template <typename Number>
std::vector<Face> read_faces(const py::array& array, std::size_t vertices) {
  const py::array_t<Number> numbers(array);  // may be a copy, which must outlive `rows`
  const auto rows = numbers.template unchecked<2>();
  std::vector<Face> faces(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    for (py::ssize_t corner = 0; corner < 3; ++corner) {
      const Number index = rows(i, corner);
      if (std::cmp_less(index, 0) || std::cmp_greater_equal(index, vertices))
        throw InputError("face " + std::to_string(i) + " has vertex index " +
                         std::to_string(index) + ", but there are " + std::to_string(vertices) +
                         " vertices");
      faces[static_cast<std::size_t>(i)][static_cast<std::size_t>(corner)] =
          static_cast<Index>(index);
    }
  return faces;
}

std::vector<Face> faces_of(const py::array& array, std::size_t vertices) {
  check_rows(array, "faces");
  if (holds<std::uint32_t>(array)) return read_faces<std::uint32_t>(array, vertices);
  if (holds<std::int32_t>(array)) return read_faces<std::int32_t>(array, vertices);
  if (holds<std::uint64_t>(array)) return read_faces<std::uint64_t>(array, vertices);
  if (array.dtype().kind() != 'i' && array.dtype().kind() != 'u' && array.shape(0) > 0)
    throw InputError("faces: an array of integers is needed");
  return read_faces<std::int64_t>(array, vertices);
}

py::array positions(const MeshPointer& self) {
  std::vector<Vec3>& rows = self->document.mesh.positions;
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return py::array_t<double>({rows.size(), std::size_t{3}},
                             rows.empty() ? nullptr : rows.data()->data(), py::cast(self));
}

py::array faces(const MeshPointer& self) {
  std::vector<Face>& rows = self->document.mesh.faces;
  return py::array_t<Index>({rows.size(), std::size_t{3}},
                            rows.empty() ? nullptr : rows.data()->data(), py::cast(self));
}

// Returns bytes as a Python string. Bytes that are not UTF-8 are preserved.
py::object text_of(const std::string& bytes) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "surrogateescape"));
}

std::string bytes_of_text(const py::handle& text) {
  return py::bytes(text.attr("encode")("utf-8", "surrogateescape"));
}

std::string description(const PythonMesh& self) {
  return "<transformesh.Mesh of " + std::to_string(self.document.mesh.positions.size()) +
         " vertices and " + std::to_string(self.document.mesh.faces.size()) + " faces>";
}

// --- Reading and writing -------------------------------------------------------------------------

MeshPointer parse(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  ReadResult result =
      without_lock(py::none(), [&](const Progress&) { return read_mesh(bytes, name, options); });
  if (has_tile_comment(result.document.style.comments))
    throw InputError(name +
                     " is a tile of a larger mesh, cut at its borders; clean each tile with "
                     "the program tm-clean, and join them with tm-tile join");
  if (result.soup_note) {
    std::string& line = result.notes[*result.soup_note];
    line = with_advice({ErrorKind::not_joined, line});
  }
  warn(result.notes);
  return mesh_of(std::move(result.document));
}

MeshPointer read(Call& call) {
  const std::string name = call.path("path");
  const Bytes bytes = read_all(name);
  return parse(bytes.view(), name, {call.get<bool>("strict"), input_folder(name)});
}

MeshPointer parse_bytes(Call& call) {
  const auto bytes = call.get<py::bytes>("bytes");
  return parse(std::string_view(bytes), "the bytes", {call.get<bool>("strict")});
}

std::string bytes_of(const PythonMesh& self, const std::string& format, const std::string& name,
                     const std::string& scalar) {
  Document document = self.document;
  std::optional<Scalar> coordinate;
  if (!scalar.empty()) coordinate = scalar == "float" ? Scalar::float32 : Scalar::float64;
  set_format(document, format_for(document.style.format, format, name), coordinate);
  WriteResult result = write_mesh(document);
  warn(result.notes);
  return std::move(result.bytes);
}

py::none write(Call& call) {
  const std::string name = call.path("path");
  const std::string bytes = bytes_of(call.mesh("mesh"), call.get<std::string>("format"), name,
                                     call.get<std::string>("scalar"));
  call.run([&](const Progress&) {
    write_file(name, bytes);
    return true;
  });
  return {};
}

}  // namespace

std::string path_text(const py::handle& path) {
  return py::str(py::module_::import("os").attr("fspath")(path));
}

std::vector<Vec3> vectors_of(const py::array& array, const std::string& name) {
  check_rows(array, name);
  return holds<float>(array) ? read_vectors<float>(array) : read_vectors<double>(array);
}

namespace {

py::object object_of(const auto& value) { return py::cast(value); }
py::object object_of(const Length& length) { return py::cast(length.text()); }
py::object object_of(const std::vector<double>& numbers) { return py::tuple(py::cast(numbers)); }

}  // namespace

py::dict dict_of(const Entries& entries) {
  py::dict all;
  for (const auto& [name, value] : entries)
    all[name.c_str()] = std::visit([](const auto& held) { return object_of(held); }, value);
  return all;
}

MeshPointer mesh_of(Document document, const Entries& report) {
  return mesh_of(std::move(document), dict_of(report));
}

MeshPointer mesh_of(Document document, py::dict report) {
  return std::make_shared<PythonMesh>(PythonMesh{std::move(document), std::move(report)});
}

MeshPointer mesh_of(Mesh mesh, const Entries& report) {
  Document document;
  document.mesh = std::move(mesh);
  return mesh_of(std::move(document), report);
}

namespace {

/// Makes a mesh from positions (n, 3) and faces (m, 3), with the same checks as for meshes in
/// files. Copies the data only once if positions are doubles or floats, and faces are 32- or 64-bit
/// integers.
MeshPointer make_mesh(const py::object& positions, const py::object& faces) {
  Mesh mesh;
  mesh.positions = vectors_of(py::array::ensure(positions), "positions");
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (!mesh.positions[v].allFinite())
      throw InputError("vertex " + std::to_string(v) + " has a coordinate that is not finite");
  if (!faces.is_none()) mesh.faces = faces_of(py::array::ensure(faces), mesh.positions.size());
  return mesh_of(std::move(mesh));
}

}  // namespace

void bind_mesh(py::module_& module) {
  bind_columns(module);
  py::class_<PythonMesh, MeshPointer>(
      module, "Mesh",
      "A triangle mesh with columns, and what else its file said. `positions` and `faces` are "
      "arrays on the mesh's own memory: writing to them changes the mesh. Operations leave their "
      "arguments alone and return new meshes, whose `report` says what was done.")
      .def(py::init(&make_mesh), py::arg("positions"), py::arg("faces") = py::none(),
           "Positions (n, 3), and faces (m, 3) of indices, counter-clockwise seen from outside.")
      .def_property_readonly("positions", &positions, "(n, 3) doubles")
      .def_property_readonly("faces", &faces, "(m, 3) indices")
      .def_property_readonly(
          "vertex_columns", [](const MeshPointer& self) { return vertex_columns(self); },
          "named numbers per vertex, as a dict of arrays")
      .def_property_readonly(
          "face_columns", [](const MeshPointer& self) { return face_columns(self); },
          "named numbers per face, as a dict of arrays")
      .def_property(
          "comments",
          [](const PythonMesh& self) {
            py::list lines;
            for (const std::string& line : self.document.style.comments)
              lines.append(text_of(line));
            return lines;
          },
          [](PythonMesh& self, const py::list& lines) {
            std::vector<std::string> comments;
            for (const py::handle& line : lines) comments.push_back(bytes_of_text(line));
            self.document.style.comments = std::move(comments);
          },
          "the lines of comment that a PLY file has")
      .def_readwrite("report", &PythonMesh::report, "what the operation did that made this mesh")
      .def("copy", [](const PythonMesh& self) { return mesh_of(self.document, self.report); })
      .def(
          "to_bytes",
          [](const PythonMesh& self, const std::string& format, const std::string& scalar) {
            return py::bytes(bytes_of(self, format, "", scalar));
          },
          py::arg("format") = "", py::arg("scalar") = "", "the bytes that `write` would write")
      .def("__repr__", &description)
      .def(py::pickle(
          [](const PythonMesh& self) { return py::bytes(write_mesh(self.document).bytes); },
          [](const py::bytes& bytes) { return parse(std::string_view(bytes), "the pickle", {}); }));
  define(module, "read", &read);
  define(module, "parse", &parse_bytes);
  define(module, "write", &write);
}

}  // namespace transformesh::python
