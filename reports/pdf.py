"""The page on paper: printed by headless Chromium, the same bytes for the same page and the same Chromium."""
import pathlib
import re
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
    # The dates have a fixed length, so replacing them moves nothing in the file.
    return re.sub(rb"(/(?:Creation|Mod)Date \(D:)\d{14}", rb"\g<1>20000101000000", data)
