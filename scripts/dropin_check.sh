#!/usr/bin/env bash
# Build a whole LIGGGHTS from Debian's source with granlaw's models in it, run decks on them, and compare every dump with
# that of Debian's own LIGGGHTS, byte for byte. Takes some minutes; needs the network for the source.
# Example: scripts/dropin_check.sh [FOLDER]      (FOLDER keeps source and build for the next time)
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
case "${1:-}" in
-h | --help) sed -n '2,4s/^# //p' "$0"; exit 0 ;;
esac
source "$here/scripts/setup.sh"
granlaw_setup
if [ $# -gt 0 ]; then
    mkdir -p "$1"
    work=$(realpath "$1")
else
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
fi

# The source package, from lists of our own: the machine's are left as they are.
fetch() {
    local suite
    suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
    mkdir -p "$work"/apt/{lists/partial,parts,cache/archives/partial}
    cat >"$work/apt/parts/source.sources" <<END
Types: deb-src
URIs: http://deb.debian.org/debian
Suites: $suite
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
END
    cat >"$work/apt/apt.conf" <<END
Dir::Etc::sourcelist "/dev/null";
Dir::Etc::sourceparts "$work/apt/parts";
Dir::State::lists "$work/apt/lists";
Dir::Cache "$work/apt/cache";
END
    (cd "$work/apt" && APT_CONFIG=$work/apt/apt.conf apt-get update -q &&
        APT_CONFIG=$work/apt/apt.conf apt-get source -q --tar-only --only-source liggghts)
    mkdir "$work/tree.part"
    tar xf "$work"/apt/liggghts_*.orig.tar.* -C "$work/tree.part" --strip-components=1
    # Debian's changes to the headers, and what its compiler would not take in the rest; VTK is left out.
    cp /usr/include/liggghts/*.h "$work/tree.part/src/"
    rm -f "$work"/tree.part/src/*vtk* "$work"/tree.part/src/*vtm*
    sed -i 's/numneigh > 0)/numneigh)/' "$work/tree.part/src/finish.cpp"
    mv "$work/tree.part" "$work/tree"
}
[ -d "$work/tree" ] || fetch

"$here/scripts/dropin.sh" "$work/tree"
make -C "$work/tree/src" -j"$(nproc)" mpi LMP_INC= VTK_INC= VTK_PATH= VTK_LIB= \
    CC="mpic++ -std=gnu++17 -fpermissive -w -DOMPI_SKIP_MPICXX" >"$work/make.log" 2>&1 ||
    { grep -m5 'error' "$work/make.log" >&2; echo "dropin_check.sh: LIGGGHTS does not build; all of it is in $work/make.log" >&2; exit 2; }

failed=0
for deck in hysteresis_history_cdt two_types mesh_wall hertz_history hooke_no_history_cdt frozen_partner settling_box; do
    rm -rf "$work/run" && mkdir -p "$work"/run/{stock,rust}
    cp "$here"/liggghts_inputs/*.stl "$work/run/stock" && cp "$here"/liggghts_inputs/*.stl "$work/run/rust"
    cp "$here/liggghts_inputs/$deck.in" "$work/run/stock/deck.in"
    sed -E '/^ *(pair_style|fix .*wall\/gran)/s#(model|tangential|rolling_friction) ([a-z_/]+)#\1 \2/rs#g' \
        "$work/run/stock/deck.in" >"$work/run/rust/deck.in"
    (cd "$work/run/stock" && liggghts -in deck.in >out.txt)
    (cd "$work/run/rust" && "$work/tree/src/lmp_mpi" -in deck.in >out.txt) || tail -3 "$work/run/rust/out.txt"
    if grep -q '/rs' "$work/run/rust/deck.in" && cmp "$work"/run/{stock,rust}/dump.txt; then
        echo "$deck: the same, $(wc -l <"$work/run/rust/dump.txt") lines"
    else
        echo "$deck: DIFFERS" && failed=1
    fi
done
exit $failed
