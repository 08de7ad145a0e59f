# What the cluster checks share: the study, the comparison. Sourced, not run.

TRUEGAP=${TRUEGAP:-target/debug/truegap}
SAMPLES=${SAMPLES:-3000000}
command -v "$TRUEGAP" > /dev/null || { echo "no $TRUEGAP: cargo build -p truegap-cli, or set TRUEGAP" >&2; exit 2; }
TRUEGAP=$(realpath "$(command -v "$TRUEGAP")")
WORK=$(mktemp -d "${TMPDIR:-/tmp}/truegap-cluster.XXXXXX")

# The two studies; a folder, then what is appended.
tolerance() { "$TRUEGAP" tolerance --samples "$SAMPLES" --limit span=2.3:2.6 --seed 7 -q -o "$@"; }
optimise() { "$TRUEGAP" optimise --searches 8 --seed 7 -q -o "$@"; }

# Everything in two folders is the same, byte for byte; what a killed process left half-written is not counted.
same() {
    if diff -r --exclude='*.part' "$1" "$2" > "$WORK/diff.txt"; then
        echo "same bytes: $(find "$1" -type f ! -name '*.part' | wc -l) files"
    else
        echo "DIFFERENT:"; head -5 "$WORK/diff.txt"; return 1
    fi
}

cases() { find "$1/cases" -name '*.json' 2> /dev/null | wc -l; }
halves() { find "$1/cases" -name '*.part' 2> /dev/null | wc -l; }
seconds() { date +%s.%N; }
since() { echo "$1 $(seconds)" | awk '{ printf "%.1f", $2 - $1 }'; }
FAILED=0
