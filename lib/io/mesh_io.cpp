#include "transformesh/mesh_io.h"

#include "io/document/edge_element.h"
#include "io/document/writable.h"
#include "io/formats/detect_format.h"
#include "io/formats/file_format.h"
#include "io/formats/glb.h"
#include "io/formats/obj.h"
#include "io/formats/off.h"
#include "io/formats/pcd.h"
#include "io/formats/ply.h"
#include "io/formats/point_table.h"
#include "io/formats/point_text.h"
#include "io/formats/stl.h"
#include "io/formats/three_mf.h"
#include "io/formats/vtk.h"
#include "io/formats/vtp.h"
#include "io/formats/xyz.h"
#include "io/polygons/merge_polygons.h"
#include "io/streams/atomic_file.h"
#include "io/streams/expand.h"
#include "io/streams/streams.h"
#include "mesh/coordinate_spacing.h"
#include "support/counted.h"

namespace transformesh {
namespace {

/// Removes a UTF-8 byte order mark at the start of a file. A binary STL file stays unchanged: its
/// header is arbitrary text, which may start with these bytes.
std::string_view without_byte_order_mark(std::string_view bytes) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  const bool is_marked = bytes.starts_with(mark) && !is_binary_stl_by_size(bytes);
  return is_marked ? bytes.substr(mark.size()) : bytes;
}

ReadResult read_expanded(std::string_view bytes, const std::string& name,
                         const ReadOptions& options) {
  const Source source{without_byte_order_mark(bytes), name, options.strict, options.keep_polygons};
  switch (detect_format(source)) {
    case FileKind::ply:
      return read_ply(source);
    case FileKind::off:
      return read_off(source);
    case FileKind::obj:
      return read_obj(source);
    case FileKind::stl_ascii:
      return read_stl_text(source);
    case FileKind::gltf:
      return read_glb(source, options.folder);
    case FileKind::three_mf:
      return read_three_mf(source);
    case FileKind::vtk:
      return read_vtk(source);
    case FileKind::vtp:
      return read_vtp(source);
    case FileKind::pcd:
      return read_pcd(source);
    case FileKind::points:
      return read_point_text(source);
    case FileKind::point_table:
      return read_point_table(source);
    default:
      return read_stl_binary(source);
  }
}

ReadResult read_compressed(std::string_view bytes, const std::string& name,
                           const ReadOptions& options) {
  if (!is_gzip(bytes)) return read_expanded(bytes, name, options);
  const Expanded expanded = expand_gzip({bytes, name, options.strict});
  ReadResult result = read_expanded(expanded.bytes, name, options);
  if (expanded.rest > 0)
    result.notes.push_back("gzip: " + counted(expanded.rest, "byte") +
                           " after the compressed data ignored");
  return result;
}

/// Writes a mesh. For PLY, OFF and OBJ, `outlines` may be the polygons to write as faces
/// (MergedPolygons::outlines). If it is null, the triangles are written.
WriteResult write_format(const Document& document, const Column* outlines = nullptr) {
  check_writable(document);
  switch (document.style.format) {
    case Format::off:
      return write_off(document, outlines);
    case Format::obj:
      return write_obj(document, outlines);
    case Format::glb:
      check_float_range(document.mesh);
      return write_glb(document);
    case Format::vtp:
      if (document.style.coordinate == Scalar::float32) check_float_range(document.mesh);
      return write_vtp(document);
    case Format::three_mf:
      if (document.style.coordinate == Scalar::float32) check_float_range(document.mesh);
      return write_three_mf(document);
    case Format::xyz:
      return write_xyz(document);
    case Format::stl_ascii:
    case Format::stl_binary:
      check_float_range(document.mesh);
      return write_stl(document);
    default:
      if (document.style.coordinate == Scalar::float32) check_float_range(document.mesh);
      return write_ply(document, outlines);
  }
}

WriteResult write_polygons(const Document& document) {
  const Format format = document.style.format;
  const bool holds_polygons = is_ply(format) || format == Format::off || format == Format::obj;
  if (holds_polygons) {
    const MergedPolygons merged = merge_polygons(document);
    WriteResult result = write_format(merged.document, &merged.outlines);
    if (merged.unmerged > 0)
      result.notes.push_back(counted(merged.unmerged, "polygon") +
                             " written as triangles, because the outline is not a single loop");
    return result;
  }
  Document triangles = document;
  triangles.mesh.face_columns.erase(polygon_column);
  WriteResult result = write_format(triangles);
  if (format == Format::xyz) return result;  // write_xyz() notes that it drops the faces
  result.notes.push_back(std::string(name_of(format)) + ": " +
                         counted(count_polygons(document.mesh.face_columns).polygons, "polygon") +
                         " written as triangles");
  return result;
}

}  // namespace

ReadResult read_mesh(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  ReadResult result = read_compressed(bytes, name, options);
  result.document.style.keeps_polygons = options.keep_polygons;
  number_edges(result.document, result.notes);
  return result;
}

WriteResult write_mesh(const Document& document) {
  if (has_stale_edges(document)) {
    Document kept = document;
    std::vector<std::string> notes;
    drop_edges(kept, notes);
    WriteResult result = write_mesh(kept);
    result.notes.insert(result.notes.begin(), notes.begin(), notes.end());
    return result;
  }
  const Column* numbers = document.mesh.face_columns.find(polygon_column);
  const bool has_polygons = numbers != nullptr && !numbers->list_count_type;
  return document.style.keeps_polygons && has_polygons ? write_polygons(document)
                                                       : write_format(document);
}

Mesh read_mesh_file(const std::string& path) {
  const Bytes bytes = read_all(path);
  return read_mesh(bytes.view(), input_name(path), {.folder = input_folder(path)}).document.mesh;
}

void write_mesh_file(const std::string& path, const Mesh& mesh) {
  Document document;
  document.mesh = mesh;
  document.style.format = format_for(Format::ply_little, "", path);
  write_file(path, write_mesh(document).bytes);
}

}  // namespace transformesh
