"""A session at the bench on a scene's cams: graphical laws, profile, the drawn pieces (испытание кулачков)."""

from __future__ import annotations

from collections.abc import Callable

from drawings.bench.session import BUDGET, Order
from plans.bench import cam_laws, cam_path, cam_profile
from plans.bench.computer import machine
from plans.bench.result import Bench, Ratio, Row
from plans.cam.study import CamDrawing
from plans.scene.scene import Scene
from plans.study import Study

STRIPS, QUICK_STRIPS = cam_laws.COUNTS, cam_laws.COUNTS[:3]
TURNS, QUICK_TURNS = cam_profile.COUNTS, cam_profile.COUNTS[:2]
FIRST = "of several cams the first one is judged"


def session(scene: Scene, order: Order, tell: Callable[[str], None]) -> Bench:
    """Run a session on the first cam of a scene."""
    there, cams = machine(), Study(scene)["cam"].drawings
    drawing: CamDrawing = next(iter(cams.values()))
    rows, ratios, words = list[Row](), list[Ratio](), [FIRST] if len(cams) > 1 else []
    tell("the law")
    made, told = cam_laws.rows(drawing.cam, order.rounds, BUDGET, STRIPS if order.startup else QUICK_STRIPS)
    rows, words = [*rows, *made], [*words, *told]
    tell("the profile")
    course, sizes, roller = drawing.course, drawing.sizing.sizes, drawing.found.roller
    counts = TURNS if order.startup else QUICK_TURNS
    made, ratios, told = cam_profile.rows(course, sizes, roller, order.rounds, BUDGET, counts)
    rows, words = [*rows, *made], [*words, *told]
    tell("the pieces")
    made, told = cam_path.rows(drawing.cam, sizes, -roller, order.rounds, BUDGET)
    tell("")
    return Bench(scene.heading(), there, (*rows, *made), tuple(ratios), (*words, *told), order.accepted)
