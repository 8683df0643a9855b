"""The works that cases cite by key, from reference-data/bibliography.bib, as a person reads them."""
import re
from dataclasses import dataclass

_ENTRY = re.compile(r"@\w+\s*\{\s*([^,\s]+)\s*,")


@dataclass(frozen=True)
class Work:
    short: str   # Kaya and Erdogan 1987
    full: str    # Kaya and Erdogan, On the solution of …, Quarterly of Applied Mathematics 45, 1987


def _braced(text, start):
    """The text within the braces that open at `start`, and the index behind them."""
    depth = 0
    for i in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return text[start + 1:i], i + 1
    raise ValueError(f"bibliography: a brace that opens at character {start} does not close")


def _plain(text):
    return " ".join(text.replace("{", "").replace("}", "").replace("--", "–").split())


def _names(authors):
    names = [_plain(a).split(",")[0] for a in authors.split(" and ")]
    return names[0] if len(names) == 1 else " and ".join(names) if len(names) == 2 else f"{names[0]} and others"


def _work(key, fields):
    authors, year = _names(fields.get("author", "")), fields.get("year", "")
    place = " ".join(fields[k] for k in ("journal", "series", "howpublished", "publisher", "volume") if k in fields)
    full = ", ".join(part for part in (authors, _plain(fields.get("title", "")), _plain(place), fields.get("note", ""), year) if part)
    return Work(f"{authors} {year}".strip() if authors else _plain(fields.get("title", key)), full)


def read(path):
    """key -> Work for every entry of a BibTeX file."""
    text = "\n".join(line for line in path.read_text(encoding="utf-8").splitlines() if not line.lstrip().startswith("%"))
    works = {}
    for match in _ENTRY.finditer(text):
        body, _ = _braced(text, text.index("{", match.start()))
        fields, at = {}, 0
        while field := re.compile(r"(\w+)\s*=\s*(?=\{)").search(body, at):
            fields[field.group(1).lower()], at = _braced(body, field.end())
        works[match.group(1)] = _work(match.group(1), fields)
    return works
