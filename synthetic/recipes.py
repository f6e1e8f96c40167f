"""The categories of test drawings: which object, lines and medium go together under one name."""

from __future__ import annotations

from dataclasses import dataclass, field

from synthetic.scenes import Wish


@dataclass(frozen=True)
class Recipe:
    """A category.

    wish    : the object
    media   : names in `media.MEDIA`, taken in turn
    marks   : "none", or the names in `marks.MARKS` to pick from ("shading" and "cut" as well)
    objects : objects on the sheet (least, most); (0, 0) is a negative
    """

    wish: Wish = field(default_factory=Wish)
    media: tuple[str, ...] = ("clean",)
    marks: tuple[str, ...] = ()
    objects: tuple[int, int] = (1, 1)


OBLIQUE, AXONO, PERSP = ("oblique",), ("axonometric",), ("perspective",)
PARALLEL = ("oblique", "axonometric")
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
}


def annotated(recipe: Recipe) -> bool:
    """Whether something is written beside the object, which then needs room."""
    return any(m not in ("shading", "cut", "dots", "diagonals", "hatching") for m in recipe.marks)
