"""Looks at the report of the built-in recording with a browser: python look.py TRUEGAP [PAGE.html ...] [--write FOLDER]

Sends pointer events to every figure and compares what it says with prediction.csv; looks whether everything has room on a wide page, a tablet and a phone, of further pages as well (a viewer, a study); with --write, makes report-wide.png, report-phone.png and
report-print.png in FOLDER. Set up once: apt-get install chromium; python3 -m venv .venv && .venv/bin/pip install pillow pypdfium2
"""
import csv
import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import pypdfium2
from PIL import Image

HERE = pathlib.Path(__file__).parent
QUIET = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--hide-scrollbars", "--virtual-time-budget=4000"]


def chromium(work: pathlib.Path, page: pathlib.Path, *arguments: str) -> str:
    profile = tempfile.mkdtemp(dir=work)
    command = ["chromium", *QUIET, f"--user-data-dir={profile}", *arguments, page.as_uri()]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout


def probed(work: pathlib.Path, report: pathlib.Path) -> list[dict]:
    """What each figure says at a third, a half and two thirds of its panels, and its ticks after a zoom."""
    page = work / "probed.html"
    page.write_text(report.read_text().replace("</body>", f"<script>\n{(HERE / 'probe.js').read_text()}</script></body>"))
    dom = chromium(work, page, "--window-size=1000,900", "--dump-dom")
    said = re.search(r'<pre id="said">(.*?)</pre>', dom, flags=re.S)
    if not said:
        sys.exit("the page has an error: nothing was said")
    return json.loads(html.unescape(said.group(1)))


def without_room(work: pathlib.Path, report: pathlib.Path, width: int) -> list[str]:
    """What has no room on a page of this width, in a frame, since a window is never narrower than 500."""
    (work / "framed.html").write_text(report.read_text().replace("</body>", f"<script>\n{(HERE / 'room.js').read_text()}</script></body>"))
    frame = work / "frame.html"
    frame.write_text(f"""<body style="margin:0"><script>addEventListener("message", (told) => {{
      document.body.appendChild(Object.assign(document.createElement("pre"), {{ id: "said", textContent: told.data }}));
    }})</script><iframe src="framed.html" style="border:0;width:{width}px;height:900px"></iframe>""")
    dom = chromium(work, frame, f"--window-size={max(width, 500)},900", "--allow-file-access-from-files", "--dump-dom")
    said = re.search(r'<pre id="said">(.*?)</pre>', dom, flags=re.S)
    if not said:
        sys.exit("the page has an error: nothing was said of its room")
    return json.loads(html.unescape(said.group(1)))["said"]


def number(lines: list[str], name: str) -> float | None:
    found = next((line for line in lines if line.startswith(f"{name}: ")), None)
    return float(found.split(": ")[1].split(" ")[0].replace("\u2212", "-")) if found else None


def agrees(said: list[str], rows: list[dict]) -> bool:
    """Whether one row of the recording has the load, the temperature and the readings that a figure says, within a thousandth of the axis."""
    columns = {"force": ("force_n", 0.006), "temperature": ("temperature_c", 0.04), "recorded": ("recorded_pf", 0.004),
               "calibrated model": ("base_pf", 0.004), "with what was missing": ("augmented_pf", 0.004)}
    wanted = [(column, number(said, name), within) for name, (column, within) in columns.items()]
    return any(all(value is not None and abs(float(row[column]) - value) < within for column, value, within in wanted) for row in rows)


def check(work: pathlib.Path, out: pathlib.Path) -> int:
    rows = list(csv.DictReader((out / "prediction.csv").open()))
    wrong = 0
    for figure in probed(work, out / "report.html"):
        for said in figure["said"]:
            courses = number(said, "recorded") is not None
            # a place far from any point says nothing, but not all of a figure
            good = any(figure["said"]) and (not courses or agrees(said, rows))
            wrong += not good
            print("ok   " if good else "WRONG", figure["name"], "|", " | ".join(said) or "nothing")
        zoomed = figure["zoomed"]
        wrong += zoomed is not None and not (zoomed["ticks"] != zoomed["before"] and zoomed["after"] == zoomed["before"])
    return wrong


def broken_in_print(work: pathlib.Path, page: pathlib.Path) -> list[str]:
    """Numbers of tables that are not on paper as they stand: cut off, or going on in the next line."""
    chromium(work, page, "--no-pdf-header-footer", f"--print-to-pdf={work / 'room.pdf'}")
    printed = " ".join(sheet.get_textpage().get_text_bounded() for sheet in pypdfium2.PdfDocument(work / "room.pdf")).split()
    numbers = {html.unescape(cell) for cell in re.findall(r'<td class="number">([^<\s]+)</td>', page.read_text())}
    return [f"broken in print: {number}" for number in sorted(numbers - set(printed))]


def room(work: pathlib.Path, page: pathlib.Path) -> int:
    said = broken_in_print(work, page)
    wrong = len(said)
    print(f"{'ok   ' if not said else 'WRONG'} {page.name}, printed", *said, sep="\n      ")
    for width in (1280, 768, 390):
        said = without_room(work, page, width)
        wrong += len(said)
        print(f"{'ok   ' if not said else 'WRONG'} {page.name}, {width} pixels wide", *said, sep="\n      ")
    return wrong


def pictures(work: pathlib.Path, report: pathlib.Path, folder: pathlib.Path) -> None:
    # a mouse, which a browser without a screen has not
    mouse = "--blink-settings=primaryHoverType=2,availableHoverTypes=2,primaryPointerType=4,availablePointerTypes=4"
    chromium(work, report, mouse, "--window-size=1000,900", f"--screenshot={work / 'wide.png'}")
    # a window is never narrower than 500
    phone = work / "phone.html"
    phone.write_text(f'<body style="margin:0"><iframe src="{report.as_uri()}" style="border:0;width:390px;height:844px"></iframe>')
    chromium(work, phone, "--window-size=500,844", f"--screenshot={work / 'phone.png'}")
    chromium(work, report, "--no-pdf-header-footer", f"--print-to-pdf={work / 'print.pdf'}")
    pages = [page.render(scale=0.9).to_pil() for page in pypdfium2.PdfDocument(work / "print.pdf")][:2]
    sheet = Image.new("RGB", (sum(page.width for page in pages) + 10, pages[0].height), "#808080")
    for place, page in enumerate(pages):
        sheet.paste(page, (place * (page.width + 10), 0))
    found = {"wide": Image.open(work / "wide.png"), "phone": Image.open(work / "phone.png").crop((0, 0, 390, 844)), "print": sheet}
    for name, picture in found.items():
        to = folder / f"report-{name}.png"
        picture.convert("RGB").quantize(128).save(to, optimize=True)
        print(to, to.stat().st_size, "bytes")


def main() -> int:
    arguments = sys.argv[1:]
    if not arguments:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        out = work / "out"
        subprocess.run([arguments[0], "diagnose", "example", "-o", str(out)], capture_output=True)
        if arguments[1:2] == ["--write"]:
            pictures(work, out / "report.html", pathlib.Path(arguments[2]))
            return 0
        wrong = check(work, out) + sum(room(work, page) for page in [out / "report.html", *(pathlib.Path(page).resolve() for page in arguments[1:])])
        print(f"{wrong} wrong")
        return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
