//! Set-ups that make no sense, made from what each law says of itself; the message must help.
use granlaw::chain::Chain;
use granlaw::laws::LAWS;
use granlaw::model::*;

/// A refusal whose message holds all of these words.
pub fn refuses<T>(outcome: Result<T, LawError>, words: &[&str]) -> Result<(), String> {
    let Err(error) = outcome else { return Err(format!("not refused; expected {words:?}")) };
    let message = error.to_string();
    match words.iter().find(|w| !message.contains(**w)) {
        None => Ok(()),
        Some(w) => Err(format!("{w:?} is missing from: {message}")),
    }
}

/// Everything in the middle of its usual range, settings at their defaults or as asked.
pub fn sound(law: &'static Entry, chosen: &[(&str, &str)]) -> Setup {
    let (meta, mut settings) = (law.meta, Settings::new(law, false));
    let open = meta.settings.iter().filter(|s| s.default.is_none()).map(|s| (s.name, s.options[0]));
    for (name, option) in open.chain(chosen.iter().copied()) {
        settings.set(name, option).unwrap();
    }
    let of = meta.props.iter().map(|p| vec![0.5 * (p.usual.0 + p.usual.1); p.shape.len(2)]).collect();
    Setup { law, settings, values: Values { types: 2, of }, nktv2p: 1.0 }
}

fn prepare(setup: &Setup) -> Result<(), LawError> {
    Chain::packed(std::slice::from_ref(setup)).map(|_| ())
}

/// Settings under which a property is needed.
fn needing(p: &Prop) -> Vec<(&'static str, &'static str)> {
    match p.need {
        Need::When(name, option) => vec![(name, option)],
        Need::All(these) => these.to_vec(),
        _ => vec![],
    }
}

/// Each law with each of its properties, in a sound set-up that needs it.
fn properties() -> impl Iterator<Item = (&'static Prop, usize, Setup)> {
    LAWS.iter().flat_map(|e| {
        e.meta.props.iter().enumerate().map(|(k, p)| {
            let setup = sound(e, &needing(p));
            assert_eq!(prepare(&setup), Ok(()));
            (p, k, setup)
        })
    })
}

/// Values outside a range, and just so.
fn outside(range: &Range) -> Vec<f64> {
    let mut bad = vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    if range.lo.is_finite() {
        bad.push(if range.open_lo { range.lo } else { range.lo.next_down() });
        bad.push(range.lo - 1.0);
    }
    if range.hi.is_finite() {
        bad.push(if range.open_hi { range.hi } else { range.hi.next_up() });
        bad.push(range.hi + 1.0);
    }
    bad
}

#[test]
fn a_missing_property_is_named_with_the_command_that_sets_it() {
    for (p, k, mut setup) in properties() {
        setup.values.of[k].clear();
        let law = setup.law.meta.called(false);
        refuses(prepare(&setup), &[&law, p.name, p.shape.keyword(), "property/global"]).unwrap();
    }
}

#[test]
fn a_property_that_the_settings_do_not_call_for_may_be_missing() {
    let mut left_out = 0;
    for e in LAWS {
        let mut setup = sound(e, &[]);
        for (p, values) in e.meta.props.iter().zip(&mut setup.values.of) {
            if !setup.settings.need(p.need) {
                values.clear();
                left_out += 1;
            }
        }
        assert_eq!(prepare(&setup), Ok(()), "{}", e.meta.keyword);
    }
    assert!(left_out > 0, "no law has such a property");
}

#[test]
fn a_wrong_number_of_values_is_counted() {
    for (p, k, mut setup) in properties() {
        setup.values.of[k].push(1.0);
        let (law, got) = (setup.law.meta.called(false), setup.values.of[k].len().to_string());
        refuses(prepare(&setup), &[&law, p.name, &got, &p.shape.len(2).to_string()]).unwrap();
    }
}

#[test]
fn a_value_out_of_range_is_named_with_its_types_and_what_is_allowed() {
    for (p, k, setup) in properties() {
        let (place, types) = match p.shape {
            Shape::Scalar => (0, ""),
            Shape::PerType => (1, "(type 2)"),
            Shape::PerPair => (1, "(types 1-2)"),
        };
        for bad in outside(&p.range) {
            let mut setup = setup.clone();
            setup.values.of[k][place] = bad;
            let (law, value) = (setup.law.meta.called(false), format!("= {bad}"));
            refuses(prepare(&setup), &[&law, p.name, &value, types, &p.range.to_string()])
                .unwrap_or_else(|e| panic!("{bad}: {e}"));
        }
    }
}

#[test]
fn the_ends_of_every_closed_range_and_the_usual_values_are_allowed() {
    let mut allowed = 0;
    for (p, k, setup) in properties() {
        let r = p.range;
        let ends =
            [(r.lo, r.open_lo), (r.hi, r.open_hi)].into_iter().filter(|(_, open)| !open).map(|(x, _)| x);
        let usual = |x: f64| x == p.usual.0 || x == p.usual.1;
        for good in ends.chain([p.usual.0, p.usual.1]) {
            let mut setup = setup.clone();
            setup.values.of[k].fill(good);
            match prepare(&setup) {
                Ok(()) => allowed += 1,
                // The end of a range may still be beyond what another property leaves of it, never what people use.
                Err(LawError::OutOfRange { range, .. }) if range != r && !usual(good) => {}
                Err(LawError::Senseless { .. }) if !usual(good) => {}
                Err(e) => panic!("{} = {good}: {e}", p.name),
            }
        }
    }
    assert!(allowed > 50, "only {allowed} values were tried");
}

#[test]
fn a_setting_that_is_not_done_is_refused_by_name_when_it_is_on_under_either_name() {
    let mut refused = 0;
    for e in LAWS {
        for s in e.liggghts.refused {
            for taken_over in [false, true] {
                let mut setup = sound(e, &[]);
                setup.settings = Settings::new(e, taken_over);
                setup.settings.set(s.name, "on").unwrap();
                let words = [&e.meta.called(taken_over)[..], s.name, "not supported", s.doc];
                refuses(prepare(&setup), &words).unwrap();
                refused += 1;
            }
        }
    }
    assert!(refused > 0, "no law refuses a setting");
}

#[test]
fn a_setting_without_default_must_be_chosen_and_its_options_are_explained() {
    let mut open = 0;
    for e in LAWS {
        for s in e.meta.settings.iter().filter(|s| s.default.is_none()) {
            let mut setup = sound(e, &[]);
            setup.settings = Settings::new(e, false);
            for other in e.meta.settings.iter().filter(|o| o.default.is_none() && o.name != s.name) {
                setup.settings.set(other.name, other.options[0]).unwrap();
            }
            let law = setup.law.meta.called(false);
            let mut words = vec![&law[..], s.name, "must be given", s.doc];
            words.extend(s.options);
            refuses(prepare(&setup), &words).unwrap();
            for option in s.options {
                setup.settings.set(s.name, option).unwrap();
                assert_eq!(prepare(&setup), Ok(()));
            }
            open += 1;
        }
    }
    assert!(open > 0, "no law has such a setting");
}

#[test]
fn an_unknown_setting_or_option_is_answered_with_the_known_ones() {
    for e in LAWS {
        let law = e.meta.called(false);
        let mut settings = Settings::new(e, false);
        let mut words = vec![&law[..], "viscuous"];
        words.extend(e.settings().map(|s| s.name));
        refuses(settings.set("viscuous", "on"), &words).unwrap();
        for s in e.settings() {
            let mut words = vec![&law[..], s.name, "maybe"];
            words.extend(s.options);
            refuses(settings.set(s.name, "maybe"), &words).unwrap();
        }
    }
}

#[test]
fn a_law_that_has_taken_over_speaks_under_the_stock_name() {
    for e in LAWS {
        let mut settings = Settings::new(e, true);
        let message = settings.set("viscuous", "on").unwrap_err().to_string();
        assert!(message.starts_with(&format!("{}: ", e.meta.keyword)), "{message}");
    }
}

#[test]
fn the_check_itself_sees_a_set_up_that_passes_and_a_word_that_is_missing() {
    let setup = sound(&LAWS[0], &[]);
    assert!(refuses(prepare(&setup), &[]).unwrap_err().contains("not refused"));
    let mut setup = setup;
    setup.values.of[0].clear();
    assert!(refuses(prepare(&setup), &["unheard-of"]).unwrap_err().contains("is missing from"));
}
