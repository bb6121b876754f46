"""Russian for what is said of files and folders (файлы)."""

from __future__ import annotations

from collections.abc import Mapping

FILES: Mapping[str, str] = {
    "No such file or directory": "нет такого файла или папки",
    "Is a directory": "это папка",
    "Not a directory": "это не папка",
    "Permission denied": "нет прав доступа",
    "File exists": "такой файл уже есть",
    "File name too long": "имя файла слишком длинное",
    "File too large": "файл слишком велик",
    "Read-only file system": "диск только для чтения",
    "No space left on device": "на диске нет места",
    "Disk quota exceeded": "исчерпана квота диска",
    "Input/output error": "ошибка ввода-вывода",
    "Too many open files": "открыто слишком много файлов",
    "Operation not permitted": "действие не разрешено",
    "not a regular file": "это не обычный файл",
    "not a regular file. Fix: give another name": "это не обычный файл. Исправьте: задайте другое имя",
    "File name too long. Fix: give the scene's file a shorter name; its sheets' names begin with it": (
        "имя файла слишком длинное. Исправьте: задайте файлу схемы имя короче, с него начинаются имена листов"
    ),
    "embedded null byte": "в имени файла есть нулевой байт",
    "another run of plandraft is writing into this folder. Fix: wait until it ends, or give another folder": (
        "в эту папку пишет другой запуск plandraft. Исправьте: дождитесь его конца или задайте другую папку"
    ),
    "is a file, and cannot be the output folder. Fix: give a folder with -o": (
        "это файл, он не может быть папкой для листов. Исправьте: задайте папку ключом -o"
    ),
    "cannot be removed: {reason}": "нельзя убрать: {reason}",
    "cannot be written: {reason}": "нельзя записать: {reason}",
    "cannot be read: {reason}": "нельзя прочитать: {reason}",
    "cannot be the output folder: {reason}": "не может быть папкой для листов: {reason}",
    "cannot take its name: {reason}": "не удалось дать файлу его имя: {reason}",
    "is written and whole, but its folder could not be forced to the disk: {reason}": (
        "записан целиком, но папку не удалось сбросить на диск: {reason}"
    ),
    "left by an earlier run with more sheets; it belongs to none of these": (
        "остался от прежнего запуска, в котором листов было больше; к этим он не относится"
    ),
    "of an earlier run with more sheets; removed": "от прежнего запуска, в котором листов было больше; убран",
    "not as it was drawn: changed since, or its run was stopped; the set is drawn anew": (
        "не такой, каким был начерчен: изменён после этого, или запуск был прерван; комплект чертится заново"
    ),
    "a run was stopped before all files of this set had their names; they have them now": (
        "запуск был прерван раньше, чем все файлы комплекта получили имена; теперь они их получили"
    ),
    "a run was stopped, and the files of this set are not of one run. Fix: draw its scene again": (
        "запуск был прерван, файлы этого комплекта - от разных запусков. Исправьте: начертите схему ещё раз"
    ),
    "a run was stopped there; temporary files that it left are removed: {count}": (
        "здесь был прерван запуск; убраны оставленные им временные файлы: {count}"
    ),
    "standard output is closed: there is nowhere to print": "стандартный вывод закрыт, печатать некуда",
}
