"""A gallery sheet looks the same in two independent renderers, but for anti-aliasing: librsvg and chromium."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

from drawings.lettering.lettering import lettered
from drawings.paper.strokes import Anchor, Group, Leaf, Text
from drawings.pens.svg import svg

GALLERY = Path(__file__).parents[2] / "drawings" / "gallery"
SHEETS = sorted(GALLERY.glob("*.svg"))
WIDTH = 2400  # pixels: a thin line of 0.25 mm on A1 is 0.7 of a pixel wide
DARK = 110  # of 255: what any renderer leaves of a thin line, spread over two pixels
FAINT = 225  # the other one's share of the same line
RSVG, CHROMIUM = shutil.which("rsvg-convert"), shutil.which("chromium")

pytestmark = [pytest.mark.deep, pytest.mark.skipif(not RSVG, reason="needs librsvg's rsvg-convert")]


def by_librsvg(sheet: Path, picture: Path) -> None:
    subprocess.run([str(RSVG), "-b", "white", "-w", str(WIDTH), str(sheet), "-o", str(picture)], check=True)


def by_chromium(sheet: Path, picture: Path, height: int) -> None:
    page = picture.with_suffix(".html")
    drawn = f'<img src="{sheet.as_uri()}" width="{WIDTH}" height="{height}">'
    page.write_text(f'<body style="margin:0;background:white">{drawn}</body>', encoding="utf-8")
    with tempfile.TemporaryDirectory() as profile:
        subprocess.run(
            [
                str(CHROMIUM), "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                "--disable-background-networking", "--force-device-scale-factor=1", f"--user-data-dir={profile}",
                f"--window-size={WIDTH},{height}", f"--screenshot={picture}", page.as_uri(),
            ],
            check=True, capture_output=True, timeout=120,
        )  # fmt: skip


def darkest_around(picture: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    """Give for every pixel the darkest one of its nine."""
    padded = np.pad(picture, 1, constant_values=255)
    rows, columns = picture.shape
    shifted = [padded[i : i + rows, j : j + columns] for i in range(3) for j in range(3)]
    return np.minimum.reduce(shifted)


def grey(picture: Path) -> npt.NDArray[np.uint8]:
    image = pytest.importorskip("PIL.Image")
    with image.open(picture) as opened:
        return np.asarray(opened.convert("L"))


@pytest.mark.skipif(not CHROMIUM, reason="needs chromium")
@pytest.mark.parametrize("sheet", SHEETS, ids=lambda path: path.stem)
def test_what_one_renderer_draws_dark_the_other_draws_within_a_pixel(sheet: Path, tmp_path: Path) -> None:
    by_librsvg(sheet, tmp_path / "one.png")
    one = grey(tmp_path / "one.png")
    by_chromium(sheet, tmp_path / "two.png", one.shape[0])
    two = grey(tmp_path / "two.png")[: one.shape[0]]
    assert one.shape == two.shape and (one < DARK).sum() > 5000
    for dark, other in ((one, two), (two, one)):
        missing = (dark < DARK) & (darkest_around(other) > FAINT)
        assert not missing.any(), f"{int(missing.sum())} pixels, first at {np.argwhere(missing)[0]}"


@pytest.mark.parametrize("anchor", ["start", "middle", "end"])
def test_librsvg_keeps_text_in_a_viewer_s_font_where_our_own_letters_stand(tmp_path: Path, anchor: Anchor) -> None:
    """It knows no textLength; without one of the fonts that are asked for it takes DejaVu Sans, or a narrower one."""
    words = Text(200 + 20j, "Холодновысадочный автомат: a^n_{BA} = 12,5 м/с²", 5.0, anchor)
    reach = {}
    for lettering in ("strokes", "text"):
        (sheet := tmp_path / f"{lettering}.svg").write_bytes(
            svg(lettered(Leaf(400, 40, (Group((words,)),)), lettering))
        )
        by_librsvg(sheet, picture := tmp_path / f"{lettering}.png")
        inked = np.flatnonzero((grey(picture) < DARK).any(axis=0))
        reach[lettering] = np.array([inked[0], inked[-1]]) * 400 / WIDTH
    assert np.abs(reach["text"] - reach["strokes"]).max() < 1.0  # mm: a gap between letters of 5 mm
