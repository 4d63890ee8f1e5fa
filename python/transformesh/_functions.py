"""The functions: their signatures, defaults and documentation.

Each passes its arguments by name to the function of the same name in the compiled module.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, Optional, Tuple, TypedDict, Union

from . import _transformesh
from ._transformesh import Mesh

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Unpack

Length = Union[float, str]
Progress = Optional[Callable[[str, float], Optional[bool]]]
Smoothing = Union[float, Tuple[float, float], Literal["tangential", "none"]]
Path = Union[str, "PathLike[str]"]


class Steps(TypedDict, total=False):
    """The steps of transform(), in the order of the call."""

    translate: ArrayLike
    rotate: ArrayLike
    scale: float
    scale_axes: ArrayLike
    mirror: Union[Literal["x", "y", "z"], ArrayLike]
    matrix: ArrayLike
    center: bool
    unit_box: bool


def set_threads(count: int) -> None:
    """How many threads calls use; 0, the default, is one per core."""
    return _transformesh.set_threads(**locals())


def read(path: Path, *, strict: bool = False) -> Mesh:
    """Reads PLY, OFF, OBJ or STL, distinguished by the first bytes. What is changed on the way in,
    as polygons cut into triangles, is a warning. Values that are not finite and lines that the
    format does not have are left out with a warning; strict refuses them."""
    return _transformesh.read(**locals())


def parse(bytes: bytes, *, strict: bool = False) -> Mesh:
    """The mesh that a file of these bytes holds."""
    return _transformesh.parse(**locals())


def write(mesh: Mesh, path: Path, *, format: str = "", scalar: str = "") -> None:
    """Writes a file, complete or not at all. The name's ending decides on the format (.ply .off
    .obj .stl .glb .vtp .3mf .xyz) unless `format` does: ply, ply-ascii, ply-be, off, obj, stl,
    glb, vtp, 3mf, xyz; else it is that of the file read, or binary PLY. `scalar` is float or
    double."""
    return _transformesh.write(**locals())


def clean(
    mesh: Mesh,
    *,
    level: int = 1,
    outermost: bool = False,
    merge_flat: bool = False,
    method: Literal["grow", "static"] = "grow",
    separate: Length = 0.0,
    box: Optional[ArrayLike] = None,
    only: bool = False,
    refuse: bool = False,
    source: bool = False,
    source_face: bool = False,
    progress: Progress = None,
) -> Mesh:
    """Removes self-intersections: the boundary of the points with winding number at least `level`,
    exactly, closed, manifold, without a self-intersection in the numbers as written. 2 intersects two
    bodies. `outermost` drops cavities and what floats in them. `merge_flat` covers flat regions
    with few triangles where faces were cut. In a `box` ((x, y, z), (x, y, z)) what intersects
    there is resolved and all else left, or with `only` left out. `source` writes where on the
    input each vertex comes from, for carry(), `source_face` the input face of each face. See
    tm-clean(1)."""
    return _transformesh.clean(**locals())


def stitch(
    mesh: Mesh,
    *,
    tolerance: Length = 0.0,
    orient: bool = False,
    drop_copies: bool = False,
    one_side: bool = False,
    outwards: bool = False,
    flip: bool = False,
) -> Mesh:
    """Joins a soup of triangles into a manifold mesh; turns and reverses faces. See tm-stitch(1)."""
    return _transformesh.stitch(**locals())


def repair(
    mesh: Mesh,
    *,
    keep_open: bool = False,
    max_change: Optional[Length] = None,
    progress: Progress = None,
) -> Mesh:
    """Makes a solid from any mesh by the least change; the report has each step, its place, and how
    much area and volume changed. See tm-repair(1)."""
    return _transformesh.repair(**locals())


def cat(*meshes: Mesh) -> Mesh:
    """Concatenates meshes."""
    return _transformesh.cat(**locals())


def boolean(
    operation: Literal["union", "intersection", "difference", "xor", "cut"],
    *meshes: Mesh,
    inside: bool = False,
    cap: bool = False,
    merge_flat: bool = True,
    source_operand: bool = False,
    progress: Progress = None,
) -> Mesh:
    """Combines solids, each by its own winding number: 'union', 'intersection', 'difference',
    'xor', or 'cut' for the part of a sheet outside a solid, `inside` for that inside it, and
    `cap` to close it with faces of the solid. `source_operand` writes the number of the mesh
    that each face comes from. See tm-boolean(1)."""
    return _transformesh.boolean(**locals())


def remesh(
    mesh: Mesh,
    *,
    min_edge: Optional[Length] = None,
    max_edge: Optional[Length] = None,
    adaptive: Optional[Length] = None,
    size_field: str = "",
    iterations: int = 1,
    smooth: Optional[Smoothing] = None,
    flip: Optional[Literal["valence", "angle", "none"]] = None,
    only: Literal["all", "smooth"] = "all",
    feature_angle: Union[float, Literal["auto"]] = "auto",
    keep_border: bool = False,
    project: bool = False,
    curved: bool = False,
    min_film: Optional[Length] = None,
    pinch: Optional[Length] = None,
    align: Optional[Mesh] = None,
    keep_out: Optional[Mesh] = None,
    gap: Optional[Length] = None,
    source: bool = False,
    progress: Progress = None,
) -> Mesh:
    """Keeps edges between two lengths ('0.7x' to '1.5x' of the reference edge) and triangles
    round, without making a self-intersection. `smooth` is 'tangential', 'none', the factor of
    the Laplace-Beltrami operator, or two where it is used twice. With `curved` new vertices lie
    on curves and others stay, unless `smooth` is given. `min_film` keeps thicker films, `pinch`
    cuts necks and handles around which no longer loop goes. With `align` it moves vertices and
    turns edges onto the sharp edges of that mesh, which lies near, and does nothing else.
    Nothing comes nearer than `gap` to the mesh `keep_out`. `source` writes where on the input
    each vertex comes from, for carry(). See tm-remesh(1)."""
    return _transformesh.remesh(**locals())


def decimate(
    mesh: Mesh,
    faces: Optional[int] = None,
    *,
    error: Optional[Length] = None,
    feature_angle: float = 180.0,
    keep_border: bool = False,
    keep_out: Optional[Mesh] = None,
    gap: Optional[Length] = None,
    source: bool = False,
    progress: Progress = None,
) -> Mesh:
    """Collapses edges where the surface changes least until so many faces are left, without making
    a self-intersection. With `error` input and result stay that close to each other in both
    directions; without `faces` it goes on while they do. `keep_out`, `gap` and `source` are as
    of remesh(). See tm-remesh(1)."""
    return _transformesh.decimate(**locals())


def displace(
    mesh: Mesh,
    velocities: Optional[ArrayLike] = None,
    *,
    normal_speed: Optional[Length] = None,
    curvature_speed: float = 0.0,
    time_step: float = 1.0,
    alpha: float = 0.2,
    mask: str = "",
    keep_out: Optional[Mesh] = None,
    gap: Optional[Length] = None,
) -> Mesh:
    """Moves vertices by velocities (n, 3), or by the columns vx vy vz, by no more than alpha times
    the mean edge at each, and no nearer than `gap` to the mesh `keep_out`. `mask` is a column
    by which velocities are multiplied. See tm-displace(1)."""
    return _transformesh.displace(**locals())


def offset(
    mesh: Mesh,
    distance: Length,
    *,
    edge: Optional[Length] = None,
    iterations: int = 500,
    miter: bool = False,
    progress: Progress = None,
) -> Mesh:
    """The surface at a distance, outwards or inwards where negative; `miter` keeps corners sharp.
    See tm-offset(1)."""
    return _transformesh.offset(**locals())


def thicken(mesh: Mesh, thickness: Length, *, progress: Progress = None) -> Mesh:
    """A solid of that thickness around an open sheet. See --thicken of tm-offset(1)."""
    return _transformesh.thicken(**locals())


def cut(mesh: Mesh, plane: ArrayLike, *, cap: bool = False, progress: Progress = None) -> Mesh:
    """The part where a x + b y + c z >= d, of the plane (a, b, c, d); `cap` closes the cut of a
    closed mesh. See --plane of tm-select(1)."""
    return _transformesh.cut(**locals())


def section(mesh: Mesh, plane: ArrayLike) -> NDArray[np.float64]:
    """The segments in which faces meet the plane (a, b, c, d): an array (n, 2, 3) of their ends.
    See --section of tm-select(1)."""
    return _transformesh.section(**locals())


def fill(
    mesh: Mesh,
    *,
    max_edges: Optional[int] = None,
    max_diameter: Optional[Length] = None,
    refine: bool = True,
    fair: bool = True,
    allow_crossings: bool = False,
    progress: Progress = None,
) -> Mesh:
    """Closes holes with smooth patches that do not intersect the mesh, unless `allow_crossings` is
    true; the report has what stays open. See tm-fill(1)."""
    return _transformesh.fill(**locals())


def align(
    mesh: Mesh,
    reference: Mesh,
    *,
    samples: int = 3000,
    iterations: int = 200,
    progress: Progress = None,
) -> Mesh:
    """Turns and moves the mesh onto a reference that shows part of the same surface. The report
    has the matrix, the share of the mesh that overlaps, and its root mean square distance. See
    tm-align(1)."""
    return _transformesh.align(**locals())


def flow(
    mesh: Mesh,
    name: str,
    *,
    time: float = 0.0,
    span: float = 0.0,
    speed: float = 1.0,
    period: Optional[float] = None,
    center: Optional[Sequence[float]] = None,
    direction: Optional[Sequence[float]] = None,
    column: Optional[str] = None,
    grid: str = "",
    grid_step: float = 0.0,
    progress: Progress = None,
) -> Mesh:
    """The mesh with the velocities of a flow as its columns vx vy vz: 'deformation', 'mean-
    curvature' and others. `grid` names a file, a folder or a pattern. See tm-flow(1)."""
    return _transformesh.flow(**locals())


def handles(mesh: Mesh, *, max_length: Length = "5x", progress: Progress = None) -> Mesh:
    """Removes handles that a loop of at most this length goes around; the surface may intersect
    itself there, for clean(). See tm-handles(1)."""
    return _transformesh.handles(**locals())


def transform(mesh: Mesh, **steps: Unpack[Steps]) -> Mesh:
    """Moves, turns, scales and mirrors, in the order of the keywords: translate=(x, y, z),
    rotate=(x, y, z, degrees), scale=factor, scale_axes=(x, y, z), mirror='x' or (a, b, c, d),
    matrix=(4, 4) numbers, center=True, unit_box=True. The report has the matrix of all. See tm-
    transform(1)."""
    return _transformesh.transform(**locals())


def select(
    mesh: Mesh,
    *,
    largest: Optional[int] = None,
    at_least: float = 0.0,
    by: Literal["faces", "area", "volume"] = "faces",
    where: Union[str, ArrayLike, None] = None,
    box: Optional[ArrayLike] = None,
    around: Optional[ArrayLike] = None,
    invert: bool = False,
) -> Mesh:
    """The faces that meet all conditions: of the `largest` components or those `at_least` so
    large, `where` a property is such as 'label=2' or an array is true, in a `box` ((x, y, z),
    (x, y, z)), of the component `around` a point. See tm-select(1)."""
    return _transformesh.select(**locals())


def split(mesh: Mesh, *, by: Literal["faces", "area", "volume"] = "faces") -> list[Mesh]:
    """The components as a list of meshes, the largest by 'faces', 'area' or 'volume' first. See
    tm-select(1)."""
    return _transformesh.split(**locals())


def sample(
    mesh: Mesh,
    count: int = 0,
    *,
    distance: Optional[Length] = None,
    seed: int = 1,
    progress: Progress = None,
) -> Mesh:
    """Points with normals on the surface, `count` of them by area, or a Poisson disk of that
    `distance`. See tm-sample(1)."""
    return _transformesh.sample(**locals())


def carry(*meshes: Mesh, columns: Sequence[str] = (), closest: bool = False) -> Mesh:
    """Carries columns from the first mesh of a chain to the last: carry(first, between, ...,
    last), each made of the one before with source=True, or with `closest` near it. `columns`
    names those to carry; without, all but normals. See tm-carry(1)."""
    return _transformesh.carry(**locals())


def shape(kind: str, *parameters: object, **options: object) -> Mesh:
    """Makes a closed mesh: shape('genus', 3, faces=4000). See tm-shape(1)."""
    return _transformesh.shape(**locals())


def intersect(mesh: Mesh, *, progress: Progress = None) -> NDArray[np.uint32]:
    """The pairs of faces that intersect, as an array (k, 2)."""
    return _transformesh.intersect(**locals())


def info(mesh: Mesh) -> dict[str, Any]:
    """Counts, topology, sizes and quality, as tm-info and tm-checkmanifold report them."""
    return _transformesh.info(**locals())


def compare(
    mesh: Mesh,
    reference: Mesh,
    *,
    distance: Optional[float] = None,
    samples: int = 100000,
    seed: int = 1,
    progress: Progress = None,
) -> dict[str, float]:
    """Distances between a mesh and a reference. See tm-compare(1)."""
    return _transformesh.compare(**locals())


def certify(
    mesh: Mesh, input: Mesh, *, level: int = 1, progress: Progress = None
) -> dict[str, Any]:
    """Whether a mesh is the boundary of the points with winding number at least `level` in the
    input, by samples and by no code that computes such boundaries. See tm-checkmanifold(1)."""
    return _transformesh.certify(**locals())


def render(
    *meshes: Mesh,
    size: tuple[int, int] = (800, 600),
    orbit: tuple[float, float] = (30.0, 20.0),
    up: Literal["x", "y", "z"] = "y",
    zoom: float = 1.0,
    frame: Literal["each", "scale", "place"] = "each",
    around: Optional[Mesh] = None,
    views: int = 1,
    columns: int = 0,
    frames: int = 0,
    color: str = "",
    color_by: str = "",
    range: Optional[tuple[float, float]] = None,
    highlight: str = "",
    segments: Optional[ArrayLike] = None,
    background: str = "#f7f7f7,#d6d9de",
    crease_angle: float = 40.0,
    ambient_occlusion: bool = False,
    edges: bool = False,
    progress: Progress = None,
) -> NDArray[np.uint8]:
    """A picture of meshes side by side as an array (height, width, 4) of red, green, blue, alpha.
    `views` draws each mesh from so many sides, `frames` makes a movie around them, (frames,
    height, width, 4). `color_by` names a column that colors stand for, `range` the numbers at
    their ends; `segments` are lines (k, 2, 3). See tm-render(1)."""
    return _transformesh.render(**locals())


def report(
    *runs: Path,
    every: int = 1,
    title: str = "",
    color_by: str = "",
    up: Literal["x", "y", "z"] = "y",
    viewer: Optional[Path] = None,
    progress: Progress = None,
) -> bytes:
    """The bytes of an HTML page that shows runs, the folders that the loops' programs write with
    --run, in 3D and over time. `viewer` is the page that shows them, where it is not installed.
    See tm-report(1)."""
    return _transformesh.report(**locals())


def evolve(
    mesh: Mesh,
    velocity: Callable[[Mesh], ArrayLike],
    *,
    iterations: int = 100,
    time_step: float = 1.0,
    alpha: float = 0.2,
    min_edge: Length = "0.7x",
    max_edge: Length = "1.5x",
    smooth: Smoothing = 0.1,
    outermost: bool = True,
    until: Union[float, Literal["stalled"], None] = None,
    on_iteration: Optional[Callable[[str], object]] = None,
    progress: Progress = None,
) -> Mesh:
    """An evolution: vertices move along `velocity(mesh)`, an array (n, 3), self-intersections are
    removed, the surface is remeshed, again and again. `until` is a length, by which no vertex
    moves any more, or 'stalled'. A vertex moves by `time_step` times its velocity, but by no
    more than `alpha` times the mean edge at it: a warning, and `clamped_iterations` and
    `clamped_share` of the report, state where that is less. `smooth` 0.1 shrinks what is
    curved; 'none' and 'tangential' keep the volume. See tm-evolve(1)."""
    return _transformesh.evolve(**locals())


def evolve_in_time(
    mesh: Mesh,
    velocity: Callable[[Mesh, float], ArrayLike],
    time: float,
    *,
    time_step: Optional[float] = None,
    integrator: Literal["euler", "midpoint", "rk4"] = "midpoint",
    max_move: float = 0.5,
    tolerance: Optional[Length] = None,
    event_tolerance: Optional[float] = None,
    keep_volume: bool = False,
    min_edge: Length = "0.7x",
    max_edge: Length = "1.5x",
    smooth: Smoothing = "none",
    curved: bool = False,
    outermost: bool = True,
    events: bool = False,
    on_iteration: Optional[Callable[[str], object]] = None,
    progress: Progress = None,
) -> Mesh:
    """Evolves a surface from time 0 to `time` along `velocity(mesh, time)`, an array (n, 3). In a
    step all vertices move by the same span of time: `time_step`, or as long as no vertex moves
    farther than `max_move` of its own edges and, if `tolerance` is given, the local error is at
    most that length. `curved` remeshes on curves, which keeps smooth shapes. With `events`,
    `report['events']` is a list of the changes of topology: dicts of iteration, time, kind,
    place, size, and the volumes of the components before and after by their labels. Faces have
    these in the column component_label. See TIME and EVENTS in tm-evolve(1)."""
    return _transformesh.evolve_in_time(**locals())


def morph(
    source: Mesh,
    target: Mesh,
    *,
    iterations: int = 1000,
    alpha: float = 0.2,
    time_step: float = 1.0,
    distance: Literal["auto", "surface", "points", "vertex"] = "auto",
    min_edge: Length = "0.7x",
    max_edge: Length = "1.5x",
    smooth: Smoothing = 0.1,
    gap_edges: float = 0.0,
    features: Literal["auto", "on", "off"] = "auto",
    scales: int = 1,
    on_iteration: Optional[Callable[[str], object]] = None,
    progress: Progress = None,
) -> Mesh:
    """Evolves a surface until it lies on a target, a mesh or points. `features`, 'auto', 'on' or
    'off', says whether vertices and edges are aligned with the target's sharp edges at the end.
    See tm-morph(1)."""
    return _transformesh.morph(**locals())


def hull(
    cameras: Path,
    silhouettes: Path,
    *,
    resolution: int = 100,
    edge: Optional[float] = None,
    keep: Union[float, Literal["largest", "all"]] = "largest",
    box: Optional[ArrayLike] = None,
    least_agreement: float = 0.7,
    drop_bad_views: bool = False,
    mirror: bool = False,
    progress: Progress = None,
) -> Mesh:
    """The visual hull of calibrated silhouettes: files, folders or patterns. Views that disagree
    with the rest are refused, or with `drop_bad_views` left out, which is a warning;
    `least_agreement` 0 believes them. `mirror` is for cameras of a left-handed world. See tm-
    hull(1)."""
    return _transformesh.hull(**locals())


def reconstruct(
    cameras: Path,
    images: Path,
    silhouettes: Path = "",
    *,
    start: Optional[Mesh] = None,
    clip: Literal["hull", "nothing"] = "hull",
    silhouettes_show: Literal["exact", "least"] = "exact",
    edge: float = 3.0,
    last_edge: Optional[float] = None,
    coarsest: Optional[float] = None,
    passes: int = 4,
    iterations: Optional[int] = None,
    robust: float = 1.0,
    keep: Union[float, Literal["auto", "largest", "all"]] = "auto",
    hollows: Literal["auto", "closed"] = "auto",
    window: Union[int, Tuple[int, int]] = 3,
    max_angle: float = 50.0,
    crumbs: float = 0.001,
    handles: float = 5.0,
    box: Optional[ArrayLike] = None,
    least_agreement: float = 0.7,
    drop_bad_views: bool = False,
    mirror: bool = False,
    preview: bool = False,
    on_pass: Optional[Callable[[str], object]] = None,
    progress: Progress = None,
) -> Mesh:
    """Reconstructs a surface from calibrated photographs: files, folders or patterns. Views
    are checked as of hull(). What went wrong on the way, as a surface that exploded and was
    begun anew, is a warning; the report has the keys of the program's. See tm-reconstruct(1)."""
    return _transformesh.reconstruct(**locals())
