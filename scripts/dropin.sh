#!/usr/bin/env bash
# Put granlaw's laws into a source tree of LIGGGHTS: one model header per law and the static library. Then build LIGGGHTS.
# Example: scripts/dropin.sh ~/LIGGGHTS-PUBLIC && make -C ~/LIGGGHTS-PUBLIC/src mpi
# Options: --from DIR (take what is built there, build nothing), --remove (take everything out again).
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
tree=
from=
remove=
while [ $# -gt 0 ]; do
    case "$1" in
    -h | --help) sed -n '2,4s/^# //p' "$0"; exit 0 ;;
    --from) from=$(realpath "${2:?--from needs a folder}"); shift 2 ;;
    --remove) remove=1; shift ;;
    -*) echo "dropin.sh: unknown option $1; see --help" >&2; exit 2 ;;
    *) tree=$1; shift ;;
    esac
done
fail() { echo "dropin.sh: $1" >&2; exit 2; }

[ -n "$tree" ] || fail "which source tree? see --help"
src=$tree
[ -f "$src/contact_models.h" ] || src=$tree/src
[ -f "$src/contact_models.h" ] || fail "$tree is no source tree of LIGGGHTS: there is no src/contact_models.h"
if [ -z "$from" ] && [ -z "$remove" ]; then
    (cd "$here" && cargo build --release --workspace --locked)
    from=${CARGO_TARGET_DIR:-$here/target}/release
fi
[ -n "$remove" ] || [ -x "$from/granlaw-dropin" ] || fail "there is no $from/granlaw-dropin; run cargo build --release --workspace"

# What an earlier run put there goes first, so that no law stays that granlaw no longer has.
for file in "$src"/*_model_*_rs.h; do
    ! grep -qs "Made by granlaw's scripts/dropin.sh" "$file" || rm "$file"
done
rm -rf "$src/granlaw.h" "$src/granlaw_dropin.h" "$src/granlaw"
[ ! -f "$src/Makefile.package" ] || sed -i '/granlaw/d' "$src/Makefile.package"
if [ -n "$remove" ]; then
    echo "granlaw is gone from $src"
    exit 0
fi

"$from/granlaw-dropin" "$src"
mkdir "$src/granlaw"
cp "$from/libgranlaw.a" "$src/granlaw/"
# LIGGGHTS's makefiles link what Makefile.package names, from a folder one below.
[ -f "$src/Makefile.package" ] || [ ! -f "$src/Makefile.package.empty" ] || cp "$src/Makefile.package.empty" "$src/Makefile.package"
[ ! -f "$src/Makefile.package" ] || echo "PKG_LIB += ../granlaw/libgranlaw.a -lm -lpthread -ldl" >>"$src/Makefile.package"

echo "$src now holds:"
sed -nE 's/^(NORMAL|COHESION|TANGENTIAL|ROLLING)_MODEL\(.*,(.*),.*/  \2/p' "$src"/*_model_*_rs.h
echo "Build LIGGGHTS as ever: its make finds them. With CMake add -DCMAKE_CXX_STANDARD_LIBRARIES=$(realpath "$src")/granlaw/libgranlaw.a"
