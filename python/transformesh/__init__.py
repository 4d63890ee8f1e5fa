"""Mesh evolution: exact removal of self-intersections, remeshing, morphing, reconstruction.

Meshes are `Mesh` objects whose numbers NumPy arrays show. Functions leave their arguments alone
and return new meshes; what they did is in `mesh.report`. Lengths are numbers in the units of the
mesh, or text as of the programs: '1%' of the box's diagonal, '0.7x' of the reference edge.
"""

from ._errors import Cancelled, Error, GoalError, InputError, OutputError, UsageError
from ._functions import (
    align,
    boolean,
    carry,
    cat,
    certify,
    clean,
    compare,
    cut,
    decimate,
    displace,
    evolve,
    evolve_in_time,
    fill,
    flow,
    handles,
    hull,
    info,
    intersect,
    morph,
    offset,
    parse,
    read,
    reconstruct,
    remesh,
    render,
    repair,
    report,
    sample,
    section,
    select,
    set_threads,
    shape,
    split,
    stitch,
    thicken,
    transform,
    write,
)
from ._transformesh import Columns, Mesh, __version__

__all__ = [name for name in dir() if not name.startswith("_")]
