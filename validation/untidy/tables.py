"""Tables as people have them, each made of the clean one, with the rows that a reader has to find in it."""
import dataclasses
import datetime
import gzip
from collections.abc import Callable, Iterable

from clean import Row, rows

CLEAN = rows()
HEADER = "Time (s),Load (N),Temp (°C),Reading (mV)"
#: what `--map` says of the columns where no TOML does
COLUMNS = ("time=Time (s)", "force=Load (N)", "temperature=Temp (°C)", "response=Reading (mV)")
START = datetime.datetime(2026, 3, 1, 11, 59, 10)


@dataclasses.dataclass(frozen=True)
class Table:
    """A table, what is odd about it and what must come of it."""

    name: str
    odd: str
    content: bytes
    #: the rows that must be read, as the clean table has them
    kept: tuple[Row, ...] = tuple(CLEAN)
    #: `--map` of a table without a TOML
    columns: tuple[str, ...] = COLUMNS
    #: what a person adds to both ways: --map of what `init` leaves open, --dayfirst
    told: tuple[str, ...] = ()
    #: words of the refusal, where it must be refused; any of them will do, as `init` and a diagnosis need not say the same
    refused: tuple[str, ...] = ()
    #: words of a note that must be told, where something was left out or assumed
    note: str = ""
    file: str = "table.csv"
    standard_input: bool = False


def cells(row: Row) -> list[str]:
    return [f"{row.time:.1f}", f"{row.force:.3f}", f"{row.temperature:.2f}", f"{row.reading:.3f}"]


def joined(separator: str = ",", of: Callable[[Row], list[str]] = cells, among: Iterable[Row] = CLEAN) -> list[str]:
    return [separator.join(of(row)) for row in among]


def text(*lines: str, end: str = "\n", encoding: str = "utf-8") -> bytes:
    return "".join(line + end for line in lines).encode(encoding)


def comma(row: Row) -> list[str]:
    return [cell.replace(".", ",") for cell in cells(row)]


def named(time: str, force: str, temperature: str, reading: str) -> tuple[str, ...]:
    return (f"time={time}", f"force={force}", f"temperature={temperature}", f"response={reading}")


def with_time(stamp: Callable[[Row], str]) -> Callable[[Row], list[str]]:
    return lambda row: [stamp(row), *cells(row)[1:]]


def at(row: Row) -> datetime.datetime:
    return START + datetime.timedelta(seconds=row.time)


def separators() -> list[Table]:
    semicolons = HEADER.replace(",", ";")
    return [
        Table("plain", "units in brackets in the names", text(HEADER, *joined())),
        Table("semicolons", "semicolons, decimal commas", text(semicolons, *joined(";", comma))),
        Table("semicolons-points", "semicolons, decimal points", text(semicolons, *joined(";"))),
        Table("tabs", "tabs", text(HEADER.replace(",", "\t"), *joined("\t")), file="table.txt"),
        Table("tabs-commas", "tabs, decimal commas", text(HEADER.replace(",", "\t"), *joined("\t", comma)), file="table.tsv"),
        Table("blanks", "columns of blanks, one word a name", text("time_s force_n temperature_c response_mv", *(
            "".join(cell.rjust(12) for cell in cells(row)) for row in CLEAN)), file="table.dat",
            columns=named("time_s", "force_n", "temperature_c", "response_mv")),
        Table("quoted-commas", "commas, and numbers with decimal commas in quotes",
              text(HEADER, *joined(of=lambda row: [f'"{cell}"' for cell in comma(row)]))),
        Table("quoted", "every cell in quotes", text(*(",".join(f'"{cell}"' for cell in line.split(",")) for line in [HEADER, *joined()]))),
        Table("trailing", "a separator at the end of each line", text(*(f"{line}," for line in [HEADER, *joined()]))),
        Table("trailing-rows", "a separator at the end of each row, none in the header", text(HEADER, *(f"{line}," for line in joined()))),
        Table("blanks-behind-commas", "a blank behind each comma", text(HEADER.replace(",", ", "), *joined(", "))),
        Table("excel-sep", "a first line `sep=;`, as Excel wants it", text("sep=;", semicolons, *joined(";", comma))),
        Table("crlf", "line ends of Windows", text(HEADER, *joined(), end="\r\n")),
        Table("cr", "line ends of an old Macintosh", text(HEADER, *joined(), end="\r")),
        Table("blank-lines", "an empty line after each row", text(HEADER, *joined(), end="\n\n")),
        Table("no-last-end", "no line end behind the last row", text(HEADER, *joined())[:-1]),
    ]


def letters() -> list[Table]:
    return [
        Table("byte-order-mark", "UTF-8 with a byte order mark", b"\xef\xbb\xbf" + text(HEADER, *joined())),
        Table("utf-16", "UTF-16, as Excel saves text", b"\xff\xfe" + text(HEADER.replace(",", "\t"), *joined("\t"), encoding="utf-16-le"), file="table.txt"),
        Table("utf-16-be", "UTF-16, the other way round", b"\xfe\xff" + text(HEADER, *joined(), encoding="utf-16-be")),
        Table("latin-1", "Latin-1, with a degree sign", text(HEADER, *joined(), encoding="latin-1"), note="Windows-1252"),
        Table("latin-1-remark", "Latin-1 in a remark above", text("# Prüfstand 3, Größe klein", "time_s,force_n,temperature_c,response_mv", *joined(), encoding="latin-1"),
              columns=named("time_s", "force_n", "temperature_c", "response_mv")),
    ]


def headers() -> list[Table]:
    short, plain = named("t", "F", "T", "U"), named("time_s", "force_n", "temperature_c", "response_mv")
    german = named("Zeit [s]", "Kraft [N]", "Temperatur [°C]", "Spannung [mV]")
    extra = lambda row: [cells(row)[3], "ok", "Müller", cells(row)[1], cells(row)[0], f"{row.time * 2:.0f}", cells(row)[2], ""]  # noqa: E731
    return [
        Table("units-below", "units in a second header row", text("t,F,T,U", "s,N,°C,mV", *joined()), columns=short),
        Table("units-below-brackets", "units in a second header row, in brackets", text("t;F;T;U", "[s];[N];[°C];[mV]", *joined(";", comma)), columns=short),
        Table("remarks", "a preamble behind `#`", text("# rig: 7", "# operator; A, B", "#", HEADER, *joined())),
        Table("remarks-between", "remarks between the rows", text(HEADER, *joined()[:90], "# load cell zeroed", *joined()[90:])),
        Table("numpy", "names behind `#`, as numpy.savetxt writes them", text("# time_s force_n temperature_c response_mv", *(
            " ".join(f"{float(cell):.18e}" for cell in cells(row)) for row in CLEAN)), file="table.dat", columns=plain),
        Table("matlab", "a preamble and names behind `%`", text("% created 01-Mar-2026", "% time_s, force_n, temperature_c, response_mv", *joined()), columns=plain),
        Table("instrument", "what the instrument says of itself above the table", text(
            "Instrument;LC-50", "Serial no.;1234", "Started;2026-03-01 11:59:10", "", HEADER.replace(",", ";"), *joined(";", comma)), note="above the header"),
        Table("labview", "a LabVIEW preamble", text(
            "LabVIEW Measurement", "Writer_Version\t2", "Separator\tTab", "***End_of_Header***", "", HEADER.replace(",", "\t"), *joined("\t")),
            file="table.lvm", note="above the header"),
        Table("german", "German names", text("Zeit [s];Kraft [N];Temperatur [°C];Spannung [mV]", *joined(";", comma)), columns=german),
        Table("french", "French names", text("Temps (s);Force (N);Température (°C);Tension (mV)", *joined(";", comma)),
              columns=named("Temps (s)", "Force (N)", "Température (°C)", "Tension (mV)")),
        Table("index", "a first column without a name, as pandas writes its index", text(f",{HEADER}", *(f"{at},{line}" for at, line in enumerate(joined())))),
        Table("others", "other columns between: text, names, counts, nothing at all", text(
            "Reading (mV),State,Operator,Load (N),Time (s),Sample,Temp (°C),Remark", *joined(of=extra))),
        Table("same-name", "two columns of one name that play no part", text(f"{HEADER},Spare,Spare", *(f"{line},1,2" for line in joined()))),
        Table("same-name-load", "two columns called `Load (N)`", text(f"{HEADER},Load (N)", *(f"{line},1" for line in joined())), refused=("`Load (N)`",)),
        Table("no-header", "no header", text(*joined()), refused=("is a number",)),
        Table("header-again", "the header once more in the middle", text(HEADER, *joined()[:120], HEADER, *joined()[120:]), refused=("header",)),
        Table("footer", "lines of words below the table", text(HEADER, *joined(), "", "End of measurement", "Operator,A. B."), note="below the rows"),
    ]


def clocks() -> list[Table]:
    stamped = HEADER.replace("Time (s)", "Timestamp")
    columns = ("time=Timestamp", *COLUMNS[1:])
    clock = lambda row: at(row).strftime("%H:%M:%S.%f")[:-5]  # noqa: E731
    coarse = [dataclasses.replace(one, force=(one.force + two.force) / 2, temperature=(one.temperature + two.temperature) / 2,
                                  reading=(one.reading + two.reading) / 2) for one, two in zip(CLEAN[::2], CLEAN[1::2])]

    def of(name: str, odd: str, stamp: Callable[[Row], str], **more: object) -> Table:
        return Table(name, odd, text(stamped, *joined(of=with_time(stamp))), **{"columns": columns, **more})

    slashes = lambda form: lambda row: (datetime.datetime(2026, 3, 4, 23, 59, 0) + datetime.timedelta(seconds=row.time)).strftime(form)  # noqa: E731
    return [
        of("iso", "ISO stamps in UTC", lambda row: at(row).isoformat(timespec="milliseconds") + "Z"),
        of("iso-zone", "ISO stamps with a zone", lambda row: at(row).isoformat(timespec="milliseconds") + "+01:00"),
        of("local", "local stamps, a blank between day and time", lambda row: at(row).isoformat(" ", "milliseconds")),
        of("zone-name", "stamps that end with UTC", lambda row: at(row).isoformat(" ", "milliseconds") + " UTC"),
        of("dots", "German dates", lambda row: at(row).strftime("%d.%m.%Y %H:%M:%S.%f")[:-3]),
        of("dots-short", "German dates with two digits of the year", lambda row: at(row).strftime("%d.%m.%y %H:%M:%S.%f")[:-3]),
        of("pm", "an American day with AM and PM", lambda row: at(row).strftime("%m/%d/%Y %I:%M:%S.%f")[:-3] + at(row).strftime(" %p")),
        of("slashes", "04/03/2026 to 05/03/2026, which nobody can tell", slashes("%d/%m/%Y %H:%M:%S.%f"), refused=("dayfirst",)),
        of("slashes-told", "the same with `--dayfirst`", slashes("%d/%m/%Y %H:%M:%S.%f"), told=("--dayfirst",)),
        of("month-shows", "a day above 12 behind the month", lambda row: (at(row) + datetime.timedelta(days=20)).strftime("%m/%d/%Y %H:%M:%S.%f")),
        Table("date-and-time", "the date in one column, the time of day in another", text(
            HEADER.replace("Time (s)", "Date,Time"), *joined(of=lambda row: ["2026-03-01", clock(row), *cells(row)[1:]])),
            columns=("time=Time", *COLUMNS[1:]), note="`Date` and `Time`"),
        of("time-of-day", "a time of day alone", clock, refused=("times of day", "hold no number")),
        of("milliseconds", "whole milliseconds since 1970", lambda row: str(int(1_772_366_350_000 + 1000 * row.time)), columns=("time=Timestamp:ms", *COLUMNS[1:]),
           told=("--map", "time=Timestamp:ms")),
        of("epoch", "seconds since 1970", lambda row: f"{1_772_366_350 + row.time:.1f}", columns=("time=Timestamp:s", *COLUMNS[1:]), told=("--map", "time=Timestamp:s")),
        Table("minutes", "minutes", text(HEADER.replace("Time (s)", "Elapsed [min]"), *joined(of=with_time(lambda row: repr(row.time / 60)))),
              columns=("time=Elapsed [min]", *COLUMNS[1:])),
        Table("coarse", "a clock that shows each second twice", text(HEADER, *joined(of=with_time(lambda row: str(int(row.time))))), kept=tuple(coarse),
              note="time of the row before"),
        Table("twice", "each tenth row written twice", text(HEADER, *(line for at, line in enumerate(joined()) for _ in range(2 if at % 10 == 0 else 1))),
              note="time of the row before"),
        Table("back", "a clock that is set back by an hour", text(HEADER, *joined(of=with_time(lambda row: f"{row.time - (50 if row.time > 60 else 0):.1f}"))),
              refused=("time goes back",)),
    ]


def missing() -> list[Table]:
    holes = {at: at % 4 for at in range(7, 240, 23)}
    kept = tuple(row for at, row in enumerate(CLEAN) if at not in holes)

    def with_holes(mark: str) -> bytes:
        of = lambda at, row: [mark if holes.get(at) == column else cell for column, cell in enumerate(cells(row))]  # noqa: E731
        return text(HEADER, *(",".join(of(at, row)) for at, row in enumerate(CLEAN)))

    marks = [("empty", "empty cells", ""), ("nan", "cells with NaN", "NaN"), ("na", "cells with NA", "NA"), ("div", "cells with #DIV/0!", "#DIV/0!"),
             ("dashes", "cells with --", "--"), ("inf", "cells with -inf", "-inf"), ("quoted-empty", "cells with two quotes", '""')]
    short = [line.rsplit(",", 1)[0] if at in holes else line for at, line in enumerate(joined())]
    most = [line if at % 3 == 0 else line.rsplit(",", 1)[0] + "," for at, line in enumerate(joined())]
    over = [line.rsplit(",", 1)[0] + ",OVER" if at in holes else line for at, line in enumerate(joined())]
    return [
        *(Table(name, odd, with_holes(mark), kept=kept, note="left out") for name, odd, mark in marks),
        Table("short-rows", "rows that end before the reading", text(HEADER, *short), refused=("cells",)),
        Table("mostly-empty", "two of three rows without a reading", text(HEADER, *most), refused=("would be left out",)),
        Table("over", "cells that say OVER", text(HEADER, *over), refused=("`OVER`",)),
    ]


def packed() -> list[Table]:
    plain = text(HEADER, *joined())
    return [
        Table("gzip", "packed by gzip", gzip.compress(plain, mtime=0), file="table.csv.gz"),
        Table("standard-input", "on standard input", plain, standard_input=True),
        Table("gzip-standard-input", "packed by gzip, on standard input", gzip.compress(plain, mtime=0), standard_input=True),
        Table("semicolons-standard-input", "semicolons, decimal commas and Latin-1 on standard input",
              text(HEADER.replace(",", ";"), *joined(";", comma), encoding="latin-1"), standard_input=True, note="Windows-1252"),
    ]


def numbers() -> list[Table]:
    def scaled(header: str, columns: tuple[str, ...], of: Callable[[Row], list[str]], name: str, odd: str, **more: object) -> Table:
        return Table(name, odd, text(header, *joined(of=of)), columns=columns, **more)

    def load(name: str, odd: str, unit: str, factor: float) -> Table:
        column = f"Load ({unit})"
        return scaled(HEADER.replace("Load (N)", column), (COLUMNS[0], f"force={column}", *COLUMNS[2:]),
                      lambda row: [cells(row)[0], repr(row.force / factor), *cells(row)[2:]], name, odd)

    def temperature(name: str, odd: str, column: str, of: Callable[[float], float]) -> Table:
        return scaled(HEADER.replace("Temp (°C)", column), (*COLUMNS[:2], f"temperature={column}", COLUMNS[3]),
                      lambda row: [*cells(row)[:2], repr(of(row.temperature)), cells(row)[3]], name, odd)

    thousands = lambda row: [*cells(row)[:3], f'"{1000 * row.reading:,.0f}"']  # noqa: E731
    return [
        temperature("fahrenheit", "`Temp (F)` in degrees Fahrenheit", "Temp (F)", lambda c: 1.8 * c + 32.0),
        temperature("kelvin", "`T_chamber [K]` in kelvin", "T_chamber [K]", lambda c: c + 273.15),
        load("grams", "a load in grams", "g", 9.80665e-3),
        load("pounds", "a load in lbf", "lbf", 4.448_221_615_260_5),
        load("millinewtons", "a load in mN", "mN", 1e-3),
        Table("exponents", "numbers as 1.5E+02, with signs", text(HEADER, *joined(of=lambda row: [f"{float(cell):+.6E}" for cell in cells(row)]))),
        Table("thousands-points", "points between thousands, decimal commas elsewhere", text(
            HEADER.replace(",", ";"), *joined(";", lambda row: [*comma(row)[:3], f"{1000 * row.reading:,.0f}".replace(",", ".")])), refused=("in thousands",)),
        Table("true-minus", "a true minus sign (U+2212)", text(HEADER, *joined(of=lambda row: [f"{row.time - 60:.1f}".replace("-", "\u2212"), *cells(row)[1:]])),
              kept=tuple(dataclasses.replace(row, time=row.time - 60) for row in CLEAN)),
        Table("units-in-cells", "units in the cells, as `5.2 N`", text(HEADER, *joined(of=lambda row: [cells(row)[0], f"{cells(row)[1]} N", *cells(row)[2:]])),
              refused=("is not a number", "hold no number")),
        Table("thousands", "commas between thousands, in quotes", text(HEADER, *joined(of=thousands)), refused=("thousands", "hold no number")),
        Table("no-unit", "a load without a unit", text(HEADER.replace("Load (N)", "Load"), *joined()), columns=(COLUMNS[0], "force=Load:N", *COLUMNS[2:]),
              told=("--map", "force=Load:N")),
    ]


def all_tables() -> list[Table]:
    found = [*separators(), *letters(), *headers(), *clocks(), *missing(), *packed(), *numbers()]
    names = [table.name for table in found]
    assert len(names) == len(set(names)), "two tables have one name"
    return found
