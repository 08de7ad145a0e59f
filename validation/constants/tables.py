"""The result files of the study, from single answers.

Limits: an answer counts as another one where the verdict, the names or the sets differ; probabilities alone do not count.
"""

import csv
import math

import battery
import inventory

MOST = 20


def write(answers, references, factors):
    entries = inventory.constants()
    rows = [row(entry, answers, references, factors) for entry in entries]
    save("constants.csv", rows)
    told = sorted(filter(None, (decides(entry, answers, references, factors) for entry in entries)), key=lambda r: r[0])
    save("most.csv", [r for _, r in told[:MOST]])
    save("changed.csv", [r for entry in entries for r in changes(entry, answers, references, factors)])
    save("battery.csv", [reference(one) for one in references.values()])
    save("counts.csv", counts(entries, answers, references, factors))


def save(name, rows):
    with (inventory.HERE / name).open("w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def found(entry, word, answers, references):
    """Pairs of answer before and after, by recording, of those that were run."""
    keys = ((name, (entry["id"], word, name)) for name in references)
    return {name: (references[name]["answer"], answers[key]) for name, key in keys if key in answers}


def other(before, after):
    """Whether the verdict differs, and whether the names do."""
    return before["verdict"] != after["verdict"], battery.names(before) != battery.names(after)


def percent(log):
    """A factor as a change in per cent."""
    change = 100 * math.expm1(log)
    return f"{change:+.0f} %" if abs(change) >= 0.5 else "0"


def right(pairs, references, side):
    """Recordings of known truth that are answered right, or right within their sets."""
    return sum(bool(battery.is_right(references[name]["truth"], pair[side])) for name, pair in pairs.items())


def told(value):
    """A value, or several, for a reader."""
    return " ".join(f"{n:.4g}" for n in value)


def row(entry, answers, references, factors):
    read = sum(entry["id"] in r["reads"] and r.get("only", entry["stage"]) == entry["stage"] for r in references.values())
    line = {"constant": entry["id"], "value": entry["value"], "what it is": entry["means"]}
    line |= {"from": entry["from"], "why": entry["why"]}
    for word, factor in factors.items():
        pairs = found(entry, word, answers, references)
        line[f"{word} to"] = told(inventory.turned(entry, factor))
        if not pairs:
            line[f"{word}: answered"] = "not turned" if read else "not read"
            line |= {f"{word}: {what}": "" for what in ("verdicts", "names", "right", "error")}
            continue
        line[f"{word}: answered"] = f"{len(pairs)} of {read}"
        differ = [other(*pair) for pair in pairs.values()]
        errors = [battery.change(*pair) for pair in pairs.values()]
        gain = right(pairs, references, 1) - right(pairs, references, 0)
        line[f"{word}: verdicts"] = sum(d[0] for d in differ)
        line[f"{word}: names"] = sum(d[1] for d in differ)
        line[f"{word}: right"] = f"{gain:+d}" if gain else 0
        line[f"{word}: error"] = percent(max(errors, key=abs))
    return line


def decides(entry, answers, references, factors):
    """Key for sorting and row of a constant that changes some answer."""
    changed, gains, largest, runs = 0, [], 0.0, 0
    where = set()
    for word in factors:
        pairs = found(entry, word, answers, references)
        runs += len(pairs)
        these = {name for name, pair in pairs.items() if any(other(*pair))}
        where |= these
        changed += len(these)
        gains.append(right(pairs, references, 1) - right(pairs, references, 0))
        largest = max([largest, *(battery.change(*pair) for pair in pairs.values())], key=abs)
    if not changed:
        return None
    line = {"constant": entry["id"], "value": entry["value"], "from": entry["from"], "other answers": f"{changed} of {runs}"}
    line |= {"right, halved and doubled": f"{gains[0]:+d}, {gains[1]:+d}", "largest change of error": percent(largest)}
    return (-changed, -abs(largest)), {**line, "recordings": " ".join(sorted(where))}


def changes(entry, answers, references, factors):
    for word in factors:
        for name, (before, after) in found(entry, word, answers, references).items():
            if any(other(before, after)):
                yield {
                    "constant": entry["id"],
                    "turned to": told(after["values"]),
                    "recording": name,
                    "before": said(before),
                    "after": said(after),
                    "error": percent(battery.change(before, after)),
                }


def said(answer):
    sets = [" or ".join(s) for s in answer["sets"]]
    return ": ".join(filter(None, [answer["verdict"], "; ".join([" + ".join(answer["names"]), *sets]).strip("; ")]))


def reference(one):
    answer, right = one["answer"], battery.is_right(one["truth"], one["answer"])
    probable = ", ".join(f"{p:.3g}" for p in answer["probability"]) or f"nothing missing: {answer['agrees']:.3g}"
    words = {None: "", True: "yes", False: "no"}
    return {"recording": one["name"], "truth": one["truth"], "answer": said(answer), "probability": probable, "right": words[right], "why it is here": one["why"]}


def counts(entries, answers, references, factors):
    """How many constants of each origin change what."""
    lines = []
    for origin in ["derived", "measured", "literature", "convention", "chosen"]:
        own = [e for e in entries if e["from"] == origin]
        run = [e for e in own if any(found(e, word, answers, references) for word in factors)]
        another = [e for e in run if decides(e, answers, references, factors)]
        lines.append({"from": origin, "constants": len(own), "read by the battery and turned": len(run), "change a verdict or a name": len(another)})
    whole = {key: sum(line[key] for line in lines) for key in lines[0] if key != "from"}
    return [*lines, {"from": "all", **whole}]
