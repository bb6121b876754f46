"""The specimen: the whole alphabet on one A3 sheet, upright and slanted, in the sizes that sheets use."""

from __future__ import annotations

from collections.abc import Iterator

from drawings.lettering.lettering import outline, text_width
from drawings.paper.strokes import Group, Leaf, Line, LineStyle, Run, Text

WIDTH, HEIGHT, LEFT, MIDDLE, RIGHT, TOP = 420.0, 297.0, 15.0, 215.0, 405.0, 264.0
STEP = 1.7  # from line to line in sizes: the least of the standard
GUIDE = LineStyle(width=0.1, colour="#a9bccd")

LETTERS = (
    "АБВГДЕЁЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯ  ҐЄІЇЎ",
    "абвгдеёжзийклмнопрстуфхцчшщъыьэюя  ґєіїў",
    "ABCDEFGHIJKLMNOPQRSTUVWXYZ abcdefghijklmnopqrstuvwxyz",
    "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩ αβγδεζηθικλμνξοπρσςτυφχψω",
    "0123456789 .,:;!?…'\"()[]{}/\\|+−×·÷±=≠≈<>≤≥%°′″№ -–—",
)
SIGNS = "«» “” ~ * _ & @ # $ € § ‰ ∥ ⊥ ∠ √ ∞ ∫ ∑ ∂ ∇ → ← ↔ ↑ ↓ ⇒ □ △ ▷ ⌒ ○ ⊙ Ø ß æ ø ł"
PHRASES = (
    (7.0, "Кинематическое исследование механизма", "Kinematics of the mechanism"),
    (7.0, "План скоростей, положение 2", "Velocity plan, position 2"),
    (
        5.0,
        "μ_v = 0,02 м·с⁻¹/мм;  v_{BA} = ω_1·l_{AB} = 3,14 м/с",
        "μ_a = 0.5 m·s⁻²/mm;  a^n_{BA} = ω_1²·l_{AB} = 31.4 m/s²",
    ),
    (5.0, "Наибольшее расхождение плана и анализа: 0,03 %", "Largest difference of plan and analysis: 0.03 %"),
    (
        3.5,
        "Съешь же ещё этих мягких французских булок, да выпей чаю. № докум.  Подп.  Утв.",
        "The quick brown fox jumps over the lazy dog. Müller, Łódź, Škoda, naïve café; φ̇, ẍ",
    ),
    (
        3.5,
        "Размах звена 3: ψ = 48,19°;  угол перекрытия θ = 21,5°;  K = 1,27;  ε_2 = 120 рад/с²",
        "Swing of link 3: ψ = 48.19°;  time-ratio angle θ = 21.5°;  K = 1.27;  ε_2 = 120 rad/s²",
    ),
)
LARGE = Text(complex(LEFT, 12), "ЖДЛбвгдтф Rag 2358", 14.0)


def specimen() -> Leaf:
    """Draw the specimen: the letters in groups by size, and the grid on which they stand."""
    texts = tuple(_texts())
    guides = tuple(line for text in texts if text.size == 10 for line in _guides(text))
    groups = [Group((*guides, *_grid()), "guides")]
    for size in sorted({text.size for text in texts}, reverse=True):
        strokes = tuple(stroke for text in texts if text.size == size for stroke in outline(text))
        groups.append(Group(strokes, f"size-{size:g}"))
    return Leaf(WIDTH, HEIGHT, tuple(groups), "Lettering", "The alphabet on the grid of GOST 2.304-81, type B")


def _texts() -> Iterator[Text]:
    yield Text(complex(LEFT, 280), "Шрифт чертёжный, тип Б", 7.0, "start", True)
    yield Text(complex(RIGHT, 280), "Drawing letters, type B", 7.0, "end", True)
    y = TOP
    for slanted in (False, True):
        for letters in LETTERS:
            yield Text(complex(LEFT, y), (Run(letters),), 10.0, "start", slanted)
            y -= 10 * STEP
    yield Text(complex(LEFT, y + 4), (Run(SIGNS),), 7.0, "start", True)
    y -= 9
    for line, (size, *pair) in enumerate(PHRASES):
        for left, phrase in zip((LEFT, MIDDLE), pair, strict=True):
            yield Text(complex(left, y), phrase, size, "start", line % 2 == 0)
        y -= size * STEP
    yield LARGE
    yield Text(complex(RIGHT, 21), "h = 10d   c = 7d   a = 2d", 5.0, "end", True)
    yield Text(complex(RIGHT, 12), "b = 17d   e = 6d   75°", 5.0, "end", True)


def _guides(text: Text) -> Iterator[Line]:
    """Base line, height of small letters, height of capitals."""
    for share in (0.0, 0.7, 1.0):
        level = text.at.imag + share * text.size
        yield Line(complex(LEFT, level), complex(RIGHT, level), GUIDE)


def _grid() -> Iterator[Line]:
    """The squares of d under the large letters."""
    d, low = LARGE.size / 10, LARGE.at.imag
    columns = round(text_width(LARGE) / d)
    for column in range(columns + 1):
        yield Line(complex(LEFT + column * d, low - 3 * d), complex(LEFT + column * d, low + 10 * d), GUIDE)
    for row in range(-3, 11):
        yield Line(complex(LEFT, low + row * d), complex(LEFT + columns * d, low + row * d), GUIDE)
