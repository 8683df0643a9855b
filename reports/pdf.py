"""The page on paper: printed by headless Chromium, the same bytes for the same page and the same Chromium."""
import pathlib
import re
import subprocess
import tempfile

from reports.browser import Browser


def print_page(html, footer):
    """The PDF (bytes) of an HTML text."""
    with tempfile.TemporaryDirectory(prefix="sunder-report-") as folder:
        page = pathlib.Path(folder) / "page.html"
        page.write_text(html, encoding="utf-8")
        with Browser(timeout=110) as browser:
            browser.open(page)
            data = browser.pdf(footer)
    return without_moment(data)


def without_moment(data):
    """The PDF with a fixed date, and with the identifiers of its structure counted from 0 in their own order: the browser
    begins to count somewhere else each time. Both keep their length, so nothing moves in the file, and the index of the
    identifiers stays sorted."""
    data = re.sub(rb"(/(?:Creation|Mod)Date \(D:)\d{14}", rb"\g<1>20000101000000", data)
    rank = {number: i for i, number in enumerate(sorted(set(re.findall(rb"\(node(\d{8})\)", data))))}
    return re.sub(rb"\(node(\d{8})\)", lambda m: b"(node%08d)" % rank[m.group(1)], data)


def mark_of(anchor):
    """What stands, too small to see, at an entry of the contents while its page is looked for."""
    return f"[[{anchor}]]"


def pages_of(data):
    """The page number (text) of every mark in a PDF, by pdftotext; a page ends with a form feed."""
    with tempfile.NamedTemporaryFile(suffix=".pdf") as file:
        file.write(data)
        file.flush()
        text = subprocess.run(["pdftotext", file.name, "-"], check=True, capture_output=True, text=True).stdout
    return {anchor: str(number) for number, sheet in enumerate(text.split("\f"), 1) for anchor in re.findall(r"\[\[([\w-]+)\]\]", sheet)}


def print_with_contents(render, footer):
    """The PDF of `render(pages)`: printed once with marks to see where the entries of the contents come to lie, and once more
    with their pages."""
    pages = pages_of(print_page(render(None), footer))
    return print_page(render(pages), footer)
