//! Every operation of a unit against plain numbers, bit by bit, awkward ones among them.
use super::*;

const NUMBERS: [f64; 13] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.1,
    -3.7e-5,
    2.5e9,
    f64::MIN_POSITIVE / 8.0,
    f64::MAX,
    -f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// What must be the same: all bits, but of a NaN only that it is one.
fn bits(x: f64) -> Option<u64> {
    (!x.is_nan()).then(|| x.to_bits())
}

#[track_caller]
fn same<U: Unit>(what: &str, got: U, expected: impl Fn(usize) -> f64) {
    for k in 0..U::WIDTH {
        assert_eq!(bits(got.lane(k)), bits(expected(k)), "{what}, lane {k} of {got:?}: {:e}", expected(k));
    }
}

/// What a pair of numbers gives, side by side and alone.
fn numbers<U: Unit>(shift: usize) {
    let (a, b) = (|k: usize| NUMBERS[(k + shift) % 13], |k: usize| NUMBERS[(k * 5 + shift / 13) % 13]);
    let (x, y) = (U::from_fn(a), U::from_fn(b));
    same("from_fn", x, a);
    same("splat", U::splat(a(0)), |_| a(0));
    same("+", x + y, |k| a(k) + b(k));
    same("-", x - y, |k| a(k) - b(k));
    same("*", x * y, |k| a(k) * b(k));
    same("/", x / y, |k| a(k) / b(k));
    same("neg", -x, |k| -a(k));
    same("abs", x.abs(), |k| a(k).abs());
    same("sqrt", x.sqrt(), |k| a(k).sqrt());
    let (gt, ge) = (x.gt(y), x.ge(y));
    same("gt", U::select(gt, x, y), |k| if a(k) > b(k) { a(k) } else { b(k) });
    same("ge", U::select(ge, x, y), |k| if a(k) >= b(k) { a(k) } else { b(k) });
    same("!", U::select(!gt, x, y), |k| if a(k) > b(k) { b(k) } else { a(k) });
    same("&", U::select(!gt & ge, x, y), |k| if a(k) == b(k) { a(k) } else { b(k) });
    same("|", U::select(gt | !ge, x, y), |k| if a(k) == b(k) { b(k) } else { a(k) });
    let set = (0..U::WIDTH).fold(0, |bits, k| bits | u32::from(a(k) > b(k)) << k);
    assert_eq!((U::bits(gt), U::any(gt)), (set, set != 0));
    assert_eq!(x == y, (0..U::WIDTH).all(|k| a(k) == b(k)));
}

/// Rows in memory to columns and back; every choice of lanes that move to the front.
fn places<U: Unit>() {
    let rows: [[f64; 3]; 8] = std::array::from_fn(|k| std::array::from_fn(|c| (10 * k + c) as f64));
    let less: [[f64; 3]; 8] = std::array::from_fn(|k| std::array::from_fn(|c| 0.1 * (k + 3 * c) as f64));
    let mut out = [[-1.0; 3]; 9];
    let to = out.as_mut_ptr();
    // SAFETY: the arrays have eight rows, and no lane is wider.
    let (columns, differences) = unsafe {
        let columns = U::gather(|k| &raw const rows[7 - k]);
        U::scatter(&columns, |k| to.add(k));
        (columns, U::differences(|k| &raw const rows[k], |k| &raw const less[7 - k]))
    };
    for c in 0..3 {
        same("gather", columns[c], |k| rows[7 - k][c]);
        same("differences", differences[c], |k| rows[k][c] - less[7 - k][c]);
    }
    assert!((0..9).all(|k| out[k] == if k < U::WIDTH { rows[7 - k] } else { [-1.0; 3] }), "{out:?}");
    let mut line = [-1.0; 9];
    // SAFETY: eight numbers, and no lane is wider.
    unsafe { U::load(rows.as_ptr().cast()).store(line.as_mut_ptr()) };
    assert!((0..9).all(|k| line[k] == if k < U::WIDTH { rows[k / 3][k % 3] } else { -1.0 }), "{line:?}");
    for bits in 0..1_u32 << U::WIDTH {
        let set: Vec<usize> = (0..U::WIDTH).filter(|k| bits >> k & 1 == 1).collect();
        let first = columns.x.first(bits);
        for (to, from) in set.iter().enumerate() {
            assert_eq!(first.lane(to), columns.x.lane(*from), "{bits:b}");
        }
    }
}

fn holds<U: Unit>() {
    (0..13 * 13).for_each(numbers::<U>);
    places::<U>();
}

#[test]
fn plain_code_answers_as_single_numbers_do() {
    holds::<f64>();
    holds::<Pack<4>>();
    holds::<Pack<8>>();
}

#[cfg(target_arch = "x86_64")]
#[test]
fn vector_units_of_this_processor_answer_as_single_numbers_do() {
    if has_avx2() {
        holds::<avx2::Avx2>();
    }
    if has_avx512() {
        holds::<avx512::Avx512>();
    }
}

#[test]
#[should_panic(expected = "abs, lane 3")]
fn a_wrong_lane_is_seen() {
    same("abs", Pack::<4>::from_fn(|k| NUMBERS[k]).abs(), |k| if k == 3 { -1.0 } else { NUMBERS[k].abs() });
}
