#include "picture/line_drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <utility>

#include "mesh/edges.h"
#include "picture/panels.h"
#include "picture/visible_lines.h"
#include "support/elementary/trigonometric.h"
#include "support/number.h"
#include "support/parallel.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

constexpr std::size_t lines_per_task = 64;  ///< affects time only

/// Kinds of lines, in drawing order.
enum Kind : std::size_t { edge, crease, outline, segment };
constexpr std::size_t kinds = 4;  ///< number of the enumerators above
struct Pen {
  const char* name;
  const char* color;
  const char* width;
};
constexpr std::array<Pen, kinds> pens{{{"edges", "#000", "0.4"},
                                       {"creases", "#000", "0.8"},
                                       {"outlines", "#000", "1.2"},
                                       {"segments", "#d90d73", "1.2"}}};

struct Line {
  Vec3 from, to;
  Kind kind;
  std::vector<Index> own;  ///< incident faces, which do not hide the line
};

/// Coordinates in hundredths of a pixel, relative to the corner of the picture.
using Place = std::array<long, 2>;
using Piece = std::array<Place, 2>;

/// Classifies edges by their incident faces.
class EdgeKinds {
 public:
  EdgeKinds(const Mesh& mesh, Vec3 eye, double crease_angle_deg)
      : mesh_(mesh),
        eye_(std::move(eye)),
        flattest_(elementary::cos(crease_angle_deg * std::numbers::pi / 180)) {}

  Kind operator()(std::span<const Index> halfedges) const {
    if (halfedges.size() != 2) return outline;
    const Index f = halfedges[0] / 3;
    const Index g = halfedges[1] / 3;
    const bool is_oriented =
        halfedge_source(mesh_, halfedges[0]) != halfedge_source(mesh_, halfedges[1]);
    if ((is_front(f) == is_front(g)) != is_oriented) return outline;
    const double cosine = normal(f).dot(normal(g));
    return (is_oriented ? cosine : -cosine) < flattest_ ? crease : edge;
  }

 private:
  Vec3 normal(Index face) const { return face_normal(mesh_, face).stableNormalized(); }
  bool is_front(Index face) const {
    return normal(face).dot(eye_ - mesh_.positions[mesh_.faces[face][0]]) > 0;
  }

  const Mesh& mesh_;
  Vec3 eye_;
  double flattest_;
};

std::vector<Line> lines_of(const Panel& panel, const ShadeOptions& options) {
  const Mesh& mesh = *panel.mesh;
  const EdgeKinds kind_of(mesh, panel.camera.center(), options.crease_angle_deg);
  const Edges edges(mesh);
  std::vector<Line> lines;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const Index> halfedges = edges.halfedges(e);
    const Kind kind = kind_of(halfedges);
    if (kind == edge && !options.draw_edges) continue;
    Line& line = lines.emplace_back(Line{mesh.positions[halfedge_source(mesh, halfedges[0])],
                                         mesh.positions[halfedge_target(mesh, halfedges[0])],
                                         kind,
                                         {}});
    for (const Index halfedge : halfedges) line.own.push_back(halfedge / 3);
  }
  for (const auto& [from, to] : options.segments) lines.push_back({from, to, segment, {}});
  return lines;
}

Place place_of(const Panel& panel, const Line& line, double share) {
  const Vec3 q = panel.camera.project(line.from + share * (line.to - line.from));
  const auto hundredths = [&](double pixel, int corner, int size) {
    return std::lround(100 * (std::clamp(pixel + 0.5, 0.0, static_cast<double>(size)) + corner));
  };
  return {hundredths(q.x() / q.z(), panel.x, panel.camera.width),
          hundredths(q.y() / q.z(), panel.y, panel.camera.height)};
}

/// Returns the visible pieces of each line. Pieces shorter than the output precision are dropped.
std::vector<std::vector<Piece>> visible_pieces(const Panel& panel, const std::vector<Line>& lines) {
  const VisibleLines visible(*panel.mesh, panel.camera);
  std::vector<std::vector<Piece>> pieces(lines.size());
  parallel_for(lines.size(), lines_per_task, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      for (const auto& [from, to] : visible.parts(lines[i].from, lines[i].to, lines[i].own)) {
        const Piece piece{place_of(panel, lines[i], from), place_of(panel, lines[i], to)};
        if (piece[0] != piece[1]) pieces[i].push_back(piece);
      }
  });
  return pieces;
}

/// Joins pieces into chains. Each end is extended by the first unused piece that begins there.
class Chains {
 public:
  explicit Chains(const std::vector<Piece>& pieces) : pieces_(pieces), is_taken_(pieces.size()) {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (const Place& end : pieces[i]) at_[end].push_back(i);
  }

  std::vector<std::vector<Place>> join() {
    std::vector<std::vector<Place>> chains;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (is_taken_[i]) continue;
      is_taken_[i] = true;
      std::vector<Place> chain{pieces_[i][1], pieces_[i][0]};
      extend(chain);
      std::reverse(chain.begin(), chain.end());
      extend(chain);
      chains.push_back(std::move(chain));
    }
    return chains;
  }

 private:
  void extend(std::vector<Place>& chain) {
    while (true) {
      const std::vector<std::size_t>& here = at_[chain.back()];
      const auto next = std::find_if(here.begin(), here.end(),
                                     [&](std::size_t piece) { return !is_taken_[piece]; });
      if (next == here.end()) return;
      is_taken_[*next] = true;
      const Piece& piece = pieces_[*next];
      chain.push_back(piece[0] == chain.back() ? piece[1] : piece[0]);
    }
  }

  const std::vector<Piece>& pieces_;
  std::vector<char> is_taken_;
  std::map<Place, std::vector<std::size_t>> at_;
};

std::string pixels(long hundredths) { return fixed(static_cast<double>(hundredths) / 100, 2); }

std::string path_of(const std::vector<Piece>& pieces, const Pen& pen) {
  if (pieces.empty()) return "";
  std::string path = "<path class=\"";
  path.append(pen.name).append(R"(" stroke=")").append(pen.color);
  path.append(R"(" stroke-width=")").append(pen.width).append(R"(" d=")");
  for (const std::vector<Place>& chain : Chains(pieces).join())
    for (std::size_t i = 0; i < chain.size(); ++i) {
      path.append(i == 0 ? "M" : i == 1 ? "L" : " ");
      path.append(pixels(chain[i][0])).append(" ").append(pixels(chain[i][1]));
    }
  return path + "\"/>\n";
}

std::string group_of(const Panel& panel, const ShadeOptions& options) {
  const std::vector<Line> lines = lines_of(panel, options);
  const std::vector<std::vector<Piece>> visible = visible_pieces(panel, lines);
  std::array<std::vector<Piece>, kinds> pieces;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<Piece>& of_kind = pieces[lines[i].kind];
    of_kind.insert(of_kind.end(), visible[i].begin(), visible[i].end());
  }
  std::string group = "<g>\n";
  for (std::size_t kind = 0; kind < kinds; ++kind) group += path_of(pieces[kind], pens[kind]);
  return group + "</g>\n";
}

}  // namespace

std::string draw_lines(std::span<const Mesh* const> meshes, const PictureOptions& options,
                       const Progress& progress) {
  const std::vector<Panel> panels = lay_out(meshes, options, 0);
  const std::string width = std::to_string(options.width);
  const std::string height = std::to_string(options.height);
  std::string svg = R"(<svg xmlns="http://www.w3.org/2000/svg" width=")";
  svg.append(width).append(R"(" height=")").append(height);
  svg.append(R"(" viewBox="0 0 )").append(width).append(" ").append(height);
  svg += "\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    progress("draw", static_cast<double>(i) / static_cast<double>(panels.size()));
    svg += group_of(panels[i], options.shade);
  }
  return svg + "</svg>\n";
}

}  // namespace transformesh
