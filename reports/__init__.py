"""Makes the validation report: records of the verification and the benchmarks -> figures -> one HTML page and its PDF.

Called by `ci/report` as `python3 -m reports`. Reading order: records (what a run left behind), front (error against run
time), figures, page, browser (prints the PDF; the tests open the page with it).
"""
