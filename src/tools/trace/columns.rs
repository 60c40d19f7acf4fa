//! The columns of a trace: names, units, meaning, and their fields in a [`Row`].
use super::Row;
use nalgebra::Vector3;
use std::fmt::Write;

/// A column, or the three columns `<name>.x`, `<name>.y`, `<name>.z` of a vector.
pub struct Column {
    /// Its name.
    pub name: &'static str,
    /// SI unit, `1` for a pure number; in a deck with other units, the unit of that kind.
    pub unit: &'static str,
    /// What it is.
    pub doc: &'static str,
    pub(crate) cell: fn(&mut Row) -> Cell<'_>,
}

/// A field of a row.
pub(crate) enum Cell<'a> {
    Flag(&'a mut bool),
    Small(&'a mut i32),
    Whole(&'a mut i64),
    /// From 0 in memory, from 1 in the file.
    Type(&'a mut usize),
    Number(&'a mut f64),
    Vector(&'a mut Vector3<f64>),
}
use Cell::*;

const fn column(
    name: &'static str,
    unit: &'static str,
    doc: &'static str,
    cell: fn(&mut Row) -> Cell<'_>,
) -> Column {
    Column { name, unit, doc, cell }
}

/// The columns before the history, in order.
pub const COLUMNS: &[Column] = &[
    column("step", "1", "number of the time step", |r| Whole(&mut r.close.call.step)),
    column("dt", "s", "time step", |r| Number(&mut r.close.call.dt)),
    column("wall", "1", "1 if j is a wall", |r| Flag(&mut r.close.call.is_wall)),
    column("touch", "1", "1 if the surfaces overlap (surfacesIntersect), 0 if not (surfacesClose)", |r| {
        Flag(&mut r.touch)
    }),
    column("computeflag", "1", "LIGGGHTS's flag of that name", |r| Small(&mut r.computeflag)),
    column(
        "shearupdate",
        "1",
        "LIGGGHTS's flag; history may be written if this and computeflag are set",
        |r| Small(&mut r.shearupdate),
    ),
    column("tag_i", "1", "number of particle i", |r| Whole(&mut r.close.i.tag)),
    column("tag_j", "1", "number of particle j; negative for a wall", |r| Whole(&mut r.close.j.tag)),
    column("type_i", "1", "atom type of i, from 1", |r| Type(&mut r.types.0)),
    column("type_j", "1", "atom type of j, from 1; of a wall, of its material", |r| Type(&mut r.types.1)),
    column("radius_i", "m", "radius of i", |r| Number(&mut r.close.i.radius)),
    column("radius_j", "m", "radius of j; 0 for a wall", |r| Number(&mut r.close.j.radius)),
    column("mass_i", "kg", "mass of i; inf if it is frozen", |r| Number(&mut r.close.i.mass)),
    column("mass_j", "kg", "mass of j; inf if it is frozen, 0 for a wall", |r| Number(&mut r.close.j.mass)),
    column("x_i", "m", "position of i", |r| Vector(&mut r.close.i.x)),
    column("x_j", "m", "position of j; of a wall, the contact point", |r| Vector(&mut r.close.j.x)),
    column("v_i", "m/s", "velocity of i", |r| Vector(&mut r.close.i.v)),
    column("v_j", "m/s", "velocity of j", |r| Vector(&mut r.close.j.v)),
    column("omega_i", "rad/s", "spin of i", |r| Vector(&mut r.close.i.omega)),
    column("omega_j", "rad/s", "spin of j; 0 for a wall", |r| Vector(&mut r.close.j.omega)),
    column("delta", "m", "from j to i", |r| Vector(&mut r.close.delta)),
    column("rsq", "m²", "square of the length of delta", |r| Number(&mut r.close.rsq)),
    column("meff", "kg", "effective mass", |r| Number(&mut r.close.meff)),
    column("deltan", "m", "overlap", |r| Number(&mut r.surface.deltan)),
    column("vn", "m/s", "normal relative velocity, negative while approaching", |r| {
        Number(&mut r.surface.vn)
    }),
    column("en", "1", "unit normal, from j to i", |r| Vector(&mut r.surface.en)),
    column("vtr", "m/s", "tangential relative velocity at the contact", |r| Vector(&mut r.surface.vtr)),
    column("roll", "rad/s", "relative spin that a rolling law sees", |r| Vector(&mut r.surface.roll)),
    column("cri", "m", "from the centre of i to the contact", |r| Number(&mut r.surface.cri)),
    column("crj", "m", "from the centre of j to the contact", |r| Number(&mut r.surface.crj)),
    column("fn", "N", "normal force, positive when it pushes apart", |r| Number(&mut r.handed.fn_)),
    column("kn", "N/m", "normal stiffness", |r| Number(&mut r.handed.kn)),
    column("kt", "N/m", "tangential stiffness", |r| Number(&mut r.handed.kt)),
    column("gamman", "N s/m", "normal damping", |r| Number(&mut r.handed.gamman)),
    column("gammat", "N s/m", "tangential damping", |r| Number(&mut r.handed.gammat)),
    column("force_i", "N", "force on i", |r| Vector(&mut r.force_i)),
    column("torque_i", "N m", "torque on i", |r| Vector(&mut r.torque_i)),
    column("force_j", "N", "force on j; 0 for a wall", |r| Vector(&mut r.force_j)),
    column("torque_j", "N m", "torque on j", |r| Vector(&mut r.torque_j)),
    column("has_force", "1", "1 if a law said that there is a force", |r| Flag(&mut r.has_force)),
];

/// The names of all columns of a chain with these per-atom properties and these history slots.
pub fn column_names(atoms: &[String], slots: &[String]) -> Vec<String> {
    let mut any = Row::default();
    let mut names = Vec::new();
    for c in COLUMNS {
        match (c.cell)(&mut any) {
            Vector(_) => names.extend(["x", "y", "z"].map(|axis| format!("{}.{axis}", c.name))),
            _ => names.push(c.name.to_string()),
        }
    }
    names.extend(atoms.iter().flat_map(|a| ["i", "j"].map(|of| format!("{of}.{a}"))));
    for when in ["before", "after"] {
        names.extend(slots.iter().map(|s| format!("{when}.{s}")));
    }
    names
}

/// The table of columns for the README.
pub fn columns_markdown() -> String {
    let mut any = Row::default();
    let mut table = String::from("| column | unit | meaning |\n|---|---|---|\n");
    for c in COLUMNS {
        let axes = if matches!((c.cell)(&mut any), Vector(_)) { "`.x .y .z`" } else { "" };
        let _ = writeln!(table, "| `{}`{axes} | {} | {} |", c.name, c.unit, c.doc);
    }
    table += "| `i.`name `j.`name | of the property | what the deck gives i and j in `fix property/atom`, if a law reads it |\n";
    table += "| `before.`slot | of the slot | history before the call, one column per slot of the header |\n";
    table += "| `after.`slot | of the slot | history after the call |\n";
    table
}
