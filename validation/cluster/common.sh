# What the cluster checks share: the studies, the comparison. Sourced, not run. STUDIES names those to run, SAMPLES and DESIGNS their size.

TRUEGAP=${TRUEGAP:-target/debug/truegap}
SAMPLES=${SAMPLES:-3000000}
DESIGNS=${DESIGNS:-32}
STUDIES=${STUDIES:-tolerance optimise}
command -v "$TRUEGAP" > /dev/null || { echo "no $TRUEGAP: cargo build -p truegap-cli, or set TRUEGAP" >&2; exit 2; }
TRUEGAP=$(realpath "$(command -v "$TRUEGAP")")
WORK=$(mktemp -d "${TMPDIR:-/tmp}/truegap-cluster.XXXXXX")

# A space of designs: every assumption of each by finite elements.
printf 'schema = "truegap.space/1"\nsensor = "singletact-s15-4.5n"\ndesigns = %s\nseed = 7\n' "$DESIGNS" > "$WORK/space.toml"

# The command of a study, without its folder.
command_of() {
    case $1 in
        tolerance) COMMAND=("$TRUEGAP" tolerance --samples "$SAMPLES" --limit span=2.3:2.6 --seed 7 -q) ;;
        optimise) COMMAND=("$TRUEGAP" optimise --searches 8 --seed 7 -q) ;;
        audit) COMMAND=("$TRUEGAP" audit --space "$WORK/space.toml" -q) ;;
        *) echo "no study $1: tolerance, optimise or audit" >&2; exit 2 ;;
    esac
}

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
