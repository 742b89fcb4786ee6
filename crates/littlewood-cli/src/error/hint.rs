//! What to do about the errors of the other crates.

use std::borrow::Cow;

use littlewood_draw::DrawError;
#[cfg(feature = "figures")]
use littlewood_figures::FigureError;
use littlewood_sweep::{
    AxisError, ListError, MOST_CHUNK_POINTS, PictureError, StoreError, SweepError,
};

use super::Error;

#[allow(clippy::match_same_arms, reason = "an attribute holds for a whole arm")]
pub(super) fn of(error: &Error) -> Option<Cow<'_, str>> {
    let hint = match error {
        Error::Value { error } | Error::ScenarioValue { error, .. } => error.hint().into(),
        Error::Scenario { help, .. } => help.as_str().into(),
        Error::UnknownCase { hint, .. }
        | Error::Mixed { hint, .. }
        | Error::Out { hint, .. }
        | Error::UnknownShade { hint, .. }
        | Error::Interrupted { hint, .. } => hint.as_str().into(),
        #[cfg(feature = "figures")]
        Error::UnknownFigure { hint, .. } => hint.as_str().into(),
        #[cfg(feature = "figures")]
        Error::FigureRemoved { instead, .. } => (*instead).into(),
        #[cfg(feature = "figures")]
        Error::ChartOfAHoop => {
            "leave out --chart for a poster of this hoop, or the case and the flags".into()
        }
        #[cfg(feature = "lab")]
        Error::NoPage { hint, .. } => hint.as_str().into(),
        Error::Missing { flags, .. } => format!(
            "give {}, or start from a case (`littlewood cases` lists them) or a scenario file \
             (--scenario)",
            flags.join(", ")
        )
        .into(),
        Error::Unreadable { .. } => "--scenario takes the path of a TOML file in UTF-8".into(),
        Error::Unwritable { .. } => "outputs need an existing folder that can be written to".into(),
        Error::LongTable { .. } => "give --format csv, or --out NAME.csv".into(),
        Error::WriteFile { .. } => "the existing file is unchanged".into(),
        Error::Sweep(error) => of_sweep(error),
        #[cfg(feature = "figures")]
        Error::Figure(error) => of_figure(error),
        Error::TwoErrors { .. } => "give each quantity once".into(),
        Error::NotDifferentiable(_) => "give --restitution, or leave the quantity out".into(),
        Error::Drawing(error) => of_drawing(error).into(),
        Error::Stopped => "unfinished files are removed; finished ones are kept".into(),
        Error::NotBuilt { feature, .. } => format!(
            "build it with `cargo run --release --features {feature} -- …`, or with \
             `--all-features`"
        )
        .into(),
        Error::InPackage { command } => format!(
            "install the package from python/ of the repository, as its README says, then \
                 `python -m littlewood {command} --help`"
        )
        .into(),
        Error::AtlasRemoved => {
            "`littlewood map --shade sequence` shows the sequences of phases on a grid; the \
             example `theron_maritz` of the crate littlewood-sweep counts those of first turns"
                .into()
        }
        #[cfg(feature = "lab")]
        Error::Port { .. } => "give another --port, or leave the flag out for a free one".into(),
        #[cfg(feature = "film")]
        Error::Film(error) => error.hint().into(),
        Error::Write { .. } | Error::ClosedPipe => return None,
    };
    Some(hint)
}

#[cfg(feature = "figures")]
fn of_figure(error: &FigureError) -> Cow<'_, str> {
    match error {
        FigureError::NeedsInertia { .. } => {
            "give --mass-ratio or --inertia above 0, or leave the figure out"
        }
        FigureError::NeedsMassless { .. } => {
            "give --mass-ratio 0 and --inertia 0, or leave the figure out"
        }
        FigureError::NeedsRim { .. } => "give --offset 1, or leave the figure out",
        FigureError::NeedsOffset { .. } => "give --offset above 0",
        FigureError::NeedsStaticFriction { .. } => "give --mu-s above 0, or leave the figure out",
        FigureError::NoContact { .. } => {
            "give a start at which the hoop stays on the plane, or leave the figure out"
        }
        FigureError::NeedsLevel { .. } => "leave out --slope, or the figure",
        FigureError::NeedsNoResistance { .. } => "leave out --rolling-resistance, or the figure",
        FigureError::NoMotion { .. } => {
            "give another start; `littlewood classify` says what there is at this one"
        }
        FigureError::NoDuration { .. } => "give a later --until, or another start",
        FigureError::NeedsRestitution { .. } => {
            "give --restitution from 0 to 1, or leave the figure out"
        }
        FigureError::NoImpact { .. } => {
            "give a start from which the hoop jumps, or a later --until; or leave the figure out"
        }
        FigureError::ImpactNumber { .. } => {
            "give another --impact; `littlewood simulate` lists the landings"
        }
        FigureError::Draw(error) => of_drawing(error),
        FigureError::Parameter(error) => error.hint(),
        FigureError::UnknownCase { .. } => "`littlewood cases` lists the names",
        FigureError::Axis(error) => return of_axis(error),
        FigureError::Threads(_) => "try again when the machine is less busy",
    }
    .into()
}

const fn of_drawing(error: &DrawError) -> &'static str {
    match error {
        DrawError::Scale { .. } => "give another --scale, such as 2",
        DrawError::Width { .. } => "give another --width-mm, such as 84 or 178",
        DrawError::NoRoom { .. } => "give a smaller picture",
    }
}

fn of_sweep(error: &SweepError) -> Cow<'_, str> {
    match error {
        SweepError::Axis(error) => of_axis(error),
        SweepError::Parameter(error) => error.hint().into(),
        SweepError::List(error) => of_list(error),
        SweepError::ListAsZarr { .. } => "a list goes to a table: give --out NAME.parquet".into(),
        SweepError::Store(error) => of_store(error).into(),
        SweepError::Picture(error) => of_picture(error).into(),
        SweepError::NotBuilt { .. } => "give a name that ends in another format".into(),
        SweepError::Threads(_) => "give fewer --threads, or leave the flag out".into(),
        SweepError::TooManyChunks { .. } => {
            format!("take fewer points, or larger chunks: --chunk N, {MOST_CHUNK_POINTS} at most")
                .into()
        }
        SweepError::LongAxis { .. } => {
            "take fewer points, or give --out NAME.parquet, which has no coordinates".into()
        }
    }
}

fn of_list(error: &ListError) -> Cow<'_, str> {
    match error {
        ListError::BadValue { source, .. } | ListError::Fixed { source, .. } => {
            source.hint().into()
        }
        ListError::Changed { .. } => {
            "give the command again when nothing writes to the list".into()
        }
        ListError::UnknownFormat { .. } => {
            "a list is a CSV file, NAME.csv; a data frame writes it with `to_csv(..., index=False)`"
                .into()
        }
        _ => {
            "a list is a CSV file with a header; columns have the names of axes, cells are finite \
             numbers"
                .into()
        }
    }
}

fn of_axis(error: &AxisError) -> Cow<'_, str> {
    match error {
        AxisError::Value { source, .. } | AxisError::Fixed(source) => source.hint().into(),
        AxisError::TooMany { .. } => "take fewer points".into(),
        AxisError::Twice { .. } => "take each quantity for one axis".into(),
        AxisError::NoFactor { .. } => {
            "a logarithmic axis (log) begins and ends on the same side of 0, such as \
             mu=0.01:1:200:log"
                .into()
        }
        _ => "an axis is NAME=FROM:TO:COUNT, such as theta=-pi:pi:200".into(),
    }
}

const fn of_picture(error: &PictureError) -> &'static str {
    match error {
        PictureError::Size { .. } => "give another --size, such as 1500x1000",
        PictureError::NotTwoAxes { .. } => "a map has one --x and one --y",
        PictureError::NoNumber { .. } => "give another --shade, such as lift_off_time",
        PictureError::NotComputed { .. } => "give it with --derivatives, too",
        PictureError::NoCurves { .. } => {
            "leave out --curves, or give --x theta=-pi:pi:400 --y theta_rate=-4:4:400 with --slip 0"
        }
    }
}

const fn of_store(error: &StoreError) -> &'static str {
    match error {
        StoreError::Exists { complete: true, .. } => {
            "it is finished; give another --out, or remove it to compute it again"
        }
        StoreError::Exists {
            complete: false, ..
        } => "--resume goes on with it; or give another --out",
        StoreError::OtherParameters { .. } => "give another --out, or the parameters of the store",
        StoreError::NotAStore { .. } | StoreError::OtherFormat { .. } => "give another --out",
        StoreError::Unwritable { finished: 0, .. } => {
            "make room, or choose a folder that can be written to"
        }
        StoreError::Unwritable { .. } => {
            "make room, then give the same command with --resume; it goes on from there"
        }
        StoreError::Locked { .. } => "wait until it has ended, or give another --out",
        _ => "give another --out, or remove what is there and run again",
    }
}
