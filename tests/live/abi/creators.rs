//! The plugin's table of LIGGGHTS's own property creators, made from what the laws say of their properties.
use crate::built::source;
use granlaw::laws::prop::CREATORS;
use granlaw::model::Shape;
use std::fmt::Write;

fn table() -> String {
    let mut out = String::from(
        "// LIGGGHTS's own creators of the properties that it knows. Made from CREATORS in src/core/laws/prop.rs by the test\n\
         // the_table_of_creators_is_made_from_the_laws; run it with GRANLAW_BLESS=1. SPDX-License-Identifier: GPL-2.0-or-later\n\
         #ifndef GRANLAW_CREATORS_HPP\n#define GRANLAW_CREATORS_HPP\n\n#include <vector>\n#include \"global_properties.h\"\n\n\
         namespace granlaw {\n\n// One of the three, by the shape of the property.\nstruct Creator {\n  const char *name;\n\
         \x20 ScalarPropertyCreator scalar;\n  VectorPropertyCreator vector;\n  MatrixPropertyCreator matrix;\n};\n\
         inline const std::vector<Creator> &creators() {\n  using namespace MODEL_PARAMS;\n  static const std::vector<Creator> all = {\n",
    );
    for (prop, creator) in CREATORS {
        let place = |shape| if prop.shape == shape { format!("&{creator}") } else { "nullptr".into() };
        let [scalar, vector, matrix] = [Shape::Scalar, Shape::PerType, Shape::PerPair].map(place);
        writeln!(out, "      {{\"{}\", {scalar}, {vector}, {matrix}}},", prop.name).unwrap();
    }
    out + "  };\n  return all;\n}\n\n}  // namespace granlaw\n#endif\n"
}

#[test]
fn the_table_of_creators_is_made_from_the_laws() {
    let path = source().join("ffi/liggghts/cpp/creators.hpp");
    if std::env::var_os("GRANLAW_BLESS").is_some() {
        std::fs::write(&path, table()).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(found, table(), "creators.hpp is not what CREATORS says; run this test with GRANLAW_BLESS=1");
}
