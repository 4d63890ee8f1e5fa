#include "clean/tiles/join_tiles.h"

#include <filesystem>

#include "clean/box/tile.h"
#include "clean/tiles/seams.h"
#include "clean/tiles/split_tiles.h"
#include "io/document/scalar.h"
#include "io/formats/ply_rows.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

namespace fs = std::filesystem;

/// Size of the output buffer, in bytes. A choice without influence on the result.
constexpr std::size_t bytes_per_write = std::size_t{1} << 20;

std::string path_in_quotes(const std::string& path) { return "'" + path + "'"; }

/// Returns the hash of the split mesh and the number of its tiles. They are read from the comment
/// of the first tile file found in the folder.
TileName find_split(const std::string& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".ply") && name.starts_with("tile-"))
      if (const auto tile = tile_of(PlyRows(entry.path()).header().style.comments))
        return tile->name;
    if (name.ends_with(".ply") && name.starts_with("clean-"))
      if (const auto cleaned = cleaned_tile_of(PlyRows(entry.path()).header().style.comments))
        return *cleaned;
  }
  if (error) throw InputError(folder + ": cannot be read: " + error.message());
  throw InputError("the folder " + path_in_quotes(folder) + " has no tiles");
}

bool have_same_properties(const PlyElement& a, const PlyElement& b) {
  const auto is_same = [](const PlyProperty& p, const PlyProperty& q) {
    return p.name == q.name && p.count_type == q.count_type &&
           // Accept different types of corner indices, because the indices of the result get their
           // own type.
           (p.count_type || p.type == q.type);
  };
  return std::equal(a.properties.begin(), a.properties.end(), b.properties.begin(),
                    b.properties.end(), is_same);
}

class Joiner {
 public:
  Joiner(const std::string& folder, AtomicFile& file, const Progress& progress)
      : folder_(folder), split_(find_split(folder)), file_(file), progress_(progress) {}
  JoinResult join(const std::string& comment);

 private:
  PlyRows open(std::size_t tile) const;
  void read_seams();
  void write_header(const std::string& comment);
  void write_vertices(std::size_t tile);
  void write_faces(std::size_t tile);
  void flush(std::size_t most);
  void report(const char* phase, std::size_t tile) const {
    progress_(phase, static_cast<double>(tile) / static_cast<double>(split_.count));
  }

  const std::string folder_;
  const TileName split_;
  AtomicFile& file_;
  const Progress& progress_;
  Seams seams_;
  Scalar index_type_ = Scalar::int32;
  std::string bytes_;
  JoinResult result_;
};

PlyRows Joiner::open(std::size_t tile) const {
  const std::string path = cleaned_tile_path(folder_, tile, split_.count);
  if (!fs::exists(path))
    throw InputError("tile " + std::to_string(tile) + " of " + std::to_string(split_.count) +
                     " has not been cleaned: " + path_in_quotes(path) + " is missing");
  return PlyRows(path);
}

void Joiner::read_seams() {
  const PlyRows first = open(0);
  std::size_t vertices = 0;
  for (std::size_t tile = 0; tile < split_.count; ++tile) {
    report("seams", tile);
    const PlyRows rows = open(tile);
    const std::string path = cleaned_tile_path(folder_, tile, split_.count);
    if (cleaned_tile_of(rows.header().style.comments) != TileName{split_.mesh, tile, split_.count})
      throw InputError(path_in_quotes(path) + " does not hold clean faces of tile " +
                       std::to_string(tile) + " of the same mesh as the other tiles");
    if (!have_same_properties(rows.vertex_element(), first.vertex_element()) ||
        !have_same_properties(rows.face_element(), first.face_element()) ||
        rows.header().style.format != first.header().style.format)
      throw InputError(path_in_quotes(path) + " does not have the properties of the first tile");
    std::vector<Face> faces(rows.face_count());
    for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = rows.face(f);
    seams_.add(faces, rows.vertex_count(), [&](Index v) { return rows.position(v); });
    vertices += rows.vertex_count();
    result_.faces += faces.size();
  }
  if (const std::size_t left = seams_.join(); left > 0)
    throw InputError("the tiles leave " + counted(left, "edge") + " open: they were not all " +
                     "cleaned with the same options");
  if (result_.faces == 0)
    throw GoalError("no tile has a face after cleaning: the joined mesh would be empty");
  result_.tiles = split_.count;
  result_.vertices = seams_.vertex_count();
  result_.joined_vertices = vertices - result_.vertices;
}

void Joiner::flush(std::size_t most) {
  if (bytes_.size() < most) return;
  file_.append(bytes_);
  bytes_.clear();
}

void Joiner::write_header(const std::string& comment) {
  const PlyRows first = open(0);
  std::vector<std::string> comments = first.header().style.comments;
  drop_tile_comments(comments);
  comments.push_back(comment);
  index_type_ = widened(first.index_type(), result_.vertices);
  bytes_ = first.header_text(comments, result_.vertices, result_.faces, index_type_);
}

void Joiner::write_vertices(std::size_t tile) {
  report("vertices", tile);
  const PlyRows rows = open(tile);
  const std::vector<bool> is_repeated = seams_.is_repeated(tile);
  for (std::size_t v = 0; v < is_repeated.size(); ++v) {
    if (!is_repeated[v]) rows.append_vertex(v, bytes_);
    flush(bytes_per_write);
  }
}

void Joiner::write_faces(std::size_t tile) {
  report("faces", tile);
  const PlyRows rows = open(tile);
  const std::vector<Index> numbers = seams_.numbers_of(tile);
  for (std::size_t f = 0; f < rows.face_count(); ++f) {
    Face face = rows.face(f);
    for (Index& v : face) v = numbers[v];
    rows.append_face(f, face, index_type_, bytes_);
    flush(bytes_per_write);
  }
}

JoinResult Joiner::join(const std::string& comment) {
  read_seams();
  write_header(comment);
  for (std::size_t tile = 0; tile < split_.count; ++tile) write_vertices(tile);
  for (std::size_t tile = 0; tile < split_.count; ++tile) write_faces(tile);
  flush(0);
  file_.finish();
  return result_;
}

}  // namespace

JoinResult join_tiles(const std::string& folder, const std::string& comment, AtomicFile& file,
                      const Progress& progress) {
  return Joiner(folder, file, progress).join(comment);
}

}  // namespace transformesh
