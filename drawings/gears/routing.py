"""Where the shafts, carriers and discs of a train stand in the plane of its axes, so that few lines cross (компоновка).

Wheels that mesh stand in one column. What else rises from a shaft, a post, stands between columns: the arm of a
carrier, the disc that bears a ring, the plates of a clutch. Each is put where it crosses least; coaxial shafts are
hollow one about another, the inner one lower. Heights are true, m; places across are counted in steps.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final, NamedTuple

from plans.model.gears import ACROSS, ToothedWheel, Train

SUN, ARM, DISC, PLATE, BRAKE, HELD, INPUT, OUTPUT = "sun", "arm", "disc", "plate", "brake", "held", "input", "output"
RIM, LEVEL, STUB = 0.07, 0.05, 0.16  # of the height of the train: a ring's thickness, hollow shafts apart, short posts
BESIDE: Final = 3.0  # steps from the outermost column to where a driving shaft begins
COLUMN, HALF = 10.0, 0.5  # places between two columns; half of the width of a wheel
CROSSING = 100.0  # what a crossing costs, in places of length


class Post(NamedTuple):
    """What rises from the shaft of a body at a place across, to a height m."""

    kind: str
    body: str
    x: float
    top: float
    name: str = ""


class Rod(NamedTuple):
    """A level line of a body: a shaft, an axle, the bar between rings."""

    body: str
    left: float
    right: float
    y: float


@dataclass
class Routing:
    """The posts and rods of a train: first those that columns settle, then all others, each where it crosses least."""

    train: Train
    roofed: bool = False  # whether carriers that bear a wheel go round the bevel wheels of their planets
    posts: list[Post] = field(default_factory=list)
    levels: dict[str, int] = field(default_factory=dict)
    roofs: dict[str, float] = field(default_factory=dict)  # heights m of carriers that go round a bevel wheel

    def __post_init__(self) -> None:
        tops = (self.train.heights[w.link] + w.radius * (w.side not in ACROSS) for w in self.train.wheels.values())
        self.size = float(max(tops))
        self.columns = columns(self.train)
        self.bodies = self.train.body_of

    def height(self, body: str) -> float:
        """Give the height m of the axis of a body."""
        return float(self.train.heights[body])

    def level(self, body: str) -> float:
        """Give the height m of the shaft of a body over the main axis."""
        return self.height(body) + LEVEL * self.size * self.levels.get(body, 0)

    def rings(self, body: str) -> list[ToothedWheel]:
        """Give the rings of a body."""
        return [wheel for wheel in self.train.wheels.values() if wheel.internal and self.bodies[wheel.link] == body]

    def outside(self, wheel: ToothedWheel) -> float:
        """Give the height m of the outside of a ring."""
        return float(self.train.heights[wheel.link] + wheel.radius) + RIM * self.size

    def bar(self, body: str) -> float:
        """Give the height m of the bar that joins the rings of a body."""
        return max(map(self.outside, self.rings(body)))

    def shaft(self, body: str) -> Rod | None:
        """Give the shaft of a body between its posts."""
        across = [post.x for post in self.posts if post.body == body and not (body in self.roofs and post.kind == ARM)]
        if not across:
            return None
        return Rod(body, min(across), max(across), self.level(body))

    def axle(self, link: str) -> Rod:
        """Give the axle of a planet from its carrier's arm through its wheels."""
        body = self.bodies[self.train.carrier_of[link]]
        across = [*self.across(link), *(post.x for post in self.posts if post.kind == ARM and post.body == body)]
        return Rod(body, min(across), max(across), float(self.train.heights[link]))

    def across(self, link: str) -> list[float]:
        """Give the places across of the wheels of a link."""
        return [self.columns[wheel.name] for wheel in self.train.wheels.values() if wheel.link == link]

    def bars(self) -> Iterator[Rod]:
        """Give the bars that join the rings of a body to each other and to its disc."""
        for body in dict.fromkeys(self.bodies.values()):
            if rings := self.rings(body):
                across = [self.columns[ring.name] for ring in rings]
                across += [post.x for post in self.posts if post.body == body and post.kind == DISC]
                yield Rod(body, min(across), max(across), self.bar(body))
        for body, y in self.roofs.items():
            across = [post.x for post in self.posts if post.body == body and post.kind in (ARM, DISC)]
            yield Rod(body, min(across), max(across), y)

    def rods(self) -> list[Rod]:
        """Give all level lines."""
        shafts = (self.shaft(body) for body in dict.fromkeys(self.bodies.values()))
        level = (link for link in self.train.carrier_of if link not in self.train.crossing)
        return [*(rod for rod in shafts if rod), *map(self.axle, level), *self.bars()]

    def nest(self) -> None:
        """Put coaxial shafts about one another: one that passes under a post of another is the inner one."""
        self.levels.clear()
        rods = {rod.body: rod for body in dict.fromkeys(self.bodies.values()) if (rod := self.shaft(body))}
        left = [*rods]
        while left:
            free = [body for body in left if not any(self._under(rods[other], body) for other in left if other != body)]
            body = (free or left)[0]
            left.remove(body)
            below = (self.levels[other] for other in self.levels if self._overlap(rods[body], rods[other]))
            self.levels[body] = max(below, default=-1) + 1

    def _under(self, inner: Rod, outer: str) -> bool:
        """Tell whether a shaft passes under a post of a coaxial one."""
        posts = (post.x for post in self.posts if post.body == outer and self.height(inner.body) == self.height(outer))
        return any(inner.left < x < inner.right for x in posts)

    def _overlap(self, one: Rod, other: Rod) -> bool:
        level = self.height(one.body) == self.height(other.body)
        return level and min(one.right, other.right) >= max(one.left, other.left)

    def cost(self) -> float:
        """Count crossings of posts and wheels with level lines of other bodies, and how long these are."""
        self.nest()
        rods, cost = self.rods(), 0.0
        for x, low, high, body in self._uprights():
            cost += CROSSING * sum(rod.body != body and rod.left < x < rod.right and low < rod.y < high for rod in rods)
        return cost + sum(rod.right - rod.left for rod in rods)

    def _uprights(self) -> Iterator[tuple[float, float, float, str]]:
        for post in self.posts:
            low, high = sorted((self.level(post.body), post.top))
            yield post.x, low, high, post.body
        for wheel in self.train.wheels.values():
            if wheel.link in self.train.carrier_of and not wheel.side:
                y, r = float(self.train.heights[wheel.link]), float(wheel.radius)
                yield self.columns[wheel.name], y - r, y + r, self.bodies[self.train.carrier_of[wheel.link]]

    def put(self, *posts: Post, near: float | None = None) -> None:
        """Put posts that stand side by side where they cross least; a clutch has two, in either order."""
        best, where = float("inf"), tuple[Post, ...]()
        places = sorted({*self.columns.values(), *(post.x for post in self.posts)})
        gaps = [places[0] - BESIDE * 2, *((a + b) / 2 for a, b in pairwise(places)), places[-1] + BESIDE]
        before = [*self.posts]
        for ways in (posts, posts[::-1]) if len(posts) > 1 else (posts,):
            for k, gap in enumerate(gaps):
                width = min((places[k] - places[k - 1]) / 4 if 0 < k < len(places) else HALF, HALF)
                off = ((2 * n - 1) * width / 2 * (len(posts) - 1) for n in range(len(ways)))
                tried = tuple(post._replace(x=gap + x) for post, x in zip(ways, off, strict=True))
                self.posts = [*before, *tried]
                cost = self.cost() + (0.0 if near is None else abs(gap - near))
                if cost < best:
                    best, where = cost, tried
        self.posts = [*before, *where]


def columns(train: Train) -> Mapping[str, float]:
    """Give the place of each wheel across: those that mesh stand in one column, bevel wheels about that of the apex."""
    row = {name: k for k, name in enumerate(train.wheels)}
    one_column = [mesh for mesh in train.meshes if mesh not in train.bevels]
    one_column += [(some[0].cross.name, one.cross.name) for some in train.crossing.values() for one in some]
    for _ in train.wheels:
        for one, other in one_column:
            low = min(row[one], row[other])
            row[one] = row[other] = low
    order = [*dict.fromkeys(row.values())]
    for bevel in sorted(train.bevels.values(), key=lambda bevel: -bevel.cross.radius):
        order.remove(row[bevel.level.name])
        order.insert(order.index(row[bevel.cross.name]) + (bevel.place[0] > 0), row[bevel.level.name])
    return {name: COLUMN * order.index(k) for name, k in row.items()}


def routed(train: Train) -> Routing:
    """Put all that a train has in its places, in that of two ways whose lines cross less."""
    ways = (_laid(Routing(train, roofed), train) for roofed in ((False, True) if train.crossing else (False,)))
    return min(ways, key=Routing.cost)


def _laid(routing: Routing, train: Train) -> Routing:
    bodies = train.body_of
    for wheel in train.wheels.values():
        if wheel.link not in train.carrier_of and not wheel.internal and wheel.link not in train.crossing:
            top = float(train.heights[wheel.link] + wheel.radius)
            routing.posts.append(Post(SUN, bodies[wheel.link], routing.columns[wheel.name], top, wheel.name))
    for carrier, links in train.carriers.items():
        top = max(float(train.heights[link]) for link in links)
        last = max(routing.columns[wheel.name] for wheel in train.wheels.values() if wheel.link in links)
        if not train.crossing.keys().isdisjoint(links):
            _across(routing, bodies[carrier], last, carrier)
            continue
        routing.put(Post(ARM, bodies[carrier], 0.0, top, carrier), near=last + COLUMN / 3)
    driven, left, right = [bodies[link] for link, _ in train.drives], -BESIDE, max(routing.columns.values()) + BESIDE
    for k, (body, (link, _)) in enumerate(zip(driven, train.drives, strict=True)):
        _end(routing, Post(INPUT, body, 0.0, 0.0, link), (left - BESIDE - k, right + BESIDE + k))
    if bodies[train.output] not in driven and not train.driven:
        _end(routing, Post(OUTPUT, bodies[train.output], 0.0, 0.0, train.output), (right + BESIDE, left - BESIDE))
    rest = [bodies[link] for pair in train.clutches.values() for link in pair]
    for body in dict.fromkeys(bodies.values()):
        if routing.rings(body) and (body in rest or any(post.body == body for post in routing.posts)):
            routing.put(Post(DISC, body, 0.0, routing.bar(body)))
    _hold(routing)
    routing.nest()
    return routing


def _across(routing: Routing, body: str, x: float, carrier: str) -> None:
    """Put the arm of bevel planets up from the shaft, or, where the carrier bears a wheel, down from over theirs."""
    train = routing.train
    rows = [row for link in train.carriers[carrier] for row in train.crossing.get(link, ())]
    top = routing.height(body) + float(max(row.level.radius for row in rows)) + STUB * routing.size
    borne = [post.x for post in routing.posts if post.body == body and post.kind == SUN]
    routing.posts.append(Post(ARM, body, x, top, carrier))
    if borne and routing.roofed:
        routing.roofs[body] = top
        routing.posts.append(Post(DISC, body, borne[0], top))


def _hold(routing: Routing) -> None:
    """Put clutches, then what holds bodies that have no rings to be held at."""
    train, short = routing.train, STUB * routing.size
    for name, pair in train.clutches.items():
        bodies = [train.body_of[link] for link in pair]
        routing.put(*(Post(PLATE, body, 0.0, routing.height(body) + short, name) for body in bodies))
    for name, link in held(train):
        body = train.body_of[link]
        if not routing.rings(body):
            kind = BRAKE if name else HELD
            routing.put(Post(kind, body, 0.0, routing.height(body) + short, name or link))


def held(train: Train) -> Iterator[tuple[str, str]]:
    """Give the brakes with the links that they hold, and without a brake the links that are held in all gears."""
    yield from train.brakes.items()
    always = set.intersection(*({*gear.held} for gear in train.gears))
    yield from (("", link) for link in train.links if link in always and link not in train.brakes.values())


def _end(routing: Routing, post: Post, places: Sequence[float]) -> None:
    """Let a level shaft end at the side where it crosses less, at the first if that is one."""
    if post.body in routing.train.crossing:
        return
    before, ways = [*routing.posts], list[tuple[float, int, list[Post]]]()
    for k, x in enumerate(places):
        routing.posts = [*before, post._replace(x=x, top=routing.height(post.body))]
        ways.append((round(routing.cost() / CROSSING), k, routing.posts))
    routing.posts = min(ways)[2]
