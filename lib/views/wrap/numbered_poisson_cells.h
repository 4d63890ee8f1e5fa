/// Cells with numbers for the Delaunay triangulation of CGAL's Poisson reconstruction.
///
/// CGAL's refinement keeps bad cells in a map that is ordered by cell handles. It compares the
/// handles by memory addresses, unless the cells have time stamps. On points of a sphere many
/// cells are equally bad, so that the result would depend on the addresses. This specialization
/// of CGAL's cell has a time stamp, which CGAL sets to a number in the order of creation.
/// Reference: Time_stamper.h and Compact_container.h of CGAL 5.5.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Poisson_reconstruction_function.h>

#include <cstddef>

namespace transformesh {

/// Geometric traits of the triangulation in CGAL::Poisson_reconstruction_function.
using PoissonTraits = CGAL::Reconstruction_triangulation_default_geom_traits_3<
    CGAL::Robust_circumcenter_filtered_traits_3<
        CGAL::Exact_predicates_inexact_constructions_kernel>>;

}  // namespace transformesh

template <typename Base>
class CGAL::Triangulation_cell_base_with_info_3<int, transformesh::PoissonTraits, Base>
    : public Base {
 public:
  using Vertex_handle = typename Base::Vertex_handle;
  using Cell_handle = typename Base::Cell_handle;
  using Info = int;
  using Has_timestamp = CGAL::Tag_true;

  template <typename Tds>
  struct Rebind_TDS {
    using Other =
        Triangulation_cell_base_with_info_3<int, transformesh::PoissonTraits,
                                            typename Base::template Rebind_TDS<Tds>::Other>;
  };

  using Base::Base;

  const Info& info() const { return info_; }
  Info& info() { return info_; }
  std::size_t time_stamp() const { return time_stamp_; }
  void set_time_stamp(std::size_t time_stamp) { time_stamp_ = time_stamp; }

 private:
  Info info_ = 0;
  std::size_t time_stamp_ = static_cast<std::size_t>(-1);
};
