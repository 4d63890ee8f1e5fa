from __future__ import annotations

from collections.abc import Callable, Iterator, MutableMapping, Sequence
from os import PathLike
from typing import Any, Literal, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

Length = Union[float, str]
Progress = Optional[Callable[[str, float], Optional[bool]]]
Smoothing = Union[float, tuple[float, float], Literal["tangential", "none"]]
Path = Union[str, PathLike[str]]

class Error(Exception):
    kind: str  # such as "not_oriented"; "other" if no kind fits
    data: dict[str, Any]  # facts of the message: faces, edge, position, counts, lengths, name
class UsageError(Error, ValueError): ...
class InputError(Error, ValueError): ...
class GoalError(Error, RuntimeError): ...
class OutputError(Error, OSError): ...
class Cancelled(Error, RuntimeError): ...

class Columns(MutableMapping[str, NDArray[Any]]):
    def __getitem__(self, name: str) -> NDArray[Any]: ...
    def __setitem__(self, name: str, values: ArrayLike) -> None: ...
    def __delitem__(self, name: str) -> None: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[str]: ...

class Mesh:
    comments: list[str]
    report: dict[str, Any]
    def __init__(self, positions: ArrayLike, faces: Optional[ArrayLike] = None) -> None: ...
    @property
    def positions(self) -> NDArray[np.float64]: ...
    @property
    def faces(self) -> NDArray[np.uint32]: ...
    @property
    def vertex_columns(self) -> Columns: ...
    @property
    def face_columns(self) -> Columns: ...
    def copy(self) -> Mesh: ...
    def to_bytes(self, format: str = "", scalar: str = "") -> bytes: ...

def set_threads(count: int) -> None: ...
def read(path: Path, *, strict: bool = False) -> Mesh: ...
def parse(bytes: bytes, *, strict: bool = False) -> Mesh: ...
def write(mesh: Mesh, path: Path, *, format: str = "", scalar: str = "") -> None: ...
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
) -> Mesh: ...
def stitch(
    mesh: Mesh,
    *,
    tolerance: Length = 0.0,
    orient: bool = False,
    drop_copies: bool = False,
    one_side: bool = False,
    outwards: bool = False,
    flip: bool = False,
) -> Mesh: ...
def repair(
    mesh: Mesh,
    *,
    keep_open: bool = False,
    max_change: Optional[Length] = None,
    progress: Progress = None,
) -> Mesh: ...
def cat(*meshes: Mesh) -> Mesh: ...
def boolean(
    operation: Literal["union", "intersection", "difference", "xor", "cut"],
    *meshes: Mesh,
    inside: bool = False,
    cap: bool = False,
    merge_flat: bool = True,
    source_operand: bool = False,
    progress: Progress = None,
) -> Mesh: ...
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
) -> Mesh: ...
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
) -> Mesh: ...
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
) -> Mesh: ...
def offset(
    mesh: Mesh,
    distance: Length,
    *,
    edge: Optional[Length] = None,
    iterations: int = 500,
    miter: bool = False,
    progress: Progress = None,
) -> Mesh: ...
def thicken(mesh: Mesh, thickness: Length, *, progress: Progress = None) -> Mesh: ...
def cut(mesh: Mesh, plane: ArrayLike, *, cap: bool = False, progress: Progress = None) -> Mesh: ...
def section(mesh: Mesh, plane: ArrayLike) -> NDArray[np.float64]: ...
def fill(
    mesh: Mesh,
    *,
    max_edges: Optional[int] = None,
    max_diameter: Optional[Length] = None,
    refine: bool = True,
    fair: bool = True,
    allow_crossings: bool = False,
    progress: Progress = None,
) -> Mesh: ...
def align(
    mesh: Mesh,
    reference: Mesh,
    *,
    samples: int = 3000,
    iterations: int = 200,
    progress: Progress = None,
) -> Mesh: ...
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
) -> Mesh: ...
def handles(mesh: Mesh, *, max_length: Length = "5x", progress: Progress = None) -> Mesh: ...
def transform(
    mesh: Mesh,
    *,
    translate: Optional[ArrayLike] = None,
    rotate: Optional[ArrayLike] = None,
    scale: Optional[float] = None,
    scale_axes: Optional[ArrayLike] = None,
    mirror: Union[Literal["x", "y", "z"], ArrayLike, None] = None,
    matrix: Optional[ArrayLike] = None,
    center: bool = False,
    unit_box: bool = False,
) -> Mesh: ...
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
) -> Mesh: ...
def split(mesh: Mesh, *, by: Literal["faces", "area", "volume"] = "faces") -> list[Mesh]: ...
def sample(
    mesh: Mesh,
    count: int = 0,
    *,
    distance: Optional[Length] = None,
    seed: int = 1,
    progress: Progress = None,
) -> Mesh: ...
def carry(*meshes: Mesh, columns: Sequence[str] = (), closest: bool = False) -> Mesh: ...
def shape(kind: str, *parameters: object, **options: object) -> Mesh: ...
def intersect(mesh: Mesh, *, progress: Progress = None) -> NDArray[np.uint32]: ...
def info(mesh: Mesh) -> dict[str, Any]: ...
def compare(
    mesh: Mesh,
    reference: Mesh,
    *,
    distance: Optional[float] = None,
    samples: int = 100000,
    seed: int = 1,
    progress: Progress = None,
) -> dict[str, float]: ...
def certify(
    mesh: Mesh, input: Mesh, *, level: int = 1, progress: Progress = None
) -> dict[str, Any]: ...
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
) -> NDArray[np.uint8]: ...
def report(
    *runs: Path,
    every: int = 1,
    title: str = "",
    color_by: str = "",
    up: Literal["x", "y", "z"] = "y",
    viewer: Optional[Path] = None,
    progress: Progress = None,
) -> bytes: ...
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
) -> Mesh: ...
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
) -> Mesh: ...
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
) -> Mesh: ...
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
) -> Mesh: ...
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
) -> Mesh: ...
