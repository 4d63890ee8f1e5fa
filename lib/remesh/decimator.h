/// Collapses edges in the order of quadric errors, for decimate.h. Reference: Garland & Heckbert,
/// "Surface simplification using quadric error metrics", SIGGRAPH 1997. There are three departures.
/// Planes are not weighted by the areas of their faces. Collapses that would make the mesh
/// intersect itself are refused. If the best position of the merged vertex is refused, the middle
/// and the ends of the edge are tried.
#pragma once

#include <array>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "geometry/keep_out.h"
#include "remesh/guards/error_bound.h"
#include "remesh/halfedges/editable_mesh.h"
#include "remesh/halfedges/vertex_role.h"
#include "remesh/operations/quadric.h"
#include "transformesh/decimate.h"

namespace transformesh {

/// A closed surface has at least this many faces.
inline constexpr std::size_t least_faces = 4;

/// The quadric of a vertex uses positions relative to the vertex, so that squares stay small.
class Decimator {
 public:
  /// Keeps references to `progress` and the surface of `options.keep_out`. `error`: largest allowed
  /// distance from `mesh`.
  Decimator(const Mesh& mesh, const DecimateOptions& options, std::optional<double> error,
            const Progress& progress);

  DecimateResult run();
  Mesh to_mesh() const { return mesh_.to_mesh(); }

 private:
  /// A position to which an edge may be collapsed.
  struct Place {
    double cost;
    Vec3 position;
  };
  /// The positions for an edge by increasing cost.
  struct Places {
    std::array<Place, 4> by_cost;
    std::size_t count = 0;
    void add(double cost, const Vec3& position);
  };
  /// An entry of the queue.
  struct Candidate {
    double cost;
    Index halfedge;
    std::uint32_t version;  ///< sum of the versions of both ends
    std::uint32_t rank;     ///< index in Places::by_cost of the position to try
    bool operator<(const Candidate& other) const {
      return cost != other.cost ? cost > other.cost : halfedge > other.halfedge;
    }
  };

  void add_quadrics();
  void add_border(Index halfedge);
  std::size_t run_stage(std::size_t wanted, double longest);
  std::optional<Candidate> candidate(Index halfedge, std::uint32_t rank = 0) const;
  void fill_queue();
  bool is_current(const Candidate& candidate) const;
  Quadric sum_at_source(Index source, Index target) const;
  Places places(Index source, Index target) const;
  void push(Index halfedge, std::uint32_t rank = 0);
  void push_around(Index vertex);
  void merge(Index goes, Index stays, const Quadric& quadric, std::span<const Index> apexes);

  EditableMesh mesh_;
  std::size_t wanted_;
  std::optional<KeepOut> keep_out_;
  const Progress& progress_;
  double area_;
  std::size_t first_faces_;
  std::optional<VertexRoles> roles_;
  std::optional<ErrorBound> bound_;
  std::vector<Quadric> quadrics_;        ///< quadric of each vertex, relative to its position
  std::vector<std::uint32_t> versions_;  ///< grows whenever a vertex is merged into this one
  std::vector<Index> valences_;          ///< number of faces at each vertex
  std::priority_queue<Candidate> queue_;
  DecimateResult result_;
};

}  // namespace transformesh
