"""Remedies for problems of the library, by their kinds. They name functions and arguments."""

_FAR_AWAY = (
    "for a shape that is small or far from the origin, move it there with transform(center=True)"
)

advice = {
    "not_closed": "close holes with fill()",
    "not_joined": "join them with stitch()",
    "not_oriented": "orient it with stitch(orient=True)",
    "not_orientable": "remove faces at this edge",
    "overlapping_sheets": "separate them with stitch()",
    "one_sided": (
        "cut it open with stitch() without orient, then close its borders with "
        "fill(allow_crossings=True)"
    ),
    "not_manifold": "orient it with stitch(orient=True)",
    "self_intersections": "remove self-intersections with clean()",
    "inside_out": "reverse it with stitch(flip=True)",
    "double_sided": "keep one side of a double-sided model with stitch(one_side=True)",
    "double_sided_sheet": "keep one side of a double-sided sheet, open, with stitch(one_side=True)",
    "canceling_faces": _FAR_AWAY,
    "no_area": _FAR_AWAY,
    "no_positive_winding": "if the mesh is inside out, reverse it with stitch(flip=True)",
    "component_too_small": "use a smaller min_edge",
    "thinner_than_rounding": _FAR_AWAY,
    "float_rounding_failed": "merge close vertices there with stitch(tolerance=LENGTH)",
    "double_rounding_failed": "merge close vertices there with stitch(tolerance=LENGTH)",
    "needs_cleaning": "leave out refuse to clean it",
    "box_in_open_mesh": (
        "close holes with fill(), or use clean() without box, which accepts open meshes"
    ),
    "static_test_of_open_mesh": "use method='grow', or close it with fill()",
    "decimation_stuck": (
        "ask for more faces, or use clean() first: edges near self-intersections are not "
        "collapsed"
    ),
    "meets_keep_out": (
        "enlarge that surface with offset(), and subtract it from the mesh with boolean()"
    ),
    "bad_reference_edge": "remove it from the mesh's comments",
    "no_velocity": "give velocities, normal_speed or curvature_speed",
    "no_source_points": "make them with source=True, or use the closest points with closest=True",
    "no_color_property": "name the property with color_by",
    "surface_vanished": "shorten the steps with max_move or time_step, or end earlier",
    "target_open": "close its holes first with fill()",
    "target_not_solid": (
        "the target is open, non-manifold or self-intersecting: clean() it, or fill() its holes"
    ),
    "source_apart": "begin with a source that overlaps all of the target",
    "edges_too_long": "begin with shorter edges",
    "uniform_edges_too_long": (
        "shorten edges at narrow places with gap_edges=1.5, or begin with shorter edges"
    ),
    "outside_hull": "check that cameras and mesh have the same units and origin, or see clip",
    "scene_behind_cameras": "mirror the scene with mirror=True",
    "views_disagree": "check cameras and masks, or accept less agreement with least_agreement",
    "few_views_disagree": (
        "check their cameras and masks, or leave these views out with drop_bad_views=True"
    ),
}
