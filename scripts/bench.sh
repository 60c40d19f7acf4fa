#!/usr/bin/env bash
# What the Rust laws cost inside LIGGGHTS: pairs of runs, stock and rust in turn, of each deck; prints the medians of
# LIGGGHTS's Pair time and of their ratio. Both sides must write the same dump. A deck sees its side in the variable
# `rust`, 0 or 1, so that it can hold a law of ours against another of LIGGGHTS's; where the two are not the same law,
# `# bench: dumps differ` says so; `# bench: plugin on both sides` compares two laws that are both ours.
# Example: scripts/bench.sh --pairs 15 scripts/bench/fcc.in
set -euo pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
plugin=${GRANLAW_PLUGIN:-$here/../target/release/libgranlaw_liggghts.so}
pairs=15
path=contact # one call per contact
decks=()
while [ $# -gt 0 ]; do
    case "$1" in
    -h | --help) sed -n '2,7s/^# //p' "$0"; exit 0 ;;
    --pairs) pairs=${2:?--pairs needs a number}; shift 2 ;;
    -*) echo "bench.sh: unknown option $1; see --help" >&2; exit 2 ;;
    *) decks+=("$(realpath "$1")"); shift ;;
    esac
done
[ ${#decks[@]} -gt 0 ] || decks=("$here"/bench/*.in)
[ -f "$plugin" ] || { echo "bench.sh: no plugin at $plugin; run cargo build --release --workspace" >&2; exit 2; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Runs one side in its own folder and prints its Pair and Loop times [s], those of the longest run of the deck.
side() {
    mkdir -p "$scratch/$1" && cd "$scratch/$1"
    local env=(GRANLAW_LAWS=rust "GRANLAW_PATH=$path" "LD_PRELOAD=$plugin") rust=1
    if [ "$1" = stock ]; then
        rust=0
        grep -q '^# bench: plugin on both sides' "$2" || env=()
    fi
    env "${env[@]}" liggghts -in "$2" -var rust "$rust" >out.txt 2>&1 || { tail -5 out.txt >&2; exit 2; }
    awk '/^Pair  time/ && $5 > pair {pair = $5} /^Loop time/ && $4 > loop {loop = $4} END {print pair, loop}' out.txt
}

# The quantiles 0, 1/4, 1/2, 3/4 and 1 of an expression over the lines "stock-pair stock-loop rust-pair rust-loop".
quantiles() {
    awk "{print $1}" "$scratch/times" | sort -g | awk '
        {v[NR] = $1}
        END {for (q = 0; q <= 4; q++) {x = 1 + q * (NR - 1) / 4; k = int(x); printf "%.4f ", v[k] + (x - k) * (v[k + (x > k)] - v[k])}}'
}

summary() {
    local -a stock rust pair loop
    read -ra stock <<<"$(quantiles '$1')"
    read -ra rust <<<"$(quantiles '$3')"
    read -ra pair <<<"$(quantiles '$3 / $1')"
    read -ra loop <<<"$(quantiles '$4 / $2')"
    echo "  Pair time: stock ${stock[2]} s, rust ${rust[2]} s (medians of $pairs interleaved pairs)"
    echo "  rust/stock, Pair: median ${pair[2]}, quartiles ${pair[1]} to ${pair[3]}, extremes ${pair[0]} to ${pair[4]}"
    echo "  rust/stock, Loop: median ${loop[2]}"
}

for deck in "${decks[@]}"; do
    echo "$(basename "$deck")"
    : >"$scratch/times"
    for ((k = 1; k <= pairs; k++)); do
        # The order alternates, so that a drift of the machine does not favour a side.
        if ((k % 2)); then stock=$(side stock "$deck") rust=$(side rust "$deck"); else rust=$(side rust "$deck") stock=$(side stock "$deck"); fi
        grep -q '^# bench: dumps differ' "$deck" || cmp -s "$scratch"/{stock,rust}/dump.txt || { echo "bench.sh: $deck: the two sides disagree" >&2; exit 1; }
        echo "$stock $rust" >>"$scratch/times"
    done
    summary
done
