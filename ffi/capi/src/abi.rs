pub const GRANLAW_ABI_VERSION: u32 = 3;
pub type granlaw_status = i32;
pub const GRANLAW_OK: _bindgen_ty_1 = 0;
pub const GRANLAW_REFUSED: _bindgen_ty_1 = 1;
pub const GRANLAW_NON_FINITE: _bindgen_ty_1 = 2;
pub const GRANLAW_MISUSE: _bindgen_ty_1 = 3;
pub const GRANLAW_BUG: _bindgen_ty_1 = 4;
pub type _bindgen_ty_1 = ::std::os::raw::c_uint;
pub const GRANLAW_NORMAL: _bindgen_ty_2 = 0;
pub const GRANLAW_COHESION: _bindgen_ty_2 = 1;
pub const GRANLAW_TANGENTIAL: _bindgen_ty_2 = 2;
pub const GRANLAW_ROLLING: _bindgen_ty_2 = 3;
pub type _bindgen_ty_2 = ::std::os::raw::c_uint;
pub const GRANLAW_SCALAR: _bindgen_ty_3 = 0;
pub const GRANLAW_PER_TYPE: _bindgen_ty_3 = 1;
pub const GRANLAW_PER_PAIR: _bindgen_ty_3 = 2;
pub type _bindgen_ty_3 = ::std::os::raw::c_uint;
pub const GRANLAW_SUPPORT_FULL: _bindgen_ty_4 = 0;
pub const GRANLAW_SUPPORT_OWN_ONLY: _bindgen_ty_4 = 1;
pub const GRANLAW_SUPPORT_STOCK_IGNORES: _bindgen_ty_4 = 2;
pub const GRANLAW_SUPPORT_REFUSED: _bindgen_ty_4 = 3;
pub type _bindgen_ty_4 = ::std::os::raw::c_uint;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_prop {
    pub name: *const ::std::os::raw::c_char,
    pub symbol: *const ::std::os::raw::c_char,
    pub unit: *const ::std::os::raw::c_char,
    pub doc: *const ::std::os::raw::c_char,
    pub shape: i32,
    pub lo: f64,
    pub hi: f64,
    pub open_lo: bool,
    pub open_hi: bool,
    pub usual_lo: f64,
    pub usual_hi: f64,
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_setting {
    pub name: *const ::std::os::raw::c_char,
    pub options: *const *const ::std::os::raw::c_char,
    pub n_options: usize,
    pub default_option: i32,
    pub support: i32,
    pub doc: *const ::std::os::raw::c_char,
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_slot {
    pub name: *const ::std::os::raw::c_char,
    pub newton: *const ::std::os::raw::c_char,
    pub unit: *const ::std::os::raw::c_char,
    pub always: bool,
}
pub const GRANLAW_ATOM_PROPS: _bindgen_ty_5 = 1;
pub const GRANLAW_ATOM_OUTPUTS: _bindgen_ty_5 = 1;
pub type _bindgen_ty_5 = ::std::os::raw::c_uint;
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_atom_prop {
    pub name: *const ::std::os::raw::c_char,
    pub doc: *const ::std::os::raw::c_char,
    pub place: usize,
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_law {
    pub kind: i32,
    pub keyword: *const ::std::os::raw::c_char,
    pub own_keyword: *const ::std::os::raw::c_char,
    pub id: i32,
    pub stock_id: i32,
    pub summary: *const ::std::os::raw::c_char,
    pub stress_strain_exponent: f64,
    pub beyond_contact: bool,
    pub coarse_graining: bool,
    pub props: *const granlaw_prop,
    pub n_props: usize,
    pub settings: *const granlaw_setting,
    pub n_settings: usize,
    pub atoms: *const granlaw_atom_prop,
    pub n_atoms: usize,
    pub outputs: *const granlaw_atom_prop,
    pub n_outputs: usize,
    pub anchors: bool,
    pub bonds: *const ::std::os::raw::c_char,
    pub slots: *const granlaw_slot,
    pub n_slots: usize,
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_choice {
    pub law: usize,
    pub taken_over: bool,
    pub options: *const i32,
    pub values: *const *const f64,
    pub history_offset: usize,
    pub history_places: *const i32,
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_setup {
    pub laws: *const granlaw_choice,
    pub n_laws: usize,
    pub n_types: usize,
    pub nktv2p: f64,
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_wall {
    pub skin: f64,
    pub turns: bool,
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_surfaces_close_data {
    pub radi: f64,
    pub radj: f64,
    pub radsum: f64,
    pub rsq: f64,
    pub delta: [f64; 3usize],
    pub area_ratio: f64,
    pub contact_flags: *mut ::std::os::raw::c_int,
    pub contact_history: *mut f64,
    pub mesh: *mut ::std::os::raw::c_void,
    pub fix_mesh: *mut ::std::os::raw::c_void,
    pub i: ::std::os::raw::c_int,
    pub j: ::std::os::raw::c_int,
    pub itype: ::std::os::raw::c_int,
    pub jtype: ::std::os::raw::c_int,
    pub is_wall: bool,
    pub has_force_update: bool,
    pub v_i: *mut f64,
    pub v_j: *mut f64,
    pub omega_i: *mut f64,
    pub omega_j: *mut f64,
    pub is_non_spherical: bool,
    pub computeflag: ::std::os::raw::c_int,
    pub shearupdate: ::std::os::raw::c_int,
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_surfaces_intersect_data {
    pub close: granlaw_surfaces_close_data,
    pub r: f64,
    pub rinv: f64,
    pub en: [f64; 3usize],
    pub kt: f64,
    pub kn: f64,
    pub gammat: f64,
    pub gamman: f64,
    pub Fn: f64,
    pub Ft: f64,
    pub vn: f64,
    pub deltan: f64,
    pub cri: f64,
    pub crj: f64,
    pub wr1: f64,
    pub wr2: f64,
    pub wr3: f64,
    pub vtr1: f64,
    pub vtr2: f64,
    pub vtr3: f64,
    pub mi: f64,
    pub mj: f64,
    pub meff: f64,
    pub P_diss: f64,
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_force_data {
    pub delta_F: [f64; 3usize],
    pub delta_torque: [f64; 3usize],
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_pass {
    pub dt: f64,
    pub step: i64,
    pub x: *const f64,
    pub tag: *const ::std::os::raw::c_int,
    pub mask: *const ::std::os::raw::c_int,
    pub frozen: ::std::os::raw::c_int,
    pub n_local: ::std::os::raw::c_int,
    pub given: [*const f64; 1usize],
    pub outputs: [*mut f64; 1usize],
}
#[repr(C)]
#[derive(Debug, Copy, Clone)]
pub struct granlaw_bonds {
    pub begun: u64,
    pub ended: u64,
    pub there: u64,
    pub step: i64,
}
