#!/bin/sh
# What the emulated machine of scripts/avx512.sh does. This is its first process; the argument is the task.
mount -t proc none /proc
mount -t sysfs none /sys
mount -t devtmpfs none /dev
mkdir /dev/shm
mount -t tmpfs none /dev/shm
ip link set lo up
hostname emulated
export PATH=/bin:/usr/bin HOME=/ TMPDIR=/tmp
export OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader OMPI_MCA_mpi_yield_when_idle=1
avx512='batched path, 8 contacts at a time, AVX-512'
failed=0

verdict() { # the exit status before it, and what was tried
    if [ $? = 0 ]; then echo "ok      $1"; else echo "FAILED  $1" && failed=1; fi
}

# LIGGGHTS on some ranks; alone it starts no daemon. What it dumps gets a name of its own.
stock() { # DUMP RANKS ARG...
    dump=$1 np=$2
    shift 2
    if [ "$np" = 1 ]; then
        env OMPI_MCA_ess_singleton_isolated=1 liggghts "$@" >out 2>&1
    else
        mpirun --allow-run-as-root --oversubscribe --bind-to none -np "$np" liggghts "$@" >out 2>&1
    fi || { tail -5 out; return 1; }
    [ "$(wc -l <dump.txt)" -gt 10 ] && mv dump.txt "$dump"
}
rust() { (export LD_PRELOAD=/granlaw/plugin.so GRANLAW_LAWS=rust GRANLAW_LANES="${GRANLAW_LANES:-8}" && stock "$@"); }

# The dump of the run before, on the AVX-512 code.
same() { rust rust.txt "$@" && grep -q "$avx512" out && cmp stock.txt rust.txt; }

compare() { # NAME RANKS DECK ARG...
    what="$1, on $2: the dump of LIGGGHTS alone" ranks=$2
    shift 2
    stock stock.txt "$ranks" -in "$@" && same "$ranks" -in "$@"
    verdict "$what"
}

quick() {
    for test in tests/*; do
        "$test" --test-threads=1 >out 2>&1 || { grep -v ' ok$' out; false; }
        verdict "${test##*/}: $(grep -c '^test .* ok$' out) tests"
    done
    cd benchmarks
    compare 'equal spheres' 1 fcc16.in -var cells 6 -var steps 20
    # What must not pass: fewer lanes, and a law that is wrong in the last digits.
    ! GRANLAW_LANES=4 same 1 -in fcc16.in -var cells 6 -var steps 20 && grep -q AVX2 out
    verdict 'four lanes are not taken for AVX-512'
    same 1 -in fcc16.in -var cells 6 -var steps 20 -var restitution 0.90000000000001 | grep -q differ
    verdict 'another restitution by 1e-14 is seen'
}

check() {
    quick
    compare 'many sizes' 1 poly.in -var cells 6 -var steps 20
    compare 'rolling' 1 rolling.in -var cells 6 -var steps 20
    for models in 'hooke' 'hertz tangential no_history rolling_friction cdt' 'hertz tangential history'; do
        compare "$models" 1 fcc16.in -var cells 5 -var steps 20 -var models "$models"
    done
    cd ../liggghts_inputs
    sed 's/^run .*/run 300/; s/custom 8000/custom 150/' settling_box.in >box.in
    sed 's/^run .*/run 400/; s/custom 1000/custom 100/' gas_two_ranks.in >gas.in
    compare 'box with walls, rebuilds' 1 box.in
    compare 'gas of two types, rebuilds' 2 gas.in
    stock stock.txt 1 -in cdt_jkr_types_stock.in && same 1 -in cdt_jkr_types.in
    verdict 'cdt_jkr, on 1: the dump of cdt with the same coefficient'
}

# Instructions per contact: a second of this machine is 1e8 of them, a few hundredths of which are the kernel's timer.
report() { # LOG WAY, with the contacts of a step
    awk -v way="$2" -v contacts="$contacts" '/^Loop time/ && !steps { whole = $4; steps = $9 } /^Pair  time/ && !pair { pair = $5 }
        END { n = contacts * steps / 1e8; printf "%-34s %8.1f in the pair style, %8.1f in all\n", way, pair / n, whole / n }' "$1"
}

count() {
    export GRANLAW_PATH=batched
    cd benchmarks
    for scene in 'fcc16.in -var steps 40' 'gas.in -var steps 300' 'poly.in -var steps 20' 'rolling.in -var steps 20' \
        'tiny.in -var steps 5000'; do
        echo "$scene: instructions per contact"
        stock stock.txt 1 -in $scene && mv out out.stock
        for lanes in 8 4 1; do
            GRANLAW_LANES=$lanes rust rust.txt 1 -in $scene && cmp stock.txt rust.txt
            verdict "$lanes lanes: the dump of LIGGGHTS alone"
            contacts=$(sed -n 's/.*batched path ends: \(.*\) steps, \(.*\) contacts.*/\2 \1/p' out | awk 'NR == 1 { print $1 / $2 }')
            report out "$(sed -n 's/^granlaw: batched path, //p' out | head -1)"
        done
        report out.stock 'LIGGGHTS alone'
    done
}

cd /granlaw || exit
grep -qw avx512f /proc/cpuinfo
verdict 'the processor has AVX-512, and Linux lets programs use it'
[ $failed = 1 ] || "$1"
[ $failed = 0 ] && echo 'everything holds'
# What was said must be out before the power goes.
sleep 1
poweroff -f
