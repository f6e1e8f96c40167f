"""The categories of test drawings: which object, lines and medium go together under one name."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from synthetic.scenes import Wish


@dataclass(frozen=True)
class Recipe:
    """A category.

    wish    : the object
    media   : names in `media.MEDIA`, taken in turn
    marks   : "none", or the names in `marks.MARKS` to pick from ("shading" and "cut" as well)
    objects : objects on the sheet (least, most); (0, 0) is a negative
    nuisances: names in `nuisances.NUISANCES`; of several, each drawing has two or three
    crop    : a corner or an edge is cut off by the border
    curved  : kinds in `turned_scenes.KINDS`, taken in turn; () for prisms
    subjects: of a negative, names in `negatives.NEGATIVES` and the like, taken in turn; () for all of `NEGATIVES`
    """

    wish: Wish = field(default_factory=Wish)
    media: tuple[str, ...] = ("clean",)
    marks: tuple[str, ...] = ()
    objects: tuple[int, int] = (1, 1)
    nuisances: tuple[str, ...] = ()
    crop: bool = False
    curved: tuple[str, ...] = ()
    subjects: tuple[str, ...] = ()


OBLIQUE, AXONO, PERSP = ("oblique",), ("axonometric",), ("perspective",)
PARALLEL = ("oblique", "axonometric")
UPRIGHT = ("upright", "upright", "axonometric", "oblique")
ALL = ("oblique", "axonometric", "perspective")
LABELS = ("letters", "dimensions", "front", "right_angles", "ticks", "caption")


def _each_way() -> dict[str, Recipe]:
    """Clean drawings: three kinds of hidden line times three kinds of projection."""
    out = {}
    for lines in ("wire", "dashed", "removed"):
        for name, views in (("oblique", OBLIQUE), ("axono", AXONO), ("persp", PERSP)):
            out[f"clean_{lines}_{name}"] = Recipe(Wish(views, lines=lines))
    return out


def _each_medium() -> dict[str, Recipe]:
    """Each medium with each kind of hidden line."""
    out = {}
    media = (
        *("thin", "marker", "icon", "hand", "handheavy", "pencil", "pen", "coloured", "blueprint", "blackboard"),
        *("dark", "transparent", "scan", "photo", "grid", "ruled", "isodots", "noisy", "lowres", "large", "jpeg"),
    )
    for medium in media:
        for lines in ("wire", "dashed", "removed"):
            broad = medium in ("marker", "icon", "lowres", "blackboard", "handheavy")
            shapes = "convex" if medium == "icon" else "everyday"
            if medium == "thin" and lines == "dashed":
                continue
            out[f"{medium}_{lines}"] = Recipe(Wish(PARALLEL if broad else ALL, shapes, lines), (medium,))
    return out


def _foreign_ink() -> dict[str, Recipe]:
    """What lies on and around the objects of real drawings, one nuisance at a time and mixed."""
    media = ("clean", "hand", "clean", "pen", "photo", "clean", "pencil", "thin", "scan", "jpeg")
    names: dict[str, tuple[str, ...]] = {
        **{"arrows": ("arrows",), "callouts": ("callouts",), "words": ("words",), "dimensioned": ("dimensioned",)},
        **{"auxiliary": ("auxiliary",), "vertexdots": ("vertex_dots",), "runon": ("run_on",), "beside": ("beside",)},
        "hatched": ("hatched",),
    }
    names["mixed"] = tuple(chosen[0] for name, chosen in names.items() if name != "hatched")
    return {
        f"{name}_{lines}": Recipe(Wish(PARALLEL, lines=lines), media, nuisances=nuisances)
        for name, nuisances in names.items()
        for lines in ("wire", "dashed", "removed")
    }


def _missing_ink() -> dict[str, Recipe]:
    """Gaps at the corners, cut by the border, faces without outlines; small, shallow, thick and sloppy drawings."""
    out = {}
    for lines in ("wire", "dashed", "removed"):
        plain = Wish(PARALLEL, lines=lines)
        out[f"gaps_{lines}"] = Recipe(plain, ("gappy",))
        out[f"cropped_{lines}"] = Recipe(plain, ("clean", "hand", "clean", "pen", "thin"), crop=True)
        out[f"shallow_{lines}"] = Recipe(replace(plain, shallow=True, room=0.5), ("clean", "jpeg", "dark", "thin"))
        out[f"tiny_{lines}"] = Recipe(Wish(AXONO, lines=lines, fine=True, room=0.36), ("cad",))
        out[f"thick_{lines}"] = Recipe(Wish(PARALLEL, "convex", lines, room=0.75), ("thick",))
        out[f"sloppy_{lines}"] = Recipe(plain, ("sloppy",))
        out[f"pressed_{lines}"] = Recipe(plain, ("pressed",))
        out[f"shade_{lines}"] = Recipe(plain, ("shade",))
    opaque = Wish(PARALLEL, lines="removed")
    out["filled_outlined"] = Recipe(opaque, ("clean", "hand", "coloured", "dark", "jpeg"), nuisances=("filled",))
    out["filled_bare"] = Recipe(opaque, ("clean", "jpeg", "dark", "clean", "shade"), nuisances=("bare",))
    for lines in ("wire", "dashed"):
        out[f"tinted_{lines}"] = Recipe(
            Wish(PARALLEL, lines=lines), ("clean", "coloured", "hand"), nuisances=("tinted",)
        )
    return out


def _curved_and_pointed() -> dict[str, Recipe]:
    """Arcs in the profile, round holes, cones, pyramids: each kind in each style, by ruler, by hand and annotated."""
    kinds = {
        **{"cylinder": ("cylinder",), "tube": ("tube",), "plate": ("plate",), "arcs": ("mixed",)},
        **{"cone": ("cone",), "frustum": ("frustum",), "pyramid": ("pyramid",)},
    }
    media = ("clean", "clean", "hand", "thin", "blueprint", "jpeg", "pen", "photo")
    every = tuple(k for chosen in kinds.values() for k in chosen)
    out = {}
    for lines in ("wire", "dashed", "removed"):
        for name, chosen in kinds.items():
            out[f"{name}_{lines}"] = Recipe(Wish(UPRIGHT, lines=lines), media, curved=chosen)
        out[f"curved_persp_{lines}"] = Recipe(Wish(PERSP, lines=lines), media, curved=every)
        out[f"curved_below_{lines}"] = Recipe(Wish(("below",), lines=lines), media, curved=every)
    annotated = ("clean", "pen", "textbook", "blueprint")
    out["curved_annotated"] = Recipe(Wish(UPRIGHT, lines="dashed"), annotated, curved=every, marks=("exercise",))
    out["curved_sketch"] = Recipe(Wish(UPRIGHT, lines="dashed"), ("pencil", "sloppy", "pen", "scan"), curved=every)
    return out


def _upright() -> dict[str, Recipe]:
    """Prisms that stand on a face, seen from above."""
    media = ("clean", "hand", "clean", "pencil", "photo")
    return {f"upright_{k}": Recipe(Wish(("upright",), lines=k), media) for k in ("wire", "dashed", "removed")}


def _no_objects() -> dict[str, Recipe]:
    """Flat figures, sheets of views, nets, tables, text, and solids of other kinds."""
    media = ("clean", "hand", "clean", "scan", "pen", "thin", "photo", "clean", "pencil", "jpeg")
    subjects = {
        "flat": ("rectangles", "triangles", "quadrilaterals", "circles_and_lines", "similar", "nested_squares"),
        "diagonals": ("diagonals",),
        "graphs": ("function_graph",),
        "tables": ("numbers_table", "board"),
        "nets": ("cube_net", "box_net", "prism_net"),
        "views": ("view_sheet",),
        "faces": ("single_face",),
        "texts": ("formulas", "words", "page_of_text"),
        "others": (
            *("drawn_sphere", "stepped_shaft", "stacked_blocks", "torus", "bolt", "bottle", "cup", "cubes"),
            "polyhedron",
        ),
    }
    return {f"no_{name}": Recipe(media=media, objects=(0, 0), subjects=chosen) for name, chosen in subjects.items()}


RECIPES: dict[str, Recipe] = {
    **_each_way(),
    **_each_medium(),
    "taper_wire": Recipe(Wish(PARALLEL, taper=True)),
    "taper_dashed": Recipe(Wish(PARALLEL, lines="dashed", taper=True)),
    "taper_removed": Recipe(Wish(PARALLEL, lines="removed", taper=True)),
    "taper_hand": Recipe(Wish(PARALLEL, taper=True), ("hand",)),
    "holes_wire": Recipe(Wish(PARALLEL, "convex", holes=2)),
    "holes_dashed": Recipe(Wish(PARALLEL, "convex", "dashed", holes=1)),
    "holes_removed": Recipe(Wish(PARALLEL, "convex", "removed", holes=1)),
    "holes_hand": Recipe(Wish(PARALLEL, "convex", holes=1), ("hand",)),
    "many_vertices": Recipe(Wish(PARALLEL, "large")),
    "many_removed": Recipe(Wish(PARALLEL, "large", "removed")),
    "many_persp": Recipe(Wish(PERSP, "large")),
    "accident_cube": Recipe(Wish(AXONO, accident="isometric_cube")),
    "accident_vertex": Recipe(Wish(OBLIQUE, accident="vertex_on_edge")),
    "accident_collinear": Recipe(Wish(OBLIQUE, accident="collinear")),
    "accident_parallel": Recipe(Wish(OBLIQUE, accident="parallel")),
    "accident_coincident": Recipe(Wish(OBLIQUE, accident="coincident")),
    "rounded_wire": Recipe(Wish(PARALLEL), ("rounded",)),
    "multi_wire": Recipe(Wish(ALL), objects=(2, 4)),
    "multi_removed": Recipe(Wish(PARALLEL, lines="removed"), objects=(2, 4)),
    "multi_hand": Recipe(Wish(PARALLEL), ("hand",), objects=(2, 3)),
    "letters": Recipe(Wish(ALL), marks=("letters",)),
    "annotated_wire": Recipe(Wish(PARALLEL), marks=LABELS),
    "annotated_dashed": Recipe(Wish(PARALLEL, lines="dashed"), marks=LABELS),
    "annotated_removed": Recipe(Wish(PARALLEL, lines="removed"), marks=LABELS),
    "annotated_hand": Recipe(Wish(PARALLEL, lines="removed"), ("pen",), marks=LABELS),
    "shaded_wire": Recipe(Wish(PARALLEL), marks=("shading",)),
    "shaded_removed": Recipe(Wish(ALL, lines="removed"), marks=("shading",)),
    "shaded_dashed": Recipe(Wish(PARALLEL, lines="dashed"), ("clean", "coloured"), marks=("shading",)),
    "tablet_wire": Recipe(Wish(PARALLEL, "convex"), ("tablet",)),
    "tablet_removed": Recipe(Wish(PARALLEL, "convex", "removed"), ("tablet",)),
    "textbook_wire": Recipe(Wish(PARALLEL, "convex"), ("textbook",)),
    "textbook_dashed": Recipe(Wish(PARALLEL, "convex", "dashed"), ("textbook",)),
    "textbook_removed": Recipe(Wish(PARALLEL, "everyday", "removed"), ("textbook",)),
    "faint_hidden": Recipe(Wish(ALL, lines="dashed"), ("faint",)),
    "leaders": Recipe(Wish(PARALLEL, lines="removed"), marks=("leaders",)),
    "hatching": Recipe(Wish(PARALLEL, lines="removed"), marks=("hatching",)),
    "construction": Recipe(Wish(PARALLEL, lines="removed"), ("clean", "pencil"), marks=("construction",)),
    "dots": Recipe(Wish(PARALLEL), marks=("dots",)),
    "diagonals": Recipe(Wish(PARALLEL), marks=("diagonals",)),
    "cut": Recipe(Wish(PARALLEL), marks=("cut",)),
    "negative": Recipe(media=("clean", "hand", "photo", "clean", "pencil", "thin"), objects=(0, 0)),
    **_foreign_ink(),
    **_missing_ink(),
    **_upright(),
    **_curved_and_pointed(),
    **_no_objects(),
}

HARD = frozenset([*_foreign_ink(), *_missing_ink(), *_upright(), *_curved_and_pointed(), *_no_objects()])
"""Categories that are not read without fault yet: the tests ask of them that nothing breaks, not that all is right."""


def annotated(recipe: Recipe) -> bool:
    """Whether something is written beside the object, which then needs room."""
    return bool(recipe.nuisances) or any(
        m not in ("shading", "cut", "dots", "diagonals", "hatching") for m in recipe.marks
    )
