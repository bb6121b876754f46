"""Russian for every other English sentence of plandraft (предложения), by its form: {name} stands for its data.

A placeholder of one letter stands for one word; which placeholders hold a phrase again, plans.scene.wording says.
"""

from __future__ import annotations

from collections.abc import Mapping

from plans.scene.messages.files import FILES
from plans.scene.messages.terms import ADVICE, TERMS, TOML

# What ends a command.
LIMITS: Mapping[str, str] = {
    "the file is longer than SIZE_LIMIT = {limit} bytes": "файл длиннее SIZE_LIMIT = {limit} байт",
    "{a} commas, equals signs and brackets: more than MARKS_LIMIT = {limit}": (
        "{a} запятых, знаков равенства и скобок - больше, чем MARKS_LIMIT = {limit}"
    ),
    "a dotted key of more than PARTS_LIMIT = {limit} parts": (
        "в имени с точками больше частей, чем PARTS_LIMIT = {limit}"
    ),
    "brackets nested deeper than NESTING_LIMIT = {limit}": "скобки вложены глубже, чем NESTING_LIMIT = {limit}",
    "links times positions, {a} x {count}, is more than {b} = {limit}. Fix: {most} positions at most": (
        "число звеньев на число положений, {a} x {count}, больше, чем {b} = {limit}. Исправьте: не больше {most} "
        "положений"
    ),
    "more than {a} = {limit}": "больше, чем {a} = {limit}",
    "more than {a} = {limit}. Fix: fewer": "больше, чем {a} = {limit}. Исправьте: возьмите меньше",
    "a table or list of {count} entries: more than {a} = {limit}": (
        "в таблице или списке {count} записей - больше, чем {a} = {limit}"
    ),
    "a sheet shows at most {most}. Fix: fewer positions, or plandraft solve for the numbers alone": (
        "на листе не больше {most} положений. Исправьте: уменьшите их число или возьмите одни числа: plandraft solve"
    ),
}
STRUCTURE: Mapping[str, str] = {
    "some links have more equations than unknowns: they form a truss": (
        "у некоторых звеньев уравнений больше, чем неизвестных: это ферма"
    ),
    "links {links} form no two-lead group with the links before them: a group of class III or higher (triad), "
    "which this version does not construct": (
        "звенья {links} не составляют двухповодковой группы со звеньями до них: это группа Ассура III класса или выше, "
        "которую эта версия не строит"
    ),
    "links {links} form no two-lead group with the links before them: each lead needs one joint with a known link "
    "and one with the other lead": (
        "звенья {links} не составляют двухповодковой группы со звеньями до них: каждому поводку нужна одна пара с "
        "известным звеном и одна с другим поводком"
    ),
    "one drive moves a mechanism of mobility 1 only": "один привод движет только механизм подвижности 1",
    "links {first} and {second} are joined by three sliding pairs: such a group has no fixed position": (
        "звенья {first} и {second} соединены тремя поступательными парами: у такой группы нет определённого положения"
    ),
    "link {a} has its slot parallel to the line it slides along: links {first} and {second} have no fixed position; "
    "turn the slot by the slide's angle": (
        "направляющая на звене {a} параллельна прямой, вдоль которой оно скользит: у звеньев {first} и {second} нет "
        "определённого положения; поверните её углом angle поступательной пары"
    ),
    "group {a} has no one place at the first position: the lines that meet in {point} fall into one there, or are "
    "parallel; start from another crank angle": (
        "у группы {a} в первом положении нет одного места: линии засечки {point} там совпадают или параллельны; "
        "начните с другого угла кривошипа"
    ),
    "group {a} can be assembled in two ways and the sketch does not tell which: show {either} roughly where it is at "
    "the first position, well off the line on which both ways meet; at a dead centre start from another crank angle": (
        "группу {a} можно собрать двумя способами, и эскиз не показывает, каким: покажите {either} примерно там, "
        "где она в первом положении, в стороне от прямой, на которой обе сборки сходятся; из мёртвого положения "
        "начинать нельзя - возьмите другой угол кривошипа"
    ),
    "{a} acts over the stroke of {thing}, which has no two extreme positions. Fix: let it act always and without "
    "overrun or diagram, or name another point by stroke": (
        "{a} действует по ходу: {thing} не имеет двух крайних положений. Исправьте: пусть она действует всегда, без "
        "overrun и diagram, или назовите в stroke другую точку"
    ),
}
GAPS: Mapping[str, str] = {
    "the lines that meet in {point} fall into one there: take a position beside it": (
        "линии, которые пересекаются в {point}, там совпадают: возьмите положение рядом"
    ),
    "the lines that meet in {point} are parallel there: take a position beside it": (
        "линии, которые пересекаются в {point}, там параллельны: возьмите положение рядом"
    ),
    "the mechanism may go on in two ways there: start the drive beyond the change point, change a length, or say in "
    '[mechanism] what carries it through: through = "parallel" (another linkage beside it) or "inertia"': (
        "дальше механизм может пойти двумя путями: начните за точкой ветвления, измените одну из длин или скажите в "
        '[mechanism], что проводит его через неё: through = "parallel" (второй такой же механизм рядом) или "inertia"'
    ),
    "the guides of {point} are parallel on the way and their pin runs to infinity: keep the crank this side": (
        "направляющие точки {point} на этом пути становятся параллельны, и она уходит в бесконечность: "
        "оставьте кривошип по эту сторону"
    ),
    "the crank cannot turn there from the first position: start the drive in that part of the turn": (
        "из первого положения кривошип туда не повернётся: начните в этой части оборота"
    ),
    "a group is at its dead centre: its velocities have no one value; take a position beside it": (
        "группа Ассура в мёртвом положении, скорости её не определены; возьмите соседнее положение"
    ),
    "the links lie in one line there and may share forces in many ways: take a position beside it": (
        "звенья там лежат на одной прямой и делят силы между собой как угодно: возьмите соседнее положение"
    ),
    "a group is at its dead centre and its reactions grow beyond all bounds: take a position beside it": (
        "группа Ассура в мёртвом положении, её реакции неограниченно растут: возьмите соседнее положение"
    ),
    "pair {a} jams by friction in positions {positions}: {advice}": (
        "пара {a} заклинивает от трения в положениях {positions}: {advice}"
    ),
    "the ray of transmission is too steep to the guide: make the rod longer, bring the guide nearer to its line of "
    "force, or lower the coefficient of friction": (
        "линия передачи силы слишком крута к направляющей: удлините шатун, приблизьте направляющую к линии силы или "
        "уменьшите коэффициент трения"
    ),
    "the ray of transmission passes too far from the middle of the contact: make the contact longer, bring it nearer "
    "to the ray, or lower the coefficient of friction": (
        "линия передачи силы проходит слишком далеко от середины ползуна: удлините ползун, приблизьте его к этой линии "
        "или уменьшите коэффициент трения"
    ),
    "the ray of transmission cuts the friction circle of the hinge: make the arm of the driven link longer, or the "
    "journal's radius or the coefficient of friction smaller": (
        "линия передачи силы пересекает круг трения шарнира: увеличьте плечо ведомого звена, уменьшите радиус цапфы "
        "или коэффициент трения"
    ),
    "{a} and {b} are {apart} m apart, {miss} m less than the slot's offset: make the offset smaller or the "
    "fixed distance larger": (
        "расстояние от {a} до {b} равно {apart} м, на {miss} м меньше смещения направляющей: "
        "уменьшите смещение или увеличьте расстояние"
    ),
    "{a} = {b} m misses the guide of {point} by {miss} m: it must be {least} m at least, or the guide nearer": (
        "{a} = {b} м не достаёт до направляющей точки {point} на {miss} м: нужно не меньше {least} м "
        "или направляющая ближе"
    ),
    "{a} and {b} are {apart} m apart, but {first} = {near} m and {second} = {far} m reach from {low} m to {high} m: "
    "lengthen one of them": (
        "расстояние от {a} до {b} равно {apart} м, а {first} = {near} м и {second} = {far} м достают от {low} м до "
        "{high} м: удлините одно из звеньев"
    ),
    "{a} and {b} are {apart} m apart, but {first} = {near} m and {second} = {far} m reach from {low} m to {high} m: "
    "make their lengths more alike": (
        "расстояние от {a} до {b} равно {apart} м, а {first} = {near} м и {second} = {far} м достают от {low} м до "
        "{high} м: сделайте их длины ближе друг к другу"
    ),
    'drive.start = "extreme", but output link {a} has no extreme position: {why}. Fix: give the first crank angle in '
    "degrees, or name another [output]": (
        'drive.start = "extreme", но у выходного звена {a} нет крайнего положения: {why}. '
        "Исправьте: задайте первый угол кривошипа в градусах или другое звено в [output]"
    ),
    'drive.start = "extreme", but {why}': 'drive.start = "extreme", но {why}',
    "it turns fully or stands still": "оно делает полный оборот или неподвижно",
    "the crank does not turn fully ({reason} at {where}, {low} to {high} degrees): {advice}": (
        "кривошип не делает полного оборота ({reason}, {where}, от {low} до {high} градусов): {advice}"
    ),
    "the mechanism cannot be assembled at any crank angle: {reason} at {where}: {advice}": (
        "механизм не собирается ни при каком угле кривошипа: {reason}, {where}: {advice}"
    ),
    "the mechanism cannot be assembled at any crank angle: {reason} at {where}": (
        "механизм не собирается ни при каком угле кривошипа: {reason}, {where}"
    ),
    "{a} acts over the stroke of {thing}, but {why}": "{a} действует по ходу: {thing}; но {why}",
    "the crank does not turn fully ({reason} at {where}, {low} to {high} degrees)": (
        "кривошип не делает полного оборота ({reason}, {where}, от {low} до {high} градусов)"
    ),
    "position {a}: {plan}: {reason} at {where}: {advice}": "положение {a}, {plan}: {reason}, {where}: {advice}",
    "positions {positions}: {plan}: {reason} at {where}, in position {a}: {advice}": (
        "положения {positions}, {plan}: {reason}, {where}; в положении {a}: {advice}"
    ),
    "positions {positions}: {plan}: {reason} at {where}: {advice}": (
        "положения {positions}, {plan}: {reason}, {where}: {advice}"
    ),
    "{reason} at {where} between two positions: see the report": (
        "{reason}, {where}, между двумя положениями: см. отчёт"
    ),
    "position {positions}: too near a dead centre to be graded: see Conditions in the report": (
        "положение {positions}: слишком близко к мёртвому, чтобы его оценивать: см. Conditions в отчёте"
    ),
    "positions {positions}: too near a dead centre to be graded: see Conditions in the report": (
        "положения {positions}: слишком близко к мёртвому, чтобы их оценивать: см. Conditions в отчёте"
    ),
}
SHEETS: Mapping[str, str] = {
    "sheet.forces: {reason} at {where}, so that position {position} has no forces. Fix: choose one of {positions}": (
        "sheet.forces: {reason}, {where}, поэтому в положении {position} сил нет. Исправьте: выберите одно из "
        "{positions}"
    ),
    "no position has forces: {reason} at {where}, in position {position}: {advice}": (
        "ни в одном положении нет сил: {reason}, {where}; в положении {position}: {advice}"
    ),
    "sheet.format = {format}: not drawn yet. Fix: {either}": (
        "sheet.format = {format}: этот формат пока не чертится. Исправьте: {either}"
    ),
    "sheet.position = {position}: the mechanism cannot be assembled there. Fix: choose one of {positions}": (
        "sheet.position = {position}: в этом положении механизм не собирается. Исправьте: выберите одно из {positions}"
    ),
    "the table of values for {count} positions needs cells of {need} mm and the sheet has room for {room} mm. Fix: "
    "name fewer positions in [sheet] plans, or take a larger format": (
        "таблице величин для положений ({count}) нужны графы по {need} мм, а на листе есть место для {room} мм. "
        "Исправьте: назовите меньше положений в plans таблицы [sheet] или возьмите больший формат"
    ),
    "no room is left for a figure of scale mu_{letter}": (
        "на листе не осталось места для чертежа в масштабе mu_{letter}"
    ),
    "lettering {text}: the alphabet lacks {letters}; write it in other letters": (
        "надпись {text}: в чертёжном шрифте нет знаков {letters}; напишите её другими знаками"
    ),
    "construction and analysis assemble the mechanism in two ways (they differ in {name}); the sheet is withheld. "
    "Fix: show more points in mechanism.sketch, nearer to where they are at the first position": (
        "построение и аналитический расчёт собирают механизм по-разному (расходятся в {name}); лист не выдан. "
        "Исправьте: покажите в mechanism.sketch больше точек и ближе к их местам в первом положении"
    ),
    "sheet.orientation = {given}: expected {way}, the only way that {standard} lays {format}. Fix: leave orientation "
    "out, or take A3": (
        "sheet.orientation = {given}: ожидается {way}: иначе {standard} не располагает {format}. "
        "Исправьте: уберите orientation или возьмите A3"
    ),
    "sheet.orientation = {given}: expected {way}, the only way that {standard} lays {format}. Fix: leave orientation "
    'out, or write standard = "GOST"': (
        "sheet.orientation = {given}: ожидается {way}: иначе {standard} не располагает {format}. "
        'Исправьте: уберите orientation или напишите standard = "GOST"'
    ),
    "construction gives up position {a} ({plan}: {reason}) and analysis does not; the sheet is withheld": (
        "построение отказывается от положения {a} ({plan}: {reason}), а расчёт нет; лист не выдан"
    ),
    "analysis gives up position {a} ({plan}: {reason}) and construction does not; the sheet is withheld": (
        "расчёт отказывается от положения {a} ({plan}: {reason}), а построение нет; лист не выдан"
    ),
    "construction and analysis differ in {name}: {times} times the allowed difference; the sheet is withheld": (
        "построение и аналитический расчёт расходятся в {name}: в {times} раз больше допустимого; лист не выдан"
    ),
    "the written sheet cannot be measured: {refusal}": "записанный лист не удаётся измерить: {refusal}",
    "the written sheet does not measure back: {marks}": "измеренное по листу не совпадает с расчётом: {marks}",
    "the report does not tell what the analysis gives: {marks}": "отчёт не совпадает с расчётом: {marks}",
    "position {position} is none of 0 to {last}": "положения {position} нет: они идут от 0 до {last}",
    "position {position} is a gap: {reason} at {where}; {advice}": (
        "положение {position} - разрыв: {reason}, {where}; {advice}"
    ),
    "link {a} does not turn: {mark} is 0 and rests on no step": (
        "звено {a} не вращается: {mark} равно 0, строить нечего"
    ),
    "no mark is named {mark}: {hint}points are {points}; also v_B, a_B, omega_3": (
        "обозначения {mark} нет: {hint}точки: {points}; есть и v_B, a_B, omega_3"
    ),
    "did you mean {near}? ": "возможно, {near}? ",
    "no mark is named {mark}: points are {points}; also v_B, a_B, omega_3": (
        "обозначения {mark} нет; точки: {points}; есть и v_B, a_B, omega_3"
    ),
    "no mark is named {mark}: {hint}points are {points}; also v_B, a_B, omega_3, R_12, M_bal": (
        "обозначения {mark} нет: {hint}точки: {points}; есть и v_B, a_B, omega_3, R_12, M_bal"
    ),
    "no mark is named {mark}: points are {points}; also v_B, a_B, omega_3, R_12, M_bal": (
        "обозначения {mark} нет; точки: {points}; есть и v_B, a_B, omega_3, R_12, M_bal"
    ),
}
SENTENCES: Mapping[str, str] = {
    **TERMS, **ADVICE, **TOML, **LIMITS, **FILES, **STRUCTURE, **GAPS, **SHEETS,
}  # fmt: skip
