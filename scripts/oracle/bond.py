#!/usr/bin/env python3
"""Oracle for `cohesion bond/nonlinear`, convention documented: the law sheet in arbitrary precision.

Written from the equations alone, without the Rust code. Prescribes the motion of two bodies, rounds it to doubles, and
works out forces and torques with 50 digits. `tests/laws/bond/oracle.rs` holds the Rust law against the files it writes.

    pip install mpmath
    scripts/oracle/bond.py reference_data/bond      # writes oracle_<case>.csv

SPDX-License-Identifier: GPL-2.0-or-later
"""
import math
import sys
from pathlib import Path

from mpmath import cos, mp, mpf, pi, sin, sqrt

mp.dps = 50
DT = 1e-7


# ---- vectors -------------------------------------------------------------------------------------------------------
def vec(a): return [mpf(c) for c in a]
def add(a, b): return [p + q for p, q in zip(a, b)]
def sub(a, b): return [p - q for p, q in zip(a, b)]
def mul(a, s): return [p * s for p in a]
def dot(a, b): return sum(p * q for p, q in zip(a, b))
def norm(a): return sqrt(dot(a, a))
def unit(a): return mul(a, 1 / norm(a))
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def flat(a, n): return sub(a, mul(n, dot(a, n)))


ZERO = [mpf(0)] * 3

# ---- the law: stiffnesses as (k, ku, kc) -----------------------------------------------------------------------------
STANDARD = dict(
    lam=0.8, k1=(4e7, 8e7, 2e7), k2=(1e10, 2e10, 5e9), kt=4e9, ktn=(4e9, 8e9, 2e9), ktt=(1e10, 2e10, 5e9),
    eta=(0.0, 0.0, 0.0, 0.0), smooth=False, near=1.1e-3, far=1.5e-3, strength=None, ratio=1.0, at=1,
    radii=(5e-4, 3e-4), masses=(1.3e-6, 2.8e-7), tags=(1, 2), wall=False, off=(),
)


def alpha(k):
    return mpf(0) if k[0] == k[1] else (mpf(k[1]) - mpf(k[0])) / (mpf(k[1]) + mpf(k[2]))


def normal_law(p, d, dmax, dmin):
    """(4) to (6), over the area; d > 0 is compression."""
    k1, k2 = vec(p["k1"]), vec(p["k2"])
    if d < 0:
        if "tension" in p["off"]: return mpf(0)
        if d <= dmin: return k2[0] * d
        if d < alpha(k2) * dmin: return k2[1] * d + (k2[0] - k2[1]) * dmin
        return -k2[2] * d
    if "compression" in p["off"]: return mpf(0)
    if d < alpha(k1) ** 2 * dmax: return -k1[2] * sqrt(d)
    if d < dmax: return k1[1] * sqrt(d) + (k1[0] - k1[1]) * sqrt(dmax)
    return k1[0] * sqrt(d)


def twist_law(k, t, tmax, tmin):
    a, (k0, ku, kc) = alpha(k), vec(k)
    if t > 0 and t == tmax or t < 0 and t == tmin: return k0 * t
    if t > a * tmax: return ku * t + (k0 - ku) * tmax
    if t < a * tmin: return ku * t + (k0 - ku) * tmin
    return -kc * t


def bend_law(k, t, c, rho):
    a, (_, ku, kc) = alpha(k), vec(k)
    centre, radius = mul(c, a), a * rho
    out = sub(t, centre)
    near = t if norm(out) <= radius else add(centre, mul(unit(out), radius))
    return sub(mul(t, ku), mul(near, ku + kc))


def sgn(x, x0):
    """x/max(|x|, x0) of a number or a vector."""
    if isinstance(x, list):
        return ZERO if norm(x) == 0 else mul(x, 1 / max(norm(x), x0))
    return mpf(0) if x == 0 else x / max(abs(x), x0)


class Bond:
    def __init__(self, p):
        self.p, self.held = p, False
        ri, rj = map(mpf, p["radii"])
        rb = mpf(p["lam"]) * (ri if p["wall"] else min(ri, rj))
        self.rb, self.A = rb, pi * rb**2
        self.J = self.A * rb**2 / 2
        self.I = self.J / 2

    def step(self, n, update, xi, delta, vi, vj, wi, wj):
        """Force on i, torques on i and j, whether bonded afterwards."""
        p = self.p
        nothing = (ZERO, ZERO, ZERO)
        xi, delta, vi, vj, wi = map(vec, (xi, delta, vi, vj, wi))
        wj = ZERO if p["wall"] else vec(wj)
        twice = 2 if p["wall"] else 1
        if not self.held:
            if update and n == p["at"] and twice * norm(delta) < p["near"]:
                self.held = True
                self.r0, self.D = norm(delta), delta
                self.anchor = sub(xi, delta)
                self.dmax = self.dmin = self.tn = self.tmax = self.tmin = self.rho = mpf(0)
                self.ft = self.tt = self.c = ZERO
            return nothing + (self.held,)
        v = sub(vi, vj)
        dt = mpf(DT)
        if p["wall"]:
            if update: self.anchor = add(self.anchor, mul(vj, dt))
            D = sub(xi, self.anchor)
            Do = sub(D, mul(v, dt)) if update else D
        else:
            D = delta
            Do = self.D if update else D
        r, nn = norm(D), unit(D)
        if update and p["strength"] is None and twice * r > p["far"]:
            self.held = False
            return nothing + (False,)
        mid = mul(add(D, Do), mpf(1) / 2)
        nb, no = unit(mid), unit(Do)
        ri, rj = map(mpf, p["radii"])
        rci, rcj = (r, mpf(0)) if p["wall"] else (r * ri / (ri + rj), r * rj / (ri + rj))
        spins = add(mul(wi, rci), mul(wj, rcj))
        shearing = lambda v: flat(sub(sub(v, mul(nb, dot(v, nb))), mul(cross(spins, nb), norm(mid) / r)), nn)  # (7)
        vtr = shearing(v)
        rel = sub(wi, wj)
        ft, tt, c, tn, rho = self.ft, self.tt, self.c, self.tn, self.rho
        tmax, tmin = self.tmax, self.tmin
        if update:
            psi = dot(add(wi, wj), nb) * dt / 2

            def carry(a):
                b = sub(a, mul(add(no, nn), dot(a, nn) / (1 + dot(no, nn))))
                return add(mul(b, cos(psi)), mul(cross(nn, b), sin(psi)))

            ft = sub(carry(ft), mul(shearing(mul(sub(D, Do), 1 / dt)), mpf(p["kt"]) * self.A * dt))  # (8)
            tn += dt * dot(rel, nb)
            tt = add(carry(tt), mul(flat(rel, nn), dt))
            c = carry(c)
            tmax, tmin = max(tmax, tn), min(tmin, tn)
            s = norm(sub(tt, c))
            if s > rho:
                c, rho = add(c, mul(sub(tt, c), (s - rho) / 2 / s)), rho + (s - rho) / 2
        d = self.r0 - r
        dmax, dmin = max(self.dmax, d), min(self.dmin, d)
        off = p["off"]
        Fn = normal_law(p, d, dmax, dmin) * self.A
        Ft = ZERO if "shear" in off else ft
        Tn = mpf(0) if "twist" in off else -self.J * twist_law(p["ktn"], tn, tmax, tmin)  # (9)
        Tt = ZERO if "bend" in off else mul(bend_law(p["ktt"], tt, c, rho), -self.I)  # (10)
        if update and p["strength"] is not None:  # (14), (15)
            smax, taumax = map(mpf, p["strength"])
            if d < 0: smax *= p["ratio"]
            if abs(Fn) / self.A + norm(Tt) * self.rb / self.I >= smax or norm(Ft) / self.A + abs(Tn) * self.rb / self.J >= taumax:
                self.held = False
                return nothing + (False,)
        if update:
            self.ft, self.tt, self.c, self.tn, self.rho, self.D = ft, tt, c, tn, rho, D
            self.tmax, self.tmin, self.dmax, self.dmin = tmax, tmin, dmax, dmin
        return self.damped(nn, r, rci, rcj, v, vtr, rel, Fn, Ft, Tn, Tt) + (True,)

    def damped(self, nn, r, rci, rcj, v, vtr, rel, Fn, Ft, Tn, Tt):
        """(11), (12), (13)."""
        p, dt = self.p, mpf(DT)
        en, et, etn, ett = map(mpf, p["eta"])
        (mi, mj), (ri, rj) = map(vec, (p["masses"], p["radii"]))
        zero = lambda load, m: mpf(0)
        x0 = zero
        if p["smooth"]:
            x0 = lambda load, m: 10 * load * dt / m
        inertia = lambda m, r: mpf(2) / 5 * m * r**2
        if p["wall"]:
            meff, kappa, turn = mi, r / ri, inertia(mi, ri)
        else:
            meff, kappa = mi * mj / (mi + mj), r / (ri + rj)
            turn = 1 / (1 / inertia(mi, ri) + 1 / inertia(mj, rj))
        # 0.4 is not a double: the law works with the double nearest to it, which is 1e-17 away.
        across = flat(rel, nn)
        Fd = Fn - en * abs(Fn) * sgn(dot(v, nn), x0(abs(Fn), meff))
        Ftd = sub(Ft, mul(sgn(vtr, x0(norm(Ft), meff / (1 + mpf(5) / 2 * kappa**2))), et * norm(Ft)))
        Tnd = Tn - etn * abs(Tn) * sgn(dot(rel, nn), x0(abs(Tn), turn))
        Ttd = sub(Tt, mul(sgn(across, x0(norm(Tt), turn)), ett * norm(Tt)))
        arm, own = cross(Ftd, nn), add(mul(nn, Tnd), Ttd)
        Tj = ZERO if p["wall"] else sub(mul(arm, rcj), own)
        return add(mul(nn, Fd), Ftd), add(mul(arm, rci), own), Tj


# ---- prescribed motion, in doubles ---------------------------------------------------------------------------------
def turned(v, axis, angle):
    c, s = math.cos(angle), math.sin(angle)
    k = sum(a * b for a, b in zip(axis, v)) * (1 - c)
    x = [axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0]]
    return [v[q] * c + x[q] * s + axis[q] * k for q in range(3)]


AXIS = [1 / 3, 2 / 3, 2 / 3]


def place(n, r0, stretch, tumble):
    """D after n steps: breathing with growing strides about r0, tumbling about an axis that is not normal to it."""
    e = stretch * (0.2 + n / 60) * math.sin(2 * math.pi * n / 27) + 0.2 * stretch * math.sin(2 * math.pi * n / 7.3)
    return turned([(r0 - e) * c for c in (0.48, -0.6, 0.64)], AXIS, tumble * n)


def spins(n, tumble, size):
    """Both bodies follow the tumbling and turn against each other."""
    follow = [tumble / DT * a for a in AXIS]
    t = 2 * math.pi * n
    i = [size * math.sin(t / 31 + 1), size * math.cos(t / 23), size * (0.3 + math.sin(t / 41))]
    j = [size * math.cos(t / 37), size * (math.sin(t / 29) - 0.2), size * math.sin(t / 19 + 2)]
    return [a + b for a, b in zip(follow, i)], [a + b for a, b in zip(follow, j)]


def rows(p, steps, stretch=2e-5, tumble=1e-3, size=600.0):
    """(step, update, x_i, delta, v_i, v_j, omega_i, omega_j); every tenth step is queried once more."""
    r0 = 5.05e-4 if p["wall"] else 8.1e-4
    # A wall bond sees positions: they must not be so large that their rounding shows in the overlap.
    shift, wall_v = [2e-4, -1e-4, 1e-4], [0.02, -0.01, 0.03]
    for n in range(1, steps + 1):
        D, before = place(n, r0, stretch, tumble), place(n - 1, r0, stretch, tumble)
        xi = [a + b for a, b in zip(shift, D)]
        v = [(a - b) / DT for a, b in zip(D, before)]
        vj = wall_v if p["wall"] else [-0.3 * c for c in v]
        vi = [a + b for a, b in zip(v, vj)]
        if p["wall"]:
            xi = [a + n * DT * b for a, b in zip(xi, wall_v)]
        wi, wj = spins(n, tumble, size)
        if p["tags"][0] > p["tags"][1]: wi, wj = wj, wi
        for update in (True, False) if n % 10 == 0 else (True,):
            yield n, update, xi, D, vi, vj, wi, [0.0] * 3 if p["wall"] else wj


CASES = {
    "pair": (dict(), {}),
    "reversed_tags": (dict(tags=(2, 1)), {}),
    "damped": (dict(eta=(0.2, 0.3, 0.25, 0.35), radii=(4e-4, 4e-4), masses=(7e-7, 7e-7)), {}),
    "smooth": (dict(eta=(0.2, 0.3, 0.25, 0.35), smooth=True), {}),
    "wall": (dict(wall=True, near=1.1e-3, eta=(0.1, 0.1, 0.1, 0.1)), {}),
    "wall_smooth": (dict(wall=True, near=1.1e-3, eta=(0.1, 0.2, 0.1, 0.3), smooth=True), {}),
    "far": (dict(near=8.2e-4, far=8.27e-4), {}),
    "stress": (dict(strength=(2.5e5, 8e5), ratio=0.7), {}),
    "stress_shear": (dict(strength=(1e9, 3e3)), {}),
    "no_tension_no_bend": (dict(off=("tension", "bend")), {}),
    "no_compression_no_shear_no_twist": (dict(off=("compression", "shear", "twist")), {}),
    "equal_k": (dict(k1=(4e7, 4e7, 0), k2=(1e10, 1e10, 0), ktn=(0, 0, 0), ktt=(1e10, 1e10, 1e9)), {}),
}
COLUMNS = ["step", "update"] + [
    f"{name}.{axis}" for name in ("x_i", "delta", "v_i", "v_j", "omega_i", "omega_j", "force_i", "torque_i", "torque_j")
    for axis in "xyz"
] + ["bonded"]


def flat_list(p):
    """The case as `# name = value` lines."""
    return {k: " ".join(map(str, v)) if isinstance(v, tuple) else str(v) for k, v in p.items()}


def write(folder, name, changes, motion, steps=90):
    p = {**STANDARD, **changes}
    bond = Bond(p)
    lines = ["# made by scripts/oracle/bond.py with mpmath, 50 digits; SI units", f"# dt = {DT!r}"]
    lines += [f"# {k} = {v}" for k, v in flat_list(p).items()]
    lines.append(",".join(COLUMNS))
    for n, update, *inputs in rows(p, steps, **motion):
        *out, bonded = bond.step(n, update, *inputs)
        numbers = [repr(float(c)) for v in inputs for c in v] + [mp.nstr(c, 18) for v in out for c in v]
        lines.append(",".join([str(n), str(int(update))] + numbers + [str(int(bonded))]))
    (folder / f"oracle_{name}.csv").write_text("\n".join(lines) + "\n")


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    for name, (changes, motion) in CASES.items():
        write(folder, name, changes, motion)


if __name__ == "__main__":
    main()
