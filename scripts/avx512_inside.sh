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
    [ "$(wc -l <dump.txt)" -gt 100 ] && mv dump.txt "$dump"
}
rust() { (export LD_PRELOAD=/granlaw/plugin.so GRANLAW_LAWS=rust && stock "$@"); }

# The dump of the run before, on the AVX-512 code.
same() { rust rust.txt "$@" && grep -q "$avx512" out && cmp stock.txt rust.txt; }

compare() { # NAME RANKS DECK ARG...
    what="$1, on $2: the dump of LIGGGHTS alone" ranks=$2
    shift 2
    stock stock.txt "$ranks" -in "$@" && same "$ranks" -in "$@"
    verdict "$what"
}

check() {
    for test in tests/*; do
        "$test" --test-threads=1 >out 2>&1 || { grep -v ' ok$' out; false; }
        verdict "${test##*/}: $(grep -c '^test .* ok$' out) tests"
    done
    sed 's/^run .*/run 400/; s/custom 8000/custom 200/' liggghts_inputs/settling_box.in >box.in
    sed 's/^run .*/run 400/; s/custom 1000/custom 100/' liggghts_inputs/gas_two_ranks.in >gas.in
    cd benchmarks
    compare 'equal spheres' 1 fcc16.in -var cells 6 -var steps 20
    # What must not pass: fewer lanes, and a law that is wrong in the last digits.
    ! GRANLAW_LANES=4 same 1 -in fcc16.in -var cells 6 -var steps 20 && grep -q AVX2 out
    verdict 'four lanes are not taken for AVX-512'
    same 1 -in fcc16.in -var cells 6 -var steps 20 -var restitution 0.90000000000001 | grep -q differ
    verdict 'another restitution by 1e-14 is seen'
    compare 'equal spheres' 2 fcc16.in -var cells 6 -var steps 20
    compare 'many sizes' 1 poly.in -var cells 6 -var steps 20
    compare 'rolling' 1 rolling.in -var cells 6 -var steps 20
    for models in 'hooke' 'hertz tangential no_history rolling_friction cdt' 'hertz tangential history'; do
        compare "$models" 1 fcc16.in -var cells 5 -var steps 20 -var models "$models"
    done
    cd ..
    compare 'box with walls, rebuilds' 1 box.in
    compare 'gas of two types, rebuilds' 2 gas.in
    cd liggghts_inputs
    stock stock.txt 1 -in cdt_jkr_types_stock.in && same 1 -in cdt_jkr_types.in
    verdict 'cdt_jkr, on 1: the dump of cdt with the same coefficient'
}

# Instructions per contact in the pair style, of each way through the contacts.
count() {
    cd benchmarks
    for scene in 'fcc16.in -var steps 20' 'gas.in -var steps 300' 'poly.in -var steps 20' 'tiny.in -var steps 5000'; do
        echo "$scene"
        stock stock.txt 1 -in $scene && mv out out.stock
        for lanes in 1 4 8; do
            GRANLAW_LANES=$lanes rust rust.txt 1 -in $scene && cmp stock.txt rust.txt
            verdict "  $(instructions out out.stock | sed 's/.* //') of LIGGGHTS's instructions: $(sed -n 's/.*batched path, //p' out)"
        done
    done
}

cd /granlaw || exit
grep -qw avx512f /proc/cpuinfo
verdict 'the processor has AVX-512, and Linux lets programs use it'
"$1"
[ $failed = 0 ] && echo 'everything holds'
# What was said must be out before the power goes.
sleep 1
poweroff -f
