#!/usr/bin/env bash
# Run the AVX-512 code where no processor has it, on an emulated one (Bochs): its tests, and decks on the Rust laws against
# LIGGGHTS alone, dumps byte for byte. Takes four minutes; the first time it fetches Debian's kernel.
# Example: scripts/avx512.sh
# Options: --quick (the tests and one deck, 80 seconds), --count (instructions per contact on scenes of benchmarks/, half an
# hour), --model NAME (another processor of `bochs --help cpu`; without AVX-512 it must fail)
set -euo pipefail
cd "$(dirname "$0")/.."
task=check
model=corei7_skylake_x
while [ $# -gt 0 ]; do
    case "$1" in
    -h | --help) sed -n '2,6s/^# //p' "$0"; exit 0 ;;
    --quick | --count) task=${1#--}; shift ;;
    --model) model=${2:?--model needs a name}; shift 2 ;;
    *) echo "avx512.sh: unknown argument $1; see --help" >&2; exit 2 ;;
    esac
done
source scripts/setup.sh
granlaw_packages+=("${granlaw_emulator[@]}")
granlaw_setup
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
kernel=$target/avx512-kernel
work=$(mktemp -d)
machine=
trap 'kill "$machine" 2>/dev/null || true; rm -rf "$work"' EXIT

# Debian's kernel for virtual machines, the smallest. It is unpacked, not installed.
fetch_kernel() {
    local package
    package=$(apt-cache depends linux-image-cloud-amd64 2>/dev/null | sed -n 's/^ *Depends: //p' | head -1)
    [ -n "$package" ] && cd "$work" && apt-get download -q "$package" && dpkg-deb -x "$package"_*.deb unpacked &&
        cp unpacked/boot/vmlinuz-* kernel
}
if [ ! -f "$kernel" ]; then
    (fetch_kernel) || { granlaw_root apt-get update -q && (fetch_kernel); }
    mkdir -p "$target" && mv "$work/kernel" "$kernel"
fi

cargo build --release --workspace --locked
tests=$(cargo test --release --workspace --exclude granlaw-liggghts --locked --lib --test bits --no-run --message-format=json |
    sed -nE 's/.*"executable":"([^"]*\/(granlaw_lanes|bits)-[^"]*)".*/\1/p')

# The system: a memory disk with LIGGGHTS, the plugin, the tests, every library that they load, and busybox for the rest.
root=$work/root
put() { # FILE...: with the libraries that it needs
    local file
    for file in "$@"; do
        cp -Lu --parents "$file" $(ldd "$file" | grep -o '/[^ ]*') "$root"
    done
}
mkdir -p "$root"/{bin,dev,etc,proc,sys,tmp,granlaw/tests} "$work/cd/isolinux"
put "$(command -v liggghts)" "$(command -v mpirun)" "$target/release/libgranlaw_liggghts.so" $tests
put /usr/lib/x86_64-linux-gnu/openmpi/lib/openmpi3/*.so /usr/lib/x86_64-linux-gnu/pmix2/lib/pmix/*.so
cp -r --parents /etc/openmpi /usr/share/openmpi "$root"
mv "$root$target/release/libgranlaw_liggghts.so" "$root/granlaw/plugin.so"
for test in $tests; do mv "$root$test" "$root/granlaw/tests/"; done
cp -r benchmarks liggghts_inputs "$root/granlaw/"
find "$root" -type f \( -name '*.so*' -o -path '*/tests/*' \) -exec strip --strip-debug {} +
cp "$(command -v busybox)" "$root/bin/"
busybox --list | grep -vx busybox | while read -r name; do ln -sf busybox "$root/bin/$name"; done
# mpirun asks for one even if it starts nothing elsewhere.
ln -sf busybox "$root/bin/ssh"
echo 'root:x:0:0:root:/:/bin/sh' >"$root/etc/passwd"
install -m 755 scripts/avx512_inside.sh "$root/init"
(cd "$root" && find . | cpio -o -H newc --quiet) >"$work/cd/isolinux/initrd"

# The machine. One tick of its clock is one instruction, so times that programs measure in it count instructions. Bochs 2.7
# gives a wrong size for the compact form of saved registers, so the kernel must use the other.
cp "$kernel" "$work/cd/isolinux/vmlinuz"
cp /usr/lib/ISOLINUX/isolinux.bin /usr/lib/syslinux/modules/bios/ldlinux.c32 "$work/cd/isolinux/"
cat >"$work/cd/isolinux/isolinux.cfg" <<END
default granlaw
label granlaw
kernel vmlinuz
append initrd=initrd console=ttyS0 loglevel=0 mitigations=off clearcpuid=xsaves,xsavec tsc=reliable tsc_early_khz=100000 lpj=400000 nowatchdog cryptomgr.notests=1 -- $task
END
xorriso -as mkisofs -quiet -o "$work/cd.iso" -b isolinux/isolinux.bin -no-emul-boot -boot-load-size 4 -boot-info-table "$work/cd"
cat >"$work/bochsrc" <<END
cpu: model=$model, count=1, ips=100000000, reset_on_triple_fault=0
clock: sync=none
memory: guest=1024, host=1024
romimage: file=/usr/share/bochs/BIOS-bochs-latest, options=fastboot
vgaromimage: file=/usr/share/vgabios/vgabios.bin
display_library: term
ata0-master: type=cdrom, path=$work/cd.iso, status=inserted
boot: cdrom
com1: enabled=1, mode=file, dev=$work/serial
log: $work/log
panic: action=fatal
error: action=ignore
info: action=ignore
END
# Debian's Bochs has the debugger, which waits for a word, and only screens that want a terminal.
echo c >"$work/rc"
touch "$work/serial"
limit=3h
[ "$task" != quick ] || limit=15m
TERM=vt100 script -qec "nice timeout -k 5 $limit bochs -q -f $work/bochsrc -rc $work/rc" "$work/screen" </dev/null >/dev/null &
machine=$!
tail -f --pid=$machine "$work/serial" || true
wait $machine || true
tr -d '\r' <"$work/serial" | grep -qx 'everything holds' || { tail -3 "$work/log" >&2; echo "avx512.sh: FAILED" >&2; exit 1; }
