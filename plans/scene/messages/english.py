"""What plandraft says of a scene in English: faults and notes, each by its kind."""

from __future__ import annotations

from collections.abc import Mapping

from plans.scene.messages import english_notes

CODE = "en"
FAULT = "expected {expected}. Fix: {advice}"
NOTE = "note: {expected}; {advice}"
MORE = "and {count} more"
NOTES = english_notes.NOTES

# Each kind of fault: what was expected, and the advice.
FAULTS: Mapping[str, tuple[str, str]] = {
    # the file as bytes and as TOML
    "not_utf8": (
        "text in UTF-8, but byte {offset} is not",
        "save the file as UTF-8 (in Notepad: Save as, Encoding UTF-8)",
    ),
    "utf16": ("text in UTF-8, but the file is in {encoding}", "save the file as UTF-8"),
    "not_text": ("a scene in TOML, but this is not a text file", "give the scene file itself"),
    "json": ("a scene in TOML, but this looks like JSON", 'write "key = value" lines, as in the example scenes'),
    "yaml": ("a scene in TOML, but this looks like YAML", 'write "key = value" lines, as in the example scenes'),
    "syntax": ("TOML; {message}", "see the example scenes for the form of a line"),
    "lookalike": (
        "plain signs of the keyboard, but found {code}, which only looks like {twin}",
        "write {twin} instead",
    ),
    "unseen": ("only visible characters, but found {code}", "delete it"),
    "line_ends": ("lines that end with LF or CRLF", "save the file with Unix or Windows line ends"),
    "comma": ("a number with a decimal point", "use a point: {written}"),
    "number_form": ("a number with digits on both sides of the point and no leading zeros", "write {written}"),
    "exponent": ("digits after the e of a number", "write the exponent, as in 1e-3"),
    "hexadecimal": ("a decimal number", "write it with the digits 0 to 9 only"),
    "huge_integer": ("a number of reasonable length", "round it to the digits that you know"),
    "bare_text": ("a number, or text in quotes", 'put text in quotes: "{text}"'),
    "bare_key": ("a name of Latin letters, digits, - and _, or a name in quotes", 'write "{text}" = ... in quotes'),
    "bare_twin": (
        "a Latin letter, but {text} has a Cyrillic one that looks Latin",
        'write "{twin}" in Latin letters, here and wherever the point is named',
    ),
    "open_bracket": ("the bracket {bracket} that opens here to be closed", "add the closing bracket"),
    "open_quote": ("the quote that opens here to be closed", "add the closing quote"),
    "duplicate": ("each name once, but it is written here and on line {line}: {name}", "keep one of the two"),
    # single values
    "missing": ("this {thing}", "add it: {example}"),
    "needs": ("{tables} in the file, which this needs", "add {example}"),
    "no_table": ("one of the tables that say what to draw: {tables}", "start from a scene of `plandraft new`"),
    "unknown_key": ("a key of {table}: {known}", "{suggestion}"),
    "wrong_type": ("{wanted}, but found {found}", "write it as {example}"),
    "not_a_number": ("a number ({kind}), but found {found}", "write a number, or a number with its unit in quotes"),
    "not_a_quantity": ("a number with a unit ({kind}; units: {units})", "write it as {example}"),
    "text_number": (
        "a number without quotes, or a unit after it ({kind}; units: {units})",
        "write {number}, or add the unit",
    ),
    "wrong_unit": (
        "a unit of {kind} ({units}), but found {unit}",
        "write it as {example}, or a bare number in SI units",
    ),
    "decimal_comma": ("a number ({kind}) with a decimal point", "use a point: {written}"),
    "not_finite": ("a finite number ({kind})", "write a number that can be measured"),
    "not_positive": ("this {kind} to be greater than 0", "check the value and its unit"),
    "negative": ("this {kind} not to be negative", "check the sign"),
    "out_of_range": ("this {kind} to be between {least} and {most} {unit}", "check the value and its unit"),
    "not_whole": ("a whole number from {least}", "write it without a fraction and without quotes"),
    "too_low": ("a whole number from {least}", "write {least} or more"),
    "frame_moves": ("a moving link, from 1: link 0 is the frame", "name a link of [mechanism.links]"),
    "coefficient": (
        "a coefficient of friction from 0 to {most}",
        "check the decimal point: oiled steel has about 0.1, which is 10 per cent",
    ),
    "comma_list": (
        "numbers with decimal points, but found commas that a space follows and commas that none follows",
        "use points: {written}",
    ),
    "pair": ("2 numbers {what}, but found {found}", "{advice}"),
    "choice": ("one of {choices}", "{suggestion}"),
    "sheet_name": ("a sheet that this version draws: {choices}", "{suggestion}"),
    "empty": ("at least one entry", "add one, or leave the key out"),
    "repeated": ("each entry once, but {entry} is repeated", "keep one of them"),
    "text": ("visible text, but found {code}", "delete that character"),
    "text_length": ("text of at most {most} characters", "shorten it"),
    "name": ("the name of a point: letters, then digits or primes, as A, B1, O'", "rename the point"),
    "letters": (
        "letters of points: a capital with digits or primes each, as OA, AB1, O'B",
        'write capitals, or longer names as a list: ["crank", "pin"]',
    ),
    "link_number": ("a link number: 1, 2, 3, ... (0 is the frame)", "number the moving links from 1"),
    "two_letters": ("two points of one link", "name the line by its two ends, as AB"),
    "one_of_two": ("either {first} or {second}, not {found}", "keep one of them"),
    "start_with_list": ("no start beside a list of positions", "leave start out: the list gives the crank angles"),
    "position_number": (
        "a position from 0 to {most}: the drive has {count} positions",
        "give a number of that range, or more positions",
    ),
    "force_value": ("{wanted}", "{advice}"),
    "diagram": ("travel and {name} lists of one length, travel rising from 0 to 1", "give one force for each travel"),
    "travel": (
        "travel from 0 to 1, but it covers {first} to {last}",
        "give the force from the beginning of the stroke to its end: 0 N where it rests",
    ),
    "travel_share": (
        "shares of the stroke from 0 to 1, but found {found}",
        "divide by the stroke; a decimal comma is a point: 0.5",
    ),
    "share": ("a share of the stroke from 0 to less than 1", "write 0.1 for a tenth of it"),
    "no_stroke_left": ("overruns that leave a part of the stroke between them", "write smaller shares"),
    "spare_stroke": ("a load that changes over a stroke", "leave stroke out, or add during, overrun or a diagram"),
    "one_stroke": (
        "no part of the turn beside back, which gives the force on the idle stroke too",
        "leave during out, or back",
    ),
    "symbol": (
        "the letters of a load: a letter, then letters, digits, _, points or primes, as F_us, M_3",
        "rename the load",
    ),
    "symbol_taken": (
        "letters of its own: a force sheet writes {name} for a reaction, a weight, an inertia force or the drive's",
        "rename the load, as F_us or F_1",
    ),
    "loaded_frame": ("a moving link: a load on the frame moves nothing", "name the link that it acts on"),
    "pair_name": ('a pair by its two links, the lower number first, as "0-1"', 'write "{example}"'),
    "two_ends": ("the two ends of a spring, but found {found}", 'write between = ["B", "O"]'),
    "invalid": ("{message}", "compare it with the example scenes"),
    # the mechanism
    "unknown_point": ("a point of the mechanism, but there is no point {name}", "{suggestion}"),
    "unknown_link": ("a link of [mechanism.links], but there is no link {link}", "the links are {links}"),
    "not_of_link": ("a point of link {link}: {points}; {name} is none", "{suggestion}"),
    "no_common_link": ("two points of one link, but no link has both {first} and {second}", "{suggestion}"),
    "fixed_length": ("a length of a moving link, but {first} and {second} are fixed", "their places give the distance"),
    "twice": ("each length once, but {first} is also written on line {line}", "keep one of the two"),
    "spare_length": (
        "only the lengths from a point to the first two points of its link ({needed})",
        "leave this one out, it follows from the others",
    ),
    "no_length": ("the length {name} of link {link}", "add {name} = ... to [mechanism.lengths]"),
    "no_place": (
        "point {name} of link {link} to be placed",
        "add the lengths {lengths}, or [mechanism.points] {name} = {{ on = {link}, at = [x, y] }}",
    ),
    "open_triangle": (
        "a triangle that closes: {name} between {least} m and {most} m",
        "correct this length or {others}",
    ),
    "side": (
        "a sketch that shows on which side of {line} the point {name} lies ({reason})",
        "give {points} in [mechanism.sketch], or place it by [mechanism.points] {name} = {{ on = {link}, "
        "at = [x, y] }} instead of lengths",
    ),
    "second_by_place": (
        "a third point: {name} is among the first two of link {link}, which make its own axis",
        "give the length {line} instead",
    ),
    "two_places": (
        "one place for {name}: it is a fixed point of [mechanism.frame] too",
        "give the point of link {link} a letter of its own",
    ),
    "on_frame": ("a moving link: link 0 is the frame", "put fixed points into [mechanism.frame]"),
    "placed_twice": ("one way to place {name}: it has a place in [mechanism.points]", "leave out this length"),
    "not_itself": ("a line of another link", "the slide joins two different links"),
    "many_owners": ("a line of one link, but links {links} have both points", "name two points of one of them"),
    "no_direction": ("two points apart from each other, but {first} and {second} are in one place", "move one of them"),
    "no_hinge": ("a drive link with a fixed hinge", "{suggestion}"),
    "many_hinges": (
        "a drive link with one fixed hinge, but {points} are all fixed",
        "leave one of them in link {link}",
    ),
    "no_end": ("a drive link with a second point", 'write it with two letters, as {link} = "{pivot}A"'),
    "fixed_output": ("a moving point, but {name} is fixed", "name a point of the output link"),
    "island": (
        "every link to be joined to the frame; not joined: {links}",
        "give it a common point with another link, or a slide",
    ),
    "loose": (
        "a second joint of link {link}, which only turns about {name}",
        "give it a slide, [[mechanism.slides]] link = {link}, or a second point",
    ),
    "one_body": (
        "one joint between two links, but {how} join links {first} and {second} twice, so that they are one body",
        "correct the letters, or leave one of the two out",
    ),
    "mobility": (
        "mobility 1, but W = 3n - 2p = 3*{n} - 2*{p} = {found} ({hinges} hinges, {slides} slides; a hinge of k links "
        "counts k - 1)",
        "{advice}",
    ),
    "ratio": (
        "a ratio of the longest to the shortest length up to {most}, but {name} is {ratio} times {other}",
        "check the units of both",
    ),
    "no_line": (
        "a link with two points, for its middle: two letters of link {link} in [mechanism.links]",
        "give the centre as [x, y], or by the letter of a point",
    ),
    # masses, loads, friction
    "nothing_acts": (
        "masses or loads for the sheet of forces, but nothing acts on the mechanism",
        'add [masses], or forces, moments or springs in [loads], or leave "forces" out of sheets',
    ),
    "many_links": (
        "a point of one link, but links {links} have {name}",
        'write {{ on = {first}, point = "{name}" }}',
    ),
    "one_hinge": ("ends that come apart, but {name} is a hinge of both links", "name points that are apart"),
    "one_link": ("ends on two different links, but both are on link {link}", "name points of two links"),
    "unknown_pair": ("a pair of the mechanism, but there is no pair {name}", "{suggestion}"),
    "pair_form": ("{thing}, which alone has a {name}, but pair {pair} is none", "leave {name} out"),
}
