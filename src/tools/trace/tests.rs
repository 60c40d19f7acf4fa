//! Written traces read back the same, and damaged ones say what is wrong with them.
use super::*;
use granlaw::model::{Body, Call};
use std::io::Cursor;

fn header() -> Header {
    let young = Property {
        name: "youngsModulus".into(),
        unit: "Pa".into(),
        shape: "peratomtype".into(),
        values: vec![5e6, f64::INFINITY],
    };
    let law = LawSpec {
        kind: "normal".into(),
        keyword: "hooke/hysteresis".into(),
        taken_over: true,
        known: true,
        settings: [("viscous".to_string(), "off".to_string())].into(),
        properties: vec![young],
        ..LawSpec::default()
    };
    let particle = Particle {
        tag: 7,
        kind: 1,
        radius: 0.1 + 0.2,
        mass: 1e-300,
        x: Vector3::new(1.0 / 3.0, -0.0, 5e-324),
        v: Vector3::zeros(),
        omega: Vector3::zeros(),
    };
    Header {
        granlaw: "0.1.0".into(),
        liggghts: "LIGGGHTS 3.8.0, \"compiled\", by x".into(),
        deck: "in, with a comma.in".into(),
        units: "si".into(),
        who: "pair".into(),
        ranks: 1,
        every: 1,
        types: 2,
        nktv2p: 1.0,
        dt: 2e-6,
        atoms: vec!["bondnonlinear_random_id".into()],
        slots: vec!["deltaMax".into()],
        laws: vec![law],
        particles: vec![particle],
        ..Header::default()
    }
}

/// A row in which no two numbers are equal, so that swapped columns show.
fn row() -> Row {
    let mut n = 0.1;
    let mut next = || {
        n *= -1.1;
        n
    };
    let call = Call { dt: next(), step: 12, update: true, is_wall: true, ..Call::default() };
    let mut vector = || Vector3::new(next(), next(), next());
    let body = |tag, v: &mut dyn FnMut() -> Vector3<f64>| Body {
        tag,
        radius: v().x,
        mass: v().y,
        x: v(),
        v: v(),
        omega: v(),
        given: [v().x],
        ..Body::default()
    };
    let (i, j) = (body(3, &mut vector), body(-1, &mut vector));
    let gap = ClosePair { call, i, j, delta: vector(), rsq: vector().x, meff: vector().y };
    let deltan = vector().x;
    let surface = Surface {
        r: i.radius - deltan,
        deltan,
        vn: vector().x,
        en: vector(),
        vtr: vector(),
        roll: vector(),
        cri: vector().x,
        crj: vector().x,
    };
    let handed = Handed {
        fn_: vector().x,
        kn: f64::INFINITY,
        kt: vector().x,
        gamman: vector().x,
        gammat: f64::NEG_INFINITY,
    };
    Row {
        computeflag: 1,
        shearupdate: 1,
        touch: true,
        types: (0, 1),
        close: gap,
        surface,
        before: vec![-0.0],
        after: vec![1e-17],
        handed,
        force_i: vector(),
        torque_i: vector(),
        force_j: vector(),
        torque_j: vector(),
        has_force: true,
    }
}

fn written(rows: usize) -> String {
    let mut bytes = Vec::new();
    let mut w = Writer::new(&mut bytes, "t", &header()).unwrap();
    (0..rows).for_each(|_| w.row(&row()).unwrap());
    w.finish().unwrap();
    String::from_utf8(bytes).unwrap()
}

fn read(text: &str) -> Result<Vec<Row>, TraceError> {
    Reader::new(Cursor::new(text.to_string()), "t.csv")?.collect()
}

fn refusal(text: &str) -> String {
    read(text).expect_err("a damaged trace").to_string()
}

#[test]
fn what_is_written_reads_back_to_the_last_bit() {
    let rows = read(&written(3)).unwrap();
    assert_eq!(rows, vec![row(); 3]);
    assert!(rows[0].before[0].is_sign_negative());
    let reader = Reader::new(Cursor::new(written(0)), "t").unwrap();
    assert_eq!(*reader.header(), header());
    assert_eq!(reader.header().particles[0].x.map(f64::to_bits), header().particles[0].x.map(f64::to_bits));
}

#[test]
fn a_header_between_rows_holds_from_there_on() {
    let (first, mut second) = (header(), header());
    second.laws[0].properties[0].values[0] = 7e6;
    let mut bytes = Vec::new();
    let mut w = Writer::new(&mut bytes, "t", &first).unwrap();
    w.row(&row()).unwrap();
    w.header(&second).unwrap();
    w.row(&row()).unwrap();
    w.finish().unwrap();
    let mut reader = Reader::new(Cursor::new(bytes), "t").unwrap();
    let mut into = Row::default();
    assert!(reader.read(&mut into).unwrap());
    assert_eq!((reader.header(), reader.headers()), (&first, 1));
    assert!(reader.read(&mut into).unwrap());
    assert_eq!((reader.header(), reader.headers()), (&second, 2));
    assert!(!reader.read(&mut into).unwrap());
    assert!(!reader.read(&mut into).unwrap());
}

#[test]
fn other_slots_in_a_later_header_are_refused() {
    let mut other = header();
    other.slots.push("more".into());
    let mut w = Writer::new(Vec::new(), "t", &header()).unwrap();
    assert!(w.header(&other).unwrap_err().to_string().contains("atom properties change"));
    let whole = written(1);
    let head = whole[..whole.find("step,").unwrap()].replace("deltaMax", "deltaMin");
    let why = refusal(&whole.replace("# end 1", &(head + "# end 1")));
    assert!(why.contains("not those of the first header"), "{why}");
}

#[test]
fn a_trace_cut_anywhere_is_an_error() {
    let whole = written(2);
    for cut in 1..whole.len() - 1 {
        let why = refusal(&whole[..cut]);
        let expected =
            ["cut short", "not a trace", "unknown", "in the header", "column", "the last line says"];
        assert!(expected.iter().any(|e| why.contains(e)), "cut at {cut}: {why}");
    }
    // After the line of columns the error always names the missing end, never half a number.
    let rows = whole.find("after.deltaMax\n").unwrap() + 15;
    for cut in rows..whole.find("# end").unwrap() + 5 {
        assert!(refusal(&whole[..cut]).contains("cut short"), "cut at {cut}: {}", refusal(&whole[..cut]));
    }
}

#[test]
fn damage_is_named_with_its_line_and_column() {
    let whole = written(2);
    let cases = [
        ("# granlaw trace 1", "ITEM: TIMESTEP", "t.csv: line 1 is not"),
        ("# granlaw trace 1", "# granlaw trace 2", "t.csv:1: format \"2\""),
        ("# types = 2", "# types = \"two\"", "t.csv:1: in the header"),
        ("# types = 2", "# tipes = 2", "tipes"),
        ("radius_i", "radius", "column 11 is \"radius\" where \"radius_i\" belongs"),
        (",after.deltaMax\n", "\n", "column 72 is \"\" where \"after.deltaMax\" belongs"),
        ("# end 2", "# end 3", "the last line says 3 rows where there are 2"),
        ("# end 2", "# end 2\n# end 2", "text behind the last line"),
        ("# end 2", "# remark\n# end 2", "belongs to no header"),
        (",-1,1,2,", ",-1,1,3,", "\"3\" in column type_j is not an atom type"),
        ("\n12,", "\n12.5,", "\"12.5\" in column step is not a whole number"),
        (",inf,", ",infinite,", "\"infinite\" in column kn is not a number"),
        ("\n12,", "\n12,12,", "the row has 73 fields where 72 columns are named"),
    ];
    for (from, to, says) in cases {
        assert!(whole.contains(from), "{from}");
        let why = refusal(&whole.replacen(from, to, 1));
        assert!(why.contains(says), "{from} -> {to}: {why}");
    }
}

#[test]
fn a_file_has_its_name_only_when_it_is_finished() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.csv");
    let w = Writer::create(&path, &header()).unwrap();
    assert!(!path.exists());
    w.finish().unwrap();
    assert_eq!(Reader::open(&path).unwrap().count(), 0);
    assert!(Reader::open(&folder.path().join("none")).err().unwrap().to_string().contains("none"));
}

#[test]
fn history_of_another_length_is_not_written() {
    let mut w = Writer::new(Vec::new(), "t", &header()).unwrap();
    let row = Row { before: vec![], ..row() };
    assert!(w.row(&row).unwrap_err().to_string().contains("0/1 slots"));
}

#[test]
fn the_table_of_columns_has_every_column() {
    let table = columns_markdown();
    for c in COLUMNS {
        assert!(table.contains(&format!("| `{}`", c.name)) && !c.doc.is_empty(), "{}", c.name);
    }
    assert_eq!(table.lines().count(), COLUMNS.len() + 5);
}

#[test]
fn headers_that_make_no_chain_say_why() {
    let why = |change: fn(&mut Header)| {
        let mut h = header();
        change(&mut h);
        h.setups().expect_err("a refusal").to_string()
    };
    let lacks = why(|h| h.laws[0].keyword = "adams".into());
    assert!(lacks.contains("normal adams") && lacks.contains("normal hooke"), "{lacks}");
    assert!(why(|h| h.laws[0].known = false).contains("normal hooke/hysteresis, which granlaw"));
    assert!(why(|h| h.slots[0] = "other".into()).contains("deltaMax) is not at slot 0"));
    assert!(why(|h| h.laws[0].offset = 9).contains("not at slot 9"));
    assert!(why(|h| h.laws[0].properties[0].name = "colour".into()).contains("no property colour"));
    assert!(why(|h| h.laws[0].properties[0].shape = "scalar".into()).contains("should be peratomtype"));
    assert!(
        why(|h| h.laws[0].settings = [("colour".into(), "on".into())].into()).contains("no setting colour")
    );
    assert!(why(|_| {}).contains("youngsModulus = inf"), "{}", why(|_| {}));
}
