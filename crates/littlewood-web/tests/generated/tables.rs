//! The tables of the core as TypeScript.

use littlewood::impact::ImpactCase;
use littlewood::tables::{Class, Dimension, Group, Quantity, SampleColumn, System};
use littlewood::{Cause, Mode, OutcomeKind, RestitutionLaw, State};
use littlewood_report::link::VIEW;
use littlewood_web::{dimensionless_quantities, si_quantities};

use crate::generated::source::{Source, object, quoted, quoted_or_null};

/// The whole file.
pub(crate) fn typescript() -> String {
    let mut source = Source::new("The tables of the core.");
    quantities(&mut source);
    columns(&mut source);
    let modes = by_code(&Mode::ALL, Mode::code, Mode::name);
    source.names(
        "MODES",
        "Mode",
        "Modes of motion. Arrays hold a mode as its place in this list.",
        modes,
    );
    let causes = Cause::ALL.map(|cause| (cause.name(), quoted(cause.label())));
    source.names("CAUSES", "Cause", "What ends a phase.", Cause::NAMES);
    source.record("CAUSE_LABELS", ("Cause", "string"), "In words.", causes);
    outcomes(&mut source);
    let classes = by_code(&Class::ALL, Class::code, Class::name);
    source.names(
        "CLASSES",
        "Class",
        "Classes of outcomes. Maps hold a class as its place in this list.",
        classes,
    );
    let labels = Class::ALL.map(|class| (class.name(), quoted(class.label())));
    source.record("CLASS_LABELS", ("Class", "string"), "In words.", labels);
    let in_contact = Class::ALL
        .into_iter()
        .filter(|class| class.stays_in_contact())
        .map(|class| quoted(class.name()))
        .collect::<Vec<_>>()
        .join(", ");
    source.lines(&format!(
        "/** Those of motions that stay in contact. */\nexport const CLASSES_IN_CONTACT: readonly Class[] = [{in_contact}];",
    ));
    impacts(&mut source);
    view(&mut source);
    source.lines(&format!(
        "/** What a core of the same version says of the order of names. */\nexport const BOUNDARY = {};",
        quoted(&littlewood_web::boundary())
    ));
    source.text()
}

fn quantities(source: &mut Source) {
    source.names(
        "QUANTITIES",
        "Quantity",
        "What a person can set.",
        Quantity::NAMES,
    );
    source.names(
        "GROUPS",
        "Group",
        "What a quantity belongs to.",
        Group::NAMES,
    );
    source.lines("export type System = 'dimensionless' | 'si';");
    source.lines(
        "export interface QuantityRow {
  group: Group;
  /** The system that a number of this name is in; an angle and a ratio are the same number in both. */
  system: System;
  /** The same quantity in the other system. */
  twin: Quantity | null;
  sign: string;
  unit: string;
  longName: string;
  /** What it is if it is not given. */
  otherwise: number | null;
  /** Range in which a person usually sets it. */
  usual: readonly [number, number];
}",
    );
    let rows = Quantity::ALL.map(|quantity| {
        let row = quantity.row();
        let fields = [
            ("group", quoted(row.group.name())),
            ("system", quoted(system_name(row.system))),
            ("twin", quoted_or_null(row.twin.map(Quantity::name))),
            ("sign", quoted(row.sign)),
            ("unit", quoted(quantity.unit_sign())),
            ("longName", quoted(row.long_name)),
            (
                "otherwise",
                row.presence
                    .default_value()
                    .map_or_else(|| "null".to_owned(), |value| value.to_string()),
            ),
            ("usual", format!("[{}, {}]", row.usual[0], row.usual[1])),
        ];
        (quantity.name(), object(&fields))
    });
    source.record(
        "QUANTITY_ROWS",
        ("Quantity", "QuantityRow"),
        "The table of quantities.",
        rows,
    );
    source.names(
        "DIMENSIONLESS",
        "DimensionlessNumber",
        "The numbers of a problem without dimension, in the order in which the core takes them.",
        dimensionless_quantities().map(Quantity::name),
    );
    source.names(
        "SI",
        "SiNumber",
        "The numbers of a problem in SI units, in the order in which the core takes them.",
        si_quantities().map(Quantity::name),
    );
}

const fn system_name(system: System) -> &'static str {
    match system {
        System::Dimensionless => "dimensionless",
        System::Si => "si",
    }
}

fn columns(source: &mut Source) {
    let columns = by_code(&SampleColumn::ALL, SampleColumn::code, SampleColumn::name);
    let doc = "The columns of a sample, in the order in which the core gives them.";
    source.names("SAMPLE_COLUMNS", "SampleColumn", doc, columns);
    source.lines(
        "export interface ColumnRow {
  longName: string;
  signs: Readonly<Record<System, string>>;
  /** Empty for an angle without dimension, and for a code. */
  units: Readonly<Record<System, string>>;
}",
    );
    let rows = SampleColumn::ALL.map(|column| {
        let twin = column
            .name()
            .parse::<Quantity>()
            .ok()
            .and_then(Quantity::si_twin);
        let signs = [column.sign(), twin.map_or(column.sign(), Quantity::sign)];
        let units = column
            .dimension()
            .map_or(["", ""], |it| [it.scale_sign(), it.si_sign()]);
        let both = |[plain, si]: [&str; 2]| {
            object(&[("dimensionless", quoted(plain)), ("si", quoted(si))])
        };
        let fields = [
            ("longName", quoted(column.long_name())),
            ("signs", both(signs)),
            ("units", both(units)),
        ];
        (column.name(), object(&fields))
    });
    source.record(
        "COLUMN_ROWS",
        ("SampleColumn", "ColumnRow"),
        "The table of columns.",
        rows,
    );
    source.names(
        "STATE_COLUMNS",
        "StateColumn",
        "Those of a state, in the order in which the core gives them.",
        State::COLUMNS.map(SampleColumn::name),
    );
}

fn outcomes(source: &mut Source) {
    source.names(
        "OUTCOMES",
        "OutcomeKind",
        "How a motion ends.",
        OutcomeKind::NAMES,
    );
    source.lines(
        "export interface OutcomeRow {
  label: string;
  /** Whether the last phase lasts for ever. */
  forever: boolean;
  /** The event that is this outcome, if there is one. */
  lastEvent: Cause | null;
}",
    );
    let rows = OutcomeKind::ALL.map(|kind| {
        let fields = [
            ("label", quoted(kind.label())),
            ("forever", kind.is_forever().to_string()),
            (
                "lastEvent",
                quoted_or_null(kind.last_event().map(Cause::name)),
            ),
        ];
        (kind.name(), object(&fields))
    });
    source.record(
        "OUTCOME_ROWS",
        ("OutcomeKind", "OutcomeRow"),
        "The table of outcomes.",
        rows,
    );
}

fn impacts(source: &mut Source) {
    let laws = RestitutionLaw::ALL.map(|law| (law.name(), quoted(law.label())));
    source.names(
        "LAWS",
        "Law",
        "Laws of restitution. The first is that of a coefficient alone.",
        RestitutionLaw::NAMES,
    );
    source.record("LAW_LABELS", ("Law", "string"), "In words.", laws);
    assert_eq!(RestitutionLaw::default().name(), RestitutionLaw::NAMES[0]);
    let cases = ImpactCase::ALL.map(|case| (case.name(), quoted(case.label())));
    source.names(
        "IMPACT_CASES",
        "ImpactCase",
        "What the contact point does in an impact.",
        ImpactCase::NAMES,
    );
    source.record(
        "IMPACT_CASE_LABELS",
        ("ImpactCase", "string"),
        "In words.",
        cases,
    );
    let impulse = [
        ("dimensionless", Dimension::Impulse.scale_sign()),
        ("si", Dimension::Impulse.si_sign()),
    ];
    source.record(
        "IMPULSE_UNITS",
        ("System", "string"),
        "The unit of an impulse.",
        impulse.map(|(system, sign)| (system, quoted(sign))),
    );
}

fn view(source: &mut Source) {
    source.names(
        "VIEW_KEYS",
        "ViewKey",
        "What a link says of the page.",
        VIEW.map(|(key, ..)| key),
    );
    let list = |items: &[&str]| {
        format!(
            "[{}]",
            items
                .iter()
                .map(|it| quoted(it))
                .collect::<Vec<_>>()
                .join(", ")
        )
    };
    let choices = VIEW.map(|(key, choices, _)| (key, list(choices)));
    source.record(
        "VIEW_CHOICES",
        ("ViewKey", "readonly string[]"),
        "What it may say.",
        choices,
    );
    let first = VIEW.map(|(key, _, first)| (key, quoted(first)));
    source.record(
        "VIEW_FIRST",
        ("ViewKey", "string"),
        "What it says at first.",
        first,
    );
}

/// The names in the order of their codes, which are 0, 1, 2, …
fn by_code<T: Copy, const N: usize>(
    all: &[T; N],
    code: fn(T) -> u8,
    name: fn(T) -> &'static str,
) -> [&'static str; N] {
    for (place, item) in all.iter().enumerate() {
        assert_eq!(
            usize::from(code(*item)),
            place,
            "the code of {} is not its place",
            name(*item)
        );
    }
    all.map(name)
}
