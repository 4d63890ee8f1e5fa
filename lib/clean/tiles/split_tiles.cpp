#include "clean/tiles/split_tiles.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <optional>

#include "clean/box/box_part.h"
#include "clean/box/box_submesh.h"
#include "clean/box/tile.h"
#include "clean/tiles/tile_boxes.h"
#include "clean/tiles/tile_windings.h"
#include "io/streams/spilled_lists.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

/// Largest number of positions that are sampled to determine the boxes of tiles. A tenth of this
/// number is enough for 16 tiles: of a million faces, their numbers of faces differ by 0.1 %.
/// Thousands of tiles need about a hundred samples per tile.
constexpr std::size_t most_samples = 1000000;
/// Size of the output buffer, in bytes. A choice without influence on the result.
constexpr std::size_t buffer_bytes = std::size_t{1} << 20;
/// Number of rings of neighboring faces that a tile contains around the faces that belong to it.
constexpr Index rings = rings_of_complete + rings_around_complete;
/// Width of a cell of `coarse_grid_`, in cells of `grid_`. With 4 or 16, a folded surface of a
/// million faces gives the same tiles, and the time differs by less than a tenth.
constexpr double cells_per_coarse_cell = 8;
/// Number of faces between two reports of progress.
constexpr std::size_t faces_per_report = std::size_t{1} << 16;

class Splitter {
 public:
  Splitter(const PlyRows& rows, std::size_t count, std::string folder, const Progress& progress)
      : rows_(rows), count_(count), folder_(std::move(folder)), progress_(progress) {}
  SplitResult split();

 private:
  template <class Visit>
  void visit_faces(const char* phase, const Visit& visit) const;
  void choose_boxes();
  void mark_own();
  void add_ring(Index ring);
  Index owner_of(Cell cell);
  void find_cells(const Triangle& triangle);
  void mark(Index tile, Index ring);
  bool is_inside(const Triangle& triangle);
  void find_tiles(const Triangle& triangle, Index ring);
  void distribute(SpilledLists& lists);
  AtomicFile write(Index tile, const std::vector<Index>& faces);
  Tile describe(Index tile, const std::vector<Index>& faces) const;

  const PlyRows& rows_;
  const std::size_t count_;
  const std::string folder_;
  const Progress& progress_;
  CellSize cell_size_;
  CellGrid grid_{1}, coarse_grid_{1};
  double margin_ = 0;
  /// Fine grid cells with the tiles whose faces touch them; coarse cells around these fine cells.
  CellMarks marks_, coarse_marks_;
  std::vector<Cell> cells_;  ///< grid cells that the current face touches
  std::vector<Cell> coarse_cells_;
  /// For each of `cells_`: the tile whose own box (Tile::own) contains the cell, or no_index.
  std::vector<Index> cell_owners_;
  /// Tiles that get the current face (`found_`); tiles whose boxes touch the cell (`owners_`).
  std::vector<Index> found_, owners_;
  std::vector<Box> own_, held_;   ///< for each tile, the boxes Tile::own and Tile::held
  std::vector<char> has_faces_;   ///< 1 for each tile with own faces, which only this tile cleans
  std::optional<BoxGrid> boxes_;  ///< search structure for the boxes Tile::own of all tiles
  std::vector<ReferencePoint> references_;
  FaceSums sums_;
  SplitResult result_;
};

template <class Visit>
void Splitter::visit_faces(const char* phase, const Visit& visit) const {
  const std::size_t count = rows_.face_count();
  for (std::size_t f = 0; f < count; ++f) {
    if (f % faces_per_report == 0)
      progress_(phase, static_cast<double>(f) / static_cast<double>(count));
    visit(static_cast<Index>(f), rows_.triangle(rows_.face(f)));
  }
}

void Splitter::choose_boxes() {
  const std::size_t step = (rows_.face_count() + most_samples - 1) / most_samples;
  std::vector<Vec3> samples;
  visit_faces("bounds", [&](Index f, const Triangle& t) {
    cell_size_.add(t);
    sums_.add(t);
    if (f % step == 0) samples.push_back(t[0]);
  });
  if (!sums_.is_closed())
    throw InputError(ErrorKind::box_in_open_mesh,
                     "only a closed oriented mesh can be split into tiles, but some edges are not "
                     "traversed equally often in both directions");
  own_ = divide_space(std::move(samples), count_);
  grid_ = CellGrid(cell_size_.size());
  coarse_grid_ = CellGrid(cells_per_coarse_cell * cell_size_.size());
  margin_ = margin_around(cell_size_.bounds(), rows_.coordinate());
}

// Returns the tile whose box Tile::own contains a grid cell, or no_index. All cells in this box
// count as marked for the tile. Hence marks for the tile are stored only for cells outside its box.
Index Splitter::owner_of(Cell cell) {
  const Box box = grid_.box_around(cell);
  boxes_->find(box.min(), box.max(), owners_);
  return owners_.size() == 1 && has_faces_[owners_[0]] ? owners_[0] : no_index;
}

void Splitter::mark(Index tile, Index ring) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cell_owners_[i] == tile) continue;
    if (!marks_.add(cells_[i], tile, ring)) continue;
    const Box cell = grid_.box_around(cells_[i]);
    coarse_grid_.find({cell.min(), cell.max(), cell.min()}, 0, coarse_cells_);
    for (const Cell coarse : coarse_cells_) coarse_marks_.add(coarse, 0);
  }
}

// True if no tile needs the face except the one in whose box Tile::own it is. The reason is that
// the face is far from the boxes of other tiles and from all marked cells. This holds for most
// faces, so that their grid cells need not be computed.
bool Splitter::is_inside(const Triangle& t) {
  const Vec3 reach = Vec3::Constant(1.02 * grid_.size() + margin_);
  const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  boxes_->find(low - reach, high + reach, found_);
  if (found_.size() != 1 || !has_faces_[found_[0]]) return false;
  if ((high - low).maxCoeff() > coarse_grid_.size()) return false;
  coarse_grid_.find(t, margin_, coarse_cells_);
  return std::none_of(coarse_cells_.begin(), coarse_cells_.end(),
                      [&](Cell cell) { return coarse_marks_.has(cell); });
}

void Splitter::find_cells(const Triangle& triangle) {
  grid_.find(triangle, margin_, cells_);
  cell_owners_.clear();
  for (const Cell cell : cells_) cell_owners_.push_back(owner_of(cell));
}

void Splitter::mark_own() {
  boxes_.emplace(cell_size_.bounds(), own_);
  has_faces_.assign(count_, 1);
  held_.assign(count_, Box());
  std::vector<char> has_faces(count_, 0);
  visit_faces("own faces", [&](Index, const Triangle& t) {
    boxes_->find(t[0], t[0], found_);
    const auto tile = std::find_if(found_.begin(), found_.end(), [&](Index i) {
      return (t[0].array() < own_[i].max().array()).all();
    });
    const Index owner = *tile;
    has_faces[owner] = 1;
    held_[owner].extend(t[0]);
    if (is_inside(t)) return;
    find_cells(t);
    mark(owner, 0);
  });
  result_.empty_tiles = static_cast<std::size_t>(std::count(has_faces.begin(), has_faces.end(), 0));
  has_faces_ = std::move(has_faces);
}

// Finds the tiles that already have faces in the grid cells of a triangle. These tiles get the
// triangle, too, as a neighbor of their faces.
void Splitter::find_tiles(const Triangle& triangle, Index ring) {
  cells_.clear();
  if (is_inside(triangle)) return;
  find_cells(triangle);
  found_.clear();
  const auto add = [&](Index tile) {
    if (tile != no_index && std::find(found_.begin(), found_.end(), tile) == found_.end())
      found_.push_back(tile);
    return false;
  };
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    add(cell_owners_[i]);
    marks_.visit(cells_[i], ring, add);
  }
  std::sort(found_.begin(), found_.end());
}

// Adds to each tile one ring of faces: the faces that share a grid cell with a face of the tile.
void Splitter::add_ring(Index ring) {
  visit_faces("halos", [&](Index, const Triangle& t) {
    find_tiles(t, ring);
    for (const Index tile : found_) mark(tile, ring);
  });
}

void Splitter::distribute(SpilledLists& lists) {
  for (Box& box : held_)
    if (!box.isEmpty()) box = with_margin(box, rows_.coordinate());
  const BoxGrid boxes(cell_size_.bounds(), held_);
  TileWindings windings(held_);
  std::vector<Index> between;
  visit_faces("distribute", [&](Index f, const Triangle& t) {
    windings.add(t);
    find_tiles(t, rings);
    boxes.find(t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]), between);
    std::vector<Index> tiles;
    std::set_union(found_.begin(), found_.end(), between.begin(), between.end(),
                   std::back_inserter(tiles));
    for (const Index tile : tiles) lists.add(tile, f);
  });
  for (std::size_t tile = 0; tile < count_; ++tile) references_.push_back(windings.of_box(tile));
}

Tile Splitter::describe(Index tile, const std::vector<Index>& faces) const {
  FaceSums sums;
  for (const Index f : faces) sums.add(rows_.triangle(rows_.face(f)));
  return {{sums_.hash(), tile, count_},
          sums.hash(),
          own_[tile],
          held_[tile],
          references_[tile],
          grid_.size(),
          rows_.coordinate()};
}

AtomicFile Splitter::write(Index tile, const std::vector<Index>& faces) {
  std::vector<Index> vertices;
  for (const Index f : faces)
    for (const Index v : rows_.face(f)) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

  std::vector<std::string> comments = rows_.header().style.comments;
  drop_tile_comments(comments);
  comments.push_back(tile_comment(describe(tile, faces)));
  AtomicFile file(tile_path(folder_, tile, count_));
  std::string bytes =
      rows_.header_text(comments, vertices.size(), faces.size(), rows_.index_type());
  const auto flush = [&](std::size_t most) {
    if (bytes.size() < most) return;
    file.append(bytes);
    bytes.clear();
  };
  for (const Index v : vertices) {
    rows_.append_vertex(v, bytes);
    flush(buffer_bytes);
  }
  for (const Index f : faces) {
    Face face = rows_.face(f);
    for (Index& v : face)
      v = static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                             vertices.begin());
    rows_.append_face(f, face, rows_.index_type(), bytes);
    flush(buffer_bytes);
  }
  flush(0);
  file.finish();
  return file;
}

SplitResult Splitter::split() {
  result_.faces = rows_.face_count();
  if (result_.faces == 0) throw InputError("the mesh has no faces: there is nothing to split");
  choose_boxes();
  mark_own();
  for (Index ring = 1; ring < rings; ++ring) add_ring(ring);
  SpilledLists lists(folder_, count_);
  distribute(lists);
  for (Index tile = 0; tile < count_; ++tile) {
    progress_("write", static_cast<double>(tile) / static_cast<double>(count_));
    const std::vector<Index> faces = lists.read(tile);
    result_.tile_faces += faces.size();
    result_.largest_tile = std::max(result_.largest_tile, faces.size());
    result_.files.push_back(write(tile, faces));
  }
  return std::move(result_);
}

/// Returns the path of a numbered file. All numbers have as many digits as the number of the last
/// tile, so that a shell sorts the names by number.
std::string numbered(const std::string& folder, const std::string& stem, std::size_t number,
                     std::size_t count) {
  const std::string digits = std::to_string(number);
  const std::size_t width = std::to_string(count - 1).size();
  return folder + '/' + stem + '-' + std::string(width - digits.size(), '0') + digits + ".ply";
}

}  // namespace

SplitResult split_tiles(const PlyRows& rows, std::size_t count, const std::string& folder,
                        const Progress& progress) {
  make_folder(folder);
  remove_folder_at_signal(folder);
  try {
    return Splitter(rows, count, folder, progress).split();
  } catch (...) {
    std::error_code ignored;  // a folder that is not empty cannot be removed; this is not an error
    std::filesystem::remove(folder, ignored);
    throw;
  }
}

std::string tile_path(const std::string& folder, std::size_t number, std::size_t count) {
  return numbered(folder, "tile", number, count);
}

std::string cleaned_tile_path(const std::string& folder, std::size_t number, std::size_t count) {
  return numbered(folder, "clean", number, count);
}

}  // namespace transformesh
