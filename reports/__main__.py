"""python3 -m reports [--records build/records] [--output build/report] [--against OLD] [--readme-figure FILE] [--no-pdf]
python3 -m reports compare OLD NEW

The first makes the report; `--against` adds what changed since older records. Exit status 0 with index.html and index.pdf written; 1 where records, figures or the browser are not as they must be.
"""
import argparse
import os
import pathlib
import sys
import time

from reports import bibliography, compare, costs, crack_water, figures, kill_matrix, koyna, page, pdf, peers, records, scenes
from reports.browser import BrowserError
from reports.surroundings import Sources, read as read_surroundings


def write(path, data):
    """Replaces the file at once: a killed run leaves no half file."""
    part = path.with_name(path.name + ".part")
    part.write_bytes(data)
    os.replace(part, path)
    print(f"  {path} ({len(data) / 1e6:.1f} MB)")


def main():
    parser = argparse.ArgumentParser(prog="python3 -m reports", description="Makes the validation report from the records of a run.")
    parser.add_argument("--records", type=pathlib.Path, default=pathlib.Path("build/records"))
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("build/report"))
    parser.add_argument("--cases", type=pathlib.Path, default=page.HERE.parent / "verification/cases")
    parser.add_argument("--layout", type=pathlib.Path, default=page.HERE / "layout.toml")
    parser.add_argument("--peers", type=pathlib.Path, default=peers.FOLDER, help="records of other programs")
    parser.add_argument("--against", type=pathlib.Path, help="older records: a folder or a file of JSON lines")
    parser.add_argument("--readme-figure", type=pathlib.Path, help="also write the first screen's figure to this SVG file")
    parser.add_argument("--no-pdf", action="store_true")
    options = parser.parse_args()
    begin = time.monotonic()
    try:
        found = records.read(options.records, options.cases)
        layout = page.read_layout(options.layout)
        view = page.view(found, layout, bibliography.read(page.HERE.parent / "reference-data/bibliography.bib"),
                         scenes.read(options.records / "scenes", layout) + crack_water.read(options.records / "scenes", layout),
                         koyna.read(options.records / "koyna", layout), peers.read(options.peers) if "peers" in layout else None,
                         compare.section(options.against, found.cases, dict(found.environment.facts)) if options.against else None,
                         costs.read(options.records), kill_matrix.read(options.records / "kill-matrix.jsonl"))
        options.output.mkdir(parents=True, exist_ok=True)
        view["scenes"] += read_surroundings(Sources(options.records / "surroundings", options.cases, found.benchmarks), layout)
        write(options.output / "index.html", page.render(view).encode())
        if not options.no_pdf:
            write(options.output / "index.pdf", pdf.print_page(page.render(view, printed=True), f"Sunder validation report · {view['headline']}"))
        if options.readme_figure:
            write(options.readme_figure, figures.standalone(view["hero"]["figure"]).encode())
    except (records.RecordError, page.LayoutError, figures.FigureError, BrowserError) as error:
        print(f"report: {error}", file=sys.stderr)
        return 1
    print(f"report: {len(found.cases)} cases, {len(found.benchmarks)} benchmarks, in {time.monotonic() - begin:.1f} s")
    return 0


if __name__ == "__main__":
    sys.exit(compare.main(sys.argv[2:]) if sys.argv[1:2] == ["compare"] else main())
