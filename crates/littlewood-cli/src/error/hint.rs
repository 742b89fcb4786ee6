//! What to do about the errors of the other crates.

#[cfg(feature = "sweep")]
use littlewood::tables::Quantity;
use littlewood_draw::DrawError;
#[cfg(feature = "figures")]
use littlewood_figures::FigureError;
use littlewood_sweep::{AxisError, ListError, MOST_CHUNK_POINTS, PictureError, StoreError, SweepError};

use super::Error;

#[allow(clippy::match_same_arms, reason = "an attribute holds for a whole arm")]
pub(super) fn of(error: &Error) -> Option<String> {
    let hint = match error {
        Error::Value { error } | Error::ScenarioValue { error, .. } => error.hint().to_owned(),
        Error::Scenario { help, .. } => help.clone(),
        Error::UnknownCase { hint, .. }
        | Error::Mixed { hint, .. }
        | Error::Out { hint, .. }
        | Error::UnknownShade { hint, .. }
        | Error::Interrupted { hint, .. } => hint.clone(),
        #[cfg(feature = "figures")]
        Error::UnknownFigure { hint, .. } => hint.clone(),
        #[cfg(feature = "lab")]
        Error::NoPage { hint, .. } => hint.clone(),
        Error::Missing { flags, .. } => format!(
            "give {}, or start from a case (`littlewood cases` lists them) or a scenario file (--scenario)",
            flags.join(", ")
        ),
        Error::Unreadable { .. } => "--scenario takes the path of a TOML file in UTF-8".to_owned(),
        Error::Unwritable { .. } => "outputs need an existing folder that can be written to".to_owned(),
        Error::LongTable { .. } => "give --format csv, or --out NAME.csv".to_owned(),
        Error::WriteFile { .. } => "the existing file is unchanged".to_owned(),
        Error::Sweep(error) => of_sweep(error),
        #[cfg(feature = "sweep")]
        Error::Hoop { source, .. } => of_axis(source),
        #[cfg(feature = "sweep")]
        Error::HoopColumn { .. } => format!(
            "columns of --hoops are those of {} that no --axis varies",
            Quantity::HOOP.map(Quantity::name).join(", ")
        ),
        #[cfg(feature = "figures")]
        Error::Figure(error) => of_figure(error),
        Error::TwoErrors { .. } => "give each quantity once".to_owned(),
        Error::NotDifferentiable(_) => "give --restitution, or leave the quantity out".to_owned(),
        Error::Drawing(error) => of_drawing(error).to_owned(),
        Error::Stopped => "unfinished files are removed; finished ones are kept".to_owned(),
        Error::NotBuilt { feature, .. } => format!(
            "build it with `cargo run --release --features {feature} -- …`, or with `--all-features`; released programs \
             have all features"
        ),
        Error::InPackage { command } => {
            format!("`pip install littlewood`, and then `python -m littlewood {command} --help`")
        }
        #[cfg(feature = "lab")]
        Error::Port { .. } => "give another --port, or leave the flag out for a free one".to_owned(),
        #[cfg(feature = "film")]
        Error::Film(error) => error.hint().to_owned(),
        Error::Write { .. } | Error::ClosedPipe => return None,
    };
    Some(hint)
}

#[cfg(feature = "figures")]
fn of_figure(error: &FigureError) -> String {
    match error {
        FigureError::NeedsInertia { .. } => "give --mass-ratio or --inertia above 0, or leave the figure out",
        FigureError::NeedsMassless { .. } => "give --mass-ratio 0 and --inertia 0, or leave the figure out",
        FigureError::NeedsStartOnPlane { .. } => "leave --gap-rate out, or leave the figure out",
        FigureError::NeedsRim { .. } => "give --offset 1, or leave the figure out",
        FigureError::NeedsOffset { .. } => "give --offset above 0",
        FigureError::NeedsStaticFriction { .. } => "give --mu-s above 0, or leave the figure out",
        FigureError::NoContact { .. } | FigureError::NoForce { .. } => {
            "give a start at which the hoop stays on the plane, or leave the figure out"
        }
        FigureError::NeedsLevel { .. } => "leave out --slope, or the figure",
        FigureError::NoMotion { .. } => {
            "give another start; `littlewood classify` says what there is at this one"
        }
        FigureError::NoDuration { .. } => "give a later --until, or another start",
        FigureError::NeedsRestitution { .. } => "give --restitution from 0 to 1, or leave the figure out",
        FigureError::NoImpact { .. } => {
            "give a start from which the hoop jumps, or a later --until; or leave the figure out"
        }
        FigureError::NoTransition { .. } => "give another line: --along NAME=FROM:TO, such as theta_rate=0:4",
        FigureError::TooManyBands { .. } => {
            "give a shorter line: --along NAME=FROM:TO, such as theta_rate=0:4"
        }
        FigureError::ImpactNumber { .. } => "give another --impact; `littlewood simulate` lists the landings",
        FigureError::Draw(error) => of_drawing(error),
        FigureError::Parameter(error) => error.hint(),
        FigureError::UnknownCase { .. } => "`littlewood cases` lists the names",
        FigureError::Axis(error) => return of_axis(error),
        FigureError::Threads(_) => "try again when the machine is less busy",
    }
    .to_owned()
}

const fn of_drawing(error: &DrawError) -> &'static str {
    match error {
        DrawError::Scale { .. } => "give another --scale, such as 2",
        DrawError::Width { .. } => "give another --width-mm, such as 84 or 178",
        DrawError::NoRoom { .. } => "give a smaller picture",
    }
}

fn of_sweep(error: &SweepError) -> String {
    match error {
        SweepError::Axis(error) => of_axis(error),
        SweepError::Parameter(error) => error.hint().to_owned(),
        SweepError::List(error) => of_list(error),
        SweepError::ListAsZarr { .. } => "a list goes to a table: give --out NAME.parquet".to_owned(),
        SweepError::Store(error) => of_store(error).to_owned(),
        SweepError::Picture(error) => of_picture(error).to_owned(),
        SweepError::NotBuilt { .. } => "give a name that ends in another format".to_owned(),
        SweepError::Threads(_) => "give fewer --threads, or leave the flag out".to_owned(),
        SweepError::TooManyChunks { .. } => {
            format!("take fewer points, or larger chunks: --chunk N, {MOST_CHUNK_POINTS} at most")
        }
        SweepError::LongAxis { .. } => {
            "take fewer points, or give --out NAME.parquet, which has no coordinates".to_owned()
        }
    }
}

fn of_list(error: &ListError) -> String {
    match error {
        ListError::BadValue { source, .. } | ListError::Fixed { source, .. } => source.hint().to_owned(),
        ListError::Changed { .. } => "give the command again when nothing writes to the list".to_owned(),
        ListError::UnknownFormat { .. } => {
            "a list is a CSV file, NAME.csv, which a data frame writes with `to_csv(..., index=False)`"
                .to_owned()
        }
        ListError::Unreadable { .. }
        | ListError::UnknownColumn { .. }
        | ListError::DuplicateColumn { .. }
        | ListError::Empty { .. }
        | ListError::BadLine { .. }
        | ListError::BadCell { .. } => {
            "a list is a CSV file with a header; columns are named as axes are, cells are finite numbers"
                .to_owned()
        }
    }
}

fn of_axis(error: &AxisError) -> String {
    match error {
        AxisError::Value { source, .. } | AxisError::Fixed(source) => source.hint().to_owned(),
        AxisError::TooMany { .. } => "take fewer points".to_owned(),
        AxisError::Twice { .. } => "take each quantity for one axis".to_owned(),
        AxisError::NoFactor { .. } => {
            "an axis of equal factors (log) begins and ends on the same side of 0, such as mu=0.01:1:200:log"
                .to_owned()
        }
        AxisError::NotAnAxis { .. }
        | AxisError::NotFinite { .. }
        | AxisError::Empty { .. }
        | AxisError::OnePointTwoEnds { .. }
        | AxisError::NoExtent { .. }
        | AxisError::None => "an axis is NAME=FROM:TO:COUNT, such as theta=-pi:pi:200".to_owned(),
    }
}

const fn of_picture(error: &PictureError) -> &'static str {
    match error {
        PictureError::Size { .. } => "give another --size, such as 1500x1000",
        PictureError::NotTwoAxes { .. } => "a map has one --x and one --y",
        PictureError::NoNumber { .. } => "give another --shade, such as lift_off_time",
        PictureError::NotComputed { .. } => "give it with --derivatives, too",
        PictureError::NoScale { .. } => {
            "leave out --contours, or give a --shade of numbers, such as lift_off_time"
        }
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
        StoreError::Exists { complete: false, .. } => "--resume goes on with it; or give another --out",
        StoreError::OtherParameters { .. } => "give another --out, or the parameters of the store",
        StoreError::NotAStore { .. } | StoreError::OtherFormat { .. } => "give another --out",
        StoreError::Unwritable { finished: 0, .. } => "make room, or choose a folder that can be written to",
        StoreError::Unwritable { .. } => {
            "make room, then give the same command with --resume; it goes on from there"
        }
        StoreError::Locked { .. } => "wait until it has ended, or give another --out",
        StoreError::Unreadable { .. }
        | StoreError::DamagedManifest { .. }
        | StoreError::DamagedMetadata { .. }
        | StoreError::DamagedChunk { .. }
        | StoreError::Encoding { .. } => "give another --out, or remove what is there and run again",
    }
}
