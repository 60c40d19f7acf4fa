use granlaw_capi::abi::*;

#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_arrays {
    pub x: *const f64,
    pub v: *const f64,
    pub omega: *const f64,
    pub f: *mut f64,
    pub torque: *mut f64,
    pub radius: *const f64,
    pub mass: *const f64,
    pub rigid: *const f64,
    pub type_: *const ::std::os::raw::c_int,
    pub mask: *const ::std::os::raw::c_int,
    pub tag: *const ::std::os::raw::c_int,
    pub ilist: *const ::std::os::raw::c_int,
    pub numneigh: *const ::std::os::raw::c_int,
    pub neighbours: *const *const ::std::os::raw::c_int,
    pub flags: *const *mut ::std::os::raw::c_int,
    pub history: *const *mut f64,
    pub rows: usize,
    pub all: usize,
    pub forced: usize,
    pub row: usize,
    pub skin: f64,
    pub dt: f64,
    pub step: i64,
    pub frozen: i32,
    pub update: bool,
    pub rebuilt: bool,
}
#[allow(clippy::unnecessary_operation, clippy::identity_op)]
const _: () = {
    ["Size of granlaw_arrays"][::std::mem::size_of::<granlaw_arrays>() - 192usize];
    ["Alignment of granlaw_arrays"][::std::mem::align_of::<granlaw_arrays>() - 8usize];
    ["Offset of field: granlaw_arrays::x"][::std::mem::offset_of!(granlaw_arrays, x) - 0usize];
    ["Offset of field: granlaw_arrays::v"][::std::mem::offset_of!(granlaw_arrays, v) - 8usize];
    ["Offset of field: granlaw_arrays::omega"][::std::mem::offset_of!(granlaw_arrays, omega) - 16usize];
    ["Offset of field: granlaw_arrays::f"][::std::mem::offset_of!(granlaw_arrays, f) - 24usize];
    ["Offset of field: granlaw_arrays::torque"][::std::mem::offset_of!(granlaw_arrays, torque) - 32usize];
    ["Offset of field: granlaw_arrays::radius"][::std::mem::offset_of!(granlaw_arrays, radius) - 40usize];
    ["Offset of field: granlaw_arrays::mass"][::std::mem::offset_of!(granlaw_arrays, mass) - 48usize];
    ["Offset of field: granlaw_arrays::rigid"][::std::mem::offset_of!(granlaw_arrays, rigid) - 56usize];
    ["Offset of field: granlaw_arrays::type_"][::std::mem::offset_of!(granlaw_arrays, type_) - 64usize];
    ["Offset of field: granlaw_arrays::mask"][::std::mem::offset_of!(granlaw_arrays, mask) - 72usize];
    ["Offset of field: granlaw_arrays::tag"][::std::mem::offset_of!(granlaw_arrays, tag) - 80usize];
    ["Offset of field: granlaw_arrays::ilist"][::std::mem::offset_of!(granlaw_arrays, ilist) - 88usize];
    ["Offset of field: granlaw_arrays::numneigh"][::std::mem::offset_of!(granlaw_arrays, numneigh) - 96usize];
    ["Offset of field: granlaw_arrays::neighbours"]
        [::std::mem::offset_of!(granlaw_arrays, neighbours) - 104usize];
    ["Offset of field: granlaw_arrays::flags"][::std::mem::offset_of!(granlaw_arrays, flags) - 112usize];
    ["Offset of field: granlaw_arrays::history"][::std::mem::offset_of!(granlaw_arrays, history) - 120usize];
    ["Offset of field: granlaw_arrays::rows"][::std::mem::offset_of!(granlaw_arrays, rows) - 128usize];
    ["Offset of field: granlaw_arrays::all"][::std::mem::offset_of!(granlaw_arrays, all) - 136usize];
    ["Offset of field: granlaw_arrays::forced"][::std::mem::offset_of!(granlaw_arrays, forced) - 144usize];
    ["Offset of field: granlaw_arrays::row"][::std::mem::offset_of!(granlaw_arrays, row) - 152usize];
    ["Offset of field: granlaw_arrays::skin"][::std::mem::offset_of!(granlaw_arrays, skin) - 160usize];
    ["Offset of field: granlaw_arrays::dt"][::std::mem::offset_of!(granlaw_arrays, dt) - 168usize];
    ["Offset of field: granlaw_arrays::step"][::std::mem::offset_of!(granlaw_arrays, step) - 176usize];
    ["Offset of field: granlaw_arrays::frozen"][::std::mem::offset_of!(granlaw_arrays, frozen) - 184usize];
    ["Offset of field: granlaw_arrays::update"][::std::mem::offset_of!(granlaw_arrays, update) - 188usize];
    ["Offset of field: granlaw_arrays::rebuilt"][::std::mem::offset_of!(granlaw_arrays, rebuilt) - 189usize];
};
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_account {
    pub passes: u64,
    pub contacts: u64,
    pub neighbours: u64,
    pub bytes: u64,
}
#[allow(clippy::unnecessary_operation, clippy::identity_op)]
const _: () = {
    ["Size of granlaw_account"][::std::mem::size_of::<granlaw_account>() - 32usize];
    ["Alignment of granlaw_account"][::std::mem::align_of::<granlaw_account>() - 8usize];
    ["Offset of field: granlaw_account::passes"][::std::mem::offset_of!(granlaw_account, passes) - 0usize];
    ["Offset of field: granlaw_account::contacts"]
        [::std::mem::offset_of!(granlaw_account, contacts) - 8usize];
    ["Offset of field: granlaw_account::neighbours"]
        [::std::mem::offset_of!(granlaw_account, neighbours) - 16usize];
    ["Offset of field: granlaw_account::bytes"][::std::mem::offset_of!(granlaw_account, bytes) - 24usize];
};
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_recorded_law {
    pub kind: i32,
    pub index: i32,
    pub keyword: *const ::std::os::raw::c_char,
    pub taken_over: bool,
    pub offset: usize,
    pub options: *const i32,
    pub values: *const *const f64,
}
#[allow(clippy::unnecessary_operation, clippy::identity_op)]
const _: () = {
    ["Size of granlaw_recorded_law"][::std::mem::size_of::<granlaw_recorded_law>() - 48usize];
    ["Alignment of granlaw_recorded_law"][::std::mem::align_of::<granlaw_recorded_law>() - 8usize];
    ["Offset of field: granlaw_recorded_law::kind"]
        [::std::mem::offset_of!(granlaw_recorded_law, kind) - 0usize];
    ["Offset of field: granlaw_recorded_law::index"]
        [::std::mem::offset_of!(granlaw_recorded_law, index) - 4usize];
    ["Offset of field: granlaw_recorded_law::keyword"]
        [::std::mem::offset_of!(granlaw_recorded_law, keyword) - 8usize];
    ["Offset of field: granlaw_recorded_law::taken_over"]
        [::std::mem::offset_of!(granlaw_recorded_law, taken_over) - 16usize];
    ["Offset of field: granlaw_recorded_law::offset"]
        [::std::mem::offset_of!(granlaw_recorded_law, offset) - 24usize];
    ["Offset of field: granlaw_recorded_law::options"]
        [::std::mem::offset_of!(granlaw_recorded_law, options) - 32usize];
    ["Offset of field: granlaw_recorded_law::values"]
        [::std::mem::offset_of!(granlaw_recorded_law, values) - 40usize];
};
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_recorded_chain {
    pub path: *const ::std::os::raw::c_char,
    pub liggghts: *const ::std::os::raw::c_char,
    pub deck: *const ::std::os::raw::c_char,
    pub units: *const ::std::os::raw::c_char,
    pub who: *const ::std::os::raw::c_char,
    pub rank: i32,
    pub ranks: i32,
    pub every: u64,
    pub types: usize,
    pub nktv2p: f64,
    pub dt: f64,
    pub laws: *const granlaw_recorded_law,
    pub n_laws: usize,
    pub slots: *const *const ::std::os::raw::c_char,
    pub n_slots: usize,
    pub given: [bool; 1usize],
}
#[allow(clippy::unnecessary_operation, clippy::identity_op)]
const _: () = {
    ["Size of granlaw_recorded_chain"][::std::mem::size_of::<granlaw_recorded_chain>() - 120usize];
    ["Alignment of granlaw_recorded_chain"][::std::mem::align_of::<granlaw_recorded_chain>() - 8usize];
    ["Offset of field: granlaw_recorded_chain::path"]
        [::std::mem::offset_of!(granlaw_recorded_chain, path) - 0usize];
    ["Offset of field: granlaw_recorded_chain::liggghts"]
        [::std::mem::offset_of!(granlaw_recorded_chain, liggghts) - 8usize];
    ["Offset of field: granlaw_recorded_chain::deck"]
        [::std::mem::offset_of!(granlaw_recorded_chain, deck) - 16usize];
    ["Offset of field: granlaw_recorded_chain::units"]
        [::std::mem::offset_of!(granlaw_recorded_chain, units) - 24usize];
    ["Offset of field: granlaw_recorded_chain::who"]
        [::std::mem::offset_of!(granlaw_recorded_chain, who) - 32usize];
    ["Offset of field: granlaw_recorded_chain::rank"]
        [::std::mem::offset_of!(granlaw_recorded_chain, rank) - 40usize];
    ["Offset of field: granlaw_recorded_chain::ranks"]
        [::std::mem::offset_of!(granlaw_recorded_chain, ranks) - 44usize];
    ["Offset of field: granlaw_recorded_chain::every"]
        [::std::mem::offset_of!(granlaw_recorded_chain, every) - 48usize];
    ["Offset of field: granlaw_recorded_chain::types"]
        [::std::mem::offset_of!(granlaw_recorded_chain, types) - 56usize];
    ["Offset of field: granlaw_recorded_chain::nktv2p"]
        [::std::mem::offset_of!(granlaw_recorded_chain, nktv2p) - 64usize];
    ["Offset of field: granlaw_recorded_chain::dt"]
        [::std::mem::offset_of!(granlaw_recorded_chain, dt) - 72usize];
    ["Offset of field: granlaw_recorded_chain::laws"]
        [::std::mem::offset_of!(granlaw_recorded_chain, laws) - 80usize];
    ["Offset of field: granlaw_recorded_chain::n_laws"]
        [::std::mem::offset_of!(granlaw_recorded_chain, n_laws) - 88usize];
    ["Offset of field: granlaw_recorded_chain::slots"]
        [::std::mem::offset_of!(granlaw_recorded_chain, slots) - 96usize];
    ["Offset of field: granlaw_recorded_chain::n_slots"]
        [::std::mem::offset_of!(granlaw_recorded_chain, n_slots) - 104usize];
    ["Offset of field: granlaw_recorded_chain::given"]
        [::std::mem::offset_of!(granlaw_recorded_chain, given) - 112usize];
};
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_recorded_particles {
    pub n: usize,
    pub tag: *const ::std::os::raw::c_int,
    pub type_: *const ::std::os::raw::c_int,
    pub radius: *const f64,
    pub mass: *const f64,
    pub x: *const f64,
    pub v: *const f64,
    pub omega: *const f64,
}
#[allow(clippy::unnecessary_operation, clippy::identity_op)]
const _: () = {
    ["Size of granlaw_recorded_particles"][::std::mem::size_of::<granlaw_recorded_particles>() - 64usize];
    ["Alignment of granlaw_recorded_particles"]
        [::std::mem::align_of::<granlaw_recorded_particles>() - 8usize];
    ["Offset of field: granlaw_recorded_particles::n"]
        [::std::mem::offset_of!(granlaw_recorded_particles, n) - 0usize];
    ["Offset of field: granlaw_recorded_particles::tag"]
        [::std::mem::offset_of!(granlaw_recorded_particles, tag) - 8usize];
    ["Offset of field: granlaw_recorded_particles::type_"]
        [::std::mem::offset_of!(granlaw_recorded_particles, type_) - 16usize];
    ["Offset of field: granlaw_recorded_particles::radius"]
        [::std::mem::offset_of!(granlaw_recorded_particles, radius) - 24usize];
    ["Offset of field: granlaw_recorded_particles::mass"]
        [::std::mem::offset_of!(granlaw_recorded_particles, mass) - 32usize];
    ["Offset of field: granlaw_recorded_particles::x"]
        [::std::mem::offset_of!(granlaw_recorded_particles, x) - 40usize];
    ["Offset of field: granlaw_recorded_particles::v"]
        [::std::mem::offset_of!(granlaw_recorded_particles, v) - 48usize];
    ["Offset of field: granlaw_recorded_particles::omega"]
        [::std::mem::offset_of!(granlaw_recorded_particles, omega) - 56usize];
};
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_recorded_call {
    pub pass: *const granlaw_pass,
    pub contact: *const granlaw_surfaces_intersect_data,
    pub touch: bool,
    pub mi: f64,
    pub mj: f64,
    pub before: *const f64,
    pub after: *const f64,
    pub i_forces: *const granlaw_force_data,
    pub j_forces: *const granlaw_force_data,
}
#[allow(clippy::unnecessary_operation, clippy::identity_op)]
const _: () = {
    ["Size of granlaw_recorded_call"][::std::mem::size_of::<granlaw_recorded_call>() - 72usize];
    ["Alignment of granlaw_recorded_call"][::std::mem::align_of::<granlaw_recorded_call>() - 8usize];
    ["Offset of field: granlaw_recorded_call::pass"]
        [::std::mem::offset_of!(granlaw_recorded_call, pass) - 0usize];
    ["Offset of field: granlaw_recorded_call::contact"]
        [::std::mem::offset_of!(granlaw_recorded_call, contact) - 8usize];
    ["Offset of field: granlaw_recorded_call::touch"]
        [::std::mem::offset_of!(granlaw_recorded_call, touch) - 16usize];
    ["Offset of field: granlaw_recorded_call::mi"]
        [::std::mem::offset_of!(granlaw_recorded_call, mi) - 24usize];
    ["Offset of field: granlaw_recorded_call::mj"]
        [::std::mem::offset_of!(granlaw_recorded_call, mj) - 32usize];
    ["Offset of field: granlaw_recorded_call::before"]
        [::std::mem::offset_of!(granlaw_recorded_call, before) - 40usize];
    ["Offset of field: granlaw_recorded_call::after"]
        [::std::mem::offset_of!(granlaw_recorded_call, after) - 48usize];
    ["Offset of field: granlaw_recorded_call::i_forces"]
        [::std::mem::offset_of!(granlaw_recorded_call, i_forces) - 56usize];
    ["Offset of field: granlaw_recorded_call::j_forces"]
        [::std::mem::offset_of!(granlaw_recorded_call, j_forces) - 64usize];
};
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_text {
    pub bytes: *const ::std::os::raw::c_char,
    pub length: usize,
}
#[allow(clippy::unnecessary_operation, clippy::identity_op)]
const _: () = {
    ["Size of granlaw_text"][::std::mem::size_of::<granlaw_text>() - 16usize];
    ["Alignment of granlaw_text"][::std::mem::align_of::<granlaw_text>() - 8usize];
    ["Offset of field: granlaw_text::bytes"][::std::mem::offset_of!(granlaw_text, bytes) - 0usize];
    ["Offset of field: granlaw_text::length"][::std::mem::offset_of!(granlaw_text, length) - 8usize];
};
